# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""No paths of one machine, no words of unfinished work, no tabs, no trailing blanks."""
import re

from house import main

RULES = [
    (re.compile(r"(?<![\w.])/(?:w" r"ork|t" r"mp|home|root|mnt)/"), "a path of one machine"),
    (re.compile(r"\b(?:TO" r"DO|FIX" r"ME|X" r"XX|st" r"ubs?|not imple" r"mented)\b"), "a word of unfinished work"),
    (re.compile(r"\t"), "a tab"),
    (re.compile(r"[ \r]$"), "a blank at the end of the line"),
]


def check(files):
    findings = []
    for path, text in files.items():
        for number, line in enumerate(text.split("\n"), 1):
            findings += [f"{path}:{number}: {words}" for pattern, words in RULES if pattern.search(line)]
        if text and not text.endswith("\n"):
            findings.append(f"{path}: the last line does not end")
    return findings


BAD = [
    {"README.md": "see /w" "ork/main/file\n"},
    {"core/a.cpp": "int a; // TO" "DO later\n"},
    {"core/a.cpp": "\tint a;\n"},
    {"core/a.cpp": "int a; \n"},
    {"core/a.cpp": "int a;\r\n"},
    {"core/a.cpp": "int a;"},
]
GOOD = {"core/a.cpp": "// stubborn fluids, https://example.org/tmpl/page\n"}
main(check, BAD, GOOD)
