# SPDX-License-Identifier: MIT
"""Checks that the sources of a folder can be compiled joined (CMake's unity build): no private name is used by two of them.

usage: check_unity.py ROOT

Private is what an anonymous namespace holds, what is `static` or a macro. Most clashes of such names break the joined build;
functions of one name with different arguments do not, and one file could call the other's. Names are found by their look, not
by a compiler. Prints one line `file:line: what is wrong` for each finding and exits with 1 if there is one.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

PROGRAMS = ("coupler_lib", "sph_solver", "fem_solver", "tests")
SINGLE = ("tests/bench",)    # each source is a program of its own
HIDDEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
RAW = re.compile(r'R"(\w*)\(.*?\)\1"', re.DOTALL)
MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", re.MULTILINE)
DIRECTIVE = re.compile(r"^[ \t]*#(?:\\\n|[^\n])*", re.MULTILINE)
GTEST = re.compile(r"^(?:TEST(?:_F|_P)?|INSTANTIATE_TEST_SUITE_P)\((\w+), *(\w+)")
TYPE = re.compile(r"^(?:struct|class|union|enum(?: class| struct)?) +(\w+)|^using +(\w+) *=")
MEMBER = re.compile(r"[^(]*::\w+ *\(")
CALLABLE = re.compile(r"(\w+) *\(")
OBJECT = re.compile(r"(\w+) *(?:\[[^]]*\])* *(?:=.*)?$", re.DOTALL)


def blank(match: re.Match) -> str:
    """As many lines, nothing on them."""
    return "\n" * match.group().count("\n")


def without_templates(head: str) -> str:
    """The head without `template<...>` in front."""
    while head.startswith("template"):
        depth = 0
        for place, letter in enumerate(head):
            depth += (letter == "<") - (letter == ">" and head[place - 1] != "-")
            if depth == 0 and letter == ">":
                break
        head = head[place + 1:].lstrip()
    return head


def declared(head: str) -> str:
    """The name that a declaration at namespace level brings, given its text up to `{`, `=` with braces, or `;`."""
    head = re.sub(r"\[\[.*?\]\]", "", " ".join(head.split()))
    head = without_templates(head.strip())
    if test := GTEST.match(head):
        return ".".join(test.groups())
    if kind := TYPE.match(head):
        return kind.group(1) or kind.group(2)
    if re.match(r"(using|namespace|extern|friend|static_assert)\b", head) or MEMBER.match(head):
        return ""
    left = head.split("=")[0].strip()
    name = CALLABLE.search(left) or OBJECT.search(left)
    return name.group(1) if name else ""


def private_names(text: str) -> dict[str, int]:
    """Each private name of a source with the line where it first stands."""
    text = HIDDEN.sub(blank, RAW.sub(blank, text))
    names = {match.group(1): text.count("\n", 0, match.start()) + 1 for match in MACRO.finditer(text)}
    text = DIRECTIVE.sub(blank, text)
    scopes: list[str] = []    # "named", "private" or "body" for each open brace
    start = 0
    for place in (match.start() for match in re.finditer(r"[{};]", text)):
        letter, head = text[place], text[start:place].strip()
        space = re.search(r"\bnamespace *([\w:]*)$", head)
        hidden = "private" in scopes or head.startswith("static ")
        if "body" not in scopes and not space and letter != "}" and hidden and (name := declared(head)):
            names.setdefault(name, text.count("\n", 0, start + len(text[start:place]) - len(text[start:place].lstrip())) + 1)
        if letter == "{":
            scopes.append(("named" if space.group(1) else "private") if space else "body")
        elif letter == "}" and scopes:
            scopes.pop()
        if "body" not in scopes:
            start = place + 1
    return names


def main(root: Path) -> int:
    findings = []
    folders = {path.parent for program in PROGRAMS for path in (root / program).rglob("*.cpp")}
    for folder in sorted(folders - {root / single for single in SINGLE}):
        places: dict[str, list[str]] = defaultdict(list)
        for source in sorted(folder.glob("*.cpp")):
            for name, line in private_names(source.read_text(encoding="utf-8")).items():
                places[name].append(f"{source.relative_to(root)}:{line}")
        findings += [f"{other}: {name} is private to {at[0]} too" for name, at in places.items() for other in at[1:]]
    print("\n".join(findings) or "no two sources of a folder use one private name")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
