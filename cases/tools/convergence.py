# SPDX-License-Identifier: MIT
"""Figures followed over resolutions: one [[convergence]] table of expect.toml each.

The keys of [[expect]] say how the figure is taken from a run; besides

    runs  = ["dx 0.04", "dx 0.02", "dx 0.01"]    names from verify.toml, the coarsest first
    exact = 0.0                                  what the figure should be; then the errors |figure - exact| are followed,
                                                 without it the differences of consecutive runs
    show  = "order" or "ratio"                   what is judged: the lowest order log(e1/e2)/log(dx1/dx2), or the lowest
                                                 ratio e1/e2, of two consecutive errors (differences)
"""
import math
import tomllib
from pathlib import Path

from expectations import Finding, measure
from run_folder import RunFolder


def spacing(run: RunFolder) -> float:
    """The particle spacing that the run used [m]."""
    used = tomllib.loads((run.path / "used_config.toml").read_text(encoding="utf-8"))
    return float(used["fluid"]["resolution"]["spacing"])


def rates(dx: list[float], figures: list[float], exact: float | None, show: str) -> list[float]:
    """The order or the ratio of each two consecutive errors, or differences where the exact value is not known."""
    if exact is None:
        errors = [abs(a - b) for a, b in zip(figures, figures[1:])]
    else:
        errors = [abs(figure - exact) for figure in figures]
    pairs = zip(errors, errors[1:], dx, dx[1:])
    if show == "ratio":
        return [coarse / fine if fine else math.inf for coarse, fine, _, _ in pairs]
    return [math.log(coarse / fine) / math.log(wide / narrow) for coarse, fine, wide, narrow in pairs]


def extrapolated(figures: list[float]) -> float | None:
    """Where three figures over dx, dx/r and dx/r^2 tend to, their error taken as a power of dx (Richardson):

        f = f_3 + (f_3 - f_2)^2 / ((f_2 - f_1) - (f_3 - f_2))

    None where the differences do not shrink with one sign, or there are not three."""
    if len(figures) != 3:
        return None
    first, last = figures[1] - figures[0], figures[2] - figures[1]
    return figures[2] + last**2 / (first - last) if first * last > 0 and abs(first) > abs(last) else None


def followed(case: str, entry: dict, runs: dict[str, RunFolder]) -> Finding:
    """The lowest rate over the runs named by the entry, with the figures themselves as the finding's detail."""
    missing = [name for name in entry["runs"] if name not in runs]
    if missing:
        return Finding(case, entry, None, f"no run {', '.join(missing)}")
    chosen = [runs[name] for name in entry["runs"]]
    try:
        dx = [spacing(run) for run in chosen]
        figures = [measure(run, entry) for run in chosen]
        found = rates(dx, figures, entry.get("exact"), entry["show"])
    except (KeyError, ValueError, TypeError, OSError) as error:
        return Finding(case, entry, None, str(error).strip("'\""))
    detail = "; ".join(f"dx = {d:g} m: {figure:.5g}" for d, figure in zip(dx, figures))
    limit = extrapolated(figures) if "exact" not in entry else None
    detail += "" if limit is None else f"; extrapolated {limit:.5g}"
    return Finding(case, entry, min(found), "", f"{detail}; {entry['show']} {', '.join(f'{rate:.2f}' for rate in found)}")


def check_convergence(folder: Path, case: str, runs: dict[str, RunFolder]) -> list[Finding]:
    path = folder / "expect.toml"
    if not path.exists():
        return []
    entries = tomllib.loads(path.read_text(encoding="utf-8")).get("convergence", [])
    return [followed(case, entry | {"folder": folder}, runs) for entry in entries]
