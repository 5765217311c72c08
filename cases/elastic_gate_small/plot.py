# SPDX-License-Identifier: MIT
"""The same pictures as the elastic gate's, at the times that this shorter run reaches."""
import importlib.util
from pathlib import Path

SPEC = importlib.util.spec_from_file_location("plot_gate", Path(__file__).resolve().parent.parent / "elastic_gate" / "plot.py")
gate = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(gate)


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    times = [0.02, 0.04, 0.06, 0.08, 0.1]
    return [(gate.snapshots(run, times), "png", "Water coloured by pressure and the gate's mesh in its deformed place."),
            (gate.tip(run), "svg", "Middle of the gate's lower face, beside the experiment of Antoci et al. (2007).")]
