# SPDX-License-Identifier: MIT
"""Pictures of the plate: its swing after the release beside the acoustic curves, and how it settles."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

from figure_style import FLUID, REFERENCE, SOLID, TOTAL, draw, plt  # noqa: E402
from run_folder import Table  # noqa: E402

STATIC = -7.05e-5                                          # [m]


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    probes = run.table("solid/probes.csv")
    if probes is None:
        return []
    beam, continuum = (Table(HERE / "reference" / f"plate_{name}_c0_62.64.csv") for name in ("transient", "continuum"))
    t, w = 1e3 * probes["t"], 1e6 * probes["middle.uy"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.2), layout="constrained")
    left.plot(1e3 * beam["t"], 1e6 * beam["w_mid"], color=REFERENCE, linewidth=2.2, alpha=0.45, label="linear acoustics, beam")
    left.plot(1e3 * continuum["t"], 1e6 * continuum["w_layered"], color=TOTAL, linewidth=0.8, label="continuum, layered water")
    early = t <= 80
    draw(left, t[early], w[early], color=FLUID, label="computed")
    left.set(title="Middle of the plate after the release", xlabel="t [ms]", ylabel="w [µm]")
    left.legend()
    draw(right, t, w, color=SOLID)
    right.axhline(1e6 * STATIC, color=REFERENCE, linewidth=1, linestyle="--", label="at rest, plane-strain continuum")
    right.set(title="The whole run", xlabel="t [ms]", ylabel="w [µm]")
    right.legend()
    return [(figure, "svg", "Clamped aluminium plate under 2 m of water, released at t = 0.")]
