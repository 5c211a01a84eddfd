"""What a proof uses, read from the record that the compiler writes beside each compiled file.

The record names every reference in a file with its place, so the references between one statement's name and the next
one's are those of the statement and of its proof.
"""

from __future__ import annotations

import bisect
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from paper_checks.proofs.sources import LIBRARY

Graph = Mapping[str, frozenset[str]]
"""From "File.name" to all that its text refers to directly, in this library."""

_REFERENCE = re.compile(rf"R(\d+):\d+ {LIBRARY}\.(\w+) (\S+) ([^\s:]+) \w+")
_STATEMENT = re.compile(r"(\w+) (\d+):\d+ (\S+) (\S+)")
# a section's variables and local lemmas ("var") are named with their section, what is in a module with the module, all
# else by itself; what an applied functor has is named as if the file that applies it had said it
_DEFINITIONS = {"def", "rec", "ind"}
_STATEMENTS = {"prf", "def", "rec", "ind", "proj", "constr", "ax", "var"}


def references(folders: Mapping[str, Path]) -> tuple[Graph, frozenset[str]]:
    """The graph of all compiled files, given the folder of each; and which of its names are definitions."""
    uses: dict[str, set[str]] = {}
    definitions: set[str] = set()
    in_modules: dict[str, str] = {}
    for file, folder in folders.items():
        definitions |= _read((folder / f"{file}.glob").read_text("utf-8"), file, uses, in_modules)

    def meant(name: str) -> str:
        return name if name in uses else in_modules.get(name.rsplit(".", maxsplit=1)[-1], name)

    return {name: frozenset(map(meant, used - {name})) for name, used in uses.items()}, frozenset(definitions)


def _read(record: str, file: str, uses: dict[str, set[str]], in_modules: dict[str, str]) -> set[str]:
    statements: list[tuple[int, str]] = []
    used: list[tuple[int, str]] = []
    definitions: set[str] = set()
    for line in record.splitlines():
        if match := _REFERENCE.match(line):
            place, other, path, name = match.groups()
            used.append((int(place), f"{other}.{name}" if path == "<>" else f"{other}.{path}.{name}"))
        elif (match := _STATEMENT.match(line)) and match[1] in _STATEMENTS:
            name = f"{file}.{match[4]}" if match[3] == "<>" else f"{file}.{match[3]}.{match[4]}"
            statements.append((int(match[2]), name))
            if match[1] != "var" and match[3] != "<>":  # what a functor has is nothing until it is applied
                in_modules[match[4]] = name
            elif match[1] in _DEFINITIONS:
                definitions.add(name)
    statements.sort()
    for _, name in statements:
        uses.setdefault(name, set())
    for place, other in used:
        if (index := bisect.bisect_right(statements, (place, chr(0x10FFFF))) - 1) >= 0:
            uses[statements[index][1]].add(other)
    return definitions


def nearest(name: str, wanted: Iterable[str], graph: Graph) -> tuple[str, ...]:
    """Those of `wanted` that a proof uses itself or through proofs that are not wanted."""
    stops, seen = frozenset(wanted) - {name}, {name}
    waiting, reached = list(graph.get(name, ())), set()
    while waiting:
        one = waiting.pop()
        if one in stops:
            reached.add(one)
        elif one not in seen:
            seen.add(one)
            waiting += graph.get(one, ())
    return tuple(sorted(reached))
