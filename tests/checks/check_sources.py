# SPDX-License-Identifier: MIT
"""Checks what every source file owes its reader: the licence line first, at most 300 lines, nothing unfinished.

usage: check_sources.py ROOT

Prints `file:line: what is wrong` for each finding and exits with 1 if there is one.
"""
import re
import sys
from pathlib import Path

FOLDERS = ("coupler_lib", "sph_solver", "fem_solver", "cases", "tests")
SUFFIXES = (".cpp", ".hpp", ".py")
LICENCE = re.compile(r"^(//|#) SPDX-License-Identifier: MIT$")
LONGEST = 300
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b")


def check_text(name: str, text: str) -> list[str]:
    """The findings for one file's text."""
    lines = text.splitlines()
    findings = []
    if not lines or not LICENCE.match(lines[0]):
        findings.append(f"{name}:1: the first line is not the licence (SPDX-License-Identifier: MIT)")
    if len(lines) > LONGEST:
        findings.append(f"{name}:{len(lines)}: longer than {LONGEST} lines")
    for number, line in enumerate(lines, start=1):
        if UNFINISHED.search(line):
            findings.append(f"{name}:{number}: unfinished: {line.strip()}")
    return findings


def main(root: Path) -> int:
    findings = []
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in SUFFIXES:
                findings += check_text(str(path.relative_to(root)), path.read_text(encoding="utf-8"))
    print("\n".join(findings) if findings else "every source file is in order")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
