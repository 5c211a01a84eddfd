"""Runs of the engine's kernel whose start is off by planted errors, and seeded scenes for them with M = a2 = L = 1."""

import math
from dataclasses import replace
from fractions import Fraction
from functools import partial
from operator import add
from random import Random
from typing import NamedTuple

import draws
import numpy as np

from numerics import Law, State, Trajectory
from numerics.arithmetic.compiled import compiled
from numerics.arithmetic.float64 import Float64
from numerics.linear.engine import _exact_rows, _run
from numerics.linear.exact_start import exact_knots
from numerics.linear.kernel import begin
from numerics.linear.prepare import Prepared, prepare
from numerics.linear.record import AT, ROW, How, Record, finish
from numerics.linear.room import enter, form_z, run_of, space_for
from numerics.trajectory.events import taken_in

BOUNDS = [AT[name] for name in ("late", "x1_error", "v1_error", "x2_error", "v2_error")]
STATE = [AT[name] for name in ("x1", "v1", "x2", "v2")]
NOTHING = (0, 0, 0, 0)


class Run(NamedTuple):
    """How a run ended, the starts of its segments, the row of the end; in the kernel's units."""

    how: int
    rows: np.ndarray
    end: np.ndarray
    prepared: Prepared

    @property
    def events(self):
        return self.rows[self.rows[:, AT["event"]] == 1]

    @property
    def modes(self):
        """The modes in order, or None in doubt."""
        return None if self.how > 2 else (*self.rows[:1, 0], *self.events[:, 0])

    @property
    def times(self):
        """The times of the events, in the kernel's unit."""
        starts = [math.ldexp(float(one.start), -self.prepared.units.time) for one in self.prepared.pieces]
        return np.array([starts[int(row[AT["piece"]])] + row[AT["local"]] for row in self.events])


def run(scene, by=NOTHING, most=60):
    """A run that is told that x1, v1, x2 and v2 may be off by so much at the start."""
    prepared = prepare(scene)
    starts = prepared.starts.copy()
    start = starts[0]
    if prepared.cells is not None:
        start[:ROW] = _exact_rows(prepared, exact_knots(scene, prepared.pieces)[:1])[0]
        start[AT["jump"]] = start[BOUNDS[1:]] = 0.0
    for k, exponent in enumerate([prepared.units.of(length=1), prepared.units.of(length=1, time=-1)] * 2):
        start[BOUNDS[1 + k]] = math.ldexp(abs(float(by[k])), -exponent)
    how, rows, end = _run(prepared, starts, -1.0, most)
    if how < 3:
        record = Record(rows.copy(), end.copy(), How(how), int(end[AT["events"]]))
        compiled(finish)(record.rows[None], record.end[None], prepared.to_si)
        taken = taken_in(Trajectory(scene, Float64(), record), range(len(rows) - (how == 2)))
        end[AT["friction"] :] = np.ldexp(taken, prepared.units.of(-1, 2, -2))
    return Run(how, rows, end, prepared)


def moved(scene, by):
    """A scene whose start is elsewhere."""
    at = scene.initial
    return replace(scene, initial=State(*map(add, (at.x1, at.v1, at.x2, at.v2), by)))


def exact(x, digits=6):
    return Fraction(round(float(x) * 10**digits), 10**digits)


def a_scene(random, drawn=draws.driven):
    """A pair with M = a2 = L = 1 from anywhere, damped or not, under forces and friction by pieces, both laws."""
    source = Random(int(random.integers(2**63)))
    light = draws.decimal(source, -4, -1)
    m1 = source.choice((light, light, 1 - light))
    scene = drawn(source, m1=m1, m2=1 - m1, a2=Fraction(1), b=1 - m1, damping=(-2, 0))
    x1, v1, x2, v2 = (exact(random.normal() * random.choice([0.1, 1, 3])) for _ in range(4))
    law = Law.THREE_VALUED_SGN if drawn is draws.driven and random.random() < 0.15 else Law.FILIPPOV
    return scene.replace(initial=State(x1, v1, x2, random.choice([v1, v2, v2, v2])), law=law)


a_weakened_scene = partial(a_scene, drawn=draws.weakened)
"""The same with friction that falls and rises with speed, and with the place."""


def errors(random, scene):
    """Errors of 1e-9 to 1e-3, of all numbers of the start or of one."""
    size = 10 ** random.uniform(-9, -3)
    kinds = random.choice([-1, 1], 4), random.uniform(-1, 1, 4), np.eye(4)[random.integers(0, 4)]
    return in_stick(scene, size * kinds[random.integers(0, 3)])


def in_stick(scene, by):
    """Differences of a start, which sticks where the scene's does."""
    x1, v1, x2, v2 = (exact(one, 15) for one in by)
    return x1, v1, x2, v1 if scene.initial.v1 == scene.initial.v2 else v2


def begun(scene, mode=0, by=NOTHING):
    """A run in which its start stands with z, and where it is, in a mode of its first piece."""
    prepared = prepare(scene)
    start, run = prepared.starts[0].copy(), run_of(prepared.problems, 0, space_for(prepared.problems.tables))
    start[AT["mode"]], start[AT["jump"]], start[BOUNDS[1:]] = mode, 0, by
    now, _ = begin(run, start)
    form_z(run, 0)
    enter(run, 0, mode)
    return run, now
