# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Runs a command and says how long it took and how much of the machine others used meanwhile."""
import os
import re
import resource
import statistics
import subprocess
import time
from dataclasses import dataclass

REPEATS = int(os.environ.get("REPEATS", "1"))


@dataclass
class Run:
    wall: float  # [s]
    cpu: float  # of the command and its children [s]
    foreign: float  # cores that other programs kept busy on average
    output: str


def busy_seconds():
    """CPU seconds of the whole machine since it started, without waiting."""
    with open("/proc/stat", encoding="ascii") as stream:
        user, nice, system, _, _, hard, soft = (int(word) for word in stream.readline().split()[1:8])
    return (user + nice + system + hard + soft) / os.sysconf("SC_CLK_TCK")


def own_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, log, cores=1):
    """Runs the command (a list) on that many MPI ranks; its output goes to the file `log` and comes back."""
    if cores > 1:
        command = ["mpirun", "-np", str(cores), *command]
    busy, own, start = busy_seconds(), own_seconds(), time.perf_counter()
    with open(log, "w", encoding="utf-8") as stream:
        code = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT, check=False).returncode
    wall, cpu = time.perf_counter() - start, own_seconds() - own
    with open(log, encoding="utf-8", errors="replace") as stream:
        output = stream.read()
    if code != 0:
        raise SystemExit(f"{' '.join(command)} ended with {code}:\n{output[-2000:]}")
    return Run(wall, cpu, max(0.0, busy_seconds() - busy - cpu) / wall, output)


def number(pattern, text):
    """The first group of the last match, as a number."""
    found = re.findall(pattern, text, re.M)
    if not found:
        raise SystemExit(f"the output holds nothing like {pattern!r}:\n{text[-2000:]}")
    return float(found[-1])


def table(title, unit, samples):
    """Prints the median of each code's samples and its ratio to the first code's.

    samples: {code: [(value, foreign cores)]}.
    """
    medians = {code: statistics.median(value for value, _ in values) for code, values in samples.items() if values}
    reference = next(iter(medians.values()))
    print(title)
    for code, median in medians.items():
        values = [value for value, _ in samples[code]]
        spread = (max(values) - min(values)) / median
        foreign = max(foreign for _, foreign in samples[code])
        print(f"  {code:10s} {median:10.4g} {unit}   {median / reference:6.3f} of {next(iter(medians))}"
              f"   n={len(values)}, spread {spread:.0%}, others used up to {foreign:.2f} cores")
