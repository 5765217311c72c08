# SPDX-License-Identifier: MIT
"""A stand-in for the calls of Code_Aster that examples/code_aster/gate.py makes, for a test without Code_Aster.

It checks every operator's keywords and carries state as Code_Aster does, but it knows one body alone: the plate [0.1, 0.105] x
[0, 0.079], 4 x 40 cells, which moves along y without turning, a mass RHO x area on a spring of E per metre of depth, under its
weight and the pressure on its lower face. So a step has an exact answer.
"""
