# SPDX-License-Identifier: MIT
"""The same pictures as the tank's."""
import importlib.util
from pathlib import Path

SPEC = importlib.util.spec_from_file_location("plot_tank", Path(__file__).resolve().parent.parent / "plot.py")
tank = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(tank)
pictures = tank.pictures
