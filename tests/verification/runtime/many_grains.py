# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Whether 16,000 rough grains that slide through blocks and a seam end in the same bits on any ranks and threads and after a restart.

many_grains.py ISAGO [--sub-steps N]: N for each run, and none may lose a grain. 100,000 make 1.6e9 grain-steps, five minutes for each way
on a quiet core.
"""
import argparse
import csv
import sys
import tempfile
import time

from same_bits import Case, Runner, Way

COUNT = 16000
SLOPE = f"""
name: rough grains that slide down a slope
grid:
  box: {{ size: [80 mm, 80 mm, 40 mm], cells: [16, 16, 8], blocks: [4, 1, 2] }}
  periodic: [x, z]
gravity: {{ direction: [1, -2, 0] }}
particles:
  - {{ name: glass, count: {COUNT}, diameter: 2 mm, density: 2500 kg/m3,
      initial: {{ arrangement: random, velocity: [1 m/s, 0 m/s, 0.3 m/s] }} }}
contact: {{ law: linear, stiffness: 2 kN/m, restitution: 0.7, friction: 0.3 }}
run: {{ until: 1 s }}
output: {{ checkpoint: never, results: never, pictures: never }}
"""
SUB_STEP = 5.4e-3  # of these contacts, rounded up [ms]

WAYS = (Way(), Way(1, 2, "tbb"), Way(1, 4, "tbb"), Way(1, 2, "openmp"), Way(2, 1, "tbb"), Way(4, 1, "tbb"),
        Way(2, 1, "tbb", Way(4, 1, "tbb")), Way(4, 1, "tbb", Way(1, 2, "tbb")))


def steps_and_grains(folder):
    """Sub-steps of all rows of a run's metrics, and the grains of the last one."""
    with open(folder / "metrics.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    return sum(int(row["sub_steps"]) for row in rows), int(rows[-1]["particles"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("isago")
    parser.add_argument("--sub-steps", type=int, default=2000)
    arguments = parser.parse_args()
    end = arguments.sub_steps * SUB_STEP
    case, expected, wrong = Case(SLOPE, [], end / 2, end), None, 0
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(arguments.isago, folder, timeout=max(1800, arguments.sub_steps))
        for way in WAYS:
            start = time.monotonic()
            digest = runner.digest(case, way)
            steps, grains = steps_and_grains(runner.last_folder())
            expected = expected or digest
            good = digest == expected and grains == COUNT and steps >= arguments.sub_steps
            wrong += not good
            seconds = time.monotonic() - start
            print(f"{str(way):36} {digest} {steps} sub-steps {grains} grains {seconds:7.1f} s {'' if good else 'WRONG'}", flush=True)
    print(f"{wrong} ways went wrong" if wrong else "all ways gave the same bits, and no grain was lost")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
