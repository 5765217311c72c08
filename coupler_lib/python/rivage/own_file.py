# SPDX-License-Identifier: MIT
"""A participant's own settings, as `file` of its table in coupling.toml names them."""
import os
import tomllib
from collections.abc import Iterable
from pathlib import Path

from rivage.participant import Error


def read_own_file(coupling_file: str | os.PathLike, role: str, arguments: Iterable[str] = ()) -> dict:
    """The tables of that file, with the arguments "ROLE.table.key=value" applied; others are not this role's.

    Raises Error(2) where the file is not named or not readable, or an override names a key that the file does not have.
    """
    shared = read(Path(coupling_file))
    name = shared.get("participants", {}).get(role, {}).get("file")
    if not name:
        raise Error(2, f'{coupling_file}: [participants.{role}] names no file = "..."')
    path = Path(coupling_file).parent / name
    tables = read(path)
    for override in arguments:
        key, _, value = override.partition("=")
        if key.startswith(f"{role}."):
            replace(tables, key.split(".")[1:], value, f"{override}: {path}")
    return tables


def read(path: Path) -> dict:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise Error(2, f"{path}: {error}") from None


def replace(tables: dict, keys: list[str], text: str, where: str) -> None:
    """Sets tables[keys[0]][keys[1]]... to the value that the text is in TOML, or to the text itself where it is none."""
    for key in keys[:-1]:
        tables = tables.get(key, {})
    if keys[-1] not in tables:
        raise Error(2, f"{where} has no key {'.'.join(keys)}")
    try:
        tables[keys[-1]] = tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        tables[keys[-1]] = text
