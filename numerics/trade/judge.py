"""How right a run is, held against a proved one; every error in balls, so that 1e-1000 is a number.

- An event of a run is found if its change of mode is that of the true event next to it, within half the gap between
  that event and its nearer neighbour; the start is a neighbour, the horizon is none. True events that nothing found are
  missed, events of the run that found nothing are extra.
- The error of the times is the largest one of an event that was found, relative to the last true event's time.
- The error of the states is the largest one at the events that were found and at the horizon, of positions relative to
  the largest |x1|, |x2| along the run, of velocities likewise.

Both are upper bounds, as the radius of the proved run is part of them; where an event is wrong they count for nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.errors import NumericsError
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_ball
from numerics.trajectory.export import word

MAX_EVENTS = 250_000
_SPARE_DIGITS = 30


class Run(NamedTuple):
    """What one run of anybody says of a scene, in its own numbers: modes, times of events (s), states in SI units."""

    modes: Sequence[str]
    """One more than there are events."""
    times: Any
    states: Any
    """At the start, at the events and at the horizon: x1, v1, x2, v2, each by axes on a surface."""


Call = Callable[[], Run]
"""Solves a scene and says what it found: what is timed."""


class Judgement(NamedTuple):
    """How many events are found, missed and extra; and the digits (-log10) of the errors of times and of states."""

    found: int
    missed: int
    extra: int
    time_digits: float | None
    """None where no event was found."""
    state_digits: float | None
    """None where the run gives no number."""
    note: str
    """The first event that is wrong; empty where all are right."""


def looked_at(trajectory: Any) -> Run:
    """Return what a trajectory of ours says: a user looks at its t, y and modes, which are made when they are read."""
    times, states = trajectory.event_times, trajectory.y.T
    if len(times) + 2 != len(states):
        raise NumericsError(trajectory.message)
    return Run([*map(word, trajectory.modes)], times, states)


def proved(scene: Any, digits: int = 0) -> Run:
    """Return the reference of a scene in balls, for methods of so many digits."""
    return looked_at(solve(scene, arithmetic="ball", digits=digits + _SPARE_DIGITS, max_events=MAX_EVENTS))


def judge(run: Run, truth: Run, digits: int = 0) -> Judgement:
    """Hold a run against the `proved` reference of as many digits."""
    with Ball(digits + 2 * _SPARE_DIGITS).context():
        run, truth = (Run(one.modes, [*map(as_arb, one.times)], one.states) for one in (run, truth))
        pairs = list(matched(run, truth))
        states = [*((j + 1, k + 1) for j, k in pairs), (-1, -1)]
        late = [abs(run.times[j] - truth.times[k]) / truth.times[-1] for j, k in pairs]
        off = _errors([run.states[j] for j, _ in states], [truth.states[k] for _, k in states], truth.states)
        found, missed, extra = len(pairs), len(truth.times) - len(pairs), len(run.times) - len(pairs)
        return Judgement(found, missed, extra, _digits(late), _digits(off), first_difference(run, truth, pairs))


def matched(run: Run, truth: Run) -> Iterator[tuple[int, int]]:
    """Yield which event of a run is which true event: indices of both."""
    times = [arb(0), *(one.mid() for one in truth.times), arb("inf")]
    k, last = 1, len(truth.times)
    for j, t in enumerate(run.times):
        while k < last and t.mid() > (times[k] + times[k + 1]) / 2:
            k += 1
        if k > last:
            return
        gap = (times[k] - times[k - 1]).min(times[k + 1] - times[k])
        if abs(t.mid() - times[k]) <= gap / 2 and run.modes[j : j + 2] == truth.modes[k - 1 : k + 1]:
            yield j, k - 1
            k += 1


def first_difference(run: Run, truth: Run, pairs: list[tuple[int, int]]) -> str:
    """Return in words the first event that is not found, or that is none; empty if there is none."""
    right = 0
    while pairs[right : right + 1] == [(right, right)]:
        right += 1
    if right == len(run.times) == len(truth.times) and run.modes[0] == truth.modes[0]:
        return ""
    said, true = (
        f"{' to '.join(one.modes[right : right + 2])} at {float(one.times[right].mid()):.6g} s"
        if right < len(one.times)
        else f"{one.modes[-1]} to the end"
        for one in (run, truth)
    )
    return f"event {right + 1}: {said}; in truth {true}"


def _errors(run: Any, truth: Any, along: Any) -> list[arb]:
    """Return the errors of states (n, 4), relative to the largest position and velocity along the true run."""
    numbers, true, every = (np.reshape(np.array(one, dtype=object), (len(one), 4, -1)) for one in (run, truth, along))
    errors = list[arb]()
    for rows in (slice(0, None, 2), slice(1, None, 2)):
        size = max((abs(one.mid()) for one in every[:, rows].flat), default=arb(0))
        off = [abs(as_arb(x) - y) for x, y in zip(numbers[:, rows].flat, true[:, rows].flat, strict=True)]
        errors += [one / size if size > 0 else one for one in off]
    return errors


def _digits(errors: list[arb]) -> float | None:
    """Return -log10 of the largest error, by the logarithm of a ball: it may be below the range of a float."""
    if not errors or not all(one.is_finite() for one in errors):
        return None
    worst = max(one.upper() for one in errors) + arb(10) ** -(10**6)
    return math.floor(float(worst.log().mid()) / -math.log(10) * 100) / 100


def as_arb(value: Any) -> arb:
    """Return a number of any arithmetic exactly, an enclosure as it is."""
    return as_ball(value) if isinstance(value, arb) or math.isfinite(value) else arb("nan")
