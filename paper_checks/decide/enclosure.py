"""Evidence from balls: a scene solved with a proved event sequence, and what its enclosures prove."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from flint import arb
from sympy import Expr

from numerics.linear.modes import Mode
from numerics.scene import Scene
from numerics.solver.solve import solve
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory
from paper_checks.decide.at_point import at_point
from paper_checks.decide.balls import precision
from paper_checks.evidence.evidence import Evidence, enclosed
from paper_checks.evidence.formula import pointed

DIGITS = 25
SHOWN = 12
"""Digits at which a ball is printed; its radius stands beside them."""


@lru_cache(maxsize=64)
def solved(scene: Scene, digits: int = DIGITS) -> Trajectory:
    """Return the trajectory of a scene in balls, every event and state enclosed to `digits` right digits.

    Raises EventUndecided or PrecisionExhausted: then nothing was proved.
    """
    return solve(scene, digits=digits, arithmetic="ball")


def ball(expression: Expr) -> arb:
    """Return a ball around the value of a real sympy constant."""
    with precision():
        return arb(at_point(expression, {}))


def compare(statement: str, left: arb, relation: str, right: arb) -> Evidence:
    """Check left < right, or left > right, for all points of two balls.

    Passed is True where that is proved, False where the contrary is proved, None where the balls overlap.
    """
    holds, fails = {"<": (left < right, left >= right), ">": (left > right, left <= right)}[relation]
    passed = True if holds else False if fails else None
    return enclosed(statement, passed, f"{text(left)} {relation} {text(right)}")


def itinerary(statement: str, trajectory: Trajectory, modes: Sequence[Mode]) -> Evidence:
    """Check that the proved sequence of modes begins with the given ones."""
    found = trajectory.modes[: len(modes)]
    return enclosed(statement, found == tuple(modes), ", ".join(mode.value for mode in found), len(modes))


def stuck_for_ever(statement: str, trajectory: Trajectory) -> Evidence:
    """Check that from its last event on the pair is proved to stick for ever."""
    return enclosed(statement, trajectory.status is Status.STUCK_FOR_EVER, trajectory.message)


def rounded(value: arb, places: int) -> str:
    """Return the decimal, with that many places, to which every point of a ball rounds.

    Raises ArithmeticError where they differ.

    >>> rounded(arb("4.549769") + arb(0, 1e-7), 4)
    '4.5498'
    """
    whole = (value * 10**places + arb("0.5")).floor().unique_fmpz()
    if whole is None:
        raise ArithmeticError(f"{text(value)} has no unique decimal of {places} places")
    return pointed(int(whole), places)


def text(value: arb, digits: int = SHOWN) -> str:
    """Return a ball with its proved digits, at most so many, and its radius, as plain text."""
    return str(value.str(digits))
