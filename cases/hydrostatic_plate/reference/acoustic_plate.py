# SPDX-License-Identifier: MIT
"""The plate's swing under linear acoustics, computed apart from Rivage: plane-strain modes of the plate, layered water.

usage: acoustic_plate.py [FILE.csv]        needs numpy and scipy; some seconds

Plate: the lowest symmetric modes of 80 x 4 eight-node quadrilaterals, M_k = 1:   q_k'' + w_k^2 q_k = f_k(weight, p0 + p)
Water: p = sum_n P_n(y, t) cos(n pi x), n even, u likewise, with rho(y) and c(y) of Tait's water at rest (layered) or of its surface (uniform):
    rho v' = -dP/dy,   rho u' = k P,   P' = -rho c^2 (dv/dy + k u),   v(0) = sum_k A_nk q_k',   P(H) = 0
on a staggered grid in y, leapfrog in time. Half a cell of water moves with the plate.
"""
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

LENGTH, THICKNESS, YOUNG, POISSON, DENSITY = 1.0, 0.05, 67.5e9, 0.34, 2700.0
HEIGHT, WATER, C0, GRAVITY, GAMMA = 2.0, 1000.0, 62.64, 9.81, 7.0
CORNERS = [(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0)]
POINTS = (np.arange(4000) + 0.5) / 4000                     # along the plate, for the integrals


