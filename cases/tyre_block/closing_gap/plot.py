# SPDX-License-Identifier: MIT
"""Where the plate's work on the water goes."""
from figure_style import draw, plt

DISSIPATIONS = ("dissipation_riemann", "dissipation_mass_flux", "dissipation_walls")


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    energy = run.table("fluid/energy.csv")
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    for label, values in (("the plate's work", energy["work_by_walls"]), ("motion", energy["kinetic"]), ("compression", energy["internal"]),
                          ("dissipated", sum(energy[name] for name in DISSIPATIONS))):
        draw(axes, 1e3 * energy["t"], values, label=label)
    axes.set(xlabel="t [ms]", ylabel="energy [J/m]")
    axes.legend(fontsize=8)
    return [(figure, "svg", "Where the plate's work on the water goes, up to the time when it has closed the gap.")]
