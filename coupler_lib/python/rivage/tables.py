# SPDX-License-Identifier: MIT
"""The tables that a solid leaves beside those of the coupling, in the columns that Rivage's report reads."""
import math
from collections.abc import Iterable
from pathlib import Path

from rivage.participant import Participant
from rivage.sides import Window

ENERGIES = {"kinetic": "kinetic", "strain": "strain", "potential": "potential", "work": "work_interface",
            "external_work": "work_loads", "dissipated": "numerical_dissipation"}


class Table:
    """A CSV file of numbers; every row is on the disk at once."""

    def __init__(self, path: Path, columns: Iterable[str]):
        self.path = path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(",".join(columns) + "\n", encoding="utf-8")

    def row(self, values: Iterable[float]) -> None:
        with self.path.open("a", encoding="utf-8") as file:
            print(*(f"{value:.12g}" for value in values), sep=",", file=file)


class SolidTables:
    """OUT/ROLE/probes.csv with the columns given ("tip.ux[m]"), OUT/ROLE/energy.csv; a row every coupling.output.table_interval.

    OUT is that of --out; without it nothing is written. Made by one rank.
    """

    def __init__(self, me: Participant, probes: Iterable[str], unit: str = "J/m"):
        self.interval, self.due, self.tables = me.table_interval, 0.0, []
        if me.out is not None:
            folder = Path(me.out) / me.role
            self.tables = [Table(folder / "probes.csv", ["t[s]", *probes]),
                           Table(folder / "energy.csv", ["t[s]", *(f"{name}[{unit}]" for name in ENERGIES.values())])]

    def write(self, window: Window, probes: Iterable[float], **report: float) -> None:
        """The row of a window, where one is due or it is the last. report: what `Solid.send` is told."""
        if not self.tables or window.step < 0 or not (window.last or window.time >= self.due * (1 - 1e-12)):
            return
        if self.interval > 0:
            self.due = (math.floor(window.time / self.interval * (1 + 1e-12)) + 1) * self.interval
        for table, values in zip(self.tables, (probes, (report.get(name, 0.0) for name in ENERGIES))):
            table.row([window.time, *values])
