"""Where a periodic motion is looked for: next to the last one found, in a run, then next to the stuck response.

Newton's method on the period map does the rest (`solve_from`). A run does not see how the stuck response breaks where
the force is a little above what friction holds: too short slips. Nothing here is proved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise

from flint import acb, arb

from numerics.control.answers import Tell, number, rounded, undecided
from numerics.control.orbit import Drive, Orbit, solve_from, solve_orbit
from numerics.control.thresholds import stiffness
from numerics.errors import EventUndecided, NotSettled, OutOfRange, PrecisionExhausted
from numerics.scene import Force, Scene, State
from numerics.solver.solve import ArithmeticName, solve

MAX_EVENTS = 10_000
"""Cap on the events of a run that looks for a periodic motion."""
_PERIODS = (2, 4, 16, 128, 1024)
SHARE = 5
"""One event in so many of a run may belong to one period: the equations of a period take longer than its run."""
_SURE, _DIGITS = 16, 60
"""Up to so many periods a run climbs where float64 leaves its events open, to so many working digits."""
_PARTS = 8
"""Times of a period among which the one with the least load is taken."""


def find_orbit(drive: Drive, last: Orbit | None, max_events: int, tell: Tell) -> Orbit:
    """Return a periodic motion, proved; `last`: one found at fewer digits. Raises EventUndecided, NotSettled."""
    failure: Exception = undecided("what is the periodic motion?", "no guess")
    try:
        if last is not None:
            return solve_orbit(last, tell)
    except EventUndecided as error:
        failure = error
    for begin, at in _starts(drive, max_events, tell):
        try:
            return solve_from(drive, begin, at, max_events // SHARE, tell)
        except (EventUndecided, OutOfRange) as error:
            failure = error
    raise failure


def _starts(drive: Drive, max_events: int, tell: Tell) -> Iterator[tuple[Fraction, list[arb]]]:
    """Yield times (s) and states (x1, v1, v2)."""
    for count in _PERIODS:
        tell(f"following {count} periods of {float(drive.period):.4g} s")
        found = _simulated(drive, count, max_events)
        if found is not None:
            yield found
        if count == _PERIODS[0]:
            yield from next_to_the_stuck_response(drive)


def next_to_the_stuck_response(drive: Drive) -> Iterator[tuple[Fraction, list[arb]]]:
    """Yield the stuck response at one of some times of a period, that with the least load; none at a resonance."""
    times = [rounded(drive.period * k / _PARTS) for k in range(1, _PARTS)]
    states = [(t, state) for t in times if (state := stuck_state(drive, number(t))) is not None]
    for t, (x1, v1, _, v2) in sorted(states, key=lambda one: _load(drive, *one))[:1]:
        yield t, [x1, v1, v2]


def _load(drive: Drive, t: Fraction, state: Sequence[arb]) -> float:
    """Return the size of the load at a time (s) in a state, N."""
    motion = drive.mode(0).motion(state, number(t))
    return abs(float(motion.range(motion.mode.load, arb(0))))


@lru_cache(maxsize=8)
def _simulated(drive: Drive, count: int, max_events: int) -> tuple[Fraction, list[arb]] | None:
    """Return where the pair is in the middle of the longest mode of the last of so many periods.

    None if that has no events. Raises NotSettled where the run has more than `max_events` events, or a period a fifth
    of that.
    """
    period = float(drive.period)
    # a start that slips at once: a pair that would stay stuck elsewhere does not hide the motion
    start, until = State(x1=2 * drive.pair.half_width), rounded(drive.period * count, 12)
    scene = Scene(drive.pair, start, until, force=Force((drive.piece,)))
    try:
        arithmetic: ArithmeticName | None = None if count <= _SURE else "float64"
        run = solve(scene, arithmetic=arithmetic, max_events=max_events, max_digits=_DIGITS)
    except (EventUndecided, OutOfRange, PrecisionExhausted):
        return None
    if not run.reached:
        raise NotSettled(
            f"from rest the pair does not settle within {max_events} events, {count} periods of "
            f"{period:.4g} s; raise max_events"
        )
    times = [float(t) for t in run.event_times if t > float(until) - 1.05 * period]
    if len(times) < 2:
        return None
    if len(times) * SHARE > max_events:
        raise crowded(drive, max_events)
    first, last = max(pairwise(times), key=lambda one: one[1] - one[0])
    middle = Fraction((first + last) / 2)
    x1, v1, _, v2 = (arb(run.arithmetic.to_float(one)) for one in run.sol(middle))
    return middle, [x1, v1, v2]


def crowded(drive: Drive, max_events: int) -> NotSettled:
    """Return the error for a period with so many events that its equations would take too long."""
    return NotSettled(
        f"a period of {float(drive.period):.4g} s holds more than a fifth of max_events = {max_events} events; "
        "raise max_events, or take frequencies with a shorter common period"
    )


def stuck_state(drive: Drive, t: arb, mass: Fraction | None = None) -> tuple[arb, arb, arb, arb] | None:
    """Return (x1, v1, 0, v1) of the stuck response at a time (s); None at a resonance of the stuck pair, a1 = 0.

    With another mass than M (kg) that of so large a body on the spring.
    """
    pair, mass = drive.pair, mass or drive.pair.mass
    x, v = number(drive.rest), arb(0)
    for one in drive.piece.sines:
        if stiffness(pair, mass, one.omega).is_zero():
            return None
        below = acb(number(pair.a2 - mass * one.omega**2), number(pair.a1 * one.omega))
        turned = acb.exp(acb(0, number(one.omega) * t + number(one.phase)))
        moved = turned * number(one.amplitude) / below
        x, v = x + moved.imag, v + number(one.omega) * moved.real
    return x, v, arb(0), v
