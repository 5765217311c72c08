# SPDX-License-Identifier: MIT
"""Rigid wedge entering water at constant speed: the exact self-similar flow (incompressible, no gravity), after Dobrovol'skaya (1969).

usage: similarity.py [DEADRISE_IN_DEGREES ...]        needs numpy and scipy; half a minute

Lengths over V t, speeds over V, apex at -i, the left half of the water. The upper half plane of t is mapped on it: t < 0 the plane
of symmetry, 0 < t < 1 the wedge, t > 1 the free surface, t = 1 the tip of the jet. Wagner's function, the integral of sqrt(W'') dz,
maps the water on a right-angled isosceles triangle; on the free surface the arc s from the tip is the speed in these coordinates. So
    |W''| |dz/dt|^2 = K / (|t| |t - 1|^(3/2)),     s s' a' = -K / (t (t - 1)^(3/2))   on the free surface, a its direction,
    ln |dz/dt| = ln A - (1/2 - b/pi) ln |t| - (1 - m) ln |t - 1| - (1/pi) int_1^inf a'(u) ln |t - u| du,
b the deadrise, m pi the angle of the jet. K follows from the turn of the free surface, m from rest at infinity, A from the level there.
"""
import sys

import numpy as np
from scipy.special import spence


def integral_of_log(x: np.ndarray, sign: float) -> np.ndarray:
    """Integral from 0 to x of ln |1 + sign exp(y)| dy, but for a constant."""
    tail = spence(1 + sign * np.exp(-np.abs(x)))                     # Li2(-sign exp(-|x|))
    return np.where(x > 0, 0.5 * x**2 + tail - spence(1 + sign) * 2, -tail)


def mean_logs(points: np.ndarray, edges: np.ndarray, sign: float) -> np.ndarray:
    """Mean of ln |exp(point) + sign exp(y)| over the cells of y: a row a point, a column a cell."""
    primitive = integral_of_log(edges[None, :] - points[:, None], sign)
    return np.diff(primitive, axis=1) / np.diff(edges)[None, :] + points[:, None]


