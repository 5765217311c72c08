# SPDX-License-Identifier: MIT
"""The same case on different numbers of fluid ranks gives the same bits; a coupled one, or the fluid alone.

usage: rank_identity.py CASE --programs BIN --ranks 1 2 3 4 7 --end SECONDS [--load KIND]

Compares with the run on the first number of ranks: the hashes of both final states, the hash of all load packets that
the solid has received, and the energy and probe tables. The fluid is cut anew as often as it can be.
"""
import argparse
import sys
import tempfile
from pathlib import Path

from coupled_run import run

from run_folder import RunFolder  # noqa: E402  (coupled_run adds cases/tools to the path)

CUT_OFTEN = ["fluid.parallel.imbalance_limit=1.0", "fluid.parallel.rebuilds_between=1"]
HASHES = {"fluid": ["state_hash", "steps"], "solid": ["state_hash", "loads_hash"]}
TABLES = ["fluid/energy.csv", "fluid/probes.csv", "solid/energy.csv", "solid/probes.csv", "energy_total.csv"]


def hashes(out: Path) -> dict[str, object]:
    summary = RunFolder(out).summary()
    return {f"{side}.{key}": summary[side][key] for side, keys in HASHES.items() if side in summary for key in keys}


def differences(out: Path, reference: Path) -> list[str]:
    found, wanted = hashes(out), hashes(reference)
    wrong = [f"{key} is {found[key]} instead of {wanted[key]}" for key in wanted if found[key] != wanted[key]]
    return wrong + [f"{name} differs" for name in TABLES if content(out / name) != content(reference / name)]


def content(path: Path) -> bytes:
    return path.read_bytes() if path.exists() else b""


def settings(case: Path, end: str, load: str) -> list[str]:
    coupled = (case / "coupling.toml").exists()
    return [*([f"coupling.time.end={end}", f"coupling.interface.load={load}"] if coupled else [f"fluid.time.end={end}"]), *CUT_OFTEN]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--ranks", nargs="+", type=int, required=True)
    parser.add_argument("--end", required=True)
    parser.add_argument("--load", default="conservative")
    arguments = parser.parse_args()
    good = True
    with tempfile.TemporaryDirectory(prefix="rivage_") as scratch:
        outs = {ranks: Path(scratch) / str(ranks) for ranks in arguments.ranks}
        for ranks, out in outs.items():
            code = run(arguments.case, arguments.programs, out, (ranks, 1), settings(arguments.case, arguments.end, arguments.load))
            if code != 0:
                return code
            wrong = differences(out, outs[arguments.ranks[0]])
            cuts = RunFolder(out).summary()["fluid"]["parallel"]["cuts"]
            print(f"{ranks} ranks, {cuts} cuts: {hashes(out)}", *wrong, sep="\n    ", flush=True)
            good = good and not wrong
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
