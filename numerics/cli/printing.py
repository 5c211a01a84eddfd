"""How answers leave the commands: numbers with their radii, as JSON or as lines, text and figures as files."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from numerics.files import whole_file
from numerics.shown import write_figure

_SPARE = 20
NAMED = {
    "x1": ("x1", "m"),
    "v1": ("v1", "m/s"),
    "v2": ("v2", "m/s"),
    "entrainment": ("U*", "N"),
    "exception": ("other motions stick up to U*/cos(pi omega/(2 Omega))", "N"),
    "non_stop": ("U**, needed to slip for ever with two reversals a period", "N"),
    "drift": ("mean velocity of body 2", "m/s"),
    "growth": ("v1's amplitude grows by", "m/s^2 at least"),
    "decay": ("decay", "of a distance left a period"),
    "threshold": ("U* = U**", "N"),
    "speed": ("slip speed", "m/s"),
    "friction_along": ("friction along the force", "N"),
    "friction_across": ("friction across it", "N"),
    "bound": ("no control arrives before", "s"),
    "time": ("this transfer takes", "s"),
    "stuck_amplitude": ("amplitude that sticking at the limit needs, or at the margin below it", "N"),
    "least_amplitude": ("least amplitude with which the bound can be met", "N"),
    "entry": ("inside the ring for good from t", "s"),
    "centre": ("its centre", "m"),
}
"""What the lines of an answer call its numbers, and their units."""


def asked(options: argparse.Namespace, *names: str) -> dict[str, Any]:
    """Return what a question is asked with: the digits, and the options of these names."""
    return {name: getattr(options, name) for name in ("digits", "max_digits", *names)}


def numbers(found: Any, *names: str, **values: Any) -> dict[str, str]:
    """Return numbers of an answer, and other enclosures, as decimal text to its digits, their radii beside them.

    `name` and `name_radius`; None is left out, what is exactly infinite is "inf".
    """
    from numerics.arithmetic.ball import Ball
    from numerics.trajectory.rendering import with_radius

    shown: dict[str, str] = {}
    with Ball(found.digits + _SPARE).context():
        for name, value in (*((name, getattr(found, name)) for name in names), *values.items()):
            if value is not None:
                shown |= with_radius(name, value, found.digits) if value.is_finite() else {name: "inf"}
    return shown


def number_lines(shown: Mapping[str, Any], **names: str) -> list[str]:
    """Return a line for each number that has a name and a unit, with its radius; `names` go before those of NAMED."""
    lines = []
    for key, (name, unit) in NAMED.items():
        if key in shown:
            within = f", within {shown[f'{key}_radius']}" if f"{key}_radius" in shown else ""
            lines.append(f"  {names.get(key, name)} = {shown[key]} {unit}{within}")
    return lines


def answer(options: argparse.Namespace, record: Mapping[str, Any], lines: Iterable[str]) -> None:
    """Print an answer: as JSON where that was asked for, else as lines."""
    print(json.dumps(record, indent=1) if options.json else "\n".join(lines))


def draw(options: argparse.Namespace, name: str, *what: Any) -> None:
    """Write the picture that --plot asks for, by the name of what draws it."""
    if options.plot is not None:
        from numerics.control import pictures

        write_figure(getattr(pictures, name)(*what), options.plot)


def write_text(text: str, path: Path) -> None:
    """Write a file of text whole, or not at all."""
    with whole_file(path) as file:
        file.write(text.encode())
