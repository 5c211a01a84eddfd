"""Guesses of a periodic motion from a run in float64 that has settled: its events in the last period."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from typing import Any

from flint import arb

from numerics.arithmetic.float64 import Float64
from numerics.control.asked import Tell
from numerics.control.orbit import Drive, Leg, Orbit
from numerics.control.rounding import rounded
from numerics.errors import EventUndecided, NotSettled, OutOfRange
from numerics.run.one import run_scene
from numerics.scene import Force, Pair, Scene, State

_PERIODS = (2, 4, 16, 128, 1024)
_SHARE = 5
"""One event in so many of a run may belong to one period: the equations of a period take longer than its run."""


def simulated_guesses(drive: Drive, max_events: int, tell: Tell) -> Iterator[Orbit]:
    """Yield what the pair does in the last of so many periods from rest, not proved.

    Of a run whose last two periods have different events nothing is taken, unless it is the longest. Raises NotSettled
    where a run has more than `max_events` events, or a period a fifth of that.
    """
    for count in _PERIODS:
        tell(f"following {count} periods of {float(drive.period):.4g} s in float64")
        guess, reached = _followed(drive, count, max_events)
        if not reached:
            raise NotSettled(
                f"from rest the pair does not settle within {max_events} events, {count} periods of "
                f"{float(drive.period):.4g} s; raise max_events"
            )
        if guess is not None and len(guess.legs) * _SHARE > max_events:
            raise NotSettled(
                f"a period of {float(drive.period):.4g} s holds {len(guess.legs)} events, more than a fifth of "
                f"max_events = {max_events}; raise max_events, or take frequencies with a shorter common period"
            )
        if guess is not None:
            yield guess


@lru_cache(maxsize=8)
def _followed(drive: Drive, count: int, max_events: int) -> tuple[Orbit | None, bool]:
    """Return the guess of a run over so many periods, if it has one, and whether the run got to its end."""
    until = rounded(drive.period * count, 12)
    scene = Scene(drive.pair, _start(drive), until, force=Force((drive.piece,)))
    try:
        found = run_scene(scene, Float64(), max_events)
    except (EventUndecided, OutOfRange):
        return None, True
    if not found.reached:
        return None, False
    return _last_period(drive, found, until, is_last=count == _PERIODS[-1]), True


def _start(drive: Drive) -> State:
    """Return a start that slips at once, so that a pair that would stay stuck elsewhere does not hide the orbit."""
    pair: Pair = drive.pair
    return State(x1=2 * pair.half_width, v1=0)


def _last_period(drive: Drive, found: Any, until: Fraction, *, is_last: bool) -> Orbit | None:
    """Return the legs of the last period, from one event to the same a period later."""
    period, events = float(drive.period), list(found.events)
    late = [number for number, event in enumerate(events) if event.t > float(until) - 1.05 * period]
    if not late:
        return None
    begin = events[late[0]].t
    before = max(events[late[0] - 1].t if late[0] else 0.0, begin - period / 10)
    edge = (before + begin) / 2  # between two events: none is near to where periods are parted
    last, earlier = ([one for one in events if start <= one.t < start + period] for start in (edge, edge - period))
    if not is_last and [one.after for one in earlier] != [one.after for one in last]:
        return None
    return Orbit(drive, tuple(Leg(one.after.sign, arb(one.t), arb(one.y[0]), arb(one.y[1])) for one in last))
