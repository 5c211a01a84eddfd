"""What each number of a run is really off by, and the first event that differs: the scene solved again, in balls."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from flint import arb

from numerics.scene.model import require_kind
from numerics.solver.truth import in_balls
from numerics.trajectory.checked import Check, Off
from numerics.trajectory.columns import STATE
from numerics.trajectory.comparison import as_ball, first_difference
from numerics.trajectory.export import END_NAMES
from numerics.trajectory.trajectory import Trajectory
from numerics.trajectory.units import unit

_SPARE_DIGITS = 15
"""How many digits the balls have more than the run."""
_SMALLEST = 5e-324
"""The least float above 0."""


def check(run: Trajectory) -> Check:
    """Solve the scene of a run again in balls, and return what each of its numbers is really off by.

    Raises EventUndecided or PrecisionExhausted where balls do not decide the scene either.

    >>> from numerics import check, load_scene, solve
    >>> found = check(solve(load_scene("velocities")))
    >>> found.right, found.difference, found.off[0].quantity, found.off[0].error < found.off[0].bound < 1e-9
    (True, None, 't', True)
    """
    require_kind("check", run, Trajectory, "give it what `solve` returns for a scene on a line")
    digits = run.arithmetic.digits + _SPARE_DIGITS
    truth = in_balls(run, digits)
    difference = first_difference(run, truth)
    with truth.context():
        compared, true = (
            [one for one in _numbers(of) if difference is None or (one.event or math.inf) < difference.event]
            for of in (run, truth)
        )
        pairs = zip(compared, true, strict=True)
        off = sorted((_off(one, other.value) for one, other in pairs), key=lambda one: (one.within, -one.error))
    worst = {one.quantity: one for one in reversed(off)}
    order = dict.fromkeys(one.quantity for one in compared)
    return Check(run.arithmetic.name, digits, len(run.events), difference, tuple(worst[name] for name in order))


class _Number(NamedTuple):
    """A number that a run states, and its bound, if it has one."""

    quantity: str
    event: int | None
    value: Any
    bound: Any


def _numbers(run: Trajectory) -> Iterator[_Number]:
    """Yield every number of a run: times and states of the events, then the end; in the context of a run in balls."""
    known = run.accuracy if run.bounded and run.certain else None
    for k, row in enumerate(zip(run.event_times, *run.event_states, strict=True)):
        bounds = [None] * 5 if known is None else [known.t[k], *known.y[k]]
        yield from (_Number(name, k + 1, *pair) for name, *pair in zip(("t", *STATE), row, bounds, strict=True))
    bounds = [None] * 7 if known is None else [*run.end_bounds()[1:], known.dissipated]
    found, names = run.end_numbers(), (*END_NAMES, "dissipated")
    end = [*found, *[None] * (len(END_NAMES) - len(found)), run.dissipated]  # without E_cr there is no excess
    told = zip(names, end, bounds, strict=True)
    yield from (_Number(name, None, value, bound) for name, value, bound in told if value is not None)
    ledger = run.ledger
    for name in ("friction", "viscous", "work", "residual"):
        yield _Number(name, None, getattr(ledger, name), None)


def _off(one: _Number, true: arb) -> Off:
    """Return what a number is off by."""
    bound = one.value.rad() if isinstance(one.value, arb) else None if one.bound is None else arb(float(one.bound))
    error = abs(as_ball(one.value).mid() - true)
    within = bound is None or not error > bound
    said = None if bound is None else _above(bound)
    return Off(one.quantity, unit(one.quantity) or "1", one.event, _above(error), said, within)


def _above(x: arb) -> float:
    """Return a float that is not below what a ball holds, also where floats end."""
    return max(float(x.upper()), 0.0 if x.is_zero() else _SMALLEST)
