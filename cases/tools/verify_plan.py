# SPDX-License-Identifier: MIT
"""The runs that verification makes of a case, from its verify.toml; without one, a single run of the case as it stands.

One [[run]] table a run:

    name        = "dx 0.04"          what expect.toml calls it (`run = "dx 0.04"`)
    set         = ["fluid.resolution.spacing=0.04"]   overrides; none: the case as it stands
    fluid_ranks = 1, solid_ranks = 1
    inputs      = ".."               the folder of the input files, relative to this one, to set another case beside this
    test        = true               a small sibling for ctest, left out by ./rivage verify
    test_program = "test_fem_time", filter = "Hht.*"    instead of a solver, tests of that program: what they record by
                                     RecordProperty is the run's summary.json

`group = "solid"` above the runs puts the case into a group, which `./rivage verify solid` runs as a whole.
A folder inside a case that has input files of its own is a variant, a case by itself: "hydrostatic_tank/inclined".
"""
import tomllib
from dataclasses import dataclass
from pathlib import Path

from expectations import AS_IT_STANDS

CASES = Path(__file__).resolve().parent.parent
INPUTS = ("coupling.toml", "fluid.toml", "solid.toml")
KEYS = {"name", "inputs", "set", "fluid_ranks", "solid_ranks", "test", "test_program", "filter"}


@dataclass(frozen=True)
class PlannedRun:
    folder: Path
    name: str
    settings: tuple[str, ...] = ()
    ranks: tuple[int, int] = (1, 1)
    test: bool = False
    test_program: str = ""
    filter: str = "*"
    inputs: str = "."

    @property
    def as_it_stands(self) -> bool:
        return not self.settings and not self.test_program and self.inputs == "."

    @property
    def names(self) -> tuple[str, ...]:
        """What expect.toml may call it."""
        return (self.name, AS_IT_STANDS) if self.as_it_stands else (self.name,)


def is_case(folder: Path) -> bool:
    return any((folder / name).is_file() for name in (*INPUTS, "verify.toml"))


def group_of(folder: Path) -> str:
    path = folder / "verify.toml"
    return tomllib.loads(path.read_text(encoding="utf-8")).get("group", "") if path.exists() else ""


def groups() -> dict[str, list[Path]]:
    """The groups that the cases name, each with its folders."""
    found: dict[str, list[Path]] = {}
    for path in sorted(CASES.rglob("verify.toml")):
        if group_of(path.parent):
            found.setdefault(group_of(path.parent), []).append(path.parent)
    return found


def title(folder: Path) -> str:
    """The case's name: its path below cases/, or the folder's own name elsewhere."""
    return str(folder.relative_to(CASES)) if folder.is_relative_to(CASES) else folder.name


def find_cases(names: list[str]) -> list[Path]:
    """The folders of the named cases, of their variants and of the named groups; without names, all of them."""
    known = groups()
    roots = [CASES / name if (CASES / name).is_dir() else Path(name).resolve() for name in names if name not in known]
    if not names:
        roots = sorted(path.parent for path in CASES.glob("*/README.md"))
    found = [folder for name in names for folder in known.get(name, [])]
    for root in roots:
        folders = [folder for folder in [root, *sorted(root.rglob("*/"))] if is_case(folder)]
        if not folders:
            raise ValueError(f"no case '{root}' and no group of that name ({', '.join(known)}); ./rivage list shows the cases")
        found += folders
    return found


def plan(folder: Path) -> list[PlannedRun]:
    path = folder / "verify.toml"
    if not path.exists():
        return [PlannedRun(folder, AS_IT_STANDS)]
    runs = []
    for entry in tomllib.loads(path.read_text(encoding="utf-8")).get("run", []):
        unknown = set(entry) - KEYS
        if unknown or "name" not in entry:
            raise ValueError(f"{path}: a [[run]] needs a name and knows {', '.join(sorted(KEYS))}; unknown: {unknown or 'none'}")
        ranks = (entry.get("fluid_ranks", 1), entry.get("solid_ranks", 1))
        runs.append(PlannedRun(folder, entry["name"], tuple(entry.get("set", ())), ranks, entry.get("test", False),
                               entry.get("test_program", ""), entry.get("filter", "*"), entry.get("inputs", ".")))
    if len({run.name for run in runs}) < len(runs):
        raise ValueError(f"{path}: two runs have the same name")
    return runs
