"""How answers leave the commands: numbers with their radii, as JSON, as lines or drawn."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable, Mapping
from typing import Any

from numerics.shown import write_figure

_SPARE = 20
SHOWN = 20
"""On a terminal so many events are printed at the beginning, and as many at the end."""


def numbers(values: dict[str, Any], digits: int) -> dict[str, str]:
    """Return enclosures as decimal text with their radii beside them, `name` and `name_radius`; None is left out.

    What is exactly infinite is "inf".
    """
    from numerics.arithmetic.ball import Ball
    from numerics.trajectory.rendering import with_radius

    found: dict[str, str] = {}
    with Ball(digits + _SPARE).context():
        for name, value in values.items():
            if value is not None and value.is_finite():
                found |= with_radius(name, value, digits)
            elif value is not None:
                found[name] = "inf"
    return found


def number_lines(shown: Mapping[str, Any], named: dict[str, tuple[str, str]]) -> list[str]:
    """Return a line for each number that has a name and a unit, with its radius."""
    return [
        f"  {name} = {shown[key]} {unit}".rstrip() + (f", within {shown[radius]}" if radius in shown else "")
        for key, (name, unit) in named.items()
        if key in shown
        for radius in [f"{key}_radius"]
    ]


def answer(options: argparse.Namespace, record: Mapping[str, Any], lines: Iterable[str]) -> None:
    """Print an answer: as JSON where that was asked for, else as lines."""
    print(json.dumps(record, indent=1) if options.json else "\n".join(lines))


def draw(options: argparse.Namespace, name: str, *what: Any) -> None:
    """Write the picture that --plot asks for, by the name of what draws it."""
    if options.plot is not None:
        from numerics.control import pictures

        write_figure(getattr(pictures, name)(*what), options.plot)
