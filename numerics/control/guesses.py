"""Where a periodic motion is looked for: next to the last one found, by exact equations under one sine, then in a run.

A motion with two stops a period under U sin(omega t + phase) repeats with the other sign after half a period h. Counted
from an exit to slip +, with a slip of length ts and u = S sin(omega t) + C cos(omega t), the exit state (x0, v0) and
(S, C) solve a linear system:

    Lambda = b at the exit, w = 0 at ts, (x1, v1)(h) = -(x0, v0) after a stick phase from ts on

U(ts) = hypot(S, C) runs from U* at ts = 0 to U** at ts = h; between two values of ts with U on either side lies a
guess. From U** on there is the motion that only slips (`thresholds`). Nothing here is proved.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise

from flint import arb, arb_mat

from numerics.arithmetic.float64 import Float64
from numerics.control.answers import Tell, number, rounded, undecided
from numerics.control.orbit import Drive, Leg, Orbit, solve_orbit
from numerics.errors import EventUndecided, NotSettled, OutOfRange
from numerics.linear.system import FIRST, ONE, V1, V2, X1, LinearMode, Row, W, matrix
from numerics.scene import Force, Piece, Scene, Sine, State
from numerics.trajectory.run import run_scene

MAX_EVENTS = 10_000
"""Cap on the events of a run that looks for a periodic motion."""
_PERIODS = (2, 4, 16, 128, 1024)
_SHARE = 5
"""One event in so many of a run may belong to one period: the equations of a period take longer than its run."""
_SAMPLES, _NEAR_ENDS = 256, 40
"""Slip lengths at which U(ts) is compared with U; half powers of 10 from either end of (0, h) besides."""


def find_orbit(drive: Drive, last: Orbit | None, max_events: int, tell: Tell) -> Orbit:
    """Return a periodic motion, proved; `last`: one found at fewer digits. Raises EventUndecided, NotSettled."""
    failure = undecided("what is the periodic motion?", "no guess")
    for guess in _guesses(drive, last, max_events, tell):
        try:
            return solve_orbit(guess, tell)
        except EventUndecided as error:
            failure = error
    raise failure


def _guesses(drive: Drive, last: Orbit | None, max_events: int, tell: Tell) -> Iterator[Orbit]:
    if last is not None:
        yield last
    if len(drive.piece.sines) == 1:
        yield from _non_stop(drive)
        yield from _two_stops(drive)
    for count in _PERIODS:
        tell(f"following {count} periods of {float(drive.period):.4g} s in float64")
        guess = _simulated(drive, count, max_events)
        if guess is not None:
            yield guess


def _two_stops(drive: Drive) -> Iterator[Orbit]:
    """Yield a two-stop motion for each change of sign of U(ts) - U that shows on a grid."""
    half = drive.period / 2
    near = [half / 256 * arb(10) ** (-k / 2) for k in range(_NEAR_ENDS, 0, -1)]
    grid = [*near, *(half * k / _SAMPLES for k in range(1, _SAMPLES)), *(half - one for one in reversed(near))]
    known = [(ts, excess) for ts in grid if (excess := _excess(drive, ts)) is not None]
    for (low, left), (high, right) in pairwise(known):
        if (left > 0) != (right > 0):
            yield _two_stop_orbit(drive, _bisected(drive, low, high, is_above=bool(left > 0)))


def _bisected(drive: Drive, low: arb, high: arb, *, is_above: bool) -> arb:
    for _ in range(60):
        middle = ((low + high) / 2).mid()
        excess = _excess(drive, middle)
        if excess is not None and bool(excess > 0) == is_above:
            low = middle
        else:
            high = middle
    return high


def _excess(drive: Drive, ts: arb) -> arb | None:
    """Return U(ts)^2 - U^2, None where its sign is open."""
    try:
        _, _, S, C = exit_state(drive, ts)
    except ZeroDivisionError:
        return None
    excess = S * S + C * C - number(drive.piece.sines[0].amplitude) ** 2
    return None if excess.contains(0) else excess


def exit_state(drive: Drive, ts: arb) -> tuple[arb, arb, arb, arb]:
    """Return (x0, v0, S, C) of the two-stop motion with a slip of length ts (s); raises ZeroDivisionError."""
    begun, slipped, stuck = _two_stop_flows(drive, ts)
    load = _unit_mode(drive, 0).load
    rows = [_combined(load, begun), _combined(W, slipped)]
    rows += [_combined(((place, Fraction(1)),), stuck + begun) for place in (X1, V1)]
    rows[0][4] -= number(drive.pair.b)
    solved = arb_mat([row[:4] for row in rows]).solve(arb_mat([[-row[4]] for row in rows]))
    x0, v0, S, C = solved.entries()
    return x0, v0, S, C


def _two_stop_flows(drive: Drive, ts: arb) -> tuple[arb_mat, arb_mat, arb_mat]:
    """Return z at the exit, after the slip and after half a period as linear functions of (x0, v0, S, C, 1)."""
    slip, stick = (matrix(_unit_mode(drive, side).generator()) for side in (1, 0))
    columns = ((X1,), (V1, V2), (FIRST + 1,), (FIRST,), (ONE,))
    begun = arb_mat([[int(row in places) for places in columns] for row in range(FIRST + 2)])
    slipped = (slip * ts).exp() * begun
    return begun, slipped, (stick * (drive.period / 2 - ts)).exp() * slipped


def _unit_mode(drive: Drive, side: int) -> LinearMode:
    """Return a mode with a sine of amplitude 1 as the force: C and S are its two components at the exit."""
    return LinearMode(drive.pair, drive.pair.b, side, Piece(0, (), [Sine(1, drive.piece.sines[0].omega)]))


def _combined(row: Row, columns: arb_mat) -> list[arb]:
    """Return a row of z of each column."""
    return [sum((number(factor) * columns[place, k] for place, factor in row), arb(0)) for k in range(columns.ncols())]


def _two_stop_orbit(drive: Drive, ts: arb) -> Orbit:
    """Return the motion with slips of length ts, in the time of the force."""
    x0, v0, S, C = exit_state(drive, ts)
    z = _two_stop_flows(drive, ts)[1] * arb_mat([[x0], [v0], [S], [C], [1]])
    begin = _time_of_phase(drive, S, C)
    return _with_mirrored(drive, Leg(1, begin, x0, v0), Leg(0, begin + ts, z[X1, 0], z[V1, 0]))


def _non_stop(drive: Drive) -> Iterator[Orbit]:
    """Yield the motion that only slips: w(h) = 0, (x1, v1)(h) = -(x0, v0), hypot(S, C) = U, Lambda > b at the start."""
    begun, slipped, _ = _two_stop_flows(drive, drive.period / 2)
    rows = [_combined(W, slipped), *(_combined(((place, Fraction(1)),), slipped + begun) for place in (X1, V1))]
    try:
        by_C, alone = arb_mat([row[:3] for row in rows]).solve(-arb_mat([row[3:] for row in rows])).transpose().tolist()
    except ZeroDivisionError:
        return
    # the other three are linear functions of C
    square, mixed = by_C[2] ** 2 + 1, by_C[2] * alone[2]
    rest = mixed**2 - square * (alone[2] ** 2 - number(drive.piece.sines[0].amplitude) ** 2)
    for root in (rest.sqrt(), -rest.sqrt()) if rest > 0 else ():
        C = (root - mixed) / square
        x0, v0, S = (slope * C + value for slope, value in zip(by_C, alone, strict=True))
        load = zip(_combined(_unit_mode(drive, 0).load, begun), (x0, v0, S, C), strict=False)
        if sum((factor * one for factor, one in load), arb(0)) > number(drive.pair.b):
            yield _with_mirrored(drive, Leg(1, _time_of_phase(drive, S, C), x0, v0))


def _time_of_phase(drive: Drive, S: arb, C: arb) -> arb:
    """Return the first time t >= 0 at which the force is C, and its derivative omega S."""
    sine = drive.piece.sines[0]
    sign = 1 if sine.amplitude > 0 else -1
    t = (arb.atan2(sign * C, sign * S) - number(sine.phase)) / number(sine.omega)
    return t - drive.period * math.floor(float(t / drive.period))


def _with_mirrored(drive: Drive, *legs: Leg) -> Orbit:
    """Return half a period of legs and the same with the other sign; a constant force shifts x1."""
    shift, half = number(drive.rest), drive.period / 2
    sides = ((1, arb(0)), (-1, half))
    return Orbit(
        drive,
        tuple(
            Leg(side * one.side, one.t + late, side * one.x + shift, side * one.v)
            for side, late in sides
            for one in legs
        ),
    )


@lru_cache(maxsize=8)
def _simulated(drive: Drive, count: int, max_events: int) -> Orbit | None:
    """Return what the pair does in the last of so many periods, in float64.

    None if the last two periods have different events, unless the run is the longest. Raises NotSettled where the run
    has more than `max_events` events, or a period a fifth of that.
    """
    period = float(drive.period)
    # a start that slips at once: a pair that would stay stuck elsewhere does not hide the motion
    start, until = State(x1=2 * drive.pair.half_width), rounded(drive.period * count, 12)
    scene = Scene(drive.pair, start, until, force=Force((drive.piece,)))
    try:
        run = run_scene(scene, Float64(), max_events)
    except (EventUndecided, OutOfRange):
        return None
    if not run.reached:
        raise NotSettled(
            f"from rest the pair does not settle within {max_events} events, {count} periods of "
            f"{period:.4g} s; raise max_events"
        )
    times = [float(event.t) for event in run.events]
    late = next((k for k, t in enumerate(times) if t > float(until) - 1.05 * period), None)
    if late is None:
        return None
    # periods are parted between two events, near none
    edge = (max(times[late - 1] if late else 0.0, times[late] - period / 10) + times[late]) / 2
    last, before = ([one for one in run.events if at <= one.t < at + period] for at in (edge, edge - period))
    if count != _PERIODS[-1] and [one.after for one in before] != [one.after for one in last]:
        return None
    if len(last) * _SHARE > max_events:
        raise NotSettled(
            f"a period of {period:.4g} s holds {len(last)} events, more than a fifth of max_events = {max_events}; "
            "raise max_events, or take frequencies with a shorter common period"
        )
    return Orbit(drive, tuple(Leg(one.after.sign, arb(one.t), arb(one.y[0]), arb(one.y[1])) for one in last))
