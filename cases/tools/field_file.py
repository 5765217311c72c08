# SPDX-License-Identifier: MIT
"""Reads fields.h5 of a participant: one group a step (step_000000, ...) with points, connectivity and the fields."""
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np


@dataclass
class FieldStep:
    """One instant: present positions (n x 3) [m], connectivity (cells x nodes) or None, and the fields by name."""
    time: float
    points: np.ndarray
    connectivity: np.ndarray | None
    fields: dict[str, np.ndarray]


class FieldFile:
    """The steps of one fields.h5 and their times [s]."""

    def __init__(self, path: Path):
        self.path = path
        with h5py.File(path, "r", locking=False) as file:
            names = sorted(name for name in file if name.startswith("step_"))
            self.steps = [(float(np.ravel(file[name].attrs["time"])[0]), name) for name in names]

    @property
    def times(self) -> np.ndarray:
        return np.array([time for time, _ in self.steps])

    def nearest(self, time: float) -> FieldStep | None:
        """The step nearest to the time, if it lies within half an output interval; else None."""
        times = self.times
        if not len(times):
            return None
        interval = np.median(np.diff(times)) if len(times) > 1 else 0.0
        index = int(np.argmin(np.abs(times - time)))
        return self.read(index) if abs(times[index] - time) <= 0.5 * interval + 1e-9 else None

    def read(self, index: int) -> FieldStep:
        time, name = self.steps[index]
        with h5py.File(self.path, "r", locking=False) as file:
            group = file[name]
            fields = {key: np.asarray(item) for key, item in group.items() if isinstance(item, h5py.Dataset)}
            points = fields.pop("points")
            if "displacement" in fields:           # a mesh is drawn where it is, whatever points were stored
                points = np.asarray(file[self.steps[0][1]]["points"])
                points = points + fields["displacement"].reshape(len(points), -1)[:, :3]
        connectivity = fields.pop("connectivity", None)
        return FieldStep(time, points, connectivity, fields)


def open_fields(path: Path | None) -> FieldFile | None:
    """The field file, or None where it is missing or a killed run left it unreadable."""
    try:
        return FieldFile(path) if path else None
    except (OSError, KeyError):
        return None
