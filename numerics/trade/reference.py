"""The proved answer that everybody is held against: balls, radii and all, solved once for each number of digits."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numerics.scene import Scene
from numerics.trade.ours import Solved, solved, solved_outcome
from numerics.trade.outcome import Outcome

NAME = "reference"
POINT_DIGITS = 40
"""For contenders of at most 34 digits, which is quadruple precision."""
MORE_DIGITS = 30
"""Beyond the digits that a contender was asked for."""


class ReferenceBall:
    """solve(scene, digits=N) as a contender whose numbers are written as enclosures."""

    label = name = NAME
    use, knob, settings, ours = "", "digits", (float(POINT_DIGITS),), True

    def missing(self) -> str | None:
        """Return None: it is always there."""
        return None

    def prepare(self, scene: Scene, setting: float) -> Callable[[], Solved]:
        """Return the solve."""
        return lambda: solved(scene, "ball", int(setting))

    def outcome(self, run: Solved) -> Outcome:
        """Return every number with its radius; the dissipated energy comes from the ledger, where nothing cancels."""
        return solved_outcome(run, lambda value, digits: str(value.str(digits)))


def contenders() -> list[Any]:
    """Return the one contender of this module, for the worker."""
    return [ReferenceBall()]


def digits_for(knob: str, setting: float) -> int:
    """Return how many digits the reference of a setting needs.

    >>> digits_for("step (s)", 1e-3), digits_for("digits", 1000.0)
    (40, 1030)
    """
    asked = int(setting) + MORE_DIGITS if knob == "digits" else 0
    return max(POINT_DIGITS, asked)
