"""Scenes and answers of numerics/control; both handed to the independent reference, which shares no code with it."""

import tomllib
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from forced_reference import Reference

from numerics.arithmetic.ball import Ball
from numerics.control.answers import rounded
from numerics.control.orbit import Orbit
from numerics.scene import Force, Pair, Piece, Scene, Sine, State
from numerics.scene.writing import scene_text
from numerics.solver.solve import solve

FREE, DAMPED = Pair(1, 1, 200, "0.5"), Pair(1, 1, 200, "0.5", 3)


def under(pair: Pair, amplitude: object, omega: object = 12, **more: object) -> Scene:
    """The pair at rest under one sine."""
    return Scene(pair, State(), until=1, force=Force.sine(amplitude, omega), **more)


def referred(scene: Scene, digits: int = 36) -> Reference:
    """The scene solved by the independent reference, through its text."""
    tables = tomllib.loads(scene_text(scene), parse_float=str)
    return Reference(tables, digits=digits).run()


def one_period(orbit: Orbit, moved: tuple[Fraction, Fraction, Fraction] = (Fraction(0),) * 3) -> Scene:
    """One period of a periodic motion from the middle of its first leg, its start moved by (x1, v1, v2)."""
    leg, after = orbit.turns[0]
    begin = rounded((leg.t + after.t) / 2)
    with Ball(50).context():
        x1, v1, _, v2 = (rounded(one) for one in orbit.motion(leg).state(Ball.number(begin) - leg.t))
        period = rounded(orbit.drive.period)
    if leg.side == 0:
        v2 = v1
    piece = orbit.drive.piece
    sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in piece.sines]
    start = State(x1=x1 + moved[0], v1=v1 + moved[1], v2=v2 + moved[2])
    force = Force((Piece(0, piece.polynomial, sines),))
    return Scene(orbit.drive.pair, start, until=period, force=force)


def outside(found: Any, until: float, points: int = 4_001) -> np.ndarray:
    """The times of a run at which the distance from the ring's centre is above its radius."""
    t = np.linspace(0, until * (1 - 1e-12), points)
    y = solve(replace(found.scene, until=until)).sol(t)
    distance = np.hypot(y[0] - y[2] - float(found.centre), (y[1] - y[3]) / float(found.rate))
    return t[distance > float(found.radius) * (1 + 1e-9)]
