# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Error against core-seconds, OpenFOAM's icoFoam and ours, over cells and steps: a cavity at Re = 1000 and Womersley's pipe.

Both start from rest and end at the same time. The cavity's error is the root mean square difference to a converged steady flow on the
middle lines, over the lid's speed; at the end, after 40 passages of the lid, the flow has settled. The pipe's is the root mean square
difference to the exact flow at eight phases of the second period, over the largest speed. icoFoam: linear schemes, second order in time
(backward), GAMG, two correctors. Times are processor seconds of the whole run, start
and output too; runs that blow up are left out. Writes accuracy.NAME.csv and .svg.
"""
import csv
import math
import os
import shutil
import sys

import numpy as np

import cavity
import foam_pipe as foam
from accuracy_picture import draw, front
from measure import run

RADIUS, LENGTH, PERIOD, SPEED = foam.RADIUS, foam.LENGTH, foam.PERIOD, 1.5  # [m], [m], [s], without walls [m/s]
PIPE_VISCOSITY = 1e-3  # [m2/s]: Womersley number 4.7
# Places on a middle line of the unit cavity and velocities there over the lid's, across the line.
# From stream function and vorticity on 512 x 512 points, extrapolated; agrees with Botella & Peyret (1998) within 2e-5.
BELOW_LID = {0.0547: -0.18128, 0.0625: -0.20232, 0.0703: -0.22289, 0.1016: -0.30045, 0.1719: -0.38856, 0.2813: -0.28036,
             0.4531: -0.10819, 0.5000: -0.06205, 0.6172: 0.05702, 0.7344: 0.18867, 0.8516: 0.33721, 0.9531: 0.47230,
             0.9609: 0.51688, 0.9688: 0.58079, 0.9766: 0.66437}
FROM_SIDE = {0.0625: 0.28068, 0.0703: 0.29625, 0.0781: 0.30989, 0.0938: 0.33302, 0.1563: 0.37690, 0.2266: 0.33398,
             0.2344: 0.32535, 0.5000: 0.02580, 0.8047: -0.32020, 0.8594: -0.42644, 0.9063: -0.52643, 0.9453: -0.41037,
             0.9531: -0.35531, 0.9609: -0.29368, 0.9688: -0.22792}


def foam_numbers(path):
    """A field of OpenFOAM in ASCII: rows of numbers."""
    with open(path, encoding="ascii") as stream:
        text = stream.read()
    body = text[text.index("nonuniform"):]
    body = body[body.index("(") + 1:]
    body = body[:body.index("\n)")]
    return np.array([[float(word) for word in line.strip("()").split()] for line in body.split("\n") if line.strip()])


def our_results(folder):
    """[(time, velocity)], and the corners of the cells: (cells, 8, 3)."""
    import h5py  # not needed for OpenFOAM alone
    with h5py.File(f"{folder}/results/grid.h5") as stream:
        grid = stream["grid"]
        first = np.concatenate([[0], np.cumsum(grid["NumberOfPoints"][:])[:-1]])  # points count from 0 in each block
        cells = grid["Connectivity"][:].reshape(-1, 8) + np.repeat(first, grid["NumberOfCells"][:])[:, None]
        corners = grid["Points"][:][cells]
    states = []
    for name in sorted(os.listdir(f"{folder}/results")):
        if name.endswith(".hdf"):
            with h5py.File(f"{folder}/results/{name}") as stream:
                states.append((float(stream["meta"].attrs["time"]), stream["VTKHDF/CellData/velocity"][:]))
    return states, corners


# --- cavity -----------------------------------------------------------------------------------------------------------------------

def on_line(places, values, wanted):
    """Cubic interpolation between cell centres."""
    result = []
    for x in wanted:
        first = min(max(np.searchsorted(places, x) - 2, 0), len(places) - 4)
        near = places[first:first + 4]
        weights = [np.prod([(x - near[m]) / (near[n] - near[m]) for m in range(4) if m != n]) for n in range(4)]
        result.append(np.dot(weights, values[first:first + 4]))
    return np.array(result)


def cavity_error(cells, velocity):
    """@param velocity  (cells * cells, 2 or 3), x fastest, over the lid's speed."""
    u = velocity[:, 0].reshape(cells, cells)
    v = velocity[:, 1].reshape(cells, cells)
    places = (np.arange(cells) + 0.5) / cells
    across = on_line(places, [on_line(places, row, [0.5])[0] for row in u], BELOW_LID)
    down = on_line(places, [on_line(places, column, [0.5])[0] for column in v.T], FROM_SIDE)
    off = np.concatenate([across - list(BELOW_LID.values()), down - list(FROM_SIDE.values())])
    return math.sqrt(np.mean(off**2))


