# SPDX-License-Identifier: MIT
"""Starts a case's programs under one mpirun, as a user would."""
import json
import os
import shlex
import subprocess
import time
from pathlib import Path

from participants import participants

ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}


def mpirun_line(case: Path, programs: Path, out: Path, ranks: tuple[int, int], settings: list[str]) -> list[str]:
    """The command: `ranks` are those of the fluid and of each solid; `settings` are KEY=VALUE overrides."""
    line = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
    overrides = [word for setting in settings for word in ("--set", setting)]
    for index, (role, program, file) in enumerate(participants(case)):
        line += [":"] * (index > 0) + ["-n", str(ranks[0] if role == "fluid" else ranks[1])]
        line += [str(programs / program), str(file), "--as", role, "--out", str(out), *overrides]
    return line


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
