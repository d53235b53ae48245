# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Every source and script begins with the two SPDX lines; headers go on with #pragma once and say what they are for."""
import re

from house import is_code, main

COPYRIGHT = "SPDX-FileCopyrightText: 2026 The Isago authors"
LICENCE = "SPDX-License-Identifier: Apache-2.0"
SCRIPTS = re.compile(r"(.*/)?CMakeLists\.txt$|.*\.(py|sh|cmake)$|isago$|\.ci/run$")


def check(files):
    findings = []
    for path, text in files.items():
        if not (is_code(path) or SCRIPTS.match(path)):
            continue
        lines = text.split("\n")
        lines = lines[1:] if lines[0].startswith("#!") else lines
        mark = "//" if is_code(path) else "#"
        if lines[:2] != [f"{mark} {COPYRIGHT}", f"{mark} {LICENCE}"]:
            findings.append(f"{path}:1: begins without the two SPDX lines")
        elif path.endswith(".hpp") and lines[2] != "#pragma once":
            findings.append(f"{path}:3: #pragma once belongs below the SPDX lines")
        elif path.endswith(".hpp") and not lines[3].startswith("//"):
            findings.append(f"{path}:4: a sentence that says what this file is for belongs below #pragma once")
    return findings


HEAD = f"// {COPYRIGHT}\n// {LICENCE}\n"
BAD = [
    {"core/a.cpp": "int a;\n"},
    {"core/a.hpp": HEAD + "int a;\n"},
    {"core/a.hpp": HEAD + "#pragma once\n#include <vector>\n"},
    {"tests/a.py": "#!/usr/bin/env python3\nimport os\n"},
]
GOOD = {"core/a.hpp": HEAD + "#pragma once\n// What this is for.\n", "README.md": "# Isago\n"}
main(check, BAD, GOOD)
