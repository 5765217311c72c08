# SPDX-License-Identifier: MIT
"""expect.toml: the figures a case must hit, how each is taken from the run's files, and where it comes from.

One [[expect]] table a figure:

    quantity  = "tip_ux_peak[m]"     its name, with the unit
    file      = "solid/probes.csv"   CSV of the run, or summary.json
    column    = "tip.ux[m]"          a column, a list of columns to add up ("-name" is subtracted), or a dotted path in
                                     summary.json
    operation = "max"                see OPERATIONS below
    function  = "period"             instead of the three above: a function (run, entry) of the case's measure.py, or of
                                     that of the folder above
    abscissa  = "mode"               the column that stands for the time below, where it is not t
    at = 0.36                        time of value_at [s]
    from = 0.0, until = 0.2          only these times count [s]
    over = 9.61                      divide by a number, or by {file, column, operation} of the same run
    reference = {file, column, time, scale}   curve for rms_to_reference and largest_distance; its columns times `scale` are SI
                {run, file, column}           or that of another run of verify.toml, made before
    value, tolerance, kind           expected value; kind = "relative" (default) or "absolute"
    low, high                        or a band, either end may be left out
    informative = true               printed, never judged
    miss   = "..."                   why the figure misses, where that was found out
    run    = "dx 0.04"               name (or names) of the runs of verify.toml it is meant for; none: the case as it
                                     stands, which is named "as it stands" among others
    source = "..."                   who says so

[[convergence]] tables follow a figure over several runs: convergence.py.
"""
import importlib.util
import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from run_folder import RunFolder, Table

AS_IT_STANDS = "as it stands"      # the name of a case's run without overrides


@dataclass
class Finding:
    """One figure of a run beside what is expected of it."""
    case: str
    entry: dict
    value: float | None
    reason: str = ""
    detail: str = ""

    @property
    def band(self) -> tuple[float, float]:
        if "value" in self.entry:
            expected, tolerance = self.entry["value"], self.entry.get("tolerance", 0.0)
            width = tolerance * (abs(expected) if self.entry.get("kind", "relative") == "relative" else 1.0)
            return expected - width, expected + width
        return self.entry.get("low", -math.inf), self.entry.get("high", math.inf)

    @property
    def judged(self) -> bool:
        return not self.entry.get("informative", False)

    @property
    def passed(self) -> bool:
        low, high = self.band
        return self.value is not None and low <= self.value <= high

    def as_record(self) -> dict:
        kind = self.entry.get("kind", "relative") if "value" in self.entry else "band"
        fields = {"case": self.case, "quantity": self.entry["quantity"], "value": self.value,
                  "reference": self.entry.get("value", [self.entry.get("low"), self.entry.get("high")]),
                  "tolerance": self.entry.get("tolerance"), "kind": kind, "judged": self.judged,
                  "pass": self.passed, "source": self.entry.get("source", "")}
        fields |= {"detail": self.detail} if self.detail else {}
        fields |= {"meant_for": self.entry["run"]} if "run" in self.entry else {}
        fields |= {"cause": self.reason or self.entry.get("miss", "not found yet")} if not self.passed else {}
        return fields


def angular_frequency(t: np.ndarray, x: np.ndarray) -> float:
    """Angular frequency [rad/s] of the sinusoid (with an offset) that fits x(t) best in the least squares.

    Where higher modes ring along, zero crossings err ten times more than this fit does. Needs about one period.
    """
    def misfit(omega: float) -> float:
        basis = np.column_stack((np.cos(omega * t), np.sin(omega * t), np.ones_like(t)))
        fit = np.linalg.lstsq(basis, x, rcond=None)[0]
        return float(np.sum((x - basis @ fit) ** 2))

    crossings = np.flatnonzero(np.diff(np.signbit(x - x.mean())))
    if len(crossings) < 2:
        raise ValueError("fewer than two zero crossings: no frequency to measure")
    first, last = t[crossings[0]], t[crossings[-1]]
    guess = math.pi * (len(crossings) - 1) / (last - first)
    trial = np.linspace(0.7 * guess, 1.3 * guess, 241)
    best = trial[int(np.argmin([misfit(omega) for omega in trial]))]
    low, high = best - 0.005 * guess, best + 0.005 * guess
    while high - low > 1e-7 * guess:
        third = (high - low) / 3
        low, high = (low, high - third) if misfit(low + third) < misfit(high - third) else (low + third, high)
    return 0.5 * (low + high)


