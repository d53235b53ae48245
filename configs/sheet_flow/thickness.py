# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Thickness of a sheet of sand over the Shields number: python3 thickness.py metrics.csv ..., at the greatest stress of each run"""
import csv
import sys

DIAMETER, DENSITY, EXCESS, GRAVITY = 0.5e-3, 1000.0, 1.65, 9.81  # of scene.yaml: [m], [kg/m3], -, [m/s2]
WINDOW = 0.1  # means over this time around the greatest [s]

print("time  Shields number  thickness / d  thickness / d / Shields number")
for name in sys.argv[1:]:
    rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(open(name))]

    def mean(column, time):
        values = [row[column] for row in rows if abs(row["time"] - time) <= WINDOW / 2]
        return sum(values) / len(values)

    time = max((row["time"] for row in rows), key=lambda t: mean("bed_stress_x", t))
    shields = mean("bed_stress_x", time) / (DENSITY * EXCESS * GRAVITY * DIAMETER)
    thickness = mean("moving_layer", time) / DIAMETER
    print(f"{time:.2f} s  {shields:.2f}  {thickness:.1f}  {thickness / shields:.1f}  {name}")
