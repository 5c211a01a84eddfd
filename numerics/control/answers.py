"""How an answer is given: to the digits asked for, in decimals that a scene holds, and solved once more by events."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple, Protocol, TypeVar

from flint import arb

from numerics.arithmetic.ball import Ball, digits_within, working_digits
from numerics.errors import EventUndecided, NumericsError, PrecisionExhausted
from numerics.scene import Scene
from numerics.solver.solve import solve
from numerics.trajectory.trajectory import Trajectory

MAX_DIGITS = 2_000
"""Cap on the working digits of what takes milliseconds."""
_MOST_TIMES = 16
_SPARE_DIGITS = 12
KEPT_DIGITS, TIME_DIGITS = 40, 20
"""Significant digits of a number that a scene cannot hold exactly, and of a time that a plan may choose."""

Answer = TypeVar("Answer")
number = Ball.number
"""An exact rational as a ball, in the arithmetic's context."""
Tell = Callable[[str], None]
"""It hears what is being done, for who waits."""


def undecided(question: str, found: arb | str) -> EventUndecided:
    """Return what says that a number leaves a question open at the present precision."""
    return EventUndecided(question, found if isinstance(found, str) else found.str(6), working_digits())


def not_negative(x: arb, question: str) -> bool:
    """Return whether a number is >= 0. Raises EventUndecided."""
    if x >= 0 or x < 0:
        return bool(x >= 0)
    raise undecided(question, x)


def silent(_: str) -> None:
    """Hear nothing."""


def most_digits(digits: int, max_digits: int | None) -> int:
    """Return the cap on the working digits of what takes seconds: as given, else 16 times as many as are asked for."""
    return max_digits or _MOST_TIMES * (digits + _SPARE_DIGITS)


def to_digits(
    attempt: Callable[[Ball], tuple[Answer, Iterable[arb]]], digits: int, max_digits: int | None = None
) -> Answer:
    """Return the answer of the first attempt whose balls have `digits` right digits each.

    An attempt runs in the context of the arithmetic that it is given. A ball that may be 0 counts as right below
    10^(-4 digits); one that is not finite is never right. The cap is MAX_DIGITS unless another is given. Raises what
    the last attempt raised (EventUndecided), PrecisionExhausted.
    """
    working, most = digits + _SPARE_DIGITS, max_digits or MAX_DIGITS
    failure: EventUndecided | None = None
    while working <= most:
        arithmetic, failure, reached = Ball(working), None, 0
        try:
            with arithmetic.context():
                answer, balls = attempt(arithmetic)
                reached = min((_right_digits(one) for one in balls), default=digits)
        except EventUndecided as error:
            failure = error
        else:
            if reached >= digits:
                return answer
        working = working + digits - reached + _SPARE_DIGITS if reached > 0 else 2 * working
    if failure is not None:
        raise failure
    raise PrecisionExhausted(f"{digits} right digits need more than {most} working digits; raise max_digits")


def _right_digits(one: arb) -> int:
    """Return how many digits of a ball are right; none of an infinity, whose radius is 0, or of a nan."""
    return digits_within(one.rad(), one, arb(1)) if one.is_finite() else 0


def rounded(x: arb, digits: int = KEPT_DIGITS) -> Fraction:
    """Return the decimal of so many significant digits next to the midpoint of a ball."""
    return Fraction(Decimal(x.mid().str(digits, radius=False)))


def rounded_up(x: arb, digits: int = KEPT_DIGITS) -> Fraction:
    """Return a decimal of so many digits that no point of a positive ball exceeds."""
    near = Decimal(x.upper().str(digits, radius=False))
    return Fraction(near) + Fraction(2) * Fraction(10) ** (near.adjusted() + 1 - digits)


class SecondSolveDiffers(NumericsError):
    """The same scene solved by events does not do what an answer says of it: one of the two is wrong."""


class Claim(NamedTuple):
    """What an answer says of a scene, solved to so many digits: its last state, and the signs of w on the way there.

    `ends`: values by their names, and how far off they may be; `when` says when that is. `sides` is None where rounded
    decimals may add slips too short to matter.
    """

    scene: Scene
    when: str
    ends: dict[str, tuple[arb, arb]]
    sides: tuple[int, ...] | None
    digits: int


class Claiming(Protocol):
    """An answer of this room."""

    def claim(self) -> Claim | None:
        """Return what it says of a scene, None if it gives none."""


def solved_again(answer: Claiming) -> Trajectory | None:
    """Return the scene of an answer solved by events in balls, None if it has none.

    Raises SecondSolveDiffers unless it does what the answer says.
    """
    claim = answer.claim()
    if claim is None:
        return None
    solved = solve(claim.scene, digits=claim.digits, arithmetic="ball")
    sides = tuple(mode.sign for mode in solved.modes)
    if claim.sides not in {None, sides}:
        raise SecondSolveDiffers(f"the signs of v1 - v2 are {sides} when solved by events, {claim.sides} by equations")
    with Ball(claim.digits + 20).context():
        state = dict(zip(("x1", "v1", "x2", "v2"), solved.final_state, strict=True))
        for name, (value, within) in claim.ends.items():
            found = state[name]
            if not abs(found - value) <= within:
                raise SecondSolveDiffers(
                    f"{name} {claim.when} is {found.str(12)} when solved by events, {value.str(12)} by equations"
                )
    return solved
