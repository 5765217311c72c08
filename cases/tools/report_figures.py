# SPDX-License-Identifier: MIT
"""The pictures that every report has, whatever the case: energies, interface, waits. Each returns a figure or None."""
import numpy as np

from energy import DISSIPATIONS, EnergySum
from figure_style import FLUID, SHADES, SOLID, TOTAL, draw, plt
from run_folder import RunFolder, Table


def energy_figure(run: RunFolder, energies: EnergySum | None):
    """Left: change of the energies of fluid, solid and both. Right: the drift beside what was dissipated."""
    if energies is None:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.4), layout="constrained")
    for values, colour, label in ((energies.fluid, FLUID, "fluid"), (energies.solid, SOLID, "solid"),
                                  (energies.total, TOTAL, "sum")):
        if np.any(values):
            draw(left, energies.t, values - values[0], color=colour, label=label)
    left.set(title="Energy, change since the start", xlabel="t [s]", ylabel=f"energy [{energies.unit}]")
    left.legend()
    draw_drift(right, run, energies)
    return figure


def draw_drift(axes, run: RunFolder, energies: EnergySum) -> None:
    """The drift as a line over the stack of what was dissipated: where the two part, the balance is not closed."""
    parts = []
    for side in run.sides():
        table = run.table(f"{side}/energy.csv")
        of = "" if side == "fluid" or len(run.solids()) == 1 else f"{side} "
        for name, label in DISSIPATIONS["fluid" if side == "fluid" else "solid"]:
            if table is not None and name in table and np.any(table[name]):
                parts.append((f"{of}{label}: {table[name][-1]:.3g}", np.interp(energies.t, table["t"], table[name])))
    if parts:
        every = max(1, len(energies.t) // 700)
        stack = [-values[::every] for _, values in parts]
        labels = [label for label, _ in parts]
        axes.stackplot(energies.t[::every], stack, labels=labels, colors=SHADES, alpha=0.55, linewidth=0)
    draw(axes, energies.t, energies.drift, color=TOTAL, label=f"drift of the sum: {energies.drift[-1]:.3g}")
    axes.set(title="Drift of the sum, and what was dissipated", xlabel="t [s]", ylabel=f"energy [{energies.unit}]")
    axes.legend(fontsize=7.5, frameon=True, framealpha=0.8, edgecolor="none", title=f"at the end [{energies.unit}]", title_fontsize=7.5)


def worst_mismatch(interface: Table) -> float:
    """Largest |W_fluid + W_solid| of the run over its largest |W|."""
    fluid, solid = interface["work_on_fluid"], interface["work_on_solid"]
    peak = max(np.abs(fluid).max(), np.abs(solid).max())
    return float(np.abs(fluid + solid).max() / peak) if peak > 0 else 0.0


def running_mean(t: np.ndarray, y: np.ndarray, span: float) -> np.ndarray:
    """Mean of y over a window of the length `span` [s] around each instant, shorter at the ends."""
    total = np.concatenate(([0.0], np.cumsum(y)))
    low, high = np.searchsorted(t, t - span / 2), np.searchsorted(t, t + span / 2, side="right")
    return (total[high] - total[low]) / (high - low)


def draw_forces(axes, interface: Table) -> None:
    """What the fluid sent, every step, and over it the mean of what the solid applied."""
    t = interface["t"]
    span = 0.0125 * (t[-1] - t[0])
    for axis, colour in (("x", FLUID), ("y", SOLID), ("z", TOTAL)):
        if f"force_sent_{axis}" in interface and np.any(np.abs(interface[f"force_sent_{axis}"]) > 1e-9):
            draw(axes, t, interface[f"force_sent_{axis}"], color=colour, linewidth=0.6, alpha=0.3)
            draw(axes, t, running_mean(t, interface[f"force_received_{axis}"], span), color=colour, label=axis)
    axes.set(title=f"Force on the solid (line: mean over {1000 * span:.2g} ms)", xlabel="t [s]",
             ylabel=f"force [{interface.unit('force_sent_x') or 'N/m'}]")
    axes.legend()


def interface_figure(interface: Table):
    """Force and work on both sides of the interface, and the share of the work that gets lost between them."""
    figure, (forces, works, mismatch) = plt.subplots(1, 3, figsize=(11.5, 3.2), layout="constrained")
    draw_forces(forces, interface)
    unit = interface.unit("work_on_solid") or "J/m"
    draw(works, interface["t"], interface["work_on_solid"], color=SOLID, label="on the solid")
    draw(works, interface["t"], -interface["work_on_fluid"], color=FLUID, linestyle=(0, (4, 3)),
         label="− on the fluid")
    works.set(title="Interface work", xlabel="t [s]", ylabel=f"work [{unit}]")
    works.legend()
    peak = max(np.abs(interface["work_on_fluid"]).max(), np.abs(interface["work_on_solid"]).max(), 1e-300)
    draw(mismatch, interface["t"], 100 * (interface["work_on_fluid"] + interface["work_on_solid"]) / peak, color=TOTAL)
    mismatch.set(title="Work mismatch, fluid + solid", xlabel="t [s]", ylabel="share of the peak work [%]")
    return figure


def wait_figure(name: str, interface: Table):
    """How long each side has waited for the other, summed over the steps, on the wall clock."""
    if "wait_fluid" not in interface:
        return None
    name = name or "the solid"
    figure, axes = plt.subplots(figsize=(5.6, 2.6), layout="constrained")
    draw(axes, interface["t"], interface["wait_fluid"], color=FLUID, label=f"fluid waited for {name}")
    draw(axes, interface["t"], interface["wait_solid"], color=SOLID, label=f"{name} waited for the fluid")
    axes.set(title="Who waited for whom", xlabel="t [s]", ylabel="wall time [s]", ylim=(0, None))
    axes.legend()
    return figure


def probe_figure(run: RunFolder, side: str):
    """Every probe of one side, one panel a unit; for cases that bring no picture of their own."""
    table = run.table(f"{side}/probes.csv")
    if table is None or len(table.headers) < 2:
        return None
    units = sorted({table.unit(name) for name in table.headers[1:]})[:4]
    figure, grid = plt.subplots(1, len(units), figsize=(11.5, 3.0), squeeze=False, layout="constrained")
    for axes, unit in zip(grid.flat, units):
        for name in [header for header in table.headers[1:] if table.unit(header) == unit][:8]:
            draw(axes, table["t"], table[name], label=name.split("[")[0], linewidth=1.1)
        axes.set(title=f"Probes of the {side}", xlabel="t [s]", ylabel=f"[{unit}]")
        axes.legend(fontsize=7.5)
    return figure
