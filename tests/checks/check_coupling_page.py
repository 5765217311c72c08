# SPDX-License-Identifier: MIT
"""Holds docs/coupling.md against the source: every error of the coupling library is in its list, every phrase of the list is in the
source, and the example is the program that the tests build.

usage: check_coupling_page.py [ROOT]
"""
import re
import sys
from pathlib import Path

FOLDERS = ("coupler_lib/coupling", "coupler_lib/recorder", "coupler_lib/session")
CALL = re.compile(r"\b(?:text|require_input|require|Error|refuse)\(")
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
PARTS = ("(packet …", "(rank …) has")    # pieces of messages, not messages
LEAST_WORDS = 4


def calls(source: str):
    """The arguments of every call that makes a message, brackets balanced."""
    for match in CALL.finditer(source):
        depth, at = 1, match.end()
        while depth and at < len(source):
            literal = LITERAL.match(source, at)
            if literal:
                at = literal.end()
                continue
            depth += {"(": 1, ")": -1}.get(source[at], 0)
            at += 1
        yield source[match.end():at]


def message(arguments: str) -> str:
    """The string literals in a row; neighbours are one literal, … stands for what is filled in."""
    joined = re.sub(r'"\s*\n\s*"', "", arguments)
    return "…".join(LITERAL.findall(joined))


def documented(page: str) -> list[str]:
    rows = [line.split("|") for line in page.splitlines() if re.match(r"\| \d", line)]
    return [phrase for row in rows for phrase in re.findall(r"`([^`]+)`", row[2])]


def faults(root: Path) -> list[str]:
    page = (root / "docs" / "coupling.md").read_text(encoding="utf-8")
    phrases = documented(page)
    files = [file for folder in FOLDERS for file in sorted((root / folder).glob("*.[ch]pp"))]
    found, everything = [], ""
    for file in files:
        source = file.read_text(encoding="utf-8")
        everything += message(source)
        for arguments in calls(source):
            text = message(arguments)
            if len(re.findall(r"[a-z]{2,}", text)) < LEAST_WORDS or any(part in text for part in PARTS):
                continue
            if not any(phrase in text for phrase in phrases):
                found.append(f"{file.relative_to(root)}: the page lacks the error '{text}'")
    found += [f"docs/coupling.md: no source says '{phrase}'" for phrase in phrases if phrase not in everything]
    example = (root / "tests" / "coupled" / "own_solid.cpp").read_text(encoding="utf-8")
    if example[example.index("#include"):] not in page:
        found.append("docs/coupling.md: the example is not tests/coupled/own_solid.cpp")
    return found


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    found = faults(root)
    print("\n".join(found) or "docs/coupling.md: every error is there")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
