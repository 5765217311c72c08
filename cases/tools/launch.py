# SPDX-License-Identifier: MIT
"""Starts a case's programs under one mpirun, as a user would."""
import os
import shlex
import subprocess
import time
from pathlib import Path

from participants import participants

ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}


def mpirun_line(case: Path, programs: Path, out: Path, ranks: tuple[int, int], settings: list[str]) -> list[str]:
    """The command: `ranks` are those of the fluid and of the solid; `settings` are KEY=VALUE overrides."""
    line = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
    overrides = [word for setting in settings for word in ("--set", setting)]
    for index, (role, program, file) in enumerate(participants(case)):
        line += [":"] * (index > 0) + ["-n", str(ranks[1] if role == "solid" else ranks[0])]
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
