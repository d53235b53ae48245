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

    def busy(self, cores):
        return self.cpu / (self.wall * cores)


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


def rate(work, seconds, busy, foreign):
    """Work per second by the clock, and per second that the code had a processor, which tells more on a busy machine.

    busy: share of `seconds` in which each of the code's cores worked for it.
    """
    return work / seconds, work / (seconds * busy), foreign


def table(title, unit, samples):
    """Prints the median rates of each code and their ratios to the first code's.

    samples: {code: [what rate() returned]}.
    """
    print(title)
    first = None
    for code, rates in samples.items():
        wall, cpu, foreign = ([one[i] for one in rates] for i in range(3))
        medians = statistics.median(wall), statistics.median(cpu)
        first = first or medians
        print(f"  {code:9s} {medians[0]:10.4g} {unit} by the clock (x {medians[0] / first[0]:.2f}), {medians[1]:.4g} by processor"
              f" time (x {medians[1] / first[1]:.2f}); n={len(rates)}, spread {(max(wall) - min(wall)) / medians[0]:.0%},"
              f" others used up to {max(foreign):.2f} cores")
