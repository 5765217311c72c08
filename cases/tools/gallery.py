# SPDX-License-Identifier: MIT
"""Writes docs/gallery.md: one picture a case, with what it shows and how to make it.

usage: gallery.py RUNS CASE ...      RUNS: a folder as ./rivage verify leaves it, RUNS/CASE/RUN_NAME

Renews the pictures of the named cases, docs/pictures/CASE.png: the first that the case's plot.py draws of its finest run
or, without a plot.py, the solid's mesh where it ended, else its probes. The page shows all cases, with the pictures that
are there.
"""
import re
import sys
from os.path import normpath
from pathlib import Path

from figure_style import plt
from mesh_picture import mesh_figure
from report import case_figures
from report_figures import probe_figure
from run_folder import RunFolder
from verify_plan import CASES, find_cases, title

DOCS = CASES.parent / "docs"
HEAD = """# Gallery: one picture a case

Written by `cases/tools/gallery.py` from runs of the cases; figures and misses are in [verification.md](verification.md).
"""


def run_of(folder: Path) -> RunFolder | None:
    """The run to draw: the largest, which is the finest, of those that left fields or probes."""
    def size(run: Path) -> int:
        return sum(path.stat().st_size for path in run.glob("*/fields.h5"))

    runs = [path for path in sorted(folder.glob("*/")) if (path / "summary.json").is_file()] if folder.is_dir() else []
    return RunFolder(max(runs, key=size)) if runs else None


def figure_of(run: RunFolder, case: Path):
    """The case's picture of a run; None where nothing can be drawn."""
    own = [figure for figure, _, _ in case_figures(run, case) or ()]
    figures = own or [mesh_figure(run), *(probe_figure(run, side) for side in run.sides())]
    return next((figure for figure in figures if figure is not None), None)


def picture_of(case: Path) -> Path:
    return DOCS / "pictures" / f"{title(case).replace('/', '_')}.png"


def draw(case: Path, runs: Path) -> None:
    """Renews the case's picture from its run."""
    run = run_of(runs / title(case))
    figure = figure_of(run, case) if run else None
    if figure is None:
        print(f"{title(case)}: no run in {runs} that can be drawn", file=sys.stderr)
        return
    figure.savefig(picture_of(case), dpi=80)
    plt.close("all")
    print(picture_of(case).relative_to(CASES.parent))


def entry(case: Path) -> str:
    """Heading, picture and the first paragraph of the case's README."""
    paragraphs = re.split(r"\n\s*\n", (case / "README.md").read_text(encoding="utf-8"))
    text = next((part for part in paragraphs[1:] if not part.startswith(("!", "#", "```", "|"))), "")
    text = re.sub(r"\]\((?!http)([^)]*)", lambda link: f"]({normpath(f'../cases/{title(case)}/{link[1]}')}", text)  # seen from docs/
    shown = f"![{title(case)}](pictures/{picture_of(case).name})\n\n" if picture_of(case).is_file() else ""
    return f"## [{paragraphs[0].splitlines()[0].lstrip('# ')}](../cases/{title(case)}/README.md)\n\n{shown}{text}\n\n    ./rivage run {title(case)}\n"


def page() -> str:
    return "\n".join([HEAD, *(entry(case) for case in find_cases([]) if (case / "README.md").is_file())])


def main() -> int:
    for case in find_cases(sys.argv[2:]) if len(sys.argv) > 2 else []:
        draw(case, Path(sys.argv[1]))
    (DOCS / "gallery.md").write_text(page(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
