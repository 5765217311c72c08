# SPDX-License-Identifier: MIT
"""Pictures of the wedge: deflection beside other solutions, pressures at A and C, the water under the panel."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "tools")]

from field_file import open_fields  # noqa: E402
from figure_style import FLUID, REFERENCE, SOLID, draw, plt  # noqa: E402
from measure import deflection, pressure  # noqa: E402
from run_folder import RunFolder, Table  # noqa: E402
from snapshots import View, snapshot_figure  # noqa: E402


def curves(run: RunFolder):
    """Left: deflection of the panel's middle. Right: pressures."""
    if run.table("solid/probes.csv") is None:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.8), layout="constrained")
    t, w = deflection(run)
    draw(left, 1e3 * t, 1e3 * w, color=FLUID, label="computed")
    for name, style, label in (("deflection_scolan", "-", "Scolan, analytical"), ("deflection_sph_fem", "--", "SPH-FEM, Fourey 2010")):
        table = Table(HERE / "reference" / f"{name}.csv")
        left.plot(1e3 * table["t"], 1e3 * table["w"], style, color=REFERENCE, linewidth=0.9, label=label)
    wagner = Table(HERE / "reference" / "hydroelastic_wagner.csv")
    left.plot(1e3 * wagner["t"], 1e3 * wagner["w_x0.30_mid"], ":", color=REFERENCE, label="hydroelastic Wagner")
    nonlinear = Table(HERE / "reference" / "hydroelastic_logvinovich.csv")
    left.plot(1e3 * nonlinear["t"], 1e3 * nonlinear["w_x0.30_mid"], "-.", color=REFERENCE, linewidth=0.9, label="with modified Logvinovich pressure")
    left.set(title="Deflection of the panel's middle", xlabel="t [ms]", ylabel="[mm]")
    for point, colour in (("A", FLUID), ("C", SOLID)):
        draw(right, 1e3 * t, 1e-6 * pressure(run, point)[1], color=colour, label=point, linewidth=0.8)
        table = Table(HERE / "reference" / f"pressure_{point}.csv")
        right.plot(1e3 * table["t"], 1e-6 * table["p"], "--", color=REFERENCE, linewidth=0.9, label=f"{point}, analytical")
    right.set(title="Pressure on the panel, 0.01 (A) and 0.45 m (C) from the apex", xlabel="t [ms]", ylabel="[MPa]")
    for axes in (left, right):
        axes.legend(fontsize=7.5)
    return figure


def water(run: RunFolder):
    """Water coloured by pressure under the bent panel."""
    view = View((-0.01, 0.8, -0.2, 0.14), pressure=20e6, spacing=0.005, walls=[[(0, -0.2), (0, 0.14)]])
    return snapshot_figure(open_fields(run.file("fluid/fields.h5")), [open_fields(run.file("solid/fields.h5"))], (0.0008, 0.0016), view, 2)


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(curves(run), "svg", "Deflection beside the rigid fall, and pressures of the water."),
            (water(run), "png", "Water coloured by pressure, the panel in its place.")]


def main() -> int:
    run, folder = RunFolder(Path(sys.argv[1])), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, figure in (("curves", curves(run)), ("water", water(run))):
        if figure is not None:
            figure.savefig(folder / f"{name}.png", dpi=110)
    return 0


if __name__ == "__main__":
    sys.exit(main())
