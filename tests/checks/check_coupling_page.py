# SPDX-License-Identifier: MIT
"""Holds docs/coupling.md and docs/couple_your_own_solver.md against the source: every error of the coupling library, of its C interface and
of the Python module is in their lists, every phrase of a list is in the source, and the example is the program that the tests build.

usage: check_coupling_page.py [ROOT]
"""
import re
import sys
from pathlib import Path

# Page: the folders whose errors it lists.
PAGES = {"docs/coupling.md": ("coupler_lib/coupling", "coupler_lib/recorder", "coupler_lib/session"),
         "docs/couple_your_own_solver.md": ("coupler_lib/c_api", "coupler_lib/python/rivage")}
CALL = re.compile(r"\b(?:text|require_input|require|Error|refuse)\(")
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
RAISED = re.compile(r"""(?:raise (?:Runtime|Value|Type)?Error|self\.fail)\((?:\d, )?f?("(?:[^"]*)"|'(?:[^']*)')""")
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


def messages(file: Path) -> list[str]:
    """What the file may say; … stands for what is filled in."""
    source = file.read_text(encoding="utf-8")
    if file.suffix == ".py":
        return [re.sub(r"{[^}]*}", "…", text[1:-1]) for text in RAISED.findall(source)]
    return [message(arguments) for arguments in calls(source)]


def page_faults(root: Path, name: str, folders: tuple[str, ...]) -> list[str]:
    phrases = documented((root / name).read_text(encoding="utf-8"))
    files = [file for folder in folders for file in sorted((root / folder).glob("*.*")) if file.suffix in (".cpp", ".hpp", ".py")]
    found, everything = [], ""
    for file in files:
        everything += message(file.read_text(encoding="utf-8")) if file.suffix != ".py" else ""
        for text in messages(file):
            everything += text
            if len(re.findall(r"[a-z]{2,}", text)) < LEAST_WORDS or any(part in text for part in PARTS):
                continue
            if not any(phrase in text for phrase in phrases):
                found.append(f"{file.relative_to(root)}: {name} lacks the error '{text}'")
    return found + [f"{name}: no source says '{phrase}'" for phrase in phrases if phrase not in everything]


def faults(root: Path) -> list[str]:
    found = [fault for name, folders in PAGES.items() for fault in page_faults(root, name, folders)]
    example = (root / "tests" / "coupled" / "own_solid.cpp").read_text(encoding="utf-8")
    if example[example.index("#include"):] not in (root / "docs" / "coupling.md").read_text(encoding="utf-8"):
        found.append("docs/coupling.md: the example is not tests/coupled/own_solid.cpp")
    return found


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    found = faults(root)
    print("\n".join(found) or "both pages: every error is there")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
