# SPDX-License-Identifier: MIT
"""Elastic wedge entering incompressible water at constant speed: Wagner's linear theory, and the modified Logvinovich pressure on top of it.

usage: hydroelastic.py [FILE.csv]        needs numpy and scipy; ten seconds; FILE: the second of the two

Panel: clamped-clamped modes, stiffness / 1.0647 for shear:   m (a_n'' + w_n^2 a_n) = int_0^L p psi_n dx,   deflection w = sum a_n psi_n
Water, -y_t down on |x| < c, y = x tan(b) - V t + w the wedge:   phi_y = y_t there, phi = 0 beside it; with x = c cos(th)
    phi = sum_j B_j sin(j th),   B_j = (2 / (pi j)) int_0^pi y_t c sin(th) sin(j th) dth,   int_0^(pi/2) y(c sin(th)) dth = 0 gives c
Linear: p = -rho phi_t. Modified Logvinovich (Korobkin 2004), f = phi + y y_t the potential on the wedge, until p = 0 near the edge:
    p = -rho (f_t - y_x y_t f_x / (1 + y_x^2) + (f_x^2 - y_t^2) / (2 (1 + y_x^2)))
x runs along the panel as in the linear theory. On the rigid wedge of 10 degrees: 249.3 and 209.3 rho V^3 t; the exact flow has 213.0.
"""
import sys

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

LENGTH, THICKNESS, YOUNG, POISSON, DENSITY, WATER, SPEED, TAN = 0.6, 0.04, 67.5e9, 0.34, 2700.0, 1000.0, 30.0, np.tan(np.radians(10))
STIFFNESS, MASS = YOUNG * THICKNESS**3 / 12 / (1 - POISSON**2) / 1.0647, DENSITY * THICKNESS
MODES, TERMS, STEP, END = 10, np.arange(1, 80, 2), 2e-6, 2.2e-3


class Panel:
    """Modes, the mean square of each 1, even about x = 0."""

    def __init__(self):
        roots = [brentq(lambda k: np.cos(k) - 1 / np.cosh(k), (n + 0.5) * np.pi - 0.5, (n + 0.5) * np.pi + 0.5) for n in range(1, MODES + 1)]
        self.k = np.array(roots)[:, None]
        self.ratio = (np.cosh(self.k) - np.cos(self.k)) / (np.sinh(self.k) - np.sin(self.k))
        self.omega = self.k[:, 0]**2 / LENGTH**2 * np.sqrt(STIFFNESS / MASS)

    def shapes(self, x: np.ndarray, slope: bool = False) -> np.ndarray:
        """Values or slopes of the modes, a row each; cosh - ratio sinh by decaying exponentials."""
        z = self.k * np.abs(x)[None, :] / LENGTH
        up, down = 0.5 * (1 - self.ratio) * np.exp(z), 0.5 * (1 + self.ratio) * np.exp(-z)
        if slope:
            return self.k / LENGTH * (up - down + np.sin(z) + self.ratio * np.cos(z)) * np.sign(x)
        return up + down - np.cos(z) + self.ratio * np.sin(z)


class Water:
    """B_j of unit speed and of each mode, and the mean of each mode over the wet width, as splines in c."""

    def __init__(self, panel: Panel):
        c = np.linspace(0, LENGTH, 301)
        th = (np.arange(600) + 0.5) * np.pi / 600
        table, mean = [], []
        for width in c:
            shapes = np.vstack([np.ones(len(th)), panel.shapes(width * np.cos(th))])
            table.append((shapes * width * np.sin(th)) @ np.sin(np.outer(th, TERMS)) * 2 / 600 / TERMS)
            mean.append(panel.shapes(width * np.cos(th)).sum(axis=1) * np.pi / 1200)
        self.b, self.mean = CubicSpline(c, np.array(table)), CubicSpline(c, np.array(mean))
        self.th = np.pi / 2 * ((np.arange(400) + 0.5) / 400)**2       # fine near the edge
        self.weight = np.pi / 400 * (np.arange(400) + 0.5) / 400
        self.sines, self.cosines = np.sin(np.outer(TERMS, self.th)), np.cos(np.outer(TERMS, self.th))

    def impulses(self, c: float, derivative: int = 0) -> np.ndarray:
        """Integrals over 0..c of phi of one times another, unit speed first; or their derivatives."""
        b, db = self.b(c) * TERMS, self.b(c, 1)
        return np.pi / 4 * (b @ self.b(c).T if not derivative else b @ db.T + db @ b.T)


