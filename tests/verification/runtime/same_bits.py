# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Whether the final state of a run is the same to the last bit for any ranks, threads, executor and restart.

same_bits.py ISAGO [--long] [--case NAME]: runs scenes in many ways and compares `isago digest`; prints the matrix.
"""
import argparse
import dataclasses
import pathlib
import re
import subprocess
import sys
import tempfile
import time

CONFIGS = pathlib.Path(__file__).resolve().parents[3] / "configs"

DRY_BED = """
name: dry bed on several blocks
grid:
  box: { size: [24 mm, 24 mm, 24 mm], cells: [8, 8, 8], blocks: [2, 1, 2] }
  periodic: [x]
gravity: { direction: -y }
particles:
  - { name: glass, count: 300, diameter: 2 mm, density: 2500 kg/m3, initial: { arrangement: random, velocity: [0.5 m/s, 0 m/s, 0.3 m/s] } }
contact: { law: linear, stiffness: 5 kN/m, restitution: 0.7, friction: 0.3 }
run: { until: 40 ms }
output: { checkpoint: never, results: never, pictures: never }
"""

LID = """
name: grains below a lid that moves to and fro
grid: { box: { size: [16 mm, 16 mm, 16 mm], cells: [8, 8, 8], blocks: [2, 2, 1] }, periodic: [x, z] }
fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-4 m2/s }
  boundaries: [{ at: y_high, velocity: [0.2 m/s, 0 m/s, 0 m/s], over_time: { frequency: 200 Hz } }]
gravity: { direction: -y }
particles: [{ name: grains, count: 60, diameter: 2 mm, density: 2000 kg/m3 }]
contact: { stiffness: 500 N/m }
run: { until: 10 ms, time_step: 0.5 ms }
output: { checkpoint: never, results: never, pictures: never }
"""


SECTOR = """
name: a sector whose ends are joined by a turn
grid:
  annulus: { inner_diameter: 20 mm, outer_diameter: 40 mm, length: 20 mm, angle: 60 degrees, cells_along: 8, cells_outwards: 8,
             cells_around: 4, blocks_along: 2, blocks_outwards: 1, blocks_around: 2 }
  periodic: [axial]
  turn: { angle: 60 degrees }
fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-4 m2/s }
  boundaries: [{ at: inner, spin: { rate: 10 rad/s }, over_time: { frequency: 20 Hz } }]
  drive: { bulk_velocity: 0.1 m/s }
  scalars: [{ name: dye, diffusivity: 1e-5 m2/s, initial: 1 }]
