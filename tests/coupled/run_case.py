# SPDX-License-Identifier: MIT
"""Runs a case through mpirun in a folder of its own and judges it by its expect.toml.

usage: run_case.py CASE_FOLDER --programs BIN_FOLDER [--ranks N+M] [--set KEY=VALUE ...] [--out FOLDER]
"""
import argparse
import sys
import tempfile
from pathlib import Path

from coupled_run import run

from check_expectations import judge  # noqa: E402  (coupled_run adds cases/tools to the path)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--ranks", default="1+1")
    parser.add_argument("--set", action="append", default=[], dest="settings")
    parser.add_argument("--out", type=Path)
    arguments = parser.parse_args()
    ranks = tuple(int(count) for count in arguments.ranks.split("+"))
    with tempfile.TemporaryDirectory(prefix="rivage_") as scratch:
        out = arguments.out or Path(scratch) / arguments.case.name
        code = run(arguments.case, arguments.programs, out, ranks, arguments.settings)
        return code if code != 0 else judge(out, arguments.case)


if __name__ == "__main__":
    sys.exit(main())
