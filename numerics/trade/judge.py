"""How right a run is, held against a proved reference; every error in balls, so that 1e-1000 is a number.

- The itinerary is right if it has the reference's modes in the reference's order, and each event's time lies within
  half the gap between the reference's event and its nearer neighbour; the start at t = 0 is a neighbour, the horizon is
  none.
- The state's error is the largest of |x_i - true|/L and |v_i - true|/(L Omega) at the horizon, with L = b M/(a2 m2) and
  Omega = sqrt(a2/M); that of the times the largest one of an event, relative to the time of the last; that of the
  dissipated energy is relative to the true one. On a surface L and Omega are those of each axis, and nobody counts the
  energy.

All are upper bounds: the radius of the reference is part of the error.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.linear.modes import MODES
from numerics.solver.solve import solve
from numerics.trade.comparisons.switched import PeerRun
from numerics.trade.contenders import MAX_EVENTS, answer_of
from numerics.trajectory.comparison import as_ball


def working_digits(digits: int) -> int:
    """Return with how many digits a run of so many is judged."""
    return max(40, digits + 30) + 20


def proved(scene: Any, digits: int = 0) -> PeerRun:
    """Return the reference of a scene in balls, for methods of so many digits."""
    found = solve(scene, arithmetic="ball", digits=working_digits(digits) - 20, max_events=MAX_EVENTS)
    return answer_of(found)


class Judgement(NamedTuple):
    """The first difference of the itinerary, None if it is right, and the digits (-log10) of the worst error."""

    difference: str | None
    digits: float | None
    """None where the run gives no number."""


def judge(found: PeerRun, truth: PeerRun, scene: Any, digits: int = 0) -> Judgement:
    """Hold a run against the `proved` reference of as many digits."""
    difference = first_difference(found, truth)
    with Ball(working_digits(digits)).context():
        parts = list(zip(found.final, truth.final, scales(scene.pair), strict=True))
        if difference is None:
            parts += [(one, true, truth.times[-1]) for one, true in zip(found.times, truth.times, strict=False)]
        if found.lost is not None and as_arb(truth.lost) > 0:
            parts.append((found.lost, truth.lost, truth.lost))
        worst = arb(0)
        for one, true, scale in parts:
            worst = worst.max((abs(as_arb(one) - as_arb(true)).upper() / as_arb(scale)).upper())
        if not worst.is_finite():
            return Judgement(difference, None)
        # through the logarithm of a ball, since the error may be far below the range of a float
        return Judgement(difference, float((worst + arb(10) ** -(10**6)).log().mid()) / -math.log(10))


def scales(pair: Any) -> list[arb]:
    """Return L, L Omega, L, L Omega, each by axes."""
    m1, m2, b = (np.atleast_1d(np.array(one, dtype=object)) for one in (pair.m1, pair.m2, pair.b))
    a2 = np.diag(np.atleast_2d(np.array(pair.a2, dtype=object)))
    lengths = [*map(Ball.number, b * (m1 + m2) / (a2 * m2))]
    speeds = [x * Ball.number(square).sqrt() for x, square in zip(lengths, a2 / (m1 + m2), strict=True)]
    return [*lengths, *speeds] * 2


def as_arb(value: Any) -> arb:
    """Return a number of any arithmetic exactly, an enclosure as it is."""
    return as_ball(value) if isinstance(value, arb) or math.isfinite(value) else arb("nan")


def first_difference(found: PeerRun, truth: PeerRun) -> str | None:
    """Return in words where the itinerary first departs from the reference's, None if it does not."""
    # the modes first: from an exchanged one on, times are compared with another event's
    for number, (one, other) in enumerate(zip(found.modes, truth.modes, strict=False)):
        if one != other:
            is_one, is_other = (MODES[mode].value if mode in MODES else mode for mode in (one, other))
            return f"segment {number + 1} is {is_one}, not {is_other}"
    if len(found.times) != len(truth.times):
        return f"{len(found.times)} events, not {len(truth.times)}"
    times = [0.0, *(float(as_arb(one).mid()) for one in truth.times), math.inf]
    for before, true, after, at in zip(times, times[1:], times[2:], found.times, strict=False):
        gap, off = min(true - before, after - true), abs(float(as_arb(at).mid()) - true)
        if not off <= gap / 2:
            return f"the event at {true:.6g} s is off by {off:.1e} s, its neighbour is {gap:.1e} s away"
    return None
