# SPDX-License-Identifier: MIT
"""Checks the floors: a folder may include only folders of a lower floor of its program, and itself.

usage: check_floors.py ROOT

Each program (coupler_lib, sph_solver, fem_solver) has a layers.txt: one line a floor, lowest first, the folders of a
floor separated by blanks. Files beside layers.txt stand above every floor. Both solvers may include coupler_lib, never
each other; coupler_lib includes neither; what an outside solver links (foundation and coupling) needs MPI alone.
Prints one line `file:line: what is wrong` for each finding and exits with 1 if there is one.
"""
import re
import sys
from pathlib import Path

PROGRAMS = {"coupler_lib": (), "sph_solver": ("coupler_lib",), "fem_solver": ("coupler_lib",)}
MPI_ONLY = ("coupler_lib/foundation", "coupler_lib/coupling")
LIBRARIES = re.compile(r"^(Eigen|hdf5|H5|toml\+\+|CLI|fmt|spdlog|metis|petsc|gtest)", re.IGNORECASE)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def read_layers(program: Path, findings: list[str]) -> dict[str, int]:
    """The floor of each folder, from layers.txt; says which lines name no folder and which folders have no line."""
    layers = program / "layers.txt"
    if not layers.exists():
        findings.append(f"{layers}:1: missing")
        return {}
    floors: dict[str, int] = {}
    for number, line in enumerate(layers.read_text(encoding="utf-8").splitlines(), start=1):
        for folder in line.split("#")[0].split():
            if folder in floors:
                findings.append(f"{layers}:{number}: {folder} stands on two floors")
            if not (program / folder).is_dir():
                findings.append(f"{layers}:{number}: there is no folder {folder}")
            floors[folder] = number
    for folder in sorted(path.name for path in program.iterdir() if path.is_dir()):
        if folder not in floors and any(sources(program / folder)):
            findings.append(f"{layers}:1: no floor for the folder {folder}")
    return floors


def sources(folder: Path):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".cpp", ".hpp", ".h"))


def judge(source: Path, target: Path, root: Path, floors: dict[str, dict[str, int]]) -> str:
    """What is wrong with `source` including `target` (both below root), or an empty text."""
    mine, other = source.relative_to(root).parts, target.parts
    if other[0] not in PROGRAMS:
        return ""
    if other[0] != mine[0]:
        return "" if other[0] in PROGRAMS[mine[0]] else f"{mine[0]} must not include {other[0]}"
    if len(mine) == 2:
        return ""
    if len(other) == 2:
        return f"{mine[1]} includes {other[1]}, which stands above every floor"
    if mine[1] == other[1]:
        return ""
    my_floor, other_floor = (floors[mine[0]].get(part, 0) for part in (mine[1], other[1]))
    if other_floor < my_floor:
        return ""
    way = "sideways" if other_floor == my_floor else "upwards"
    return f"{mine[1]} (floor {my_floor}) includes {way}: {other[1]} (floor {other_floor})"


def check_file(source: Path, root: Path, floors: dict[str, dict[str, int]]) -> list[str]:
    findings = []
    room = "/".join(source.relative_to(root).parts[:2])
    for number, line in enumerate(source.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(line)
        if not match:
            continue
        kind, name = match.groups()
        wrong = ""
        if kind == "<":
            if room in MPI_ONLY and LIBRARIES.match(name):
                wrong = f"{room} needs MPI alone, not <{name}>"
        elif (root / name).exists():
            wrong = judge(source, Path(name), root, floors)
        elif (source.parent / name).exists():
            wrong = judge(source, (source.parent / name).resolve().relative_to(root), root, floors)
        else:
            wrong = f"there is no file {name} (paths count from the root of the repository)"
        if wrong:
            findings.append(f"{source.relative_to(root)}:{number}: {wrong}")
    return findings


def check(root: Path) -> list[str]:
    findings: list[str] = []
    programs = [name for name in PROGRAMS if (root / name).is_dir()]
    floors = {name: read_layers(root / name, findings) for name in programs}
    for name in programs:
        for source in sources(root / name):
            findings += check_file(source, root, floors)
    return findings


if __name__ == "__main__":
    found = check(Path(sys.argv[1]).resolve())
    print("\n".join(found) if found else "every include goes down")
    sys.exit(1 if found else 0)
