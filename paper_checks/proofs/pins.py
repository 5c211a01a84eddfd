"""The pins: what each cited theorem said when it was last read by a person, in `pins.json`.

A theorem whose printed statement, or a definition beneath it, differs from its pin does not count as proved.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

PINS = Path(__file__).parent / "pins.json"


@dataclass(frozen=True)
class Pin:
    """One theorem: its printed statement, the definitions beneath it by name, and the cited theorems that it uses by id."""

    statement: str
    definitions: tuple[str, ...]
    uses: tuple[str, ...]


@dataclass(frozen=True)
class Pins:
    """All pins."""

    theorems: Mapping[str, Pin]
    definitions: Mapping[str, str]
    """Each definition as printed."""
    ties: Mapping[str, str]
    """What each tie to the theory says in words. Their statements are printed from `theory/`, so they are not compared."""
    tied: Mapping[str, tuple[str, ...]]
    """By the id of a tie: the definitions that it speaks of."""


@cache
def pinned() -> Pins:
    """The pins of the package."""
    return read(PINS.read_text("utf-8"))


def read(text: str) -> Pins:
    """Pins from the text of the file."""
    data = json.loads(text)
    return Pins(
        {
            one: Pin("\n".join(entry["statement"]), tuple(entry["definitions"]), tuple(entry["uses"]))
            for one, entry in data["theorems"].items()
        },
        {name: "\n".join(lines) for name, lines in data["definitions"].items()},
        data["ties"],
        {one: tuple(defined) for one, defined in data["tied"].items()},
    )


def written(pins: Pins) -> str:
    """The text of the file: a printed line is a line there, so that a change can be read in a diff."""
    data = {
        "theorems": {
            one: {"statement": pin.statement.splitlines(), "definitions": pin.definitions, "uses": pin.uses}
            for one, pin in sorted(pins.theorems.items())
        },
        "definitions": {name: text.splitlines() for name, text in sorted(pins.definitions.items())},
        "ties": dict(sorted(pins.ties.items())),
        "tied": dict(sorted(pins.tied.items())),
    }
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"
