# SPDX-License-Identifier: MIT
"""Pictures of the moving piston: the water's energy beside the wall's work, or the sound wave's pressure."""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

from figure_style import FLUID, REFERENCE, TOTAL, draw, plt  # noqa: E402
from run_folder import RunFolder  # noqa: E402

CAPTION = "Work of the piston and energy of the water; what is left between them is dissipated, column by column."


def energies(run: RunFolder):
    """The water's energy, the wall's work, and their difference with the dissipations that explain it."""
    table = run.table("fluid/energy.csv")
    if table is None:
        return None
    t, work = table["t"], table["work_by_walls"]
    energy = table["total"] - table["total"][0]
    peak = max(abs(work).max(), 1e-300)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.5, 3.4), layout="constrained")
    left.plot(t, work, color=REFERENCE, linewidth=2.4, alpha=0.45, label="work of the piston W")
    draw(left, t, energy, color=FLUID, label="energy of the water E")
    left.set(title="Energy", xlabel="t [s]", ylabel="[J/m]")
    left.legend()
    draw(right, t, 100 * (energy - work) / peak, color=TOTAL, label="E - W")
    for name, style in (("riemann", "--"), ("mass_flux", ":"), ("walls", "-.")):
        right.plot(t, -100 * table[f"dissipation_{name}"] / peak, style, color=REFERENCE, label=f"-{name}")
    right.set(title="Lost, in per cent of the largest work", xlabel="t [s]", ylabel="[%]")
    right.legend(ncols=2)
    return figure


def pictures(run: RunFolder) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    return [(energies(run), "svg", CAPTION)]


def main() -> int:
    run, target = RunFolder(Path(sys.argv[1])), Path(sys.argv[2])
    energies(run).savefig(target, dpi=110)
    return 0


if __name__ == "__main__":
    sys.exit(main())
