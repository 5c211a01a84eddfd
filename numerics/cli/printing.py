"""How enclosures and figures leave the commands: numbers with their radii, whole files."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

_SPARE = 20


def numbers(values: dict[str, Any], digits: int) -> dict[str, str]:
    """Return enclosures as decimal text with their radii beside them, `name` and `name_radius`; None is left out.

    What is exactly infinite is "inf".
    """
    from numerics.arithmetic.ball import Ball
    from numerics.trajectory.rendering import ball_text

    found = {}
    with Ball(digits + _SPARE).context():
        for name, value in values.items():
            if value is not None and value.is_finite():
                found[name], found[f"{name}_radius"] = ball_text(value, digits)
            elif value is not None:
                found[name] = "inf"
    return found


def print_numbers(shown: dict[str, str], units: dict[str, str], sentences: dict[str, str]) -> None:
    """Print numbers with unit and radius, each under its sentence or its name."""
    for name, text in shown.items():
        if not name.endswith("_radius"):
            radius = f", within {shown[f'{name}_radius']}" if f"{name}_radius" in shown else ""
            print(f"  {sentences.get(name, name)} = {text} {units.get(name, '')}".rstrip() + radius)


def write_figure(figure: Any, path: Path) -> None:
    """Write a matplotlib figure to a .svg, .pdf or .png file."""
    from numerics.files import whole_file

    with whole_file(path) as file:
        figure.savefig(file, format=path.suffix[1:], dpi=200)


@contextmanager
def shown_steps() -> Iterator[Callable[[str], None]]:
    """Yield what shows on stderr what is being done, one line that goes away at the end; on a terminal only."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    try:
        yield lambda what: print(f"\r\033[K{what}", end="", file=sys.stderr, flush=True)
    finally:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
