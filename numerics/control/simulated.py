"""Guesses of a periodic motion from a run in float64 that has settled: its events in the last period."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.float64 import Float64
from numerics.control.orbit import Drive, Leg, Orbit
from numerics.control.rounding import rounded
from numerics.errors import EventUndecided, OutOfRange
from numerics.run.one import run_scene
from numerics.scene import Force, Pair, Scene, State

_PERIODS, _MAX_EVENTS = (16, 128, 1024), 10_000


def simulated_guesses(drive: Drive) -> Iterator[Orbit]:
    """Yield what the pair does in the last of so many periods from rest, not proved."""
    for count in _PERIODS:
        until = rounded(drive.period * count, 12)
        scene = Scene(drive.pair, _start(drive), until, force=Force((drive.piece,)))
        try:
            found = run_scene(scene, Float64(), _MAX_EVENTS)
        except (EventUndecided, OutOfRange):
            return
        if not found.reached:
            return
        guess = _last_period(drive, found, until)
        if guess is not None:
            yield guess


def _start(drive: Drive) -> State:
    """Return a start that slips at once, so that a pair that would stay stuck elsewhere does not hide the orbit."""
    pair: Pair = drive.pair
    return State(x1=2 * pair.half_width, v1=0)


def _last_period(drive: Drive, found: Any, until: Fraction) -> Orbit | None:
    """Return the legs of the last period, from one event to the same a period later."""
    period = float(drive.period)
    late = [event for event in found.events if event.t > float(until) - 1.05 * period]
    if not late:
        return None
    first = late[0]
    legs = [
        Leg(event.after.sign, arb(event.t), arb(event.y[0]), arb(event.y[1]))
        for event in late
        if event.t < first.t + period * (1 - 1e-6)
    ]
    return Orbit(drive, tuple(legs)) if legs else None
