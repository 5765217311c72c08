# SPDX-License-Identifier: MIT
"""Half width of the contact from the pressures at the nodes: Hertz's p^2 = p0^2 (1 - x^2/a^2) is a straight line over x^2."""
import h5py
import numpy as np


def half_width(run, entry) -> float:
    """Where the line through the points with more than a fifth of the largest pressure meets zero [m]."""
    with h5py.File(run.path / "solid" / "fields.h5") as file:
        last = file[sorted(name for name in file if name.startswith("step"))[-1]]
        x, p = last["points"][:, 0], np.ravel(last["contact_pressure"][:])
    pressed = p > 0.2 * p.max()
    slope, square = np.polyfit(x[pressed] ** 2, p[pressed] ** 2, 1)
    return float(np.sqrt(-square / slope))