def shapes(r: float, s: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Values and derivatives of the eight shape functions."""
    n, dr, ds = np.zeros((3, 8))
    for k, (p, q) in enumerate(CORNERS):
        if p and q:
            n[k] = (1 + p * r) * (1 + q * s) * (p * r + q * s - 1) / 4
            dr[k] = p * (1 + q * s) * (2 * p * r + q * s) / 4
            ds[k] = q * (1 + p * r) * (2 * q * s + p * r) / 4
        elif q:
            n[k], dr[k], ds[k] = (1 - r * r) * (1 + q * s) / 2, -r * (1 + q * s), q * (1 - r * r) / 2
        else:
            n[k], dr[k], ds[k] = (1 - s * s) * (1 + p * r) / 2, p * (1 - s * s) / 2, -s * (1 + p * r)
    return n, dr, ds


def element(a: float, b: float) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness (2 x 2 points) and mass (3 x 3) of a rectangle of the half sides a and b."""
    lame, shear = YOUNG * POISSON / (1 + POISSON) / (1 - 2 * POISSON), YOUNG / 2 / (1 + POISSON)
    law = np.array([[lame + 2 * shear, lame, 0], [lame, lame + 2 * shear, 0], [0, 0, shear]])
    stiffness, mass = np.zeros((2, 16, 16))
    for order in (2, 3):
        points, weights = np.polynomial.legendre.leggauss(order)
        for r, wr in zip(points, weights):
            for s, ws in zip(points, weights):
                n, dr, ds = shapes(r, s)
                strain, value = np.zeros((3, 16)), np.zeros((2, 16))
                strain[0, ::2], strain[1, 1::2], strain[2, ::2], strain[2, 1::2] = dr / a, ds / b, ds / b, dr / a
                value[0, ::2], value[1, 1::2] = n, n
                if order == 2:
                    stiffness += strain.T @ law @ strain * a * b * wr * ws
                else:
                    mass += DENSITY * value.T @ value * a * b * wr * ws
    return stiffness, mass


def plate(nx: int = 80, ny: int = 4, kept: int = 8):
    """(angular frequencies, upper face's deflection at POINTS, mid-plane's middle, integral of rho u_y) of the symmetric modes."""
    def node(i, j):
        return i * (2 * ny + 1) + j

    count = (2 * nx + 1) * (2 * ny + 1)
    nodes = np.array([[node(2 * i + 1 + p, 2 * j + 1 + q) for p, q in CORNERS] for i in range(nx) for j in range(ny)])
    dofs = np.stack([2 * nodes, 2 * nodes + 1], 2).reshape(len(nodes), 16)
    where = (np.repeat(dofs, 16, 1).ravel(), np.tile(dofs, (1, 16)).ravel())
    stiffness, mass = (sparse.csr_matrix((np.tile(part.ravel(), len(nodes)), where), shape=(2 * count, 2 * count))
                       for part in element(LENGTH / nx / 2, THICKNESS / ny / 2))
    free = np.zeros(count, bool)
    free[nodes.ravel()] = True
    free[:node(1, 0)] = free[node(2 * nx, 0):] = False
    rows = np.flatnonzero(np.repeat(free, 2))
    squares, vectors = linalg.eigsh(stiffness[rows][:, rows].tocsc(), 3 * kept, mass[rows][:, rows].tocsc(), sigma=0)
    full = np.zeros((2 * count, 3 * kept))
    full[rows] = vectors
    top = full[[2 * node(i, 2 * ny) + 1 for i in range(2 * nx + 1)]]
    cell = (POINTS * nx).astype(int)
    r = (2 * (POINTS * nx - cell) - 1)[:, None]
    face = r * (r - 1) / 2 * top[2 * cell] + (1 - r * r) * top[2 * cell + 1] + r * (r + 1) / 2 * top[2 * cell + 2]
    upwards = np.tile([0.0, 1.0], count)
    symmetric = np.flatnonzero(np.abs(face.mean(0)) > 1e-6 * np.abs(face).max())[:kept]
    return (np.sqrt(squares)[symmetric], face[:, symmetric], full[2 * node(nx, ny) + 1, symmetric],
            (full.T @ (mass @ upwards))[symmetric])


def swing(modes, layered: bool, end: float = 0.08, cells: int = 800, cosines: int = 32) -> tuple[np.ndarray, np.ndarray]:
    """Times and the displacement of the middle."""
    omega, face, middle, weight = modes
    k = 2 * np.pi * np.arange(cosines)
    project = np.cos(np.outer(k, POINTS)) @ face / len(POINTS)
    norm = np.where(k == 0, 1.0, 2.0)[:, None]
    dy = HEIGHT / cells

    def ratio(y):                                           # rho / rho0 of Tait's water at rest
        return (1 + layered * (GAMMA - 1) * GRAVITY * (HEIGHT - y) / C0**2) ** (1 / (GAMMA - 1))

    at_cells, at_faces = ratio((np.arange(cells) + 0.5) * dy), WATER * ratio(np.arange(cells + 1) * dy)
    rho, modulus = WATER * at_cells, WATER * at_cells * (C0 * at_cells**3) ** 2
    bottom = WATER * C0**2 / GAMMA * (ratio(0.0) ** GAMMA - 1) if layered else WATER * GRAVITY * HEIGHT
    load = -bottom * face.mean(0) - GRAVITY * weight
    inverse = np.linalg.inv(np.eye(len(omega)) + at_faces[0] * dy / 2 * (project * norm).T @ project)
    steps = int(np.ceil(end / min(0.55 * dy / C0, 1.6 / omega[-1])))
    dt = end / steps
    p, u, v = np.zeros((cosines, cells)), np.zeros((cosines, cells)), np.zeros((cosines, cells + 1))
    q, speed, w = np.zeros(len(omega)), np.zeros(len(omega)), np.zeros(steps + 1)
    for step in range(steps):
        speed += (dt if step else dt / 2) * inverse @ (load - omega**2 * q - project.T @ p[:, 0])
        v[:, 1:-1] -= dt / dy / at_faces[1:-1] * (p[:, 1:] - p[:, :-1])
        v[:, -1] += 2 * dt / dy / at_faces[-1] * p[:, -1]
        v[:, 0] = norm[:, 0] * (project @ speed)
        u += dt * k[:, None] / rho * p
        p -= dt * modulus * ((v[:, 1:] - v[:, :-1]) / dy + k[:, None] * u)
        q += dt * speed
        w[step + 1] = q @ middle
    return dt * np.arange(steps + 1), w


def main() -> None:
    modes = plate()
    times = np.linspace(0, 0.08, 801)
    columns = [times] + [np.interp(times, *swing(modes, layered)) for layered in (True, False)]
    with open(sys.argv[1] if len(sys.argv) > 1 else "plate_continuum_c0_62.64.csv", "w", encoding="utf-8") as out:
        out.write("# The plate's swing: plane-strain modes, linear acoustics; Tait's layers, and uniform water. By acoustic_plate.py.\n")
        out.write("t[s],w_layered[m],w_uniform[m]\n")
        for row in zip(*columns):
            out.write(",".join(f"{value:.7g}" for value in row) + "\n")


if __name__ == "__main__":
    main()
