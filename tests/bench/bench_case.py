# SPDX-License-Identifier: MIT
"""What the benches that run whole cases share: one run in a folder of its own, and figures as JSON lines."""
import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases/tools"))

from launch import ENVIRONMENT, cores, mpirun_line  # noqa: E402


def summary_of(case: Path, programs: Path, out: Path, ranks: tuple[int, int], settings: list[str], limit: float) -> dict:
    """Runs a case and returns its summary.json. Raises SystemExit when it fails or takes more than `limit` seconds."""
    shutil.rmtree(out, ignore_errors=True)
    line = mpirun_line(case, programs, out, ranks, settings, cores())
    print(f"bench: {shlex.join(line)}", flush=True)
    out.mkdir(parents=True)
    with open(out / "printed.log", "w", encoding="utf-8") as log:
        try:
            code = subprocess.run(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                  timeout=limit, check=False).returncode
        except subprocess.TimeoutExpired:
            sys.exit(f"bench: {case.name} took more than {limit:.0f} s")
    if code != 0:
        sys.exit(f"bench: {case.name} ended with code {code}\n" + (out / "printed.log").read_text(encoding="utf-8")[-2000:])
    return json.loads((out / "summary.json").read_text(encoding="utf-8"))


def figure(bench: str, metric: str, value: float, ranks: int) -> None:
    print(json.dumps({"bench": bench, "metric": metric, "value": float(f"{value:.5g}"), "ranks": ranks}), flush=True)


def seconds(timers: dict, chosen) -> float:
    """Seconds of all timers of a tree whose name `chosen` accepts; what is inside an accepted one is not counted again."""
    total = 0.0
    for name, entry in timers.items():
        total += entry["seconds"] if chosen(name) else seconds(entry.get("inside", {}), chosen)
    return total
