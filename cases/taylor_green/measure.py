# SPDX-License-Identifier: MIT
"""What the vortex has lost to viscosity, against the exact decay E = E_0 exp(-4 pi^2 nu t)."""
import math

import numpy as np

RATE = 4 * math.pi**2 * 0.01          # [1/s] of the kinetic energy, nu = 0.01 m^2/s


def first_power_ratio(run, entry) -> float:
    """Work of the viscous forces in the first 0.05 s over that of the exact vortex with the same kinetic energy."""
    table = run.table("fluid/energy.csv")
    first = table["t"] <= 0.05 + 1e-9
    t, kinetic, viscous = (np.asarray(table[name])[first] for name in ("t", "kinetic", "viscous"))
    return float(viscous[-1] / (RATE * np.sum(0.5 * (kinetic[1:] + kinetic[:-1]) * np.diff(t))))


def kinetic_energy_left(run, entry) -> float:
    """Kinetic energy at the end over the exact one."""
    table = run.table("fluid/energy.csv")
    return float(table["kinetic"][-1] / (table["kinetic"][0] * math.exp(-RATE * table["t"][-1])))
