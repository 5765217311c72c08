# SPDX-License-Identifier: MIT
"""What a case starts.

A case with coupling.toml starts the programs of its [participants]: an executable of the build, one of the user's own ("./plate"), a
Python script ("gate.py"), both beside coupling.toml, or a Python module ("rivage.fake_solid"). One without starts the solver whose own
file it holds (fluid.toml: sph_solver, solid.toml: fem_solver).
"""
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

PYTHON = "/usr/bin/python3"


@dataclass(frozen=True)
class Starter:
    """One program of a run: its role, what plays it, the file it is given, its own arguments before --as, --out and --set."""
    role: str
    program: str
    file: Path
    arguments: list[str] = field(default_factory=list)

    @property
    def is_from_outside(self) -> bool:
        return "." in self.program or "/" in self.program

    def words(self, programs: Path) -> list[str]:
        """The command up to --as; `programs` is the folder of the executables."""
        beside = str(self.file.parent / self.program)
        if self.program.endswith(".py"):
            first = [PYTHON, beside]
        elif "/" in self.program:
            first = [beside]
        else:
            first = [PYTHON, "-m", self.program] if "." in self.program else [str(programs / self.program)]
        return [*first, str(self.file), *self.arguments]


def participants(folder: Path) -> list[Starter]:
    """In the order of the file. Raises ValueError, OSError."""
    shared = folder / "coupling.toml"
    if shared.exists():
        with shared.open("rb") as file:
            table = tomllib.load(file).get("participants", {})
        if not table:
            raise ValueError(f"{shared}: there is no [participants.NAME] table")
        for role, entry in table.items():
            if "program" not in entry:
                raise ValueError(f"{shared}: [participants.{role}] names no program")
        return [Starter(role, entry["program"], shared, entry.get("arguments", [])) for role, entry in table.items()]
    for role, program in (("fluid", "sph_solver"), ("solid", "fem_solver")):
        own = folder / f"{role}.toml"
        if own.exists():
            return [Starter(role, program, own)]
    raise ValueError(f"{folder}: neither coupling.toml nor fluid.toml nor solid.toml is there")
