# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Whether runs end well: mistakes in scenes, signals, kills, damaged checkpoints, a full disk, numbers that blow up.

faults.py ISAGO [NAME...]: runs all tests, or the named ones.
"""
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

CONFIGS = pathlib.Path(__file__).resolve().parents[3] / "configs"
PIPE = str(CONFIGS / "pipe_oscillating")
SMALL = ["grid.pipe.size=small", "particles.S.count=40", "particles.L.count=20", "run.settle=2 ms", "run.time_step=0.02 ms", "output.checkpoint=every 1 steps",
         "output.keep_checkpoints=3", "output.results=never", "output.pictures=never"]
END = ["--until", "0.6 ms"]
FAILED, WRONG_SCENE, STOPPED = 1, 2, 75


class Bench:
    def __init__(self, isago, folder):
        self.isago, self.folder = isago, folder / "run"

    def command(self, *words, settings=(), scene=PIPE):
        words = [self.isago, "run", str(scene), "-o", str(self.folder), "--threads", "1", *words]
        for setting in [*(SMALL if scene == PIPE else []), *settings]:
            words += ["--set", setting]
        return words

    def run(self, *words, settings=(), scene=PIPE, code=0):
        """Runs to the end. @returns all that it said."""
        done = subprocess.run(self.command(*words, settings=settings, scene=scene), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=300)
        expect(done.returncode == code, f"exit code {done.returncode}, not {code}:\n{done.stdout[-3000:]}")
        return done.stdout

    def start(self, *words):
        return subprocess.Popen(self.command(*words), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def checkpoints(self):
        return sorted((self.folder / "checkpoints").glob("checkpoint_*.h5"))

    def wait_for_checkpoints(self, count):
        for _ in range(1200):
            if len(self.checkpoints()) >= count:
                return
            time.sleep(0.05)
        raise AssertionError("no checkpoint came in a minute")

    def digest(self):
        return subprocess.run([self.isago, "digest", str(self.folder)], capture_output=True, text=True, check=True).stdout.strip()


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def expect_words(text, *words):
    for word in words:
        expect(word in text, f"'{word}' is missing in:\n{text[-3000:]}")


_expected = {}


def undisturbed(bench):
    """The digest of the same run without any fault."""
    if "digest" not in _expected:
        with tempfile.TemporaryDirectory() as folder:
            other = Bench(bench.isago, pathlib.Path(folder))
            other.run(*END)
            _expected["digest"] = other.digest()
    return _expected["digest"]


def expect_same_end(bench, *words):
    text = bench.run(*END, "--restart", *words)
    expect(bench.digest() == undisturbed(bench), f"the end differs from that of an undisturbed run:\n{text}")
    return text


def scene_with_mistakes(bench, folder):
    """A typo and a wrong unit are told with place and advice; particles outside the domain are refused."""
    scene = folder / "scene.yaml"
    scene.write_text((CONFIGS / "settling_bed" / "scene.yaml").read_text().replace("gravity:", "gravitty:").replace("2 mm", "2 kg"))
    text = bench.run(scene=scene, code=WRONG_SCENE)
    expect_words(text, "scene.yaml:", "gravitty", "did you mean 'gravity'", "2 kg")
    low = "particles.glass.initial.low=[90 mm, 10 mm, 10 mm]"
    text = bench.run(scene=CONFIGS / "settling_bed", settings=[low, "particles.glass.initial.high=[95 mm, 20 mm, 20 mm]"], code=WRONG_SCENE)
    expect_words(text, "domain")
    expect(not bench.folder.exists(), "a wrong scene has made a run directory")


def more_ranks_than_blocks(bench, folder):
    """Refused in one sentence, said once."""
    text = bench.run("--ranks", "3", scene=CONFIGS / "settling_bed", code=WRONG_SCENE)
    expect_words(text, "3 ranks, but the grid has only 2 blocks")
    expect(text.count("3 ranks, but") == 1, f"said more than once:\n{text}")


def second_run_in_the_same_place(bench, folder):
    """An earlier run is neither overwritten nor mixed with."""
    bench.run("--until", "0.2 ms")
    text = bench.run("--until", "0.2 ms", code=WRONG_SCENE)
    expect_words(text, "--restart", "--force")


def damaged_checkpoint(bench, folder):
    """The newest checkpoint is cut short, then the next has a changed byte: the one before is used, and it is said."""
    bench.run("--until", "0.4 ms")
    newest = bench.checkpoints()[-1]
    newest.write_bytes(newest.read_bytes()[: newest.stat().st_size * 2 // 3])
    second = bench.checkpoints()[-2]
    data = bytearray(second.read_bytes())
    data[len(data) // 2] ^= 1
    second.write_bytes(data)
    text = expect_same_end(bench)
    expect_words(text, newest.name, second.name, "damaged", "restart from")


def all_checkpoints_damaged(bench, folder):
    """Nothing is begun anew by mistake."""
    bench.run("--until", "0.2 ms")
    for path in bench.checkpoints():
        path.write_bytes(b"not a checkpoint")
    text = bench.run("--restart", code=FAILED)
    expect_words(text, "no good checkpoint")


def signals(bench, folder):
    """Ctrl-C and TERM end a run with a checkpoint and exit code 75; so they do through the ranks that the program starts."""
    for number, name, ranks, then in ((signal.SIGINT, "Ctrl-C", 1, 2), (signal.SIGTERM, "signal TERM", 2, 1)):
        shutil.rmtree(bench.folder, ignore_errors=True)
        running = bench.start(*END, "--ranks", str(ranks))
        bench.wait_for_checkpoints(1)
        running.send_signal(number)
        text, _ = running.communicate(timeout=120)
        expect(running.returncode == STOPPED, f"exit code {running.returncode} after {number.name}:\n{text}")
        expect_words(text, f"stopped by {name}")
        expect_same_end(bench, "--ranks", str(then))


def stopped_while_settling(bench, folder):
    """Ctrl-C is heard while the grains settle; the rest is done after a restart, to the same state."""
    settle = ["run.settle=0.8 s"]  # more than one of the parts in which grains settle
    running = subprocess.Popen(bench.command(*END, settings=settle), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    for line in running.stdout:
        if "settling for" in line:
            break
    running.send_signal(signal.SIGINT)
    text, _ = running.communicate(timeout=120)
    expect(running.returncode == STOPPED, f"exit code {running.returncode}:\n{text}")
    expect_words(text, "stopped by Ctrl-C while the grains settled", "state saved")
    bench.run(*END, "--restart", "--ranks", "2", settings=settle)
    with tempfile.TemporaryDirectory() as other_folder:
        other = Bench(bench.isago, pathlib.Path(other_folder))
        other.run(*END, settings=settle)
        expect(bench.digest() == other.digest(), "the end differs from that of an undisturbed run")


def absurd_values(bench, folder):
    """Each is refused before the first step, with the key that is to blame."""
    for setting, word in (("particles.S.diameter=60 mm", "domain"), ("particles.S.count=1000000", "random placing"), ("particles.S.count=1.5", "count"),
                          ("fluid.water.density=.nan kg/m3", "density"), ("fluid.water.viscosity=-1 m2/s", "viscosity"),
                          ("fluid.drive.pressure_gradient=33 kPa", "Pa/m"), ("contact.restitution=2", "restitution"), ("run.time_step=0 s", "time_step"),
                          ("grid.pipe.blocks_along=1000", "blocks"), ("solver.tolerance=10", "tolerance"), ("gravity.direction=q", "direction"),
                          ("output.results=every 0 ms", "results"), ("particles=hello", "item")):
        text = bench.run(settings=[setting], code=WRONG_SCENE)
        expect_words(text, word)
        expect(not bench.folder.exists(), f"{setting} has made a run directory")


def blocks_in_one_another(bench, folder):
    """Two boxes of a grid file that share a fifth of their volume are named, with the cells."""
    points = [(i, j, k) for k in range(6) for j in range(6) for i in range(6)]
    numbers = [0.2 * p[axis] + (shift if axis == 0 else 0.0) for shift in (0.0, 0.8) for axis in range(3) for p in points]
    (folder / "grid.xyz").write_text("2 6 6 6 6 6 6 " + " ".join(map(str, numbers)))
    scene = folder / "scene.yaml"
    scene.write_text("name: boxes in one another\ngrid: { blocks: { file: grid.xyz, other_sides: wall } }\n"
                     "fluid: { water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s } }\nrun: { until: 1 s }\n")
    text = bench.run(scene=scene, code=WRONG_SCENE)
    expect_words(text, "scene.yaml:2:", "blocks 0 and 1 overlap: cell (4, 0, 0) of block 0", "of block 1")


def grains_break_out(bench, folder):
    """Springs that cannot hold the grains: the sub-step in which they would pass through others is refused, with and without water."""
    for scene in (PIPE, CONFIGS / "settling_bed"):
        shutil.rmtree(bench.folder, ignore_errors=True)
        text = bench.run("--until", "1 s", scene=scene, settings=["contact.stiffness=1e-9 N/m", "run.settle=0.5 s"], code=FAILED)
        expect_words(text, "particle ", "would pass through others", "too soft")


def step_too_long(bench, folder):
    """Water that would come from beyond the halo: named with its block and cell, not cut short. A step that is free becomes shorter."""
    fast = ["fluid.drive.pressure_gradient=3e6 Pa/m", "run.limits.cfl=100", "run.limits.particle_move=100"]
    text = bench.run("--until", "20 ms", settings=[*fast, "run.time_step=2 ms"], code=FAILED)
    expect_words(text, "block ", "cell (", "stencils and halos reach 1", "make the step smaller")


def place_that_cannot_be_written(bench, folder):
    """Said in one sentence before anything is computed."""
    (folder / "file").write_text("in the way")
    bench.folder = folder / "file" / "run"
    text = bench.run(code=WRONG_SCENE)
    expect_words(text, "file")


def no_room(bench, folder):
    """A file system that fills up during the run: the earlier checkpoint is left, and the run goes on where there is room."""
    room = folder / "room"
    room.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=32m", "tmpfs", str(room)], capture_output=True).returncode != 0:
        return  # only root may mount
    try:
        bench.folder = room / "run"
        bench.run("--until", "0.2 ms")
        before = bench.digest()
        used = shutil.disk_usage(room)
        (room / "ballast").write_bytes(bytes(used.free - bench.checkpoints()[-1].stat().st_size // 2))
        text = bench.run(*END, "--restart", code=FAILED)
        expect_words(text, "No space left on device")
        expect(bench.digest() == before, "the earlier checkpoint was lost")
        (room / "ballast").unlink()
        expect_same_end(bench)
    finally:
        subprocess.run(["umount", str(room)], check=True)


def killed(bench, folder):
    """kill -9 at any moment, in the middle of a checkpoint, too."""
    random_delay = random.Random(1)
    running = bench.start("--until", "0.5 ms")
    for _ in range(4):
        bench.wait_for_checkpoints(1)
        time.sleep(random_delay.uniform(0.0, 0.4))
        running.kill()
        running.communicate()
        running = bench.start("--until", "0.5 ms", "--restart")
    running.communicate(timeout=120)
    unfinished = bench.checkpoints()[-1]
    (unfinished.parent / (unfinished.name.replace(".h5", "9.h5.part"))).write_bytes(unfinished.read_bytes()[:5000])
    expect_same_end(bench)


def full_disk(bench, folder):
    """Files that may not grow: one message, the earlier checkpoint is left, the run goes on when there is room."""
    bench.run("--until", "0.2 ms")
    before = bench.digest()
    limit = bench.checkpoints()[-1].stat().st_size // 2048
    for ranks in ("1", "2"):
        # mpirun itself needs large files, so only the ranks are limited; their messages must not need files
        limited = ["env", "OMPI_MCA_btl=self,tcp", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "mpirun", "--oversubscribe",
                   "-n", ranks, "bash", "-c", f'ulimit -f {limit}; exec "$0" "$@"', *bench.command(*END, "--restart")]
        done = subprocess.run(limited, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
        expect(done.returncode == FAILED, f"exit code {done.returncode} of {ranks} ranks:\n{done.stdout}")
        expect_words(done.stdout, "checkpoint_")
        expect(done.stdout.count("File too large") == 1, f"not said once:\n{done.stdout}")
        expect(bench.digest() == before, "the earlier checkpoint was lost")
    expect_same_end(bench)


def numbers_blow_up(bench, folder):
    """Absurd values end with a message, and the last good state is kept."""
    bench.run("--until", "0.2 ms")
    before = bench.digest()
    text = bench.run(*END, "--restart", "--ranks", "2", settings=["fluid.drive.pressure_gradient=1e300 Pa/m"], code=FAILED)
    expect_words(text, "saving the state before it", "finite")  # the field, or the particle that found it first
    expect(bench.digest() == before, "the last good state was lost")


TESTS = [scene_with_mistakes, absurd_values, blocks_in_one_another, more_ranks_than_blocks, second_run_in_the_same_place, place_that_cannot_be_written,
         damaged_checkpoint, all_checkpoints_damaged, signals, stopped_while_settling, killed, full_disk, no_room, numbers_blow_up, grains_break_out,
         step_too_long]


def main():
    isago, names = sys.argv[1], sys.argv[2:]
    failures = 0
    for test in TESTS:
        if names and test.__name__ not in names:
            continue
        start = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(Bench(isago, pathlib.Path(folder)), pathlib.Path(folder))
                outcome = "good"
            except (AssertionError, subprocess.SubprocessError, OSError) as error:
                outcome, failures = f"FAILED: {error}", failures + 1
        print(f"{test.__name__:30} {time.monotonic() - start:6.1f} s  {outcome}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
