# SPDX-License-Identifier: MIT
"""The tests' way to a case: cases/tools on the path, and its launcher."""
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cases" / "tools"))

from launch import ENVIRONMENT, mpirun_line, run  # noqa: E402, F401
