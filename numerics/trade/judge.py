"""How right a run is, held against a proved one; every error in balls, so that 1e-1000 is a number.

Event by event its modes must be the true ones. Where they are, the error is the largest one of event times, relative to
the last true event's time, and of states at the events and at the horizon, positions relative to the largest |x1|, |x2|
along the run, velocities likewise. The radius of the proved run is part of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import zip_longest
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.errors import NumericsError
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_ball

MAX_EVENTS = 250_000
_SPARE_DIGITS = 30
NO_ERROR = 10**6
"""Stands for the digits of what is exact."""


class Outcome(NamedTuple):
    """What one run of anybody says of a scene, in its own numbers: modes, times of events (s), states in SI units."""

    modes: Sequence[Any]
    """One more than there are events; a mode is equal to its word."""
    times: Any
    states: Any
    """At the start, at the events and at the horizon: x1, v1, x2, v2, each by axes on a surface."""


Call = Callable[[], Outcome]
"""Solves a scene and says what it found: what is timed."""


class Judgement(NamedTuple):
    """How many events are right from the start on, -log10 of the largest error, and what is wrong, if something is."""

    events: int
    digits: float | None
    note: str


def looked_at(trajectory: Any) -> Outcome:
    """Return what a trajectory of ours says: a user looks at its t, y and modes, which are made when they are read."""
    times, states = trajectory.event_times, trajectory.y.T
    if len(times) + 2 != len(states):
        raise NumericsError(trajectory.message)
    return Outcome(trajectory.modes, times, states)


def proved(scene: Any, digits: int = 0) -> Outcome:
    """Return the reference of a scene in balls, for methods of so many digits."""
    return looked_at(solve(scene, arithmetic="ball", digits=digits + _SPARE_DIGITS, max_events=MAX_EVENTS))


def judge(run: Outcome, truth: Outcome, digits: int = 0) -> Judgement:
    """Hold a run against the `proved` reference of as many digits."""
    pairs = [*zip_longest(run.modes, truth.modes)]
    right = next((k for k, (said, true) in enumerate(pairs) if said != true), len(pairs))
    with Ball(digits + 2 * _SPARE_DIGITS).context():
        if right < len(pairs):
            event = max(1, right)
            said, true = (_change(one, event) for one in (run, truth))
            return Judgement(event - 1, None, f"event {event}: {said}; in truth {true}")
        every = np.reshape(np.array([*truth.states], dtype=object), (right + 1, 4, -1))
        errors = [abs(_ball(one) - true) / truth.times[-1] for one, true in zip(run.times, truth.times, strict=True)]
        states = np.reshape(np.array([*run.states], dtype=object), every.shape)
        for rows in (slice(0, None, 2), slice(1, None, 2)):
            size = max(abs(one.mid()) for one in every[:, rows].flat)
            off = (abs(_ball(x) - y) for x, y in zip(states[1:, rows].flat, every[1:, rows].flat, strict=True))
            errors += [one / size if size > 0 else one for one in off]
        if not all(one.is_finite() for one in errors):
            return Judgement(right - 1, None, "not every number is finite")
        # by the logarithm of a ball: it may be below the range of a float
        worst = max(one.upper() for one in errors) + arb(10) ** -NO_ERROR
        return Judgement(right - 1, math.floor(float(worst.log().mid()) / -math.log(10) * 100) / 100, "")


def _change(run: Outcome, event: int) -> str:
    """Return in words what happens at an event, counted from 1, or that there is none."""
    if event >= len(run.modes):
        return f"{run.modes[-1]} to the end"
    return f"{run.modes[event - 1]} to {run.modes[event]} at {float(run.times[event - 1]):.6g} s"


def _ball(value: Any) -> arb:
    """Return a number of any arithmetic exactly, an enclosure as it is."""
    return as_ball(value) if isinstance(value, arb) or math.isfinite(value) else arb("nan")
