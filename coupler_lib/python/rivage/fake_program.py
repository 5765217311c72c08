# SPDX-License-Identifier: MIT
"""What both fakes do as programs: their arguments, and a run on one rank."""
import argparse
from collections.abc import Callable, Iterable

from rivage.participant import Error, Participant


def command(name: str, text: str | None) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog=f"rivage.fake_{name}", description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="coupling.toml")
    return parser


def add_common(parsers: Iterable[argparse.ArgumentParser], role: str) -> None:
    for parser in parsers:
        parser.add_argument("--as", dest="role", default=role, help=f"role ({role})")
        parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="override, the same on all sides")
        parser.add_argument("--out", help="folder for the tables")


def run(told: argparse.Namespace, play: Callable[[argparse.Namespace, Participant], None]) -> None:
    with Participant(told.role, told.file, [*told.set, *(["--out", told.out] if told.out else [])]) as me:
        if me.comm.size > 1:
            raise Error(2, f"the fakes in Python play on one rank, but '{told.role}' has {me.comm.size}")
        play(told, me)
