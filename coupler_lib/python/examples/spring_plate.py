# SPDX-License-Identifier: MIT
"""A plate on a spring in the place of fem_solver.

    mpirun -n 1 fake_fluid coupling.toml : -n 1 /usr/bin/python3 spring_plate.py coupling.toml [KEY=VALUE ...]
"""
import sys

import numpy as np
import rivage

MASS, STIFFNESS = 100.0, 1e6                     # [kg/m], [N/m^2]


def vertical(y: float) -> np.ndarray:
    return np.array([[0, y], [0, y]])


with rivage.Participant("solid", sys.argv[1], sys.argv[2:]) as me:
    wet = me.solid(dimension=2, node_ids=[0, 1], reference=[[1, 0], [0, 0]], facets=[[0, 1]])
    u = v = 0.0
    for window in wet.windows():                 # load n has come: wet.force, window.time, window.dt
        a = (wet.force[:, 1].sum() - STIFFNESS * u) / MASS
        wet.send(wet.reference + vertical(u), vertical(v), vertical(a), kinetic=0.5 * MASS * v**2, strain=0.5 * STIFFNESS * u**2)
        v += window.dt * a
        u += window.dt * v
    print(f"plate: u = {u:.6e} m at t = {window.time:g} s")