def cavity_icofoam(cells, courant, until=40.0):
    case = f"accuracy.cavity.{cells}.{courant}"
    shutil.rmtree(case, ignore_errors=True)
    cavity.write_case(case, (cells, cells, 1), (1.0, 1.0, 1.0 / cells), {"speed": 1.0, "viscosity": 1e-3}, "empty")
    foam.control(case, "icoFoam", courant / cells, until, until)
    foam.numerics(case, 1, "backward")
    seconds = foam.solve(case, "icoFoam", 1).cpu
    return seconds, cavity_error(cells, foam_numbers(f"{case}/{until:g}/U"))


def cavity_ours(cells, courant, advection="lcsi", until=40.0):
    scene = f"accuracy.{advection}.cavity.{cells}.{courant}"
    result = run_ours(scene, f"""name: cavity
grid: {{ box: {{ size: [1 m, 1 m, {1 / cells} m], cells: [{cells}, {cells}, 1] }}, periodic: [z] }}
fluid:
  oil: {{ density: 1 kg/m3, viscosity: 1e-3 m2/s }}
  advection: {advection}
  boundaries: [{{ at: y_high, velocity: [1 m/s, 0 m/s, 0 m/s] }}]
run: {{ until: {until} s, time_step: {courant / cells} s }}
output: {{ results: every {until} s, checkpoint: every 6000 s wall }}
""")
    states, corners = our_results(f"{scene}/run")
    centres = corners.mean(axis=1)
    order = np.lexsort((np.round(centres[:, 0] * cells * 2), np.round(centres[:, 1] * cells * 2)))
    return result.cpu, cavity_error(cells, states[-1][1][order])


def run_ours(scene, text):
    os.makedirs(scene, exist_ok=True)
    with open(os.path.join(scene, "scene.yaml"), "w", encoding="ascii") as stream:
        stream.write(text)
    program = os.path.join(os.environ["ISAGO_ROOT"], "build/release/io/isago")  # run.sh has just built it
    return run([program, "run", scene, "-o", f"{scene}/run", "--force", "--threads", "1"], f"{scene}.log")


# --- pipe -------------------------------------------------------------------------------------------------------------------------

PHASES = [PERIOD * (1 + n / 8) for n in range(1, 9)]


def exact_pipe(times, points=600, steps=2400):
    """Axial velocity from rest under A cos(w t) at radii and times: implicit midpoint rule on fine rings."""
    omega = 2 * math.pi / PERIOD
    h, dt = RADIUS / points, 2 * PERIOD / steps
    r, faces = (np.arange(points) + 0.5) * h, np.arange(points + 1) * h
    low, high = PIPE_VISCOSITY * faces[:-1] / (r * h * h), PIPE_VISCOSITY * faces[1:] / (r * h * h)
    diagonal = -(low + high)
    diagonal[-1] -= high[-1]
    a, b, c = -0.5 * dt * low, 1 - 0.5 * dt * diagonal, -0.5 * dt * high
    factor = np.empty(points)
    pivot = np.empty(points)
    pivot[0] = b[0]
    for n in range(1, points):
        factor[n] = a[n] / pivot[n - 1]
        pivot[n] = b[n] - factor[n] * c[n - 1]
    u, found = np.zeros(points), {}
    for step in range(steps):
        right = u + 0.5 * dt * diagonal * u + dt * SPEED * omega * math.cos(omega * (step + 0.5) * dt)
        right[1:] += 0.5 * dt * low[1:] * u[:-1]
        right[:-1] += 0.5 * dt * high[:-1] * u[1:]
        for n in range(1, points):
            right[n] -= factor[n] * right[n - 1]
        u = right
        u[-1] /= pivot[-1]
        for n in range(points - 2, -1, -1):
            u[n] = (u[n] - c[n] * u[n + 1]) / pivot[n]
        for t in times:
            if abs((step + 1) * dt - t) < 0.1 * dt:
                found[t] = u.copy()
    return r, found


