# SPDX-License-Identifier: MIT
"""What tests of solvers from outside share: mpirun with the Python module of a build."""
import argparse
import os
import subprocess
import sys
import unittest
from pathlib import Path

from coupled_run import ENVIRONMENT, ROOT, InScratchFolder

CASE = ROOT / "tests" / "coupled" / "drill_case" / "coupling.toml"
ARGUMENTS = argparse.Namespace()


class OutsideTest(InScratchFolder):
    python_paths: tuple[Path, ...] = ()          # besides the build's module

    def mpirun(self, *segments: list[str]) -> subprocess.CompletedProcess:
        """One run of several programs, each given as its words after `mpirun` or `:`."""
        line = ["mpirun", "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
        for k, segment in enumerate(segments):
            line += [":"] * (k > 0) + segment
        environment = os.environ | ENVIRONMENT | {"PYTHONPATH": os.pathsep.join(map(str, (ARGUMENTS.build / "python", *self.python_paths)))}
        return subprocess.run(line, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=100, check=False)


def main(text: str) -> None:
    """Takes --build, leaves the rest to unittest."""
    parser = argparse.ArgumentParser(description=text.splitlines()[0])
    parser.add_argument("--build", type=lambda path: Path(path).resolve(), required=True)
    _, rest = parser.parse_known_args(namespace=ARGUMENTS)
    unittest.main(argv=[sys.argv[0], *rest])
