# SPDX-License-Identifier: MIT
"""The same case on different numbers of ranks gives the same answer.

usage: rank_agreement.py CASE --programs BIN --ranks 1+1 2+1 3+1 --end SECONDS [--tolerance REL | --tip METRES]

Compares the last particles (by id), the last solid nodes and the last row of the tables of each run with those of the
first one. The distance is relative to the largest value of each field. With --tip, only the tip's displacement [m].
"""
import argparse
import sys
import tempfile
from pathlib import Path

import numpy as np

from coupled_run import run

from field_file import FieldFile  # noqa: E402  (coupled_run adds cases/tools to the path)
from run_folder import RunFolder  # noqa: E402


def last_fields(path: Path) -> dict[str, np.ndarray]:
    """The fields of the last step, rows in the order of the ids where there are any."""
    file = FieldFile(path)
    step = file.read(len(file.steps) - 1)
    fields = {"points": step.points, **step.fields}
    fields.pop("rank", None)
    if "id" in fields:
        order = np.argsort(np.ravel(fields.pop("id")))
        fields = {name: values[order] for name, values in fields.items()}
    return fields


def final_state(out: Path) -> dict[str, np.ndarray]:
    state = {}
    for side in ("fluid", "solid"):
        for name, values in last_fields(out / side / "fields.h5").items():
            state[f"{side}/{name}"] = np.asarray(values, dtype=float)
        table = RunFolder(out).table(f"{side}/energy.csv")
        for header in table.headers:
            if "balance" not in header:
                state[f"{side}/energy/{header}"] = table[header][-1:]
    return state


def distance(state: dict[str, np.ndarray], reference: dict[str, np.ndarray]) -> tuple[float, str]:
    """The largest relative distance and the field that has it."""
    worst, where = 0.0, "none"
    scale_of_energy = max(np.abs(values).max() for name, values in reference.items() if "/energy/" in name)
    for name, values in reference.items():
        if state[name].shape != values.shape:
            return np.inf, f"{name}: {state[name].shape} instead of {values.shape}"
        scale = scale_of_energy if "/energy/" in name else np.abs(values).max()
        found = np.abs(state[name] - values).max() / scale if scale > 0 else np.abs(state[name]).max()
        if not found <= worst:
            worst, where = float(found), name
    return worst, where


def tip(out: Path) -> np.ndarray:
    probes = RunFolder(out).table("solid/probes.csv")
    return np.array([probes["tip.ux"][-1], probes["tip.uy"][-1]])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--ranks", nargs="+", required=True)
    parser.add_argument("--end", required=True)
    parser.add_argument("--tolerance", type=float, default=1e-9)
    parser.add_argument("--tip", type=float)
    arguments = parser.parse_args()
    good, reference = True, None
    with tempfile.TemporaryDirectory(prefix="rivage_") as scratch:
        for text in arguments.ranks:
            ranks, out = tuple(int(count) for count in text.split("+")), Path(scratch) / text
            code = run(arguments.case, arguments.programs, out, ranks, [f"coupling.time.end={arguments.end}"])
            if code != 0:
                return code
            state = tip(out) if arguments.tip else final_state(out)
            if reference is None:
                reference = state
                continue
            if arguments.tip:
                found, limit, where = float(np.abs(state - reference).max()), arguments.tip, "tip [m]"
            else:
                (found, where), limit = distance(state, reference), arguments.tolerance
            good = good and found <= limit
            print(f"{text} against {arguments.ranks[0]}: {found:.3g} (in {where}), allowed {limit:.3g}", flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
