# SPDX-License-Identifier: MIT
"""When the block has stopped."""


def stop_time(run, entry) -> float:
    """First zero of the velocity, between two rows [s]."""
    table = run.table("solid/probes.csv")
    t, v = table["t"], table["mid.vx"]
    k = next(k for k in range(1, len(v)) if v[k] <= 0)
    return float(t[k - 1] + (t[k] - t[k - 1]) * v[k - 1] / (v[k - 1] - v[k]))
