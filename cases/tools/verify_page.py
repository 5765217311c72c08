# SPDX-License-Identifier: MIT
"""The generated part of docs/verification.md: what stands between its two markers, misses first.

The records behind it are kept in docs/verification_results.jsonl, one JSON object a figure: a run of `verify` replaces those of
the cases that it ran, or with `--run` those of the runs alone; the page is made anew from all. Everything outside the markers is
written by hand and left alone; the cause of a miss stands beside its expectation (`miss = "..."` in expect.toml).
"""
import json
import tomllib
from pathlib import Path

BEGIN, END = "<!-- verify: begin; written by ./rivage verify -->", "<!-- verify: end -->"
HEADER = ("case", "quantity", "ours", "reference", "difference", "tolerance", "", "source", "run", "dx [m]", "ranks", "time [s]")


def number(value) -> str:
    return "" if value is None else f"{value:.5g}" if isinstance(value, (int, float)) else str(value)


def reference(record: dict) -> tuple[str, str, str]:
    """The cells reference, difference and tolerance."""
    value, wanted, tolerance = record["value"], record["reference"], record["tolerance"]
    if isinstance(wanted, list):
        low, high = wanted
        if None not in wanted:
            return f"{number(low)} to {number(high)}", "", ""
        return f">= {number(low)}" if high is None and low is not None else f"<= {number(high)}" if high is not None else "", "", ""
    if value is None:
        return number(wanted), "", number(tolerance)
    if record["kind"] == "relative" and wanted:
        return number(wanted), f"{100 * (value - wanted) / abs(wanted):+.3g} %", f"{100 * (tolerance or 0):.3g} %"
    return number(wanted), f"{value - wanted:+.3g}", number(tolerance)


def verdict(record: dict) -> str:
    return "note" if not record["judged"] else "pass" if record["pass"] else "**miss**"


def row(cells) -> str:
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"


def figure_row(record: dict) -> str:
    return row((record["case"], record["quantity"], number(record["value"]) or "-", *reference(record), verdict(record),
                record["source"], record.get("run", ""), number(record.get("dx")), record.get("ranks", ""), number(record.get("wall_s"))))


def convergence_row(record: dict) -> str:
    wanted, _, _ = reference(record)
    return row((record["case"], record["quantity"], record.get("detail", "-"), number(record["value"]) or "-", wanted,
                verdict(record), record["source"]))


def miss_row(record: dict) -> str:
    wanted, difference, tolerance = reference(record)
    return row((record["case"], record["quantity"], number(record["value"]) or "-", wanted, difference, tolerance,
                record.get("dx", ""), record.get("cause", "not found yet")))


def table(header, rows: list[str]) -> list[str]:
    return [row(header), row(["---"] * len(header)), *rows] if rows else []


def page(records: list[dict]) -> str:
    misses = [record for record in records if record["judged"] and not record["pass"]]
    commits = sorted({record["commit"] for record in records if record.get("commit")})
    lines = [f"{len(records)} figures, {len(misses)} misses; commits of the runs: {', '.join(commits)}.", "", "### Misses", ""]
    lines += table(("case", "quantity", "ours", "reference", "difference", "tolerance", "dx [m]", "cause"),
                   [miss_row(record) for record in misses]) or ["None."]
    over_runs = [record for record in records if record.get("run") == "all"]
    lines += ["", "### Over resolutions", "", *table(("case", "quantity", "figures", "lowest", "reference", "", "source"),
                                                     [convergence_row(record) for record in over_runs])]
    single = [record for record in records if record.get("run") != "all"]
    for group in sorted({record.get("group", "") for record in single} - {""}):
        lines += ["", f"### Cases of `./rivage verify {group}`", ""]
        lines += table(HEADER, [figure_row(record) for record in single if record.get("group") == group])
    lines += ["", "### Single runs", ""]
    lines += table(HEADER, [figure_row(record) for record in single if not record.get("group")])
    return "\n".join(lines)


def with_causes(records: list[dict], cases: Path) -> list[dict]:
    """The records with the causes of misses as expect.toml states them now."""
    stated: dict[str, dict] = {}
    for record in records:
        path = cases / record["case"] / "expect.toml"
        if record["case"] not in stated and path.is_file():
            content = tomllib.loads(path.read_text(encoding="utf-8"))
            entries = content.get("expect", []) + content.get("convergence", [])
            stated[record["case"]] = {(entry["quantity"], str(entry.get("run"))): entry.get("miss") for entry in entries}
        cause = stated.get(record["case"], {}).get((record["quantity"], str(record.get("meant_for"))))
        if cause and record["value"] is not None and not record["pass"]:
            record["cause"] = cause
    return records


def merged(old: list[dict], new: list[dict], some_runs: bool) -> list[dict]:
    """The old records with the new ones in place of those of the same cases, or of the same runs of them."""
    def key(record: dict) -> tuple:
        return (record["case"], record.get("run")) if some_runs else (record["case"],)

    made_anew = {key(record) for record in new}
    return sorted([record for record in old if key(record) not in made_anew] + new, key=lambda record: record["case"])


def write_page(docs: Path, new: list[dict], some_runs: bool = False) -> None:
    """Takes the new records, of whole cases or of some of their runs, into the file of results and renews the page. Throws ValueError
    when the markers are gone."""
    results, path = docs / "verification_results.jsonl", docs / "verification.md"
    old = [json.loads(text) for text in results.read_text(encoding="utf-8").splitlines()] if results.exists() else []
    records = with_causes(merged(old, new, some_runs), docs.parent / "cases")
    text = path.read_text(encoding="utf-8")
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        raise ValueError(f"{path}: the markers '{BEGIN}' and '{END}' must stand there once each")
    before, rest = text.split(BEGIN)
    path.write_text(f"{before}{BEGIN}\n{page(records)}\n{END}{rest.split(END)[1]}", encoding="utf-8")
    results.write_text("".join(json.dumps(record) + "\n" for record in records), encoding="utf-8")
