# SPDX-License-Identifier: MIT
"""Reads what a run wrote: CSV tables with units in their headers and summary.json.

Everything here bears a run that was stopped half-way: a last line cut short is left out, a missing file is None.
"""
import json
from pathlib import Path

import numpy as np


class Table:
    """A CSV file as named columns. Headers read `name[unit]`; a column is found by its full header or its name."""

    def __init__(self, path: Path):
        rows, self.headers = [], []
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith("#") or not line.strip():
                continue
            cells = [cell.strip() for cell in line.split(",")]
            if not self.headers:
                self.headers = cells
            elif len(cells) == len(self.headers):
                rows.append(cells)
        self.path = path
        self.values = np.array(rows, dtype=float).reshape(len(rows), len(self.headers))

    def __len__(self) -> int:
        return len(self.values)

    def find(self, name: str) -> str | None:
        """The full header of the column `name` (with or without its unit), or None."""
        if name in self.headers:
            return name
        for header in self.headers:
            if header.split("[")[0] == name:
                return header
        return None

    def __contains__(self, name: str) -> bool:
        return self.find(name) is not None

    def __getitem__(self, name: str) -> np.ndarray:
        header = self.find(name)
        if header is None:
            raise KeyError(f"{self.path}: no column '{name}'; there are: {', '.join(self.headers)}")
        return self.values[:, self.headers.index(header)]

    def get(self, name: str) -> np.ndarray:
        """The column, or zeros where the file has none."""
        return self[name] if name in self else np.zeros(len(self))

    def unit(self, name: str) -> str:
        header = self.find(name) or ""
        return header[header.index("[") + 1:].rstrip("]") if "[" in header else ""


class RunFolder:
    """The folder of one run. `missing` collects the names of the files that were asked for and are not there."""

    def __init__(self, path: Path):
        self.path = Path(path)
        self.missing: list[str] = []
        self.tables: dict[str, Table | None] = {}

    def file(self, name: str) -> Path | None:
        path = self.path / name
        if path.is_file():
            return path
        if name not in self.missing:
            self.missing.append(name)
        return None

    def table(self, name: str) -> Table | None:
        """The CSV file as a table; None where it is missing or holds no row."""
        if name not in self.tables:
            path = self.file(name)
            table = Table(path) if path else None
            self.tables[name] = table if table is not None and len(table) > 0 else None
        return self.tables[name]

    def sides(self) -> list[str]:
        """The participants that left an account, the fluid first; a run that left none is taken for fluid and solid."""
        names = {path.parent.name for path in self.path.glob("*/energy.csv")} | {path.parent.name for path in self.path.glob("*/summary.json")}
        return sorted(names or {"fluid", "solid"}, key=lambda name: (name != "fluid", name))

    def solids(self) -> list[str]:
        return [side for side in self.sides() if side != "fluid"]

    def interfaces(self) -> dict[str, Table]:
        """The table of each interface, under the name of its solid where there are several."""
        several = {path.suffixes[0][1:]: self.table(f"coupling/{path.name}") for path in sorted(self.path.glob("coupling/interface.*.csv"))}
        found = several or {"": self.table("coupling/interface.csv")}
        return {name: table for name, table in found.items() if table is not None}

    def summary(self) -> dict:
        path = self.file("summary.json")
        try:
            return json.loads(path.read_text(encoding="utf-8")) if path else {}
        except json.JSONDecodeError as error:
            self.missing.append(f"summary.json (not readable: {error})")
            return {}