run: { until: 40 ms, time_step: 2 ms }
output: { checkpoint: never, results: never, pictures: never }
"""


@dataclasses.dataclass
class Case:
    """A scene, and times [ms] at which to stop: in the middle, for restarts, and at the end."""

    scene: str
    settings: list
    middle: float
    end: float


QUIET = ["output.checkpoint=never", "output.results=never", "output.pictures=never"]


def cases(long):
    """Small scenes: the long part has more of them and goes through all ways."""
    grains = ["particles.S.count=80", "particles.L.count=40", "run.settle=5 ms"]
    pipe = ["grid.pipe.size=small", *grains, "run.time_step=0.1 ms", *QUIET]
    pipe_file = str(CONFIGS / "pipe_oscillating")
    few = ["particles.S.count=10", "particles.L.count=5", "run.settle=0 ms", "coupling.mode=concurrent"]
    all_cases = {"pipe": Case(pipe_file, pipe, 1, 2), "coarse": Case(pipe_file, [*pipe, "coupling.mode=coarse"], 1, 2),
                 "few": Case(pipe_file, [*pipe, *few], 1, 2), "dry": Case(DRY_BED, [], 4, 8)}
    turbulent = ["fluid.turbulence.model=k-epsilon", "fluid.turbulence.speed=0.5 m/s"]  # it spreads grains at random
    all_cases["volumes"] = Case(pipe_file, [*pipe, *turbulent, "fluid.advection=finite_volume"], 1, 2)
    forces = ["drag=beetstra", "added_mass=zuber", "shear_lift=on", "history=on", "own_disturbance=on"]  # and, with them, a mixture of sizes
    all_cases["forces"] = Case(pipe_file, [*pipe, *(f"coupling.{f}" for f in forces)], 1, 2)
    all_cases["lid"] = Case(LID, [], 4, 8)
    all_cases["sector"] = Case(SECTOR, [], 10, 20)
    # The same pipe, its flow prescribed: keys of a drive exclude each other, so the text has another one.
    text = pathlib.Path(pipe_file, "scene.yaml").read_text()
    drive = "drive: { bulk_velocity: 0.5 m/s, over_time: { frequency: 40 Hz, mean: 1, amplitude: 0.5 } }"
    all_cases["flow"] = Case(re.sub(r"drive: *\{[^{}]*\{[^{}]*\}[^{}]*\}", drive, text), pipe, 1, 2)
    if long:
        seed = ["grid.pipe.size=small", "run.settle=50 ms", *QUIET]  # all 1,600 grains, time step by its limits, past a reversal
        all_cases["seed"] = Case(pipe_file, seed, 30, 60)
        all_cases["fluid"] = Case(str(CONFIGS / "pipe_womersley"), [*QUIET, "output.metrics=never", "grid.pipe.cells.across=12"], 25, 50)
    return all_cases


@dataclasses.dataclass(frozen=True)
class Way:
    """How a case is run; `then` is the way in which it goes on after a stop in the middle."""

    ranks: int = 1
    threads: int = 1
    executor: str = "serial"
    then: "Way | None" = None

    def __str__(self):
        text = f"{self.ranks} x {self.threads} {self.executor}"
        return text if self.then is None else f"{text}, stop, {self.then}"


def ways(long):
    """All ways; the first is the one that the others are compared with."""
    if not long:
        yield from (Way(), Way(1, 2, "tbb"), Way(1, 2, "openmp"), Way(2, 1, "serial"), Way(2, 2, "tbb"))
        yield from (Way(2 - seed % 2, 1, f"shuffle:{seed}") for seed in (1, 2, 3))
        yield from (Way(1, 1, "serial", Way(2, 1, "tbb")), Way(2, 1, "openmp", Way()))
        return
    for ranks in (1, 2, 4):
        for threads in (1, 2):
            for executor in ("serial", "openmp", "tbb"):
                yield Way(ranks, threads, executor)
    for seed in range(1, 21):
        yield Way((1, 2, 4)[seed % 3], 1 + seed % 2, f"shuffle:{seed}")
    for before, after in ((1, 1), (1, 2), (2, 1), (4, 2), (2, 4), (4, 1)):
        yield Way(before, 1, "tbb", Way(after, 1, "tbb"))


class Runner:
    def __init__(self, isago, folder, timeout=1800):
        self.isago, self.folder, self.timeout, self.count = isago, pathlib.Path(folder), timeout, 0

    def isago_run(self, case, way, folder, *words):
        command = [self.isago, "run", self.scene(case), "-o", str(folder), "--ranks", str(way.ranks), "--threads", str(way.threads),
                   "--executor", way.executor, *words]
        for setting in case.settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True, timeout=self.timeout)
        if done.returncode != 0:
            raise RuntimeError(f"exit code {done.returncode} of {' '.join(command)}\n{done.stdout[-1000:]}{done.stderr[-2000:]}")

    def last_folder(self):
        return self.folder / str(self.count)

    def scene(self, case):
        if "\n" not in case.scene:
            return case.scene
        file = self.folder / f"{abs(hash(case.scene))}.yaml"
        file.write_text(case.scene)
        return str(file)

    def digest(self, case, way):
        self.count += 1
        folder = self.last_folder()
        if way.then is None:
            self.isago_run(case, way, folder, "--until", f"{case.end} ms")
        else:
            self.isago_run(case, way, folder, "--until", f"{case.middle} ms")
            self.isago_run(case, way.then, folder, "--until", f"{case.end} ms", "--restart")
        return subprocess.run([self.isago, "digest", str(folder)], capture_output=True, text=True, check=True).stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("isago")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--case")
    arguments = parser.parse_args()
    different = 0
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(arguments.isago, folder)
        for name, case in cases(arguments.long).items():
            if arguments.case not in (None, name):
                continue
            expected = None
            for way in ways(arguments.long):
                start = time.monotonic()
                try:
                    digest = runner.digest(case, way)
                except (RuntimeError, subprocess.SubprocessError) as error:
                    digest = f"failed: {error}"
                expected = expected or digest
                same = digest == expected and not digest.startswith("failed")
                different += not same
                print(f"{name:6} {str(way):42} {digest} {time.monotonic() - start:6.1f} s {'' if same else 'DIFFERENT'}", flush=True)
    print(f"{different} ways gave other bits" if different else "all ways gave the same bits")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
