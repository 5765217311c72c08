# SPDX-License-Identifier: MIT
"""One step of HHT-alpha with a factorisation that is kept as long as it serves.

    M a_1 + (1+alpha) g_1 - alpha g_0 = 0,  g = f_int - f_ext + Z (v - w),  beta = (1-alpha)^2/4,  gamma = 1/2 - alpha
    u_1 = u_0 + dt v_0 + dt^2 [(1/2-beta) a_0 + beta a_1],  v_1 = v_0 + dt [(1-gamma) a_0 + gamma a_1]
"""
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg


class NotConverged(RuntimeError):
    pass


class Load:
    """External forces, and a surface damping Z that answers to velocities other than w."""

    def __init__(self, force: np.ndarray, damping: sparse.csc_matrix | None = None, reference_velocity: np.ndarray | None = None):
        self.force, self.damping = force, damping
        self.constant = force if damping is None else force + damping @ reference_velocity

    def at(self, v: np.ndarray) -> np.ndarray:
        return self.constant if self.damping is None else self.constant - self.damping @ v


class Hht:
    """u, v, a of a body with the methods of Rubber; `fixed` unknowns stay where they are."""

    def __init__(self, body, fixed: np.ndarray, alpha: float, tolerance: float, load: Load):
        self.body, self.alpha, self.tolerance = body, alpha, tolerance
        self.beta, self.gamma = (1 - alpha)**2 / 4, 0.5 - alpha
        self.free = np.setdiff1d(np.arange(len(body.weight)), fixed)
        self.u, self.v, self.a, self.pace = (np.zeros(len(body.weight)) for _ in range(4))
        self.steps = self.factorisations = self.iterations = 0
        self.factorised_dt, self.work = 0.0, 0.0
        self.external, self.internal = load.at(self.v), body.internal_force(self.u)
        self.weighted = self.external               # f^h of the step that ended, of the fluid's load alone
        self.a[self.free] = linalg.spsolve(self.part(body.mass), (self.external + body.weight - self.internal)[self.free])

    def part(self, matrix: sparse.csc_matrix) -> sparse.csc_matrix:
        return matrix[self.free][:, self.free].tocsc()

    def factorise(self, load: Load, dt: float) -> None:
        matrix = self.body.mass / (self.beta * dt**2) + (1 + self.alpha) * self.body.tangent(self.u)
        if load.damping is not None:
            matrix = matrix + (1 + self.alpha) * self.gamma / (self.beta * dt) * load.damping
        self.factors, self.factorised_dt = linalg.splu(self.part(matrix)), dt
        self.factorisations += 1

    def advance(self, load: Load, dt: float) -> None:
        """Raises NotConverged."""
        start, before = self.u, self.external - self.internal + self.body.weight
        self.predict(dt)
        if abs(dt - self.factorised_dt) > 0.02 * self.factorised_dt:
            self.factorise(load, dt)
        last = np.inf
        for _ in range(20):
            size = self.correct(load, before, dt)
            if size <= self.tolerance:
                break
            if size > 0.1 * last:
                self.factorise(load, dt)
            last = size
        else:
            raise NotConverged(f"{size:.1e} of the forces is left after 20 iterations, {self.tolerance:.0e} is asked for")
        self.book(load, start)
        self.pace = (self.u - start) / dt
        self.steps += 1

    def predict(self, dt: float) -> None:
        """Displacements change as fast as over the step before, at first not at all."""
        change, v, a = dt * self.pace, self.v, self.a
        self.u = self.u + change
        self.a = (change - dt * v) / (self.beta * dt**2) - (0.5 / self.beta - 1) * a
        self.v = v + dt * ((1 - self.gamma) * a + self.gamma * self.a)

    def correct(self, load: Load, before: np.ndarray, dt: float) -> float:
        """The largest entry of the residual over the largest nodal force; above the tolerance one correction is made."""
        self.internal = self.body.internal_force(self.u)
        inertia = self.body.mass @ self.a
        residual = (inertia + (1 + self.alpha) * (self.internal - load.at(self.v) - self.body.weight) + self.alpha * before)[self.free]
        size = np.abs(residual).max() / max(np.abs(self.internal).max(), np.abs(inertia).max())
        if size > self.tolerance:
            step = np.zeros_like(self.u)
            step[self.free] = self.factors.solve(-residual)
            self.u, self.v = self.u + step, self.v + self.gamma / (self.beta * dt) * step
            self.a = self.a + step / (self.beta * dt**2)
            self.iterations += 1
        return size

    def book(self, load: Load, start: np.ndarray) -> None:
        """The work of the fluid's load: du . [(1-gamma) f^h_0 + gamma f^h_1], f^h_n = (1+alpha) f_n - alpha f_(n-1)."""
        now = load.at(self.v)
        weighted = (1 + self.alpha) * now - self.alpha * self.external
        self.work += float((self.u - start) @ ((1 - self.gamma) * self.weighted + self.gamma * weighted))
        self.external, self.weighted = now, weighted

    @property
    def kinetic(self) -> float:
        return float(0.5 * self.v @ (self.body.mass @ self.v))
