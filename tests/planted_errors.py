"""Errors planted at the start of a free run: its bounds are then held against the run of the true start."""

import math
from fractions import Fraction
from operator import add
from random import Random
from typing import NamedTuple

import numpy as np

from numerics import Pair, Scene, State
from numerics.free.bounds import Errors, in_floats, with_exit
from numerics.free.engine import begin_in_rows
from numerics.free.frame import Begun
from numerics.free.rows import solve_start
from numerics.linear.record import AT, END_ROW, ROW

MOST = 40
COORDINATES = ("x1", "v1", "x2", "v2")


class Found(NamedTuple):
    """A run: its rows with one number a column, its end, and whether its events are certain."""

    rows: np.ndarray
    end: np.ndarray
    certain: bool

    @property
    def modes(self) -> list[float]:
        return self.rows[:, 0].tolist()

    @property
    def stopped(self) -> bool:
        """Whether the cap on events ended it."""
        return len(self.rows) > MOST


def unit_pair(q: Fraction) -> Pair:
    """A pair with L = Omega = M = 1: its SI units are the reduced ones, but for its energy."""
    return Pair(m1=q, m2=1 - q, a2=1, b=1 - q)


def run(scene: Scene, planted: Scene | None = None) -> Found:
    """Solve a scene by interpreted code; with the distance of the scene `planted` as an error of its start."""
    begun, errors, given = begin_in_rows(scene)
    if planted is not None:
        errors = _with_distance(begun, errors, scene, planted)
    rows, end = [[0.0] * ROW for _ in range(MOST + 1)], [0.0] * END_ROW
    count = solve_start(begun, errors, given, MOST, rows, end)
    return Found(np.array(rows[: count + 1]), np.array(end), end[AT["certain"]] == 1.0)


def _with_distance(begun: Begun, errors: Errors, scene: Scene, other: Scene) -> Errors:
    x1, v1, _, v2 = (abs(float(getattr(scene.initial, name) - getattr(other.initial, name))) for name in COORDINATES)
    slides = abs(float((scene.initial.x1 - scene.initial.x2) - (other.initial.x1 - other.initial.x2)))
    q, w = float(scene.pair.share), abs(float(scene.energy_excess - other.energy_excess))
    distance = math.sqrt(x1**2 + q * v1**2 + (1 - q) * v2**2)
    planted = Errors(0, x1 / q, max(v1, v2) / math.sqrt(q), w, 0, slides, 0, distance, 0)
    at, start = in_floats(begun.at, begun.start)
    return with_exit(at, Errors(*map(add, errors, planted)), start)


def in_units(scene: Scene, mass: Fraction, time: Fraction, length: Fraction) -> Scene:
    """The scene in other units."""
    pair, at, speed, stiff = scene.pair, scene.initial, length / time, mass / time**2
    other = Pair(pair.m1 * mass, pair.m2 * mass, pair.a2 * stiff, pair.b * stiff * length)
    start = State(at.x1 * length, at.v1 * speed, at.x2 * length, at.v2 * speed)
    return Scene(other, start, scene.until * time)


def draw_scene(random: Random) -> Scene:
    """A start of any kind: from off the surface, on it outside and inside S0, on a ray, close to E_cr."""
    share = random.choice([random.uniform(0.02, 0.98), 10 ** random.uniform(-4, -1), 1 - 10 ** random.uniform(-4, -1)])
    pair = unit_pair(Fraction(share).limit_denominator(10**6))

    def number(low: float = -2, high: float = 1) -> Fraction:
        return Fraction(random.choice([-1, 1]) * 10 ** random.uniform(low, high)).limit_denominator(10**12)

    kind, v = random.randrange(6), number()
    x1, v2 = number(), v
    if kind <= 1:
        v2 = number()
    elif kind == 2:
        x1 = number(-2, 0)
    elif kind == 3:
        x1, v = Fraction(random.choice([-1, 1])), number(-3, 0.5)
        v2 = v
    elif kind == 4:  # close to E_cr: X^2 + V^2 = 1 + w
        angle = random.uniform(0, 6.28)
        size = math.sqrt(1 + 10 ** random.uniform(-7, -2))
        x1, v = Fraction(size * math.cos(angle)), Fraction(size * math.sin(angle))
        v2 = v
    return Scene(pair, State(x1, v, number(), v2), Fraction(10 ** random.uniform(-0.5, 1.5)))