class Entry:
    def __init__(self, logvinovich: bool):
        self.panel = Panel()
        self.water, self.logvinovich = Water(self.panel), logvinovich
        self.c, self.extra = 0.0, np.zeros(MODES)

    def width(self, t: float, a: np.ndarray) -> float:
        c = max(self.c, 1e-9)
        for _ in range(30):
            step = (c * TAN - SPEED * t * np.pi / 2 + self.water.mean(c) @ a) / (TAN + self.water.mean(c, 1) @ a)
            c -= step
            if abs(step) < 1e-13:
                break
        return c

    def rates(self, t: float, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """a', b' with m b = m a' + the water's impulse on each mode."""
        self.c = c = self.width(t, a)
        s = WATER * self.water.impulses(c)
        matrix = MASS * LENGTH * np.eye(MODES) + s[1:, 1:]
        v = np.linalg.solve(matrix, b + SPEED * s[1:, 0])
        pull = -MASS * LENGTH * self.panel.omega**2 * a
        if self.logvinovich and t > 0:
            growth = (SPEED * np.pi / 2 - self.water.mean(c) @ v) / (TAN + self.water.mean(c, 1) @ a)
            ds = WATER * self.water.impulses(c, 1) * growth
            acceleration = np.linalg.solve(matrix, pull + self.extra + SPEED * ds[1:, 0] - ds[1:, 1:] @ v)
            self.extra = self.correction(t, c, growth, a, v, acceleration)
        return v, pull + self.extra

    def correction(self, t: float, c: float, growth: float, a, v, acceleration) -> np.ndarray:
        """Modified Logvinovich less linear: the force on each mode."""
        w, x = self.water, self.water.th
        x, sine = c * np.cos(w.th), np.sin(w.th)
        shapes, speeds = self.panel.shapes(x), np.concatenate([[-SPEED], v])
        b, db = speeds @ w.b(c), speeds @ w.b(c, 1)
        along = (b * TERMS) @ w.cosines                              # d phi / d th
        phi_t = growth * (db @ w.sines + along * np.cos(w.th) / (c * sine)) + (acceleration @ w.b(c)[1:]) @ w.sines
        phi_x = -along / (c * sine)
        y, y_t, y_tt = x * TAN - SPEED * t + a @ shapes, -SPEED + v @ shapes, acceleration @ shapes
        y_x, y_xt = TAN + a @ self.panel.shapes(x, True), v @ self.panel.shapes(x, True)
        f_x = phi_x + y_x * y_t + y * y_xt
        p = -WATER * (phi_t + y_t**2 + y * y_tt + (-y_x * y_t * f_x + 0.5 * (f_x**2 - y_t**2)) / (1 + y_x**2))
        p[:np.argmax(p > 0)] = 0
        self.force = 2 * np.sum(p * c * sine * w.weight)
        return shapes @ ((p + WATER * phi_t) * c * sine * w.weight)

    def run(self) -> np.ndarray:
        """Rows of t, c, deflection of the middle."""
        a, b, rows = np.zeros(MODES), np.zeros(MODES), [(0.0, 0.0, 0.0)]
        middle = self.panel.shapes(np.array([LENGTH / 2]))[:, 0]
        for n in range(round(END / STEP)):
            t = n * STEP
            k1 = self.rates(t, a, b)
            k2 = self.rates(t + STEP / 2, a + STEP / 2 * k1[0], b + STEP / 2 * k1[1])
            k3 = self.rates(t + STEP / 2, a + STEP / 2 * k2[0], b + STEP / 2 * k2[1])
            k4 = self.rates(t + STEP, a + STEP * k3[0], b + STEP * k3[1])
            a, b = (u + STEP / 6 * (p + 2 * q + 2 * r + s) for u, p, q, r, s in zip((a, b), k1, k2, k3, k4))
            rows.append((t + STEP, self.c, middle @ a))
        return np.array(rows)


def main() -> None:
    for name, logvinovich in (("linear", False), ("modified Logvinovich", True)):
        t, c, w = Entry(logvinovich).run().T
        print(f"{name}: " + ", ".join(f"{1e3 * np.interp(at, t, w):.2f} mm at {1e3 * at:g} ms" for at in (1e-3, 1.5e-3, 2e-3, 2.2e-3))
              + f"; wetted to 0.45 m at {1e3 * np.interp(0.45, c, t):.3f} ms")
    if len(sys.argv) > 1:
        with open(sys.argv[1], "w", encoding="utf-8") as file:
            file.write("# Wagner's hydroelastic model with the modified Logvinovich pressure, incompressible: made by hydroelastic.py.\n")
            file.write("t[s],wetted_half_length_c[m],w_x0.30_mid[m]\n")
            for row in zip(t[::10], c[::10], w[::10]):
                file.write(",".join(f"{value:.6g}" for value in row) + "\n")


if __name__ == "__main__":
    main()
