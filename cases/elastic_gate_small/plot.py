# SPDX-License-Identifier: MIT
"""The same pictures as the elastic gate's, at the times that this shorter run reaches."""
import importlib.util
from pathlib import Path

CASES = Path(__file__).resolve().parent.parent
SPEC = importlib.util.spec_from_file_location("plot_gate", CASES / "elastic_gate" / "plot.py")
gate = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(gate)


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    times = [0.02, 0.04, 0.06, 0.08, 0.1]
    return [(gate.snapshots(run, times), "png", gate.CAPTIONS[0]), (gate.tip_and_energies(run), "svg", gate.CAPTIONS[1])]
