"""How times, factors, digits and lists of names are said."""

from __future__ import annotations

import math
from collections.abc import Sequence

from numerics.trade.front import Point
from numerics.trade.recorded import RecordedScene, RecordedTrade
from numerics.trade.scenes import HEADLINE
from numerics.trade.table import seconds_text

_GROUPS = {
    "velocities": "the paper's scenes",
    "relative-motion-": "the paper's scenes",
    "near-critical-": "near-critical scenes",
    "long-": "the long scene",
}


def groups(trade: RecordedTrade) -> dict[str, list[RecordedScene]]:
    """Return the scenes by what they are there for, in the order of the trade."""
    found: dict[str, list[RecordedScene]] = {}
    for scene in trade.scenes:
        name = next((title for start, title in _GROUPS.items() if scene.name.startswith(start)), scene.name)
        found.setdefault(name, []).append(scene)
    return found


def headline(trade: RecordedTrade) -> RecordedScene:
    """Return the scene that single numbers are quoted for: the headline scene, or the first where a trade lacks it."""
    return next((one for one in trade.scenes if one.name == HEADLINE), trade.scenes[0])


def digits(error: float) -> int:
    """Return how many digits a decimal logarithm of an error leaves right.

    >>> digits(-14.9), digits(0.3), digits(float("inf"))
    (14, 0, 0)
    """
    return max(0, math.floor(-error)) if math.isfinite(error) else 0


def time_text(seconds: float) -> str:
    """Return a time with its unit.

    >>> time_text(3.66e-6), time_text(0.25)
    ('3.66 µs', '250 ms')
    """
    return seconds_text(seconds).replace(" us", " µs")


def factor_text(factor: float) -> str:
    """Return a ratio to three digits, or whole.

    >>> factor_text(1.234), factor_text(12345.6), factor_text(0.1234)
    ('1.23', '12,346', '0.123')
    """
    return f"{factor:,.0f}" if factor >= 100 else f"{factor:.3g}"


def step_text(step: float) -> str:
    """Return a step in LaTeX, to two digits.

    >>> step_text(1e-4), step_text(2.24e-6)
    ('$10^{-4}$', '$2.2\\\\cdot10^{-6}$')
    """
    mantissa, _, exponent = f"{step:.1e}".partition("e")
    power = f"10^{{{int(exponent)}}}"
    return f"${power}$" if mantissa == "1.0" else f"${mantissa.removesuffix('.0')}\\cdot{power}$"


def listed(names: Sequence[str]) -> str:
    """Return names as a sentence has them.

    >>> listed(["a", "b", "c"]), listed(["a"]), listed([])
    ('a, b and c', 'a', 'none')
    """
    if not names:
        return "none"
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def spread(least: str, most: str) -> str:
    """Return a range, or its one value.

    >>> spread("2", "5"), spread("2", "2")
    ('2 to 5', '2')
    """
    return least if least == most else f"{least} to {most}"


def counted(number: int, one: str, many: str) -> str:
    """Return a number with its noun.

    >>> counted(1, "run", "runs"), counted(3, "run", "runs")
    ('1 run', '3 runs')
    """
    return f"{number:,} {one if number == 1 else many}"


def asked(trade: RecordedTrade, point: Point) -> str:
    """Return who a point is of, with its setting where that is a choice."""
    settings = {one.setting for one in trade.runs if one.contender == point.contender}
    knob = next(one.knob for one in trade.runs if one.contender == point.contender)
    if len(settings) == 1:
        return point.contender
    what = f"{point.setting:,.0f} digits" if knob == "digits" else f"{knob} {point.setting:g}"
    return f"{point.contender}, {what}"
