# SPDX-License-Identifier: MIT
"""Writes report.html into a run's folder: one self-contained page about the run.

usage: report.py RUN [--case FOLDER]       (default: the folder of cases/ that has the run's name, / read as _)

The pictures of the case come from its plot.py or, for a variant, from that of the case above: a function `pictures(run) -> list of (figure, kind, caption)`, with kind
"svg" or "png". Everything else is the same for every case.
"""
import argparse
import importlib.util
import sys
from pathlib import Path

from energy import write_energy_total
from expectations import check
from figure_style import as_image
from mesh_picture import mesh_figure
from report_figures import energy_figure, interface_figure, probe_figure, wait_figure
from report_page import columns, missing_note, page, picture, section
from report_tables import expectation_table, run_figures, time_table
from run_folder import RunFolder

CASES = Path(__file__).resolve().parent.parent
ENERGY_NOTE = ("What particles that left the domain took along is counted as the fluid's. Dissipations are summed "
               "pair by pair, never taken as a remainder: where they part from the drift, the balance is not closed.")
INTERFACE_NOTE = "The work of both sides should be opposite: what differs is made or lost by the exchange."


def case_figures(run: RunFolder, case: Path) -> list[tuple] | None:
    """(figure, kind, caption) of what the case's own plot.py draws or that of the case above; None without one."""
    path = next((folder / "plot.py" for folder in (case, case.parent) if (folder / "plot.py").exists()), None)
    if path is None:
        return None
    spec = importlib.util.spec_from_file_location(f"plot_{case.name}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.pictures(run)


def case_pictures(run: RunFolder, case: Path) -> list[str]:
    """What the case's own plot.py draws; a case without one shows the solid's mesh and the probes."""
    figures = case_figures(run, case)
    if figures is None:
        figures = [(mesh_figure(run), "png", "The mesh where it ended."), *((probe_figure(run, side), "svg", "") for side in run.sides())]
    drawn = (entry for entry in figures if entry[0] is not None)
    return [picture(as_image(figure, kind, caption), caption) for figure, kind, caption in drawn]


def image_of(figure, alt: str) -> str:
    return as_image(figure, "svg", alt) if figure is not None else ""


def subtitle(run: RunFolder, case: Path, summary: dict) -> str:
    readme = case / "README.md"
    title = readme.read_text(encoding="utf-8").splitlines()[0].lstrip("# ") if readme.exists() else ""
    parts = [summary[side] for side in run.sides() if side in summary]
    names = sorted({f"Rivage {part['version']}, commit {part.get('commit', '?')}" for part in parts
                    if "version" in part})
    return " · ".join(part for part in (title, *names) if part)


def write_report(folder: Path, case: Path) -> Path:
    """Writes folder/report.html (and energy_total.csv where it can be made) and returns its path."""
    run = RunFolder(folder)
    energies = write_energy_total(run)
    summary = run.summary()
    body = [
        run_figures(run, summary, energies),
        *case_pictures(run, case),
        section("Energies", picture(image_of(energy_figure(run, energies), "energies over time"), ENERGY_NOTE)),
        *(section(f"Interface {name}".rstrip(), picture(image_of(interface_figure(table), "interface force and work"), INTERFACE_NOTE))
          for name, table in run.interfaces().items()),
        section("Expected and found", expectation_table(check(run, case))),
        section("Time", *(picture(image_of(wait_figure(name, table), "waits"), summary.get("wait_balance", ""))
                          for name, table in run.interfaces().items()),
                columns(*(time_table(side, summary.get(side, {})) for side in run.sides()))),
    ]
    body.insert(1, missing_note(run.missing))
    path = folder / "report.html"
    path.write_text(page(case.name.replace("_", " "), subtitle(run, case, summary), body), encoding="utf-8")
    return path


def case_of(folder: Path) -> Path:
    """The case that a run's folder is named after."""
    names = {str(path.relative_to(CASES)).replace("/", "_"): path for path in CASES.rglob("*/")}
    return names.get(folder.name, CASES / folder.name)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path)
    parser.add_argument("--case", type=Path)
    arguments = parser.parse_args()
    if not arguments.run.is_dir():
        print(f"{arguments.run}: there is no such folder", file=sys.stderr)
        return 2
    folder = arguments.run.resolve()
    case = (arguments.case or case_of(folder)).resolve()
    print(f"report: {write_report(folder, case)}")
    judged = [finding for finding in check(RunFolder(folder), case) if finding.judged]
    missed = [finding.entry["quantity"] for finding in judged if not finding.passed]
    if judged:
        print(f"expected: {len(judged) - len(missed)} of {len(judged)} hold" + "".join(f"\n  missed: {name}" for name in missed))
    return 0


if __name__ == "__main__":
    sys.exit(main())