def pipe_error(exact, radii, volumes, states):
    """@param states  {time: axial velocity of the cells}."""
    r, found = exact
    squares = [np.sum(volumes * (states[t] - np.interp(radii, r, found[t]))**2) / np.sum(volumes) for t in PHASES]
    return math.sqrt(np.mean(squares)) / max(np.abs(u).max() for u in found.values())


def pipe_icofoam(cells, steps, exact):
    case = f"accuracy.pipe.{cells}.{steps}"
    shutil.rmtree(case, ignore_errors=True)
    omega = 2 * math.pi / PERIOD
    foam.pipe_grid(case, (cells // 2, cells // 4, 2))
    foam.control(case, "icoFoam", PERIOD / steps, 2 * PERIOD, PERIOD / 8)
    foam.numerics(case, 1, "backward")
    foam.velocity_field(case, "U")
    foam.pressure_field(case, "type zeroGradient;", {
        "shape": "sine",
        "values": f"frequency {1 / PERIOD:.12g}; amplitude {SPEED * omega * LENGTH:.12g}; scale 1; level 0; t0 {-PERIOD / 4};"})
    foam.write(case, "constant/transportProperties", "dictionary", f"nu [0 2 -1 0 0 0 0] {PIPE_VISCOSITY};")
    seconds = foam.solve(case, "icoFoam", 1).cpu
    run(["postProcess", "-case", case, "-time", f"{PHASES[-1]:g}", "-funcs", "(writeCellCentres writeCellVolumes)"], f"{case}.centres.log")
    centres, volumes = foam_numbers(f"{case}/{PHASES[-1]:g}/C"), foam_numbers(f"{case}/{PHASES[-1]:g}/V")[:, 0]
    states = {t: foam_numbers(f"{case}/{t:.10g}/U")[:, 2] for t in PHASES}
    sign = np.sign(np.sum(states[PHASES[-1]] * np.interp(np.hypot(centres[:, 0], centres[:, 1]), exact[0], exact[1][PHASES[-1]])))
    return seconds, pipe_error(exact, np.hypot(centres[:, 0], centres[:, 1]), volumes, {t: sign * u for t, u in states.items()})


def pipe_ours(cells, steps, exact):
    scene = f"accuracy.isago.pipe.{cells}.{steps}"
    gradient = 1000 * SPEED * 2 * math.pi / PERIOD
    result = run_ours(scene, f"""name: oscillating flow
grid: {{ pipe: {{ diameter: {2 * RADIUS} m, length: {LENGTH} m, cells: {{ across: {cells}, along: 2 }}, blocks_along: 1 }}, periodic: [axial] }}
fluid:
  oil: {{ density: 1000 kg/m3, viscosity: {PIPE_VISCOSITY} m2/s }}
  drive: {{ pressure_gradient: {gradient:.12g} Pa/m, frequency: {1 / PERIOD:.15g} Hz }}
run: {{ until: {2 * PERIOD} s, time_step: {PERIOD / steps:.15g} s }}
output: {{ results: every {PERIOD / 8} s, checkpoint: every 6000 s wall }}
""")
    found, corners = our_results(f"{scene}/run")
    axis = int(np.argmax([np.abs(found[-1][1][:, c]).max() for c in range(3)]))
    others = [c for c in range(3) if c != axis]
    flat = corners.mean(axis=1)[:, others]
    middle = 0.5 * (corners.reshape(-1, 3).max(axis=0) + corners.reshape(-1, 3).min(axis=0))[others]
    radii = np.hypot(*(flat - middle).T)
    states = {t: min(found, key=lambda s: abs(s[0] - t))[1][:, axis] for t in PHASES}
    return result.cpu, pipe_error(exact, radii, volumes_of(corners), states)


def volumes_of(corners):
    """Of hexahedra with straight edges, from the vectors between opposite sides."""
    lines = [corners[:, [1, 2, 6, 5]].mean(1) - corners[:, [0, 3, 7, 4]].mean(1),
             corners[:, [3, 2, 6, 7]].mean(1) - corners[:, [0, 1, 5, 4]].mean(1),
             corners[:, 4:].mean(1) - corners[:, :4].mean(1)]
    return np.abs(np.einsum("ij,ij->i", lines[0], np.cross(lines[1], lines[2])))


# --- both -------------------------------------------------------------------------------------------------------------------------

SIZES = (12, 16, 20, 24, 28, 32, 40, 48, 56, 64)  # close enough for runs of either code with the same error
CASES = {
    # icoFoam is implicit: to a flow that settles it comes in longer steps too, as accurately, until it breaks down above 4.
    "cavity": {"icofoam": [(n, c) for n in SIZES for c in (0.5, 1.0, 2.0, 4.0)],
               "isago": [(n, 1.0) for n in SIZES],
               "isago finite_volume": [(n, c) for n in SIZES for c in (0.5, 1.0)]},
    "womersley": {"icofoam": [(n, s) for n in (16, 32, 64) for s in (40, 80, 160, 320)],
                  "isago": [(n, s) for n in (16, 32, 64) for s in (16, 40, 80, 160)]},
}


def say_where_we_stand(rows):
    theirs, ours = (front([row for row in rows if (row["code"] == "icofoam") == is_theirs]) for is_theirs in (True, False))
    for their in theirs:
        as_good = [our["seconds"] for our in ours if our["error"] <= their["error"]]
        as_quick = [our["error"] for our in ours if our["seconds"] <= their["seconds"]]
        print(f"  icoFoam {their['error']:.2e} in {their['seconds']:.1f} s; ours: the same error in "
              + (f"{min(as_good) / their['seconds']:.2f} of the time" if as_good else "no run")
              + (f", in the same time {min(as_quick) / their['error']:.2f} of the error" if as_quick else ""))


def main(names):
    for name in names or CASES:
        exact = (exact_pipe(PHASES),) if name == "womersley" else ()
        solvers = {"icofoam": (cavity_icofoam, pipe_icofoam), "isago": (cavity_ours, pipe_ours),
                   "isago finite_volume": (lambda n, c: cavity_ours(n, c, "finite_volume"), None)}
        rows = []
        # By size, one code after the other: a machine that others keep busy is slow for both.
        runs = sorted(((code, *choice) for code, choices in CASES[name].items() for choice in choices), key=lambda run: run[1])
        for code, cells, second in runs:
            try:
                seconds, error = solvers[code][0 if name == "cavity" else 1](cells, second, *exact)
            except (SystemExit, OSError) as stopped:  # icoFoam that blows up leaves nothing to read, or stops
                print(name, code, cells, second, "did not finish:", str(stopped).splitlines()[0], flush=True)
                continue
            rows.append({"code": code, "cells": cells, "courant" if name == "cavity" else "steps": second, "seconds": seconds,
                         "error": error})
            print(name, rows[-1], flush=True)
        with open(f"accuracy.{name}.csv", "w", encoding="ascii", newline="") as stream:
            writer = csv.DictWriter(stream, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
        draw(f"accuracy.{name}.svg", name, rows)
        say_where_we_stand(rows)


if __name__ == "__main__":
    main(sys.argv[1:])
