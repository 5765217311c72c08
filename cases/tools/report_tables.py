# SPDX-License-Identifier: MIT
"""The tables of a report: the run's figures, expected against found, where the time went."""
import math
from html import escape

from energy import EnergySum
from expectations import Finding
from report_figures import worst_mismatch
from report_page import key_figures, table
from run_folder import RunFolder


def short(value, digits: int = 4) -> str:
    """A number as a reader wants it: thousands apart, few digits."""
    if not isinstance(value, (int, float)):
        return str(value)
    if isinstance(value, int) or (value == int(value) and abs(value) < 1e15):
        return f"{int(value):,}".replace(",", " ")
    return f"{value:.{digits}g}"


def run_figures(run: RunFolder, summary: dict, energies: EnergySum | None) -> str:
    """The strip of figures at the head of the page."""
    pairs = []
    if energies is not None:
        pairs.append(("physical time [s]", short(float(energies.t[-1]))))
    for side in run.sides():
        part = summary.get(side, {})
        if "ranks" in part:
            pairs.append((f"{side}: ranks", short(part["ranks"])))
        for key, name in (("particles", "particles"), ("nodes", "nodes"), ("steps", "steps")):
            if key in part:
                pairs.append((f"{side}: {name}", short(part[key])))
    wall = max((summary.get(side, {}).get("wall_s", 0.0) for side in run.sides()), default=0.0)
    if wall > 0:
        pairs.append(("wall time", f"{wall:.1f} s" if wall < 120 else f"{wall / 60:.1f} min"))
    updates = summary.get("fluid", {}).get("particle_updates_per_s")
    if updates:
        pairs.append(("particle updates per second", f"{updates / 1e6:.3g} million"))
    if energies is not None:
        pairs.append((f"energy drift at the end [{energies.unit}]", short(float(energies.drift[-1]), 3)))
    for name, interface in run.interfaces().items():
        pairs.append((f"interface work mismatch, largest over peak {name}".rstrip(), f"{100 * worst_mismatch(interface):.3g} %"))
    for side in run.sides():
        if "state_hash" in summary.get(side, {}):
            pairs.append((f"{side}: state hash", str(summary[side]["state_hash"])))
    return key_figures(pairs)


def expectation_table(findings: list[Finding]) -> str:
    rows = []
    for finding in findings:
        entry, (low, high) = finding.entry, finding.band
        if "value" in entry:
            tolerance = entry.get("tolerance", 0)
            relative = entry.get("kind", "relative") == "relative"
            expected = f"{entry['value']:.6g} ± " + (f"{100 * tolerance:.3g} %" if relative else f"{tolerance:.3g}")
        elif math.isinf(low):
            expected = f"at most {high:.4g}"
        else:
            expected = f"at least {low:.4g}" if math.isinf(high) else f"{low:.4g} to {high:.4g}"
        verdict = "note" if not finding.judged else "pass" if finding.passed else "miss"
        value = "–" if finding.value is None else f"{finding.value:.5g}"
        source = f"{finding.reason}. " if finding.reason else ""
        rows.append([f'<span class="{verdict}">{verdict}</span>', escape(entry["quantity"]), value, escape(expected),
                     escape(source + entry.get("source", ""))])
    return table(["", "figure", "found", "expected", "source"], rows, {2})


def time_rows(tree: dict, whole: float, level: int = 0) -> list[list[str]]:
    rows = []
    for name, entry in sorted(tree.items(), key=lambda item: -item[1].get("seconds", 0.0)):
        seconds = entry.get("seconds", 0.0)
        share = seconds / whole if whole > 0 else 0.0
        bar = f'<span class="bar" style="width:{max(1, round(110 * share))}px"></span>'
        rows.append([f'<span style="padding-left:{16 * level}px">{escape(name.replace("_", " "))}</span>',
                     f"{seconds:.2f}", f"{100 * share:.1f} %", short(entry.get("calls", 0)), bar])
        rows += time_rows(entry.get("inside", {}), whole, level + 1)
    return rows


def time_table(side: str, part: dict) -> str:
    """Where the wall time of one participant went, nested as the code is."""
    tree = part.get("timers", {})
    whole = part.get("wall_s") or sum(entry.get("seconds", 0.0) for entry in tree.values())
    return table([f"{side}", "seconds", "share", "calls", ""], time_rows(tree, whole), {1, 2, 3})
