# SPDX-License-Identifier: MIT
"""The page itself: a sheet of paper's worth of HTML, no scripts, nothing loaded from elsewhere."""
from html import escape

STYLE = """
:root { --ink: #1c2126; --soft: #66707a; --line: #e2e6ea; --water: #1f6fb2; }
* { box-sizing: border-box }
body { margin: 0; background: #f4f6f8; color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif }
main { max-width: 1120px; margin: 0 auto; padding: 32px 40px 56px; background: #fff }
header { border-bottom: 2px solid var(--water); padding-bottom: 10px }
h1 { margin: 0; font-size: 26px; letter-spacing: -.01em }
h2 { margin: 34px 0 8px; font-size: 17px }
p, figcaption { color: var(--soft); margin: 4px 0 }
figure { margin: 10px 0 }
figcaption { font-size: 13px; max-width: 90ch }
img { max-width: 100%; display: block }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 1px; margin-top: 18px;
  background: var(--line); border: 1px solid var(--line) }
.figures div { background: #fff; padding: 8px 12px }
.figures b { display: block; font-size: 17px; font-weight: 600; overflow-wrap: anywhere }
.figures span { color: var(--soft); font-size: 12px }
table { border-collapse: collapse; font-size: 13.5px; width: 100% }
th { text-align: left; font-weight: 600; color: var(--soft); border-bottom: 1px solid var(--line) }
td, th { padding: 3px 10px 3px 0; vertical-align: top }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
tr + tr td { border-top: 1px solid #f0f2f4 }
.pass { color: #22794a } .miss { color: #b3261e; font-weight: 600 } .note { color: var(--soft) }
.columns { display: grid; grid-template-columns: 1fr 1fr; gap: 36px }
.bar { display: inline-block; height: 8px; background: var(--water); border-radius: 2px; vertical-align: middle }
.missing { background: #fff7e8; border-left: 3px solid #d9962b; padding: 8px 14px; margin: 16px 0; color: #6b4a10 }
@media (max-width: 760px) { main { padding: 20px } .columns { grid-template-columns: 1fr } }
@media print { body { background: #fff } main { padding: 0 } }
"""


def page(title: str, subtitle: str, body: list[str]) -> str:
    """The complete document."""
    return (f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head>\n'
            f'<body><main>\n<header><h1>{escape(title)}</h1><p>{escape(subtitle)}</p></header>\n'
            + "\n".join(body) + "\n</main></body></html>\n")


def section(title: str, *parts: str) -> str:
    """A heading and what stands under it; empty when nothing does."""
    inside = "\n".join(part for part in parts if part)
    return f"<h2>{escape(title)}</h2>\n{inside}" if inside else ""


def picture(image: str, caption: str = "") -> str:
    return f"<figure>{image}<figcaption>{escape(caption)}</figcaption></figure>" if image else ""


def key_figures(pairs: list[tuple[str, str]]) -> str:
    cells = "".join(f"<div><b>{escape(value)}</b><span>{escape(name)}</span></div>" for name, value in pairs)
    return f'<div class="figures">{cells}</div>' if pairs else ""


def table(header: list[str], rows: list[list[str]], numbers: set[int] = frozenset()) -> str:
    """Cells are HTML already; the columns in `numbers` stand right-aligned."""
    if not rows:
        return ""
    head = "".join(f"<th>{escape(name)}</th>" for name in header)
    lines = []
    for row in rows:
        kinds = (' class="number"' if index in numbers else "" for index in range(len(row)))
        lines.append("<tr>" + "".join(f"<td{kind}>{cell}</td>" for kind, cell in zip(kinds, row)) + "</tr>")
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(lines)}</tbody></table>"


def columns(*parts: str) -> str:
    """The parts side by side."""
    return '<div class="columns">' + "".join(f"<div>{part}</div>" for part in parts) + "</div>" if any(parts) else ""


def missing_note(names: list[str]) -> str:
    if not names:
        return ""
    return f'<div class="missing">Missing in the run folder, so left out here: {escape(", ".join(names))}</div>'
