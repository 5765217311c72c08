# SPDX-License-Identifier: MIT
"""A piston that radiates into an unbounded fluid: m u'' + Z u' + k u = -p, Z = rho c, has an exact answer.

The fake fluid's pressure p + Z v.n meets the fake solid's spring and mass through the whole coupling. Shown: the
impedance-corrected exchange converges to the exact motion with second order and stays right where beta = Z dt/m is
far above 1; the plain parallel exchange, lagged by a step, does not; both load kinds agree; so do 1+1 and 3+2 ranks.

usage: exact_pair.py --programs BIN_FOLDER
"""
import argparse
import cmath
import csv
import sys
from pathlib import Path

from drill_tools import Run, fluid, solid

MASS, STIFFNESS, PRESSURE = 100.0, 1e6, 1000.0  # of drill_case


def exact(t: float, impedance: float) -> float:
    """From rest at u = 0, relaxing about -p/k."""
    rest = -PRESSURE / STIFFNESS
    damping = impedance / (2 * MASS)
    root = cmath.sqrt(damping**2 - STIFFNESS / MASS)
    fast, slow = -damping - root, -damping + root
    return rest * (1 - ((slow * cmath.exp(fast * t) - fast * cmath.exp(slow * t)) / (slow - fast)).real)


def solve(programs, dt, impedance, scheme="parallel_impedance", load="conservative", ranks=(1, 1), end=0.1):
    """(error relative to p/k, largest work mismatch relative to the peak work, displacements)."""
    settings = (f"fluid.fluid.dt={dt}", f"fluid.fluid.impedance={impedance}", f'coupling.coupling.scheme="{scheme}"',
                f'coupling.interface.load="{load}"', f"coupling.time.end={end}", "coupling.interface.motion_jump_limit=1e300")
    run = Run(programs, [fluid(ranks=ranks[0]), solid(ranks=ranks[1])], settings).finish()
    assert run.code == 0, run.text
    with (run.out / "solid" / "probes.csv").open() as file:
        rows = [(float(row["t[s]"]), float(row["piston.u[m]"])) for row in csv.DictReader(file)]
    with (run.out / "coupling" / "interface.csv").open() as file:
        works = [(float(row["work_on_fluid[J/m]"]), float(row["work_on_solid[J/m]"])) for row in csv.DictReader(file)]
    error = max(abs(u - exact(t, impedance)) for t, u in rows) * STIFFNESS / PRESSURE
    mismatch = max(abs(a + b) for a, b in works) / max(max(abs(a), abs(b)) for a, b in works)
    print(f"  {scheme}, {load}, dt {dt}, Z {impedance}, ranks {ranks}: error {error:.3e}, work mismatch {mismatch:.3e}", flush=True)
    return error, mismatch, [u for _, u in rows]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True)
    programs = parser.parse_args().programs
    coarse, coarse_gap, _ = solve(programs, 1e-3, 5e3)
    fine, fine_gap, kept = solve(programs, 5e-4, 5e3)
    assert coarse / fine > 3.5, "the corrected exchange is not of second order"
    assert fine < 2e-3 and fine_gap < 0.6 * coarse_gap, "error or work mismatch is too large"
    plain = [solve(programs, dt, 5e3, "parallel")[0] for dt in (1e-3, 5e-4)]
    assert plain[1] > 2 * fine, "the plain exchange shows no lag: was it used?"
    assert plain[0] / plain[1] > 1.7, "the plain exchange does not converge"
    stiff, _, _ = solve(programs, 1e-3, 5e5)  # beta = 5
    assert stiff < 0.05, "the corrected exchange fails where the fluid is stiff"
    _, _, averaged = solve(programs, 5e-4, 5e3, load="averaged")
    assert max(abs(a - b) for a, b in zip(kept, averaged)) < 1e-12 * PRESSURE / STIFFNESS * 1e3, "the two kinds of load differ"
    _, _, many = solve(programs, 5e-4, 5e3, ranks=(3, 2))
    assert many == kept, "the motion depends on the number of ranks"
    return 0


if __name__ == "__main__":
    sys.exit(main())
