# SPDX-License-Identifier: MIT
"""Radius of the contact from the pressures at the nodes: Hertz's p^2 = p0^2 (1 - r^2/a^2) is a straight line over r^2."""
import h5py
import numpy as np


def radius(run, entry) -> float:
    """Where the line through the points with more than a fifth of the largest pressure meets zero [m]."""
    with h5py.File(run.path / "solid" / "fields.h5") as file:
        last = file[sorted(name for name in file if name.startswith("step"))[-1]]
        points, p = last["points"][:], np.ravel(last["contact_pressure"][:])
    square_radius = points[:, 0] ** 2 + points[:, 1] ** 2
    pressed = p > 0.2 * p.max()
    slope, square = np.polyfit(square_radius[pressed], p[pressed] ** 2, 1)
    return float(np.sqrt(-square / slope))
