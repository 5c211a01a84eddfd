"""What each number of a run is really off by, and the first event that differs: the scene solved again, in balls."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

from flint import arb

from numerics.scene.model import require_kind
from numerics.trajectory.comparison import Check, Off, as_ball, first_difference
from numerics.trajectory.export import AT_END, END_NAMES, bounds_at, in_balls, numbers_at
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
    worst: dict[str, Off] = {}
    with truth.context():
        places = [*range(len(run.events)), AT_END] if difference is None else range(difference.event - 1)
        for index in places:
            for name, value, bound, true in _numbers(run, truth, index):
                off = _off(name, None if index == AT_END else index + 1, value, bound, true)
                if name not in worst or (off.within, -off.error) < (worst[name].within, -worst[name].error):
                    worst[name] = off
    return Check(run.arithmetic.name, digits, len(run.events), difference, tuple(worst.values()))


def _numbers(run: Trajectory, truth: Trajectory, index: int) -> Iterator[tuple[str, Any, Any, arb]]:
    """Yield name, number, bound if it has one, and true number, of an event or of the end."""
    values, true = (numbers_at(one, index) for one in (run, truth))
    known: Any = run.accuracy if run.bounded and run.certain else None
    bounds = [None] * len(values) if known is None else bounds_at(run, index)
    found = zip(("t", *END_NAMES), values, bounds, true, strict=False)
    yield from found if index != AT_END else islice(found, 1, None)  # the end is at a given time
    if index == AT_END:
        yield "dissipated", run.dissipated, None if known is None else known.dissipated, truth.dissipated
        for name in ("friction", "viscous", "work", "residual"):
            yield name, getattr(run.ledger, name), None, getattr(truth.ledger, name)


def _off(name: str, event: int | None, value: Any, bound: Any, true: arb) -> Off:
    """Return what a number is off by."""
    bound = value.rad() if isinstance(value, arb) else None if bound is None else arb(float(bound))
    error = abs(as_ball(value).mid() - true)
    within = bound is None or not error > bound
    return Off(name, unit(name) or "1", event, _above(error), None if bound is None else _above(bound), within)


def _above(x: arb) -> float:
    """Return a float that is not below what a ball holds, also where floats end."""
    return max(float(x.upper()), 0.0 if x.is_zero() else _SMALLEST)
