"""Output of the commands: numbers with their radii, as JSON or as lines; text and figures as files."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable, Mapping
from decimal import Decimal
from pathlib import Path
from typing import Any

from numerics.files import whole_file
from numerics.meter import meter
from numerics.shown import write_figure

_SPARE = 20
NAMED = {
    "x1": ("x1", "m"),
    "v1": ("v1", "m/s"),
    "v2": ("v2", "m/s"),
    "entrainment": ("U*", "N"),
    "exception": ("other motions can stick up to U*/cos(pi omega/(2 Omega))", "N"),
    "non_stop": ("U**, required for permanent slip with two reversals per period", "N"),
    "drift": ("mean velocity of body 2", "m/s"),
    "growth": ("growth rate of the amplitude of v1", "m/s^2 at least"),
    "decay": ("factor by which a distance changes per period", ""),
    "threshold": ("U* = U**", "N"),
    "speed": ("slip speed", "m/s"),
    "friction_along": ("friction along the force", "N"),
    "friction_across": ("friction across it", "N"),
    "bound": ("no force arrives before", "s"),
    "time": ("duration of this transfer", "s"),
    "energy": ("int u^2 dt of this transfer", "N^2 s"),
    "least_energy": ("no transfer in this time that sticks, and keeps the margin, has less int u^2 dt than", "N^2 s"),
    "peak": ("max |u| of this transfer", "N"),
    "least_peak": ("no transfer in this time that sticks, and keeps the margin, has a lower max |u| than", "N"),
    "stuck_amplitude": ("amplitude required for sticking at the limit, or at the margin below it", "N"),
    "least_amplitude": ("minimum amplitude to arrive at the bound", "N"),
    "entry": ("stays inside the ring from t", "s"),
    "centre": ("its centre", "m"),
    "stuck": ("time to permanent stick", "s"),
    "rest": ("time to rest within the tolerance", "s"),
}
"""Names and units of the numbers in a result."""


def asked(options: argparse.Namespace, *names: str) -> dict[str, Any]:
    """Return the arguments of a question: the digits, and the options of these names."""
    return {name: getattr(options, name) for name in ("digits", "max_digits", *names)}


def numbers(found: Any, *names: str, **values: Any) -> dict[str, str]:
    """Return numbers of a result, and other enclosures, as decimal text to its digits, each with its radius.

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


def in_brief(x: Any, digits: int) -> str:
    """Return a force as a decimal of so many digits without zeros at its end, and what it may be off by, in N."""
    from numerics.arithmetic.ball import Ball
    from numerics.trajectory.rendering import with_radius

    with Ball(digits + _SPARE).context():
        text, radius = with_radius("", x, digits, spare=0).values()
    return f"{Decimal(text).normalize()} N (+/- {radius})"


def number_lines(shown: Mapping[str, Any], **names: str) -> list[str]:
    """Return a line for each number that has a name and a unit, with its radius; `names` go before those of NAMED."""
    lines = []
    for key, (name, unit) in NAMED.items():
        if key in shown:
            within = f", within {shown[f'{key}_radius']}" if f"{key}_radius" in shown else ""
            lines.append(f"  {names.get(key, name)} = {shown[key]} {unit}".rstrip() + within)
    return lines


def answer(options: argparse.Namespace, record: Mapping[str, Any], lines: Iterable[str]) -> None:
    """Print a result: as JSON if requested, else as lines."""
    print(json.dumps(record, indent=1) if options.json else "\n".join(lines))


def draw(options: argparse.Namespace, name: str, *what: Any) -> None:
    """Write the figure that --plot requests, by the name of the function that draws it."""
    if options.plot is not None:
        from numerics.control import pictures

        with meter("drawing"):
            write_figure(getattr(pictures, name)(*what), options.plot)


def write_text(text: str, path: Path) -> None:
    """Write a file of text whole, or not at all."""
    with whole_file(path) as file:
        file.write(text.encode())
