# SPDX-License-Identifier: MIT
"""What the water's compressibility does to Wagner's linear theory of the wedge: the wetted length grows below the speed of sound.

usage: acoustic.py [SOUND_SPEED ...]        needs numpy and scipy

Linear acoustics below y = 0: -V on |x| < c(t) = c' t, p = 0 beside it. Pressure and speed depend on z = x / (c' t) alone (a conical
flow, as a slender delta wing's in supersonic flow, t for the wing's chord). With M = c' / c0 and E the complete elliptic integral,
    on the wedge     p = rho V c' / (E(k) sqrt(1 - z^2)),   k^2 = 1 - M^2
    on the water     dv/dz = -(V / E(k)) sqrt(1 - M^2 z^2) / (z^2 - 1)^(3/2),   v = 0 at z = 1 / M
E(k) follows from the way down the axis, where v goes from 0 at the wave to -V at the wedge. That the water meets the wedge gives
    c' tan(b) / V = 1 + int_1^(1/M) v / (V z^2) dz,   F = pi rho V c'^2 t / E(k),   b the deadrise.
At M = 0: pi / 2 and Wagner's pi^3 / (4 tan^2 b).
"""
import sys

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe

SPEED, DEADRISE = 30.0, np.radians(10)


def rise(mach: float) -> float:
    """c' tan(b) / V; the integral by parts, with z = 1 + u^2."""
    def slope(u: float) -> float:
        z = 1 + u * u
        return 2 / z * np.sqrt(max(0.0, 1 - (mach * z)**2)) / (2 + u * u)**1.5
    return 1 + quad(slope, 0, np.sqrt(1 / mach - 1), limit=200)[0] / ellipe(1 - mach**2)


def main() -> None:
    slow = SPEED / np.tan(DEADRISE)
    for c0 in [float(a) for a in sys.argv[1:]] or [1480.0, 3000.0, 4500.0, 1e6]:
        mach = brentq(lambda m: rise(m) * slow / c0 - m, 1e-7, 0.9)
        length, pressure = rise(mach) / (np.pi / 2), 1 / ellipe(1 - mach**2)
        print(f"c0 = {c0:g} m/s: M = {mach:.4f}, over incompressible: wetted length {length:.4f}, pressure at the apex {length * pressure:.4f}, "
              f"force {length**2 * pressure:.4f}")


if __name__ == "__main__":
    main()
