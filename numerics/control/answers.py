"""Results of this subpackage: to the digits requested, in decimals that a scene holds, and solved again by events."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.attempts import SPARE_DIGITS
from numerics.arithmetic.ball import Ball
from numerics.errors import NumericsError
from numerics.solver.solve import solve
from numerics.trajectory.trajectory import Trajectory

_MOST_TIMES, _DECIMALS = 16, 15
KEPT_DIGITS, TIME_DIGITS = 40, 20
"""Significant digits of a number that a scene cannot hold exactly, and of a time that a plan may choose."""

number = Ball.number
"""An exact rational as a ball, in the arithmetic's context."""


def most_digits(digits: int, max_digits: int | None) -> int:
    """Return the limit on working digits where they take seconds: as given, else 16 times the digits requested."""
    return max_digits or _MOST_TIMES * (digits + SPARE_DIGITS)


def rounded(x: arb, digits: int = KEPT_DIGITS) -> Fraction:
    """Return the decimal of so many significant digits next to the midpoint of a ball."""
    return Fraction(Decimal(x.mid().str(digits, radius=False)))


def rounded_up(x: arb, digits: int = KEPT_DIGITS) -> Fraction:
    """Return a decimal of so many digits that no point of a positive ball exceeds."""
    near = Decimal(x.upper().str(digits, radius=False))
    return Fraction(near) + Fraction(2) * Fraction(10) ** (near.adjusted() + 1 - digits)


class SecondSolveDiffers(NumericsError):
    """The same scene solved by events contradicts a result: one of the two is wrong."""


class SlipsAgain(SecondSolveDiffers):
    """The bodies slip where a result says that they stick."""


def solved_again(found: Any) -> Trajectory | None:
    """Return the scene of a Transfer or a Tracking solved by events in balls, None if it has none.

    Raises SecondSolveDiffers unless body 2 gets where the answer says, to 15 digits where it has more, and the bodies
    stick where it says so.
    """
    if found.scene is None:
        return None
    solved = solve(found.scene, digits=found.digits, arithmetic="ball")
    if found.sticks and any(mode.sign for mode in solved.modes):
        raise SlipsAgain("the bodies slip when solved by events, and stick by equations")
    with Ball(found.digits + 20).context():
        (goal, size), x2 = found.goal(found.scene), solved.final_state[2]
        if not abs(x2 - goal) <= size * arb(10) ** (3 - min(found.digits, _DECIMALS)):
            raise SecondSolveDiffers(f"x2 is {x2.str(12)} when solved by events, {goal.str(12)} by equations")
    return solved
