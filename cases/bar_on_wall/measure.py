# SPDX-License-Identifier: MIT
"""Time of contact, impulse and pressure of a bar on a wall."""
import numpy as np


def _force(run):
    table = run.table("solid/contact.csv")
    return np.asarray(table["t"]), np.asarray(table["bottom.normal_y"])


def contact_time(run, entry) -> float:
    t, force = _force(run)
    return float(t[np.nonzero(force)[0][-1]])


def impulse(run, entry) -> float:
    t, force = _force(run)
    return float(np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(t)))


def mean_pressure(run, entry) -> float:
    """Mean from 0.2 to 1.7 ms [Pa]."""
    t, force = _force(run)
    return float(np.mean(force[(t > 2e-4) & (t < 1.7e-3)]) / 0.01)
