# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Writes OpenFOAM cases of the pipe (R = 25 mm, L = 90 mm, axis z, periodic), a butterfly grid and the solver's files, and runs them."""
import math
import os

from measure import run

RADIUS, LENGTH, PERIOD = 0.025, 0.09, 0.18  # [m], [m], [s]
# cells along a side of the core square, from it to the wall, along the axis
GRIDS = {1920: (4, 4, 24), 20160: (8, 7, 70), 102400: (16, 16, 80)}


def solve(case, solver, cores):
    """Makes the grid of a case that is written, splits it for the cores and runs the solver."""
    run(["blockMesh", "-case", case], f"{case}.grid.log")
    parallel = []
    if cores > 1:
        run(["decomposePar", "-case", case], f"{case}.split.log")
        parallel = ["-parallel"]
    return run([solver, *parallel, "-case", case], f"{case}.log", cores)


def write(case, name, kind, text):
    path = os.path.join(case, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as stream:
        stream.write(f"FoamFile {{ version 2.0; format ascii; class {kind}; object {os.path.basename(name)}; }}\n{text}\n")


def arcs(circle):
    """The four quarter arcs of each end; their middles lie on the coordinate axes."""
    lines = []
    for end, z in enumerate((0.0, LENGTH)):
        for i, (x, y) in enumerate([(0, -RADIUS), (RADIUS, 0), (0, RADIUS), (-RADIUS, 0)]):
            lines.append(f"arc {8 * end + circle + i} {8 * end + circle + (i + 1) % 4} ({x} {y} {z})")
    return "\n".join(lines)


def pipe_grid(case, grid, wall_grading=1.0):
    """blockMeshDict: a square core of half the radius and four blocks around it.

    grid: cells along a side of the core, from it to the wall, along the axis.
    """
    across, outwards, along = grid
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    core, wall = 0.5 * RADIUS / math.sqrt(2), RADIUS / math.sqrt(2)
    vertices = [(side * x, side * y, z) for z in (0.0, LENGTH) for side in (core, wall) for x, y in corners]
    blocks = [f"hex (0 1 2 3 8 9 10 11) ({across} {across} {along}) simpleGrading (1 1 1)"]
    ends, sides = ["(0 1 2 3)"], []
    for i in range(4):
        j = (i + 1) % 4
        base = [j, i, 4 + i, 4 + j]
        blocks.append(f"hex ({' '.join(map(str, base + [8 + v for v in base]))}) ({across} {outwards} {along})"
                      f" simpleGrading (1 {wall_grading} 1)")
        ends.append(f"({i} {j} {4 + j} {4 + i})")
        sides.append(f"({4 + i} {4 + j} {12 + j} {12 + i})")
    far_ends = [f"({' '.join(str(int(v) + 8) for v in face.strip('()').split())})" for face in ends]
    points = " ".join("({:.10g} {:.10g} {:.10g})".format(*v) for v in vertices)
    newline = "\n"
    write(case, "system/blockMeshDict", "dictionary", f"""vertices ({points});
blocks ({newline.join(blocks)});
edges ({arcs(4)});
boundary
(
    inlet {{ type cyclic; neighbourPatch outlet; faces ({' '.join(ends)}); }}
    outlet {{ type cyclic; neighbourPatch inlet; faces ({' '.join(far_ends)}); }}
    wall {{ type wall; faces ({' '.join(sides)}); }}
);""")


def control(case, solver, step, until, every=1e9):
    write(case, "system/controlDict", "dictionary", f"""application {solver}; startFrom startTime; startTime 0;
stopAt endTime; endTime {until:.10g}; deltaT {step:.15g}; writeControl runTime; writeInterval {every:.10g}; writeFormat ascii;
timeFormat general; timePrecision 10; runTimeModifiable no;""")


def numerics(case, cores, in_time="Euler"):
    """Second order in space, PISO with two correctors, GAMG to 1e-6."""
    write(case, "system/fvSchemes", "dictionary", f"""ddtSchemes {{ default {in_time}; }}
gradSchemes {{ default Gauss linear; }}
divSchemes
{{
    default none;
    div(phi,U) Gauss linear;
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
    div(alphaPhi.water,U.water) Gauss linearUpwindV unlimited;
    div(((alpha.water*nuEff.water)*dev2(T(grad(U.water))))) Gauss linear;
}}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}""")
    pressure = "solver GAMG; smoother DICGaussSeidel; nCellsInCoarsestLevel 50; tolerance 1e-6;"
    velocity = "solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0;"
    loop = "nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0;"
    write(case, "system/fvSolution", "dictionary", f"""solvers
{{
    "(p|kinematicCloud:theta)" {{ {pressure} relTol 0.05; }}
    "(p|kinematicCloud:theta)Final" {{ {pressure} relTol 0; }}
    "(U|U.water)" {{ {velocity} }}
    "(U|U.water)Final" {{ {velocity} }}
}}
PISO {{ {loop} }}
PIMPLE {{ nOuterCorrectors 1; momentumPredictor yes; {loop} }}""")
    write(case, "system/decomposeParDict", "dictionary",
          f"numberOfSubdomains {cores}; method simple; simpleCoeffs {{ n ({cores} 1 1); delta 1e-4; }}")


def pressure_field(case, wall, drive):
    """p / density with a jump over the periodic ends: these solvers have no body force."""
    jump = f"jumpTable {drive['shape']}; jumpTableCoeffs {{ {drive['values']} }}"
    write(case, "0/p", "volScalarField", f"""dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField
{{
    wall {{ {wall} }}
    inlet {{ type uniformJump; patchType cyclic; {jump} value uniform 0; }}
    outlet {{ type uniformJump; patchType cyclic; value uniform 0; }}
}}""")


def velocity_field(case, name):
    write(case, f"0/{name}", "volVectorField", """dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField { wall { type noSlip; } "(inlet|outlet)" { type cyclic; } }""")
