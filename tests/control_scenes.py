"""Scenes and answers of numerics/control; both handed to the inclusion, which shares no equation with them."""

from dataclasses import replace
from fractions import Fraction
from functools import cache
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from flint import arb
from inclusion import motion, solved

from numerics import Force, Pair, Scene, State, response, solve
from numerics.arithmetic.ball import Ball
from numerics.control.answers import rounded
from numerics.control.orbit import Orbit, state_at, without_x2
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


class Followed(NamedTuple):
    """Events, each with its time and the sign of the mode after it, and mode and state at the end."""

    events: list[Any]
    mode: int
    x1: arb
    v1: arb
    x2: arb
    v2: arb

    def state(self) -> tuple[arb, ...]:
        return self[2:]


def referred(scene: Scene, digits: int = 60) -> Followed:
    """The motion of a scene, in balls, found by the inclusion to be one, but for polynomials of high degree: slow."""
    is_quick = all(len(piece.polynomial) < 9 for piece in scene.force.pieces)
    run = (motion if is_quick else solved)(scene, digits=digits)
    events = [SimpleNamespace(t=t, after=sign) for t, sign in zip(run.event_times, run.signs[1:], strict=True)]
    return Followed(events, run.signs[-1], *run.final_state)


def arrived(found: Any, distance: str, digits: int = 36) -> Followed:
    """The scene of a transfer from x2 = 0.25 m solved by the reference, which has it at rest at its goal."""
    run = referred(found.scene, digits)
    with Ball(36).context():
        assert abs(run.x2 - Ball.number(Fraction("0.25") + Fraction(distance))) < 1e-19
        assert abs(run.v1) + abs(run.v2) < 1e-18
    return run


def started(orbit: Orbit, begin: Fraction) -> list[Fraction]:
    """(x1, v1, v2) of a periodic motion at a time."""
    with Ball(50).context():
        t = Ball.number(begin)
        x1, v1, v2 = without_x2(state_at(orbit.passage_at(t), t))
        return [rounded(one) for one in (x1, v1, v1 if v1.overlaps(v2) else v2)]


def outside(found: Any, until: float) -> np.ndarray:
    """The times of a run at which the distance from the ring's centre is above its radius."""
    t = np.linspace(0, until * (1 - 1e-12), 4_001)
    y = solve(replace(found.scene, until=until)).sol(t)
    distance = np.hypot(y[0] - y[2] - float(found.centre), (y[1] - y[3]) / float(found.rate))
    return t[distance > float(found.radius) * (1 + 1e-9)]