OPERATIONS = {
    "last": lambda t, y, entry: y[-1],
    "max": lambda t, y, entry: y.max(),
    "min": lambda t, y, entry: y.min(),
    "max_abs": lambda t, y, entry: np.abs(y).max(),
    "time_of_max": lambda t, y, entry: t[y.argmax()],
    "time_of_min": lambda t, y, entry: t[y.argmin()],
    "value_at": lambda t, y, entry: np.interp(entry["at"], t, y),
    "mean": lambda t, y, entry: np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(t)) / (t[-1] - t[0]),
    "relative_spread": lambda t, y, entry: (y.max() - y.min()) / abs(y[0]),
    "rise": lambda t, y, entry: (y - y[0]).max(),
    "change": lambda t, y, entry: np.abs(y - y[0]).max(),
    "angular_frequency": lambda t, y, entry: angular_frequency(t, y),
    "rms_to_reference": lambda t, y, entry: np.sqrt(np.mean(distances(t, y, entry)**2)),
    "largest_distance": lambda t, y, entry: np.abs(distances(t, y, entry)).max(),
}


def distances(t: np.ndarray, y: np.ndarray, entry: dict) -> np.ndarray:
    """From a reference curve at the reference's own times within [from, until]."""
    curve = entry["reference"]
    table = Table((entry["beside"] / curve["run"] if "run" in curve else entry["folder"]) / curve["file"])
    times = table[curve.get("time", "t")]
    inside = (times >= max(entry.get("from", t[0]), t[0])) & (times <= min(entry.get("until", t[-1]), t[-1]))
    if not inside.any():
        raise ValueError("the run covers none of the reference's times")
    return np.interp(times[inside], t, y) - curve.get("scale", 1.0) * table[curve["column"]][inside]


def case_function(folder: Path, name: str):
    """A function of measure.py in the case's folder or, for a variant, in the case's above."""
    for path in (folder / "measure.py", folder.parent / "measure.py"):
        if path.exists():
            spec = importlib.util.spec_from_file_location(f"measure_{path.parent.name}", path)
            module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(module)
            if hasattr(module, name):
                return getattr(module, name)
    raise ValueError(f"no function {name} in a measure.py of {folder}")


def measure(run: RunFolder, entry: dict) -> float:
    """The figure that `entry` describes, taken from the run."""
    if "function" in entry:
        return float(case_function(entry["folder"], entry["function"])(run, entry)) / scale_of(run, entry)
    if entry["file"].endswith(".json"):
        value = run.summary()
        for part in entry["column"].split("."):
            value = value[part]
        return float(value) / scale_of(run, entry)
    table = run.table(entry["file"])
    if table is None:
        raise ValueError(f"{entry['file']} is missing or empty")
    columns = entry["column"] if isinstance(entry["column"], list) else [entry["column"]]
    t, y = table[entry.get("abscissa", "t")], sum(-table[name[1:]] if name.startswith("-") else table[name] for name in columns)
    if "at" in entry and not t[0] <= entry["at"] <= t[-1] * (1 + 1e-9) + 1e-9:
        raise ValueError(f"the run ends at t = {t[-1]:.4g} s")
    if "reference" not in entry:
        inside = (t >= entry.get("from", -math.inf)) & (t <= entry.get("until", math.inf))
        t, y = t[inside], y[inside]
    return float(OPERATIONS[entry["operation"]](t, y, entry)) / scale_of(run, entry)


def scale_of(run: RunFolder, entry: dict) -> float:
    over = entry.get("over", 1.0)
    return measure(run, {"file": entry.get("file"), **over}) if isinstance(over, dict) else float(over)


def is_meant(entry: dict, names: tuple[str, ...]) -> bool:
    """Whether an expectation is about a run of one of these names."""
    wanted = entry.get("run", AS_IT_STANDS)
    return not set(names).isdisjoint([wanted] if isinstance(wanted, str) else wanted)


def check(run: RunFolder, case: Path, names: tuple[str, ...] = (AS_IT_STANDS,), title: str = "") -> list[Finding]:
    """Every figure that expect.toml asks of this run, measured; empty where the case expects nothing of it."""
    path = case / "expect.toml"
    if not path.exists():
        return []
    findings = []
    for entry in tomllib.loads(path.read_text(encoding="utf-8")).get("expect", []):
        if not is_meant(entry, names):
            continue
        try:
            findings.append(Finding(title or case.name, entry, measure(run, entry | {"folder": case, "beside": run.path.parent})))
        except (KeyError, OSError, ValueError, TypeError, IndexError, ZeroDivisionError) as error:
            findings.append(Finding(title or case.name, entry, None, str(error).strip("'\"")))
    return findings
