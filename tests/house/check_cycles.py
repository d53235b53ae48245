# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""No file includes itself through others."""
from house import includes, is_code, main


def check(files):
    graph = {
        path: [target for _, quote, target in includes(text) if quote == '"' and target in files]
        for path, text in files.items()
        if is_code(path)
    }
    findings, finished = [], set()

    def visit(path, trail):
        if path in trail:
            findings.append("an include cycle: " + " -> ".join(trail[trail.index(path):] + [path]))
        elif path not in finished:
            for target in graph.get(path, []):
                visit(target, trail + [path])
            finished.add(path)

    for path in graph:
        visit(path, [])
    return findings


BAD = [
    {"core/a.hpp": '#include "core/a.hpp"\n'},
    {"core/a.hpp": '#include "core/b.hpp"\n', "core/b.hpp": '#include "core/c.hpp"\n', "core/c.hpp": '#include "core/a.hpp"\n'},
]
GOOD = {"core/a.hpp": '#include "core/b.hpp"\n#include "core/c.hpp"\n', "core/b.hpp": '#include "core/c.hpp"\n', "core/c.hpp": ""}
main(check, BAD, GOOD)
