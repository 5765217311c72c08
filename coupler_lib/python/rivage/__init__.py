# SPDX-License-Identifier: MIT
"""Couple a solver of your own to Rivage's fluid or solid.

    import numpy as np, rivage

    with rivage.Participant("solid", "coupling.toml") as me:
        wet = me.solid(dimension=2, node_ids=[0, 1], reference=[[1, 0], [0, 0]], facets=[[0, 1]])
        u = v = 0.0
        for window in wet.windows():                  # load n has come: wet.force, window.time, window.dt
            a = (wet.force[:, 1].sum() - 1e6 * u) / 100
            column = lambda y: np.array([[0, y], [0, y]])
            wet.send(wet.reference + column(u), column(v), column(a), kinetic=50 * v**2, strain=0.5e6 * u**2)
            v += window.dt * a
            u += window.dt * v

Arrays are numpy's, [nodes, dimension] or [facets]; those that come in are views of the library's memory, valid until the next
receive. SI units; 2D is per metre of depth.
"""
from rivage.own_file import read_own_file
from rivage.participant import Error, Participant, version
from rivage.sides import Fluid, Solid, Window
from rivage.tables import SolidTables

__all__ = ["Error", "Fluid", "Participant", "Solid", "SolidTables", "Window", "read_own_file", "version"]