class Flow:
    """Free surface on a grid in ln(t - 1), wedge on one in ln(t / (1 - t))."""

    def __init__(self, cells: int):
        self.edges = np.linspace(-50.0, 40.0, cells + 1)
        self.x, self.dx = 0.5 * (self.edges[1:] + self.edges[:-1]), self.edges[1] - self.edges[0]
        self.log_t = np.logaddexp(0, self.x)
        self.kernel = mean_logs(self.x, self.edges, -1.0) / np.pi
        self.y = (np.arange(2 * cells) + 0.5) * self.dx - 80.0
        self.to_tip = -np.logaddexp(0, self.y)                       # ln(1 - t)
        self.wedge_kernel = mean_logs(self.to_tip, self.edges, 1.0) / np.pi
        self.sum_up = (np.tri(cells) - 0.5 * np.eye(cells)) * self.dx

    def guess(self, deadrise: float, m: float, root: float) -> np.ndarray:
        """Unknowns: ln of the turn within each cell, m, ln(K dx / A^2)."""
        drop = 1 / np.cosh((self.x - root) / 1.5)
        return np.concatenate([np.log(drop * (np.pi - deadrise - m * np.pi) / drop.sum()), [m, 0.0]])

    def free_surface(self, b: float, unknown: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Residual of its equation, in logarithms, and the derivatives; keeps ds/dx and the straight jet before the grid, over A."""
        n, drop, m, k = len(self.x), np.exp(unknown[:-2]), unknown[-2], unknown[-1]
        self.slope = np.exp(-(0.5 - b / np.pi) * self.log_t + m * self.x + self.kernel @ drop)
        d_log = np.hstack([self.kernel * drop, self.x[:, None], np.zeros((n, 1))])
        self.jet = self.slope[0] / m * np.exp(-0.5 * m * self.dx)
        self.d_jet = self.jet * d_log[0]
        self.d_jet[-2] -= self.jet * (1 / m + 0.5 * self.dx)
        self.d_slope = self.slope[:, None] * d_log
        s, d_s = self.jet + self.sum_up @ self.slope, self.d_jet + self.sum_up @ self.d_slope
        derivative = d_s / s[:, None] + d_log + np.eye(n, n + 2)
        derivative[:, -1] -= 1
        return unknown[:-2] - k - 0.5 * self.x + self.log_t + np.log(s * self.slope), derivative

    def wetted(self, b: float, drop: np.ndarray, m: float) -> tuple[float, np.ndarray]:
        """Length of the wedge's wet side over A and its derivatives; keeps ds/dy."""
        self.wedge = np.exp((0.5 + b / np.pi) * (self.y + self.to_tip) + m * self.to_tip + self.wedge_kernel @ drop)
        last = self.wedge[-1] / m                                    # between the grid's end and the tip
        derivative = np.append(self.wedge @ self.wedge_kernel * drop, [self.wedge @ self.to_tip, 0.0]) * self.dx
        derivative[:-2] += last * self.wedge_kernel[-1] * drop
        derivative[-2] += last * (self.to_tip[-1] - 1 / m - 0.5 * self.dx)
        return np.sum(self.wedge) * self.dx + last * np.exp(-0.5 * m * self.dx), derivative

    def rest(self, b: float, drop: np.ndarray, m: float) -> tuple[float, np.ndarray]:
        """Horizontal speed at infinity, over the wetted width's growth, and its derivatives; sets A by the level at infinity."""
        above = self.sum_up.T @ drop / self.dx                       # direction less pi
        d_above = np.hstack([self.sum_up.T * drop / self.dx, np.zeros((len(drop), 2))])
        back, sine = 1 - np.cos(above), np.sin(above)
        across = np.sum(back * self.slope) * self.dx + back[0] * self.jet
        d_across = (back @ self.d_slope + (sine * self.slope) @ d_above) * self.dx + back[0] * self.d_jet + sine[0] * self.jet * d_above[0]
        length, d_length = self.wetted(b, drop, m)
        down = np.sum(sine * self.slope) * self.dx + sine[0] * self.jet
        self.a = 1 / (length * np.sin(b) - down)
        self.length = self.a * length
        return across / (length * np.cos(b)) - 1, (d_across - across / length * d_length) / (length * np.cos(b))

    def residual(self, b: float, unknown: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of the free surface's equation, of its whole turn and of the rest at infinity; with the derivatives."""
        drop, m = np.exp(unknown[:-2]), unknown[-2]
        self.b, self.m, self.k = b, m, np.exp(unknown[-1]) / self.dx
        surface, d_surface = self.free_surface(b, unknown)
        far, d_far = self.rest(b, drop, m)
        return np.append(surface, [drop.sum() - np.pi + b + m * np.pi, far]), np.vstack([d_surface, np.append(drop, [np.pi, 0.0]), d_far])

    def solve(self, b: float, unknown: np.ndarray) -> np.ndarray:
        """Newton, damped while far."""
        for _ in range(200):
            r, derivative = self.residual(b, unknown)
            step = np.linalg.solve(derivative, r)
            part = min(1.0, 0.5 / np.abs(step[:-2]).max(), 0.3 * unknown[-2] / abs(step[-2]))
            unknown = unknown - part * step
            if part == 1 and np.abs(step).max() < 1e-9:
                self.residual(b, unknown)
                return unknown
        raise RuntimeError(f"no convergence at {np.degrees(b)} degrees: {np.abs(r).max()}")

    def pressure(self) -> tuple[np.ndarray, np.ndarray]:
        """Distance from the apex, p over rho V^2."""
        s = self.a * (np.cumsum(self.wedge) - 0.5 * self.wedge) * self.dx
        grow = self.k * self.a * np.exp(1.5 * self.to_tip + self.y) / self.wedge
        speed = -np.sin(self.b) + (np.cumsum(grow) - 0.5 * grow) * self.dx
        self.tip_error = speed[-1] - (self.length - np.sin(self.b))  # the tip stays a tip: an equation not used above
        gain = (speed - s + np.sin(self.b)) * grow * self.dx
        return s, np.cumsum(gain[::-1])[::-1] - 0.5 * gain


def solved(deadrise: float, cells: int) -> Flow:
    """By way of blunter wedges, from 45 degrees."""
    flow, b = Flow(cells), np.radians(45)
    unknown = flow.solve(b, flow.guess(b, 0.02, -3.0))
    while b > deadrise:
        b = max(deadrise, 0.85 * b)
        unknown = flow.solve(b, unknown)
    return flow


def figures(deadrise: float, cells: int) -> np.ndarray:
    flow = solved(deadrise, cells)
    s, p = flow.pressure()
    force = 2 * np.cos(deadrise) * np.sum(p * flow.a * flow.wedge) * flow.dx
    peak = s[np.argmax(p)]
    root = (flow.length - peak) * np.tan(np.pi * flow.m)             # the jet as a triangle from the peak on, all at the tip's speed
    area, tip = 0.5 * root * (flow.length - peak), abs(flow.length * np.exp(1j * deadrise) - 1j)
    return np.array([force, 2 * p.max(), 2 * p[0], np.sin(deadrise) * peak, 180 * flow.m, flow.length, flow.tip_error,
                     root, 2 * area * np.tan(deadrise), 2 * area * tip**2 / force])


def main() -> None:
    names = ("force of the whole wedge / rho V^3 t", "largest pressure / (rho V^2 / 2)", "pressure at the apex / (rho V^2 / 2)",
             "height of the peak above the apex / V t", "angle of the jet [degrees]", "wetted length with the jet / V t", "speed at the tip, error / V",
             "jet's thickness at the peak / V t", "jet's share of the displaced water", "jet's share of the work")
    for degrees in [float(a) for a in sys.argv[1:]] or [10.0]:
        coarse, fine = (figures(np.radians(degrees), cells) for cells in (450, 900))
        print(f"deadrise {degrees} degrees: 450 cells, 900, limit of second order")
        for name, a, b in zip(names, coarse, fine):
            print(f"  {name:42s} {a:10.5g} {b:10.5g} {b + (b - a) / 3:10.5g}")


if __name__ == "__main__":
    main()
