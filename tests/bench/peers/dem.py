# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Settling and stirred grains: LAMMPS, LIGGGHTS and ours with the same law, step, skin and start.

Linear springs with damping and sliding friction between grains and with analytic walls: kn = 1000 N/m, kt = 2/7 kn,
gamma_n = 4960 1/s over the reduced mass (restitution 0.6 for two 2 mm grains), gamma_t = 2/7 gamma_n, mu = 0.5, forces
that never pull, step 1e-5 s, skin 0.5 mm. The states that the codes come to are printed beside the speeds; ours starts
each turn up to a nanometre elsewhere, and the spread of its states is the noise.
"""
import os
import sys

import numpy as np

import particles
from measure import REPEATS, number, rate, run, table

STEPS = {"pipe1": 50000, "pipe10": 2500, "bed1": 40000, "bed100": 200}
NORMAL, TANGENTIAL, DAMPING, DAMPING_TANGENTIAL, FRICTION, TIME_STEP = 1000, 2000 / 7, 4960, 4960 * 2 / 7, 0.5, 1e-5
LAW = f"{NORMAL} {TANGENTIAL:.6g} {DAMPING} {DAMPING_TANGENTIAL:.6g} {FRICTION} 1"

COMMON_HEAD = """units si
newton off
boundary {boundary}
"""
COMMON_TAIL = """neigh_modify delay 0 every 1 check yes
fix gravity all gravity 9.81 vector {gravity}
fix move all nve/sphere
timestep {time_step}
compute touching all contact/atom
compute contacts all reduce ave c_touching
compute height all reduce ave {up}
thermo_style custom step atoms ke c_height c_contacts
thermo {every}
thermo_modify norm no lost error
run {steps}
{dump}
"""
LAMMPS = "atom_style sphere\n" + COMMON_HEAD + """comm_modify vel yes
read_data {scene}.data
neighbor 0.0005 bin
pair_style gran/hooke/history {law} limit_damping
pair_coeff * *
fix wall all wall/gran hooke/history {law} limit_damping {lammps_wall}
""" + COMMON_TAIL
LIGGGHTS = "atom_style granular\natom_modify map array\ncommunicate single vel yes\n" + COMMON_HEAD + """read_data {scene}.data
neighbor 0.0005 bin
fix p1 all property/global kn peratomtypepair 1 {normal}
fix p2 all property/global kt peratomtypepair 1 {tangential}
fix p3 all property/global gamman peratomtypepair 1 {damping}
fix p4 all property/global gammat peratomtypepair 1 {damping_tangential}
fix p5 all property/global coefficientFriction peratomtypepair 1 {friction}
pair_style gran model hooke/stiffness tangential history limitForce on
pair_coeff * *
fix wall all wall/gran model hooke/stiffness tangential history primitive type 1 {liggghts_wall} limitForce on
""" + COMMON_TAIL
PIPE = {"boundary": "f f p", "gravity": "0 -1 0", "up": "y",
        "lammps_wall": "zcylinder 0.025", "liggghts_wall": "zcylinder 0.025 0 0"}
BED = {"boundary": "p p f", "gravity": "0 0 -1", "up": "z",
       "lammps_wall": "zplane 0 NULL", "liggghts_wall": "zplane 0"}


def deck(template, scene, steps, dump=""):
    """Writes the input file of one code and returns its name."""
    name = f"in.{'lammps' if template is LAMMPS else 'liggghts'}.{scene}"
    with open(name, "w", encoding="ascii") as stream:
        stream.write(template.format(
            scene=scene, steps=steps, every=max(1, steps // 25), dump=dump, law=LAW, normal=NORMAL,
            tangential=f"{TANGENTIAL:.6g}", damping=DAMPING, damping_tangential=DAMPING_TANGENTIAL, friction=FRICTION,
            time_step=TIME_STEP, **(PIPE if scene.startswith("pipe") else BED)))
    return name


def settle(scene):
    """Runs the loose scene to rest with LAMMPS; places and diameters in the order of the grains."""
    dump = f"write_dump all custom {scene}.settled id diameter x y z modify sort id format float %.10g"
    run(["lmp", "-in", deck(LAMMPS, scene, STEPS[scene], dump), "-log", "none"], f"{scene}.settle.log")
    rows = np.loadtxt(f"{scene}.settled", skiprows=9)
    return rows[:, 2:5], rows[:, 1]


def peer(program, template):
    """@returns a function that runs the code once: (seconds, busy, foreign), (mm, contacts per grain, J)."""
    def measured(scene, steps, cores, _turn):
        result = run([program, "-in", deck(template, scene, steps), "-log", "none"], f"{program}.{scene}.log", cores)
        seconds = number(r"^Loop time of ([\d.e+-]+) ", result.output)
        row = [line.split() for line in result.output.splitlines() if line.strip().startswith(f"{steps} ")][-1]
        return (seconds, result.busy(cores), result.foreign), (1e3 * float(row[3]), float(row[4]), float(row[2]))

    return measured


def ours(wall):
    program = os.path.join(os.environ["ISAGO_ROOT"], "build/release/tests/dem_bench")

    def measured(scene, steps, cores, turn):
        kind = "pipe" if scene.startswith("pipe") else "bed"
        command = [program, f"{scene}.txt", kind, str(steps), f"threads={cores}", f"wall={wall}", f"shift={turn}"]
        output = (result := run(command, f"isago.{scene}.log")).output
        seconds, cpu = (number(pattern, output) for pattern in (r"threads: ([\d.]+) s", r"CPU ([\d.]+) s"))
        state = tuple(number(f"{name} ([\\d.e+-]+)", output) for name in ("height", "per grain", "energy"))
        return (seconds, cpu / (seconds * cores), result.foreign), state

    return measured


def print_states(states):
    """Means and, where starts differ from turn to turn, half the range of the turns."""
    for code, turns in states.items():
        values = np.array(turns)
        middle, half = (values.max(axis=0) + values.min(axis=0)) / 2, np.ptp(values, axis=0) / 2
        columns = (("mean height", "{:.4f} +- {:.4f} mm"), ("contacts per grain", "{:.4f} +- {:.4f}"), ("kinetic energy", "{:.4g} +- {:.1g} J"))
        print(f"  {code:9s}", "; ".join(f"{name} " + form.format(m, h) for (name, form), m, h in zip(columns, middle, half)))


def main(scenes, steps, cores):
    codes = {"lammps": peer("lmp", LAMMPS), "liggghts": peer("liggghts", LIGGGHTS)}
    if os.path.exists(os.path.join(os.environ["ISAGO_ROOT"], "build/release/tests/dem_bench")):
        codes |= {"isago": ours("primitive"), "on faces": ours("faces")}
    else:
        print("build/release/tests/dem_bench is not built: the other codes alone")
    for scene in scenes:
        particles.prepare(scene, settle)
        count, turns = len(np.loadtxt(f"{scene}.txt")), steps or STEPS[scene]
        here = {code: measured for code, measured in codes.items() if code != "on faces" or scene.startswith("pipe")}
        samples, states = ({code: [] for code in here} for _ in range(2))
        for turn in range(REPEATS):
            for code, measured in here.items():
                times, state = measured(scene, turns, cores, turn)
                samples[code].append(rate(count * turns / 1e6, *times))
                states[code].append(state)
        table(f"{scene}: {count} grains, {turns} steps, {cores} core(s)", "million grain-steps/s", samples)
        print_states(states)


if __name__ == "__main__":
    main(sys.argv[1:2] or ["pipe1", "pipe10", "bed100"], int((sys.argv[2:3] or [0])[0]), int((sys.argv[3:4] or [1])[0]))
