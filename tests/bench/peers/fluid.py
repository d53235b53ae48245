# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Oscillating laminar flow in the same pipe without grains: OpenFOAM's icoFoam."""
import math
import shutil
import sys

import foam_pipe as foam
from measure import REPEATS, rate, table

CELLS, STEP, STEPS = 102400, 3e-4, 40  # -, [s], -
VISCOSITY, SPEED = 1e-4, 1.5  # [m2/s], amplitude of the flow without walls [m/s]


def icofoam(cores):
    case = f"icofoam.{cores}"
    shutil.rmtree(case, ignore_errors=True)
    frequency = 1 / foam.PERIOD
    amplitude = SPEED * 2 * math.pi * frequency * foam.LENGTH
    foam.pipe_grid(case, foam.GRIDS[CELLS], wall_grading=0.4)
    foam.control(case, "icoFoam", STEP, STEPS * STEP)
    foam.numerics(case, cores)
    foam.velocity_field(case, "U")
    foam.pressure_field(case, "type zeroGradient;", {
        "shape": "sine",
        "values": f"frequency {frequency:.12g}; amplitude {amplitude:.12g}; scale 1; level 0; t0 {-foam.PERIOD / 4};"})
    foam.write(case, "constant/transportProperties", "dictionary", f"nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    return foam.solve(case, "icoFoam", cores)


def main(cores):
    samples = []
    for _ in range(REPEATS):
        result = icofoam(cores)
        samples.append(rate(CELLS * STEPS / 1e6, result.wall, result.busy(cores), result.foreign))
    table(f"{CELLS} cells, {STEPS} steps of {STEP} s, {cores} core(s)", "million cell-steps/s", {"icofoam": samples})


if __name__ == "__main__":
    main(int((sys.argv[1:2] or [1])[0]))
