# SPDX-License-Identifier: MIT
"""The turn of the beam's end face at the full load, from its two corners."""
import math

HEIGHT = 0.005                                          # [m]


def tip_angle(run, entry) -> float:
    """Angle of the end face against its first direction, 0 to 2 pi [rad]."""
    probes = run.table("solid/probes.csv")
    across = [probes[f"upper.{component}"][-1] - probes[f"lower.{component}"][-1] for component in ("ux", "uy")]
    return math.atan2(-across[0], HEIGHT + across[1]) % (2 * math.pi)
