"""Results of this subpackage: to the digits requested, in decimals that a scene holds, and solved again by events."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from numerics.arithmetic.attempts import SPARE_DIGITS
from numerics.arithmetic.ball import Ball
from numerics.errors import NumericsError
from numerics.scene import Scene
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


class Prediction(NamedTuple):
    """What an answer says of a scene, to its digits: its last state, and whether the bodies stick all the way.

    `ends`: values by their names, which count as met within 10^(3 - digits) of `size`; `when` says when that is.
    """

    scene: Scene
    when: str
    ends: dict[str, arb]
    size: arb
    sticks: bool


def solved_again(answer: Any) -> Trajectory | None:
    """Return the scene that an answer claims something of (its `claim`) solved by events in balls, None if none.

    Raises SecondSolveDiffers unless it does what the answer says, to 15 digits where it has more.
    """
    claim: Prediction | None = answer.claim()
    if claim is None:
        return None
    solved = solve(claim.scene, digits=answer.digits, arithmetic="ball")
    if claim.sticks and any(mode.sign for mode in solved.modes):
        raise SecondSolveDiffers("the bodies slip when solved by events, and stick by equations")
    state = dict(zip(("x1", "v1", "x2", "v2"), solved.final_state, strict=True))
    with Ball(answer.digits + 20).context():
        near = claim.size * arb(10) ** (3 - min(answer.digits, _DECIMALS))
        for name, value in claim.ends.items():
            if not abs(state[name] - value) <= near:
                found = f"{state[name].str(12)} when solved by events, {value.str(12)} by equations"
                raise SecondSolveDiffers(f"{name} {claim.when} is {found}")
    return solved
