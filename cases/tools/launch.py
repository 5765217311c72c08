# SPDX-License-Identifier: MIT
"""Starts a case's programs under one mpirun, as a user would.

usage: launch.py CASE --programs BIN_FOLDER --out FOLDER [--fluid-ranks N] [--solid-ranks M] [--set KEY=VALUE ...]

prints the command for `./rivage run`, a word a line.
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
import time
from pathlib import Path

from participants import participants

# More ranks than cores: they share them, and one that waits gives its core away.
CROWDED = ["--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}


def mpirun_line(case: Path, programs: Path, out: Path, ranks: tuple[int, int], settings: list[str],
                cores: int = 0) -> list[str]:
    """The command: `ranks` are those of the fluid and of each solid; `settings` are KEY=VALUE overrides. With at least
    as many cores as ranks nothing is shared."""
    overrides = [word for setting in settings for word in ("--set", setting)]
    starters = participants(case)
    counts = [ranks[0] if starter.role == "fluid" else ranks[1] for starter in starters]
    line = ["mpirun", *(CROWDED if sum(counts) > cores else [])]
    path = ["-x", f"PYTHONPATH={programs.parent.resolve() / 'python'}"]      # mpirun gives it to one segment alone
    for index, (starter, count) in enumerate(zip(starters, counts)):
        line += [":"] * (index > 0) + ["-n", str(count), *(path if starter.is_from_outside else []), *starter.words(programs)]
        line += ["--as", starter.role, "--out", str(out), *overrides]
    return line


def cores() -> int:
    """Those this process may use, two threads of one core counted once."""
    listed = subprocess.run(["lscpu", "-p=Core,Socket"], capture_output=True, text=True, check=False).stdout.splitlines()
    whole = len({line for line in listed if not line.startswith("#")})
    usable = len(os.sched_getaffinity(0))
    return min(whole, usable) if whole else usable


def run(case: Path, programs: Path, out: Path, ranks=(1, 1), settings=(), timeout: float | None = 600) -> int:
    """Runs the case and returns mpirun's exit code. Raises subprocess.TimeoutExpired; mpirun ends its ranks then."""
    line = mpirun_line(case, programs, out, ranks, list(settings))
    print(shlex.join(line), flush=True)
    start = time.monotonic()
    code = subprocess.run(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, timeout=timeout,
                          check=False).returncode
    print(f"exit code {code} after {time.monotonic() - start:.1f} s", flush=True)
    return code


def run_tests(program: Path, chosen: str, out: Path) -> int:
    """Runs the chosen tests of a test program. out/summary.json holds under "recorded" what they noted as figure_NAME, the worst (by
    size) where several note the same one."""
    out.mkdir(parents=True, exist_ok=True)
    line = [str(program), f"--gtest_filter={chosen}", f"--gtest_output=json:{out / 'tests.json'}", "--gtest_brief=1"]
    print(shlex.join(line), flush=True)
    code = subprocess.run(line, env=os.environ | ENVIRONMENT, stdin=subprocess.DEVNULL, check=False).returncode
    tests = [test for suite in json.loads((out / "tests.json").read_text(encoding="utf-8"))["testsuites"]
             for test in suite["testsuite"]]
    recorded: dict[str, float] = {}
    for test in tests:
        for name, value in test.items():
            if name.startswith("figure_"):
                recorded[name] = max(float(value), recorded.get(name, 0.0), key=abs)
    (out / "summary.json").write_text(json.dumps({"recorded": recorded, "tests": len(tests)}), encoding="utf-8")
    return code


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--fluid-ranks", type=int, default=1)
    parser.add_argument("--solid-ranks", type=int, default=1)
    parser.add_argument("--set", action="append", default=[], dest="settings")
    told = parser.parse_args()
    try:
        line = mpirun_line(told.case, told.programs, told.out, (told.fluid_ranks, told.solid_ranks), told.settings, cores())
    except (ValueError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    print(*line, sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
