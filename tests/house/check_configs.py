# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Every scene in configs/ has its scene.yaml and a README.md."""
from house import main


def check(files):
    folders = sorted({"/".join(path.split("/")[:2]) for path in files if path.startswith("configs/") and path.count("/") > 1})
    needed = [f"{folder}/{name}" for folder in folders for name in ("scene.yaml", "README.md")]
    return [f"{path} is missing" for path in needed if not files.get(path, "").strip()]


BAD = [
    {"configs/pipe/scene.yaml": "name: pipe\n"},
    {"configs/pipe/README.md": "# Pipe\n"},
    {"configs/pipe/scene.yaml": "name: pipe\n", "configs/pipe/README.md": "\n"},
]
GOOD = {"configs/README.md": "# Scenes\n", "configs/pipe/scene.yaml": "name: pipe\n", "configs/pipe/README.md": "# Pipe\n"}
main(check, BAD, GOOD)
