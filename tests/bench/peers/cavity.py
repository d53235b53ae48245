# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""A cube of water under a moving lid at Re = 1000, from rest: OpenFOAM's icoFoam and ours, seconds per step.

Equal steps (0.32 of a cell per step at the lid). icoFoam solves pressure to 1e-6 of its norm twice a step; we leave in a cell
1e-6 of the flux through it.
"""
import os
import re
import shutil
import statistics
import sys

import foam_pipe as foam
from measure import REPEATS, number, run

SIDE, SPEED, VISCOSITY = 0.1, 0.1, 1e-5  # [m], [m/s], [m2/s]


def step_of(cells):
    return 0.32 * SIDE / (cells * SPEED)


def write_case(case, cells, size, flow, sides="wall"):
    """Grid, start and fluid of a box under a moving lid.

    sides: what the two sides across z are: wall, or empty for a flow in two dimensions.
    """
    (nx, ny, nz), (x1, y1, z1) = cells, size
    corners = " ".join(f"({x} {y} {z})" for z in (0, z1) for x, y in ((0, 0), (x1, 0), (x1, y1), (0, y1)))
    foam.write(case, "system/blockMeshDict", "dictionary", f"""vertices ({corners});
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {ny} {nz}) simpleGrading (1 1 1)); edges ();
boundary
(
    lid {{ type wall; faces ((3 7 6 2)); }}
    rest {{ type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0)); }}
    sides {{ type {sides}; faces ((0 3 2 1) (4 5 6 7)); }}
);""")
    at_sides = {"wall": ("type noSlip;", "type zeroGradient;"), "empty": ("type empty;", "type empty;")}[sides]
    foam.write(case, "0/U", "volVectorField", f"""dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField {{ lid {{ type fixedValue; value uniform ({flow['speed']} 0 0); }} rest {{ type noSlip; }} sides {{ {at_sides[0]} }} }}""")
    foam.write(case, "0/p", "volScalarField", f"""dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField {{ "(lid|rest)" {{ type zeroGradient; }} sides {{ {at_sides[1]} }} }}""")
    foam.write(case, "constant/transportProperties", "dictionary", f"nu [0 2 -1 0 0 0 0] {flow['viscosity']};")


def icofoam(cells, steps, cores):
    case = f"cavity.{cells}.{cores}"
    shutil.rmtree(case, ignore_errors=True)
    write_case(case, (cells, cells, cells), (SIDE, SIDE, SIDE), {"speed": SPEED, "viscosity": VISCOSITY})
    foam.control(case, "icoFoam", step_of(cells), steps * step_of(cells))
    foam.numerics(case, cores)
    output = foam.solve(case, "icoFoam", cores).output
    seconds = [float(word) for word in re.findall(r"ExecutionTime = ([\d.]+) s", output)]
    first = steps // 4
    return (seconds[-1] - seconds[first - 1]) / (steps - first)


def ours(cells, steps, cores):
    scene = f"isago.cavity.{cells}.{cores}"
    os.makedirs(scene, exist_ok=True)
    with open(os.path.join(scene, "scene.yaml"), "w", encoding="ascii") as stream:
        stream.write(f"""name: cube under a moving lid
grid: {{ box: {{ size: [{SIDE} m, {SIDE} m, {SIDE} m], cells: [{cells}, {cells}, {cells}], blocks: [{cores}, 1, 1] }} }}
fluid:
  water: {{ density: 1000 kg/m3, viscosity: {VISCOSITY} m2/s }}
  boundaries: [{{ at: y_high, velocity: [{SPEED} m/s, 0 m/s, 0 m/s] }}]
run: {{ until: {steps * step_of(cells)} s, time_step: {step_of(cells)} s }}
output: {{ results: every 1000 s, pictures: every 1000 s, checkpoint: every 6000 s wall }}
""")
    command = [os.path.join(os.environ["ISAGO_ROOT"], "isago"), "run", scene, "-o", f"{scene}/run", "--force", "--trace",
               "--threads", str(cores)]
    return 1e-3 * number(r"per step: wall ([\d.]+) ms", run(command, f"{scene}.log").output)


def main(cells, steps, cores):
    codes = {"icofoam": icofoam, "isago": ours}
    samples = {code: [] for code in codes}
    for _ in range(REPEATS):
        for code, measured in codes.items():
            samples[code].append(measured(cells, steps, cores))
    print(f"{cells}^3 cells, {steps} steps, {cores} core(s)")
    medians = {code: statistics.median(times) for code, times in samples.items()}
    for code, median in medians.items():
        print(f"  {code:9s} {median:8.4f} s per step (x {median / medians['icofoam']:.3f})")


if __name__ == "__main__":
    arguments = [int(word) for word in sys.argv[1:]]
    main(*(arguments + [64, 30, 1][len(arguments):]))
