# SPDX-License-Identifier: MIT
"""Prints the cases: the name of each folder and the first line of its README."""
from pathlib import Path

CASES = Path(__file__).resolve().parent.parent

for readme in sorted(CASES.glob("*/README.md")):
    title = readme.read_text(encoding="utf-8").splitlines()[0].lstrip("# ")
    print(f"{readme.parent.name:24s} {title}")
