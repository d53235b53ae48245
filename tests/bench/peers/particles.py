# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Where the particles of each scene start; the same numbers for every code."""
import os

import numpy as np

DENSITY = 2000.0  # [kg/m3]
PIPE_RADIUS, PIPE_LENGTH, BED_WIDTH = 0.025, 0.09, 0.02  # [m]
COUNT, COUNT_LARGE = 1600, 533  # 2 mm and 3 mm grains in one copy of pipe or bed
BOXES = {
    "pipe1": [(-0.026, 0.026), (-0.026, 0.026), (0.0, PIPE_LENGTH)],
    "pipe10": [(-0.026, 0.026), (-0.026, 0.026), (0.0, 10 * PIPE_LENGTH)],
    "bed1": [(0.0, BED_WIDTH), (0.0, BED_WIDTH), (0.0, 0.16)],
    "bed100": [(0.0, 10 * BED_WIDTH), (0.0, 10 * BED_WIDTH), (0.0, 0.1)],
}


def shuffled_diameters(random):
    diameter = np.full(COUNT, 0.002)
    diameter[:COUNT_LARGE] = 0.003
    return random.permutation(diameter)


def loose_pipe():
    """Grains on a shaken 3.4 mm lattice inside the pipe, at rest. Axis z."""
    random = np.random.default_rng(1)
    across = np.arange(-8, 9) * 0.0034
    along = (np.arange(26) + 0.5) * PIPE_LENGTH / 26
    x, y, z = (axis.ravel() for axis in np.meshgrid(across, across, along, indexing="ij"))
    inside = np.hypot(x, y) < PIPE_RADIUS - 0.0018
    places = random.permutation(np.stack([x, y, z], axis=1)[inside])[:COUNT]
    return places + random.uniform(-1.5e-4, 1.5e-4, places.shape), shuffled_diameters(random)


def loose_bed():
    """Grains on a shaken 3.3 mm lattice over a square floor of 20 mm, at rest."""
    random = np.random.default_rng(2)
    layer, row, column = np.unravel_index(np.arange(COUNT), (45, 6, 6))
    places = (np.stack([column, row, layer], axis=1) + 0.5) * BED_WIDTH / 6
    return places + random.uniform(-1.5e-4, 1.5e-4, places.shape), shuffled_diameters(random)


def copies(places, diameter, shifts):
    """The settled packing at every shift, stirred by up to 0.1 m/s in each direction."""
    places = np.concatenate([places + shift for shift in shifts])
    velocity = np.random.default_rng(3).uniform(-0.1, 0.1, places.shape)
    return places, np.tile(diameter, len(shifts)), velocity


def many(scene, places, diameter):
    """pipe10 or bed100 from the settled pipe1 or bed1: places, diameters, velocities; thrown down with 0.2 m/s."""
    places = places.copy()
    if scene == "pipe10":
        places[:, 2] %= PIPE_LENGTH
        result = copies(places, diameter, [(0.0, 0.0, k * PIPE_LENGTH) for k in range(10)])
        result[2][:, 1] -= 0.2
    else:
        places[:, :2] %= BED_WIDTH
        result = copies(places, diameter, [(i * BED_WIDTH, j * BED_WIDTH, 0.0) for i in range(10) for j in range(10)])
        result[2][:, 2] -= 0.2
    return result


def write(scene, places, diameter, velocity):
    """SCENE.txt (x y z radius vx vy vz, SI) and SCENE.data, the same for LAMMPS and LIGGGHTS."""
    np.savetxt(f"{scene}.txt", np.column_stack([places, diameter / 2, velocity]), fmt="%.9g",
               header=" ".join(f"{low:g} {high:g}" for low, high in BOXES[scene]))
    with open(f"{scene}.data", "w", encoding="ascii") as stream:
        print(f"{scene}\n\n{len(places)} atoms\n1 atom types\n", file=stream)
        for name, (low, high) in zip("xyz", BOXES[scene]):
            print(f"{low:.9g} {high:.9g} {name}lo {name}hi", file=stream)
        print("\nAtoms\n", file=stream)
        for i, (place, d) in enumerate(zip(places, diameter), 1):
            print(f"{i} 1 {d:.9g} {DENSITY:g} " + " ".join(f"{c:.9g}" for c in place), file=stream)
        print("\nVelocities\n", file=stream)
        for i, v in enumerate(velocity, 1):
            print(f"{i} " + " ".join(f"{c:.9g}" for c in v) + " 0 0 0", file=stream)


def prepare(scene, settle):
    """Makes SCENE.txt and SCENE.data once. settle(scene) runs a loose scene to rest and returns places, diameters."""
    if os.path.exists(f"{scene}.txt") and os.path.exists(f"{scene}.data"):
        return
    if scene in ("pipe1", "bed1"):
        places, diameter = loose_pipe() if scene == "pipe1" else loose_bed()
        write(scene, places, diameter, np.zeros_like(places))
    else:
        base = "pipe1" if scene == "pipe10" else "bed1"
        prepare(base, settle)
        write(scene, *many(scene, *settle(base)))
