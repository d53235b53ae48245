# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Bed load against two published laws: python3 rate.py FROM metrics.csv ..., means from the time FROM [s] on"""
import csv
import math
import sys

DIAMETER, DENSITY, EXCESS, GRAVITY = 2e-3, 1000.0, 1.65, 9.81  # of scene.yaml: [m], [kg/m3], -, [m/s2]

print("Shields number  q*  Meyer-Peter & Mueller  Wong & Parker")
for name in sys.argv[2:]:
    rows = [row for row in csv.DictReader(open(name)) if float(row["time"]) >= float(sys.argv[1])]

    def mean(column):
        return sum(float(row[column]) for row in rows) / len(rows)

    shields = mean("bed_stress_x") / (DENSITY * EXCESS * GRAVITY * DIAMETER)
    rate = mean("transport_x") / math.sqrt(EXCESS * GRAVITY * DIAMETER**3)
    laws = [factor * max(shields - onset, 0.0) ** 1.5 for factor, onset in ((8.0, 0.047), (3.97, 0.0495))]
    print(f"{shields:.4f}  {rate:.5f}  {laws[0]:.5f}  {laws[1]:.5f}  {name}")
