# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""What the house checks share: the files of the repository, and how a check proves itself and reports."""
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FLOORS = ["core", "tasks", "physics", "io"]
CODE = (".hpp", ".cpp")
SKIPPED_FOLDERS = {".git", "build", "runs", "run", "__pycache__", ".cache", ".vscode"}
BINARY = (".png", ".jpg", ".pdf", ".h5", ".hdf", ".gz", ".swp", ".pyc")


def files_of_repository():
    """All text files as {path from the root: text}."""
    found = {}
    for folder, folders, names in os.walk(ROOT):
        folders[:] = sorted(f for f in folders if f not in SKIPPED_FOLDERS)
        for name in sorted(names):
            path = os.path.join(folder, name)
            if os.path.isfile(path) and name not in SKIPPED_FOLDERS and not name.endswith(BINARY):  # .git is a file in a linked worktree
                with open(path, encoding="utf-8", errors="replace", newline="") as stream:
                    found[os.path.relpath(path, ROOT)] = stream.read()
    return found


def is_code(path):
    """True for C++ of the four floors and of the tests."""
    return path.endswith(CODE) and path.split("/")[0] in FLOORS + ["tests"]


def includes(text):
    """(line number, '"' or '<', target) of every include directive."""
    pattern = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.M)
    return [(text.count("\n", 0, m.start()) + 1, m[1], m[2]) for m in pattern.finditer(text)]


def main(check, bad_samples, good_sample):
    """Proves that `check` finds every bad sample and nothing in the good one, then runs it on the repository.

    A sample is {path: text}; check({path: text}) returns a list of findings, each one line.
    """
    for sample in bad_samples:
        if not check(sample):
            sys.exit(f"the check itself is broken: it finds nothing wrong in {sample}")
    if check(good_sample):
        sys.exit(f"the check itself is broken: it reports {check(good_sample)} in a good sample")
    findings = check(files_of_repository())
    print("\n".join(findings) if findings else "nothing found")
    sys.exit(1 if findings else 0)
