"""The proved answer that everybody is held against: balls, radii and all, solved once for each number of digits."""

from __future__ import annotations

from typing import Any

from numerics.scene import Scene
from numerics.trade.ours import BALL, Ours, solved
from numerics.trade.outcome import Outcome

NAME = "reference"
POINT_DIGITS = 40
"""For contenders of at most 34 digits, which is quadruple precision."""
MORE_DIGITS = 30
"""Beyond the digits that a contender was asked for."""


def contenders() -> list[Any]:
    """Return `solve` in balls as the one contender of this module: every number is written with its radius."""
    return [Ours(NAME, solved(BALL), "", "digits", (POINT_DIGITS,), write=lambda value, digits: str(value.str(digits)))]


def proved(scene: Scene, digits: int = POINT_DIGITS) -> Outcome:
    """Return the reference of a scene."""
    (ball,) = contenders()
    found: Outcome = ball.outcome(ball.prepare(scene, float(digits))())
    return found


def digits_for(knob: str, setting: float) -> int:
    """Return how many digits the reference of a setting needs.

    >>> digits_for("step (s)", 1e-3), digits_for("digits", 1000.0)
    (40, 1030)
    """
    asked = int(setting) + MORE_DIGITS if knob == "digits" else 0
    return max(POINT_DIGITS, asked)
