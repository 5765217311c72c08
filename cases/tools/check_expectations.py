# SPDX-License-Identifier: MIT
"""Compares a run with its case's expect.toml: prints a table, exits with 1 when a judged figure misses.

usage: check_expectations.py RUN CASE_FOLDER [--json FILE]      (--json appends one JSON object a figure)
"""
import argparse
import json
import sys
from pathlib import Path

from expectations import Finding, check
from run_folder import RunFolder


def line(finding: Finding) -> str:
    low, high = finding.band
    if "value" in finding.entry:
        kind = "" if finding.entry.get("kind", "relative") == "absolute" else " relative"
        expected = f"{finding.entry['value']:.6g} +- {finding.entry.get('tolerance', 0):.3g}{kind}"
    else:
        expected = f"{low:.6g} to {high:.6g}".replace("-inf to", "at most").replace(" to inf", " or more")
        expected = expected.replace("at most inf", "nothing, reported")
    value = "not measured" if finding.value is None else f"{finding.value:.6g}"
    verdict = "note" if not finding.judged else "pass" if finding.passed else "MISS"
    text = f"{verdict:5s} {finding.entry['quantity']:38s} {value:>14s}   expected {expected}"
    note = finding.reason or finding.detail
    return f"{text}   ({note})" if note else text


def judge(run: Path, case: Path, json_file: Path | None = None) -> int:
    """Prints the table; 0 when every judged figure is in its band, 1 when one misses, 2 when nothing is expected."""
    findings = check(RunFolder(run), case)
    if not findings:
        print(f"{case}: no expect.toml, or nothing in it", file=sys.stderr)
        return 2
    print("\n".join(line(finding) for finding in findings))
    if json_file:
        with json_file.open("a", encoding="utf-8") as file:
            file.writelines(json.dumps(finding.as_record()) + "\n" for finding in findings)
    return 0 if all(finding.passed for finding in findings if finding.judged) else 1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path)
    parser.add_argument("case", type=Path)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    return judge(arguments.run, arguments.case, arguments.json)


if __name__ == "__main__":
    sys.exit(main())
