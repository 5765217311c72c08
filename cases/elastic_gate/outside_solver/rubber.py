# SPDX-License-Identifier: MIT
"""The gate's rubber in GetFEM: biquadratic elements, full integration, finite displacement, plane strain.

    w = mu/2 (J^(-2/3) (F:F + 1) - 3) + K/2 (J - 1)^2,  P = dw/dF,  F = 1 + grad u,  J = det F
"""
import getfem
import numpy as np
import scipy.sparse as sparse

ENERGY = "mu/2*(pow(Det(F),-2/3)*(Norm_sqr(F)+1)-3)+K/2*sqr(Det(F)-1)"
STRESS = "(mu*pow(Det(F),-2/3)*F+(K*(Det(F)-1)*Det(F)-mu*pow(Det(F),-2/3)*(Norm_sqr(F)+1)/3)*(Inv(F)'))"


def matrix(of_getfem) -> sparse.csc_matrix:
    of_getfem.to_csc()
    starts, rows = of_getfem.csc_ind()
    return sparse.csc_matrix((of_getfem.csc_val(), rows, starts))


class Rubber:
    """A rectangle [low, high] of cells[0] x cells[1] elements. Vectors are of all unknowns, x and y of a node in turn."""

    def __init__(self, low, high, cells, modulus: float, poisson: float, density: float, gravity):
        getfem.util_trace_level(0)
        lines = [np.linspace(low[k], high[k], cells[k] + 1) for k in range(2)]
        mesh = getfem.Mesh("cartesian", *lines)
        space = getfem.MeshFem(mesh, 2)
        space.set_fem(getfem.Fem("FEM_QK(2,2)"))
        self.integration = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,5)"))
        self.model = getfem.Model("real")
        self.model.add_fem_variable("u", space)
        for name, value in {"mu": modulus / (2 * (1 + poisson)), "K": modulus / (3 * (1 - 2 * poisson)), "rho": density}.items():
            self.model.add_initialized_data(name, [value])
        self.model.add_initialized_data("g", gravity)
        self.model.add_macro("F", "Id(2)+Grad_u")
        self.nodes = space.basic_dof_nodes()[:, ::2].T
        self.mass = matrix(self.assembled(2, "rho*u.Test_u"))
        self.weight = self.assembled(1, "rho*g.Test_u")

    def assembled(self, order: int, expression: str):
        """Order 0: the integral, 1: against the test functions, 2: its matrix."""
        return getfem.asm_generic(self.integration, order, expression, -1, self.model)

    def internal_force(self, u: np.ndarray) -> np.ndarray:
        self.model.set_variable("u", u)
        return self.assembled(1, f"{STRESS}:Grad_Test_u")

    def tangent(self, u: np.ndarray) -> sparse.csc_matrix:
        self.model.set_variable("u", u)
        return matrix(self.assembled(2, f"{STRESS}:Grad_Test_u"))

    def strain_energy(self, u: np.ndarray) -> float:
        self.model.set_variable("u", u)
        return float(self.assembled(0, ENERGY))

    def polyline(self, corners) -> np.ndarray:
        """The nodes met on a walk from corner to corner, straight lines along the rectangle's sides."""
        met: list[int] = []
        for a, b in zip(np.asarray(corners[:-1], float), np.asarray(corners[1:], float)):
            along = (b - a) / np.linalg.norm(b - a)
            off = np.abs((self.nodes - a) @ np.array([-along[1], along[0]]))
            on = np.flatnonzero(off < 1e-9)
            met += [node for node in on[np.argsort((self.nodes[on] - a) @ along)] if node not in met[-1:]]
        return np.array(met)
