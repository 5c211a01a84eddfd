"""Scenes and answers of numerics/control; both handed to the independent reference, which shares no equation."""

from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from forced_reference import Reference

from numerics import Force, Pair, Piece, Scene, Sine, State, response, solve
from numerics.arithmetic.ball import Ball
from numerics.control.answers import rounded
from numerics.control.attraction import passage_at
from numerics.control.orbit import Orbit
from numerics.control.response import Response

FREE, DAMPED = Pair(1, 1, 200, "0.5"), Pair(1, 1, 200, "0.5", 3)
UNEVEN = Pair(3, "0.5", 200, "0.5", 3)
"""Under 3 N at 12 rad/s it sticks twice a period, under 5 N not at all."""


def under(pair: Pair, amplitude: object, omega: object = 12, **more: object) -> Scene:
    """The pair at rest under one sine."""
    return Scene(pair, State(), until=1, force=Force.sine(amplitude, omega), **more)


@cache
def answer(pair: Pair, amplitude: str, omega: int = 12) -> Response:
    """The response to one sine."""
    return response(under(pair, amplitude, omega))


def referred(scene: Scene, digits: int = 36) -> Reference:
    """The scene solved by the independent reference."""
    return Reference(scene, digits).run()


def middle(orbit: Orbit, number: int = 0) -> Fraction:
    """A time in the middle of a leg of a periodic motion."""
    return rounded((orbit.legs[number].start + orbit.legs[number].end) / 2)


def started(orbit: Orbit, begin: Fraction) -> list[Fraction]:
    """(x1, v1, v2) of a periodic motion at a time."""
    with Ball(50).context():
        x1, v1, _, v2 = passage_at(orbit, Ball.number(begin)).state(Ball.number(begin))
        return [rounded(one) for one in (x1, v1, v1 if v1.overlaps(v2) else v2)]


def one_period(orbit: Orbit) -> Scene:
    """One period of a periodic motion from the middle of its first leg."""
    begin = middle(orbit)
    x1, v1, v2 = started(orbit, begin)
    piece = orbit.drive.piece
    sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in piece.sines]
    with Ball(50).context():
        period = rounded(orbit.drive.period)
    return Scene(
        orbit.drive.pair, State(x1, v1, 0, v2), until=period, force=Force((Piece(0, piece.polynomial, sines),))
    )


def moved(orbit: Orbit, by: object) -> Orbit:
    """The orbit with x1 off by so much at the start of every leg."""
    legs = (one._replace(state=(one.state[0] + by, *one.state[1:])) for one in orbit.legs)
    return Orbit(orbit.drive, tuple(legs))


def outside(found: Any, until: float, points: int = 4_001) -> np.ndarray:
    """The times of a run at which the distance from the ring's centre is above its radius."""
    t = np.linspace(0, until * (1 - 1e-12), points)
    y = solve(replace(found.scene, until=until)).sol(t)
    distance = np.hypot(y[0] - y[2] - float(found.centre), (y[1] - y[3]) / float(found.rate))
    return t[distance > float(found.radius) * (1 + 1e-9)]
