# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""A file includes only its own floor and those below, in io its own room and those before; each outside library appears only where it has
its job."""
import re

from house import FLOORS, includes, is_code, main

# A scene is read, becomes grids and physics, runs, is drawn, and many runs make a study.
ROOMS = ["scene", "files", "build", "picture", "run", "study", "cli"]
# (header, where it may appear, in words)
LIBRARIES = [
    (r"mpi\.h$", r"core/comm/", "core/comm"),
    (r"(tbb|oneapi)/", r"core/base/team\.cpp$|tasks/(.*/)?executor_tbb", "core/base/team.cpp and tasks/executor_tbb*"),
    (r"omp\.h$", r"core/base/team\.cpp$|tasks/(.*/)?executor_openmp", "core/base/team.cpp and tasks/executor_openmp*"),
    (r"(hdf5|H5\w*)\.h$|yaml-cpp/|(EGL|GL|GLES\d)/|CLI/|fmt/|png\.h$|udunits2\.h$", r"io/", "io"),
    (r"nlohmann/", r"io/|tasks/(.*/)?trace", "io and tasks/trace"),
    (r"doctest", r"(?!)", "tests"),
]
OMP_PRAGMA = re.compile(r"^[ \t]*#[ \t]*pragma[ \t]+omp[ \t]+(?!simd\b|declare[ \t]+simd\b)", re.M)
OMP_PLACES = re.compile(LIBRARIES[2][1])


def check_floor(path, line, target):
    floor, place = path.split("/")[0], f"{path}:{line}: "
    target_floor = target.split("/")[0]
    if target_floor not in FLOORS:
        return [place + f'"{target}" is not written from the root of the repository']
    if FLOORS.index(target_floor) > FLOORS.index(floor):
        return [place + f"{floor} may not include {target}: it is on a floor above"]
    if floor == "physics" and target_floor == "tasks" and not path.startswith("physics/steps/"):
        return [place + f"only physics/steps may include {target}"]
    if floor == target_floor == "io":
        return check_room(path, place, target)
    return []


def check_room(path, place, target):
    room, target_room = path.split("/")[1], target.split("/")[1]
    for name in (room, target_room):
        if name not in ROOMS:
            return [place + f"io has no room '{name}'"]
    if ROOMS.index(target_room) > ROOMS.index(room):
        return [place + f"io/{room} may not include {target}: it is in a room behind it"]
    return []


def check(files):
    findings = []
    for path, text in files.items():
        if not is_code(path) or path.startswith("tests/"):
            continue
        for line, quote, target in includes(text):
            if quote == '"':
                findings += check_floor(path, line, target)
            for header, allowed, words in LIBRARIES:
                if re.match(header, target) and not re.match(allowed, path):
                    findings.append(f"{path}:{line}: <{target}> belongs only in {words}")
        for match in OMP_PRAGMA.finditer(text):
            if not OMP_PLACES.match(path):
                line = text.count("\n", 0, match.start()) + 1
                findings.append(f"{path}:{line}: OpenMP threads belong only in {LIBRARIES[2][2]}; use core::Team")
    return findings


BAD = [
    {"core/a.hpp": '#include "tasks/graph.hpp"\n'},
    {"physics/fluid/a.hpp": '#include "tasks/graph.hpp"\n'},
    {"physics/fluid/a.hpp": '#include "io/scene/yaml.hpp"\n'},
    {"core/grid/a.cpp": '#include "block.hpp"\n'},
    {"io/scene/a.cpp": '#include "io/build/b.hpp"\n'},
    {"io/attic/a.cpp": '#include "io/scene/b.hpp"\n'},
    {"core/grid/a.cpp": "#include <mpi.h>\n"},
    {"tasks/executor_serial.cpp": "#include <tbb/parallel_for.h>\n"},
    {"physics/fluid/a.cpp": "void f()\n{\n    #pragma omp parallel for\n}\n"},
    {"physics/a.cpp": "#include <hdf5.h>\n"},
    {"tasks/stage_graph.cpp": "#include <nlohmann/json.hpp>\n"},
]
GOOD = {
    "core/comm/a.cpp": '#include "core/base/error.hpp"\n#include <mpi.h>\n',
    "physics/steps/a.cpp": '#include "tasks/graph.hpp"\n#pragma omp simd\n',
    "tasks/executor_openmp.cpp": "#pragma omp parallel\n",
}
main(check, BAD, GOOD)
