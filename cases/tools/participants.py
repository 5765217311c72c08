# SPDX-License-Identifier: MIT
"""Prints what a case starts, one line a program: role, program, configuration file.

A case with coupling.toml starts the programs of its [participants]; one without starts the solver whose own file it
holds (fluid.toml: sph_solver, solid.toml: fem_solver).
"""
import sys
import tomllib
from pathlib import Path


def participants(folder: Path) -> list[tuple[str, str, Path]]:
    """The (role, program, configuration file) of each participant, in the order of the file."""
    shared = folder / "coupling.toml"
    if shared.exists():
        with shared.open("rb") as file:
            table = tomllib.load(file).get("participants", {})
        if not table:
            raise ValueError(f"{shared}: there is no [participants.NAME] table")
        return [(role, entry["program"], shared) for role, entry in table.items()]
    for role, program in (("fluid", "sph_solver"), ("solid", "fem_solver")):
        own = folder / f"{role}.toml"
        if own.exists():
            return [(role, program, own)]
    raise ValueError(f"{folder}: neither coupling.toml nor fluid.toml nor solid.toml is there")


def main() -> int:
    try:
        for line in participants(Path(sys.argv[1])):
            print(*line)
    except KeyError as key:
        print(f"{sys.argv[1]}/coupling.toml: a participant has no key {key}", file=sys.stderr)
        return 2
    except (ValueError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
