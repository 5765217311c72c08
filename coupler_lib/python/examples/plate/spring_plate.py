# SPDX-License-Identifier: MIT
"""A plate on a spring in the place of fem_solver: spring_plate.py coupling.toml [--as ROLE] [--out FOLDER] [--set KEY=VALUE ...]"""
import sys

import numpy as np
import rivage

MASS, STIFFNESS = 100.0, 1e6                     # [kg/m], [N/m per metre of depth]


def vertical(y: float) -> np.ndarray:
    return np.array([[0, y], [0, y]])


with rivage.Participant("solid", sys.argv[1], sys.argv[2:]) as me:
    wet = me.solid(dimension=2, node_ids=[0, 1], reference=[[1, 0], [0, 0]], facets=[[0, 1]])    # the body on the left of 0 -> 1
    tables = rivage.SolidTables(me, ["plate.uy[m]"])
    u = v = work = 0.0
    for window in wet.windows():                 # load n has come: wet.force, window.time, window.dt
        force = wet.force[:, 1].sum()
        a = (force - STIFFNESS * u) / MASS
        told = {"work": work, "kinetic": 0.5 * MASS * v**2, "strain": 0.5 * STIFFNESS * u**2}
        wet.send(wet.reference + vertical(u), vertical(v), vertical(a), **told)
        tables.write(window, [u], **told)
        if not window.last:                      # the step that the fluid makes meanwhile
            v += window.dt * a
            u += window.dt * v
            work += force * window.dt * v
    print(f"plate: u = {u:.6e} m at t = {window.time:g} s")
