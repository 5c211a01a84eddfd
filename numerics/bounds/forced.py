"""What rounding can have done under a force, component by component: sharper than N after many events.

The error e = (dx1, dv1, dv2, dx2) of the path obeys a linear equation as long as both motions are in one mode, since
their forces differ by a2 dx1 + a1 dv1 only; so it is carried by the exact matrices of the modes, as a box in a basis
that turns with it (Lohner's method: the columns' own orthogonal directions). N alone only says that it never grows.

At an event the momentum m1 v1 + m2 v2 does not feel friction, so its error goes on as it was, whenever the true event
is; that of w = v1 - v2 becomes 0 in stick, stays 0 at an exit, and is multiplied by the quotient of w' after and before
at a reversal. All this up to terms that are quadratic in how late the true event can be: they are bounded and added.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from numerics.arithmetic.float64 import UNIT
from numerics.bounds.spread import SLACK, Spread, Vector
from numerics.flows.forced_jet import load_error, push_at, state_at
from numerics.flows.forced_records import ROUNDINGS, Drive, Pair, Push, Start, Swing
from numerics.flows.oscillator import propagate

_X1, _V1, _V2, _X2 = range(4)


class Point(NamedTuple):
    """A row (trajectory/forced_record.py): the start of a mode, whether it is an event, whether u or b jumped there.

    `late` is how late, or early, the true event may be by the bound in N.
    """

    start: Start
    is_event: bool
    is_jump: bool
    late: float


def spreads(
    pair: Pair, drive: Drive, points: list[Point], end: Start, begun: Spread | None = None
) -> tuple[Vector, Vector]:
    """Return bounds on the errors (t, x1, v1, x2, v2) of each row, seen at its event, and (x1, v1, x2, v2) at the end.

    `begun` are the errors at the start, where they are not those of rounding. inf where nothing is said here: take the
    smaller of these and those of N.
    """
    units = np.array([pair.root_a2, pair.root_m1, pair.root_m2, pair.root_a2])
    found = np.full((len(points), 5), math.inf)
    spread = Spread(units, rounding_of(points[0].start)) if begun is None else begun
    for k, point in enumerate(points):
        if k:
            before = points[k - 1].start
            if is_exact(pair, point.start):
                spread, late = Spread(units, rounding_of(point.start)), 0.0
            else:
                flown(pair, drive, spread, before, point.start)
                late = through(pair, drive, spread, before, point) if point.is_event else 0.0
            if not math.isfinite(late) or not np.isfinite(spread.basis).all():
                return found, np.full(4, math.inf)
            found[k] = seen(pair, drive, spread.box, (before, point.start), late)
    flown(pair, drive, spread, points[-1].start, end)
    return found, spread.box[[_X1, _V1, _X2, _V2]]


def rounding_of(at: Start) -> Vector:
    """Return the errors of a state that was rounded once."""
    return UNIT * np.abs([at.x1, at.v1, at.v2, at.x2]) * SLACK


def is_exact(pair: Pair, at: Start) -> bool:
    """Return whether a state is one that was known exactly: its bound in N is that of one rounding."""
    x1, v1, v2, _ = rounding_of(at)
    return bool(at.norm <= pair.root_a2 * x1 + pair.root_m1 * v1 + pair.root_m2 * v2)


def flown(pair: Pair, drive: Drive, spread: Spread, start: Start, at: Start) -> None:
    """Carry the errors from the start of a mode to the next row, or the end, as if both motions kept the mode."""
    place = drive.places[start.piece]
    length, b = drive.numbers[place[0] + 1], drive.numbers[place[0] + 2]
    same = at.piece == start.piece
    tau = (at.local if same else length) - start.local
    here = state_at(pair, drive, start, tau)
    swing = pair.stick if start.mode == 0 else pair.slip
    gain = start.mode * (b / pair.m2) * tau
    v2, x2 = start.v2 + gain, start.x2 + (start.v2 + gain / 2) * tau
    if start.mode == 0:
        v2, x2 = here.v, start.x2 + (here.x - start.x1)
    roundings = ROUNDINGS * UNIT
    local = roundings * np.array(
        [
            here.x_size,
            here.v_size,
            abs(start.v2) + abs(gain) if start.mode else here.v_size,
            abs(start.x2) + (abs(start.v2) + abs(gain)) * tau + (0.0 if start.mode else here.x_size),
        ]
    )
    # what was written differs from this where both velocities were made one, and by the rounding of the time
    local += np.abs([here.x - at.x1, here.v - at.v1, v2 - at.v2, x2 - at.x2])
    late = 2.0 * UNIT * (abs(at.local if same else length) + start.local + tau)
    before = Start._make((*start[:3], start.local + tau, here.x, here.v, x2, v2, *start[8:]))
    fast = 2.0 * accelerations(pair, drive, before, start.mode)
    local += late * np.array([abs(here.v) + fast[0] * late, *fast, abs(v2) + fast[1] * late])
    local += parameters(pair, swing, start, at, b, tau)
    spread.carried(matrix(swing, start.mode, tau), local)


def accelerations(pair: Pair, drive: Drive, at: Start, mode: int) -> Vector:
    """Return |v1'| and |v2'| of a mode at a state."""
    b = drive.numbers[drive.places[at.piece][0] + 2]
    force = push_at(drive, at.piece, at.local).u0 - pair.a2 * at.x1 - pair.a1 * at.v1
    if mode == 0:
        return np.abs([force / pair.mass, force / pair.mass])
    return np.abs([(force - mode * b) / pair.m1, b / pair.m2])


def parameters(pair: Pair, swing: Swing, start: Start, at: Start, b: float, tau: float) -> Vector:
    """Return what the rounding of the parameters does: the force is off by theirs all the time."""
    x, v = max(abs(start.x1), abs(at.x1)), max(abs(start.v1), abs(at.v1))
    reach = v * min(tau, 1.0 / swing.rate)
    force = 4.0 * UNIT * (pair.a2 * (x + reach) + 2.0 * pair.a1 * v + 2.0 * b)
    # N of one body grows by force/sqrt(m) a second
    speed = force * tau / swing.mass
    far = speed * min(tau, math.sqrt(swing.mass / pair.a2))
    other = 4.0 * UNIT * b / pair.m2 * tau
    if start.mode == 0:
        return np.array([far, speed, speed, far])
    return np.array([far, speed, other, other * tau])


def matrix(swing: Swing, mode: int, tau: float) -> Vector:
    """Return the matrix that carries errors through a mode: body 1 swings, body 2 keeps dv2, or goes with it."""
    one, two = propagate(swing.of, 1.0, 0.0, tau), propagate(swing.of, 0.0, 1.0, tau)
    if mode != 0:
        return np.array(
            [[one[0], two[0], 0.0, 0.0], [one[1], two[1], 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, tau, 1.0]]
        )
    rows = [[one[0], two[0], 0.0, 0.0], [one[1], two[1], 0.0, 0.0], [one[1], two[1], 0.0, 0.0]]
    return np.array([*rows, [one[0] - 1.0, two[0], 0.0, 1.0]])


def through(pair: Pair, drive: Drive, spread: Spread, before: Start, point: Point) -> float:
    """Carry the errors through an event; return how late, or early, the true one may be, inf if that is not known."""
    at, share = point.start, pair.m1 / pair.mass
    if before.mode == 0 and point.is_jump:
        return 0.0  # both stick up to the jump
    b = drive.numbers[drive.places[at.piece][0] + 2]
    push, box = push_at(drive, at.piece, at.local), spread.box
    force = push.u0 - pair.a2 * at.x1 - pair.a1 * at.v1
    drift = pair.a2 * box[_X1] + pair.a1 * box[_V1]
    if before.mode == 0:
        return exit_of(pair, drive, spread, point, (push, force, drift))
    if point.is_jump:
        return math.inf  # only what is exact meets a jump in a slip
    old, new = ((force - mode * b) / pair.m1 - mode * b / pair.m2 for mode in (before.mode, at.mode))
    slope = abs(old)
    if not slope > 0.0:
        return math.inf
    late = min(point.late, 1.25 * (spread.width(np.array([0.0, 1.0, -1.0, 0.0])) + UNIT * abs(at.v1)) / slope)
    bend = jerk(pair, push, force - before.mode * b, at, late) + jerk(pair, push, force - at.mode * b, at, late)
    gap = late * (2.0 * slope + bend * late)
    kept = new / old if at.mode else 0.0
    # m1 dv1 + m2 dv2 as before, dv1 - dv2 times `kept`
    rows = np.eye(4)
    rows[_V1, _V1:_X2] = share + (1.0 - share) * kept, (1.0 - share) * (1.0 - kept)
    rows[_V2, _V1:_X2] = share * (1.0 - kept), 1.0 - share + share * kept
    off = 2.0 * late * drift / pair.m1 + bend * late * late
    rest = (pair.a1 * gap + pair.a2 * gap * late) * late / pair.mass
    if at.mode == 0:
        off = rest
    spread.mapped(rows, np.array([gap * late, off + rest, off + rest, gap * late]))
    return late


def exit_of(pair: Pair, drive: Drive, spread: Spread, point: Point, known: tuple[Push, float, float]) -> float:
    """Carry the errors through the end of stick at b: w begins with 0 and, in both motions, with w' = 0 nearly."""
    at, (push, force, drift) = point.start, known
    b = drive.numbers[drive.places[at.piece][0] + 2]
    x2 = force / pair.mass
    slope = abs(pair.m2 * (push.u1 - pair.a1 * x2 - pair.a2 * at.v1) / pair.mass)
    if not slope > 0.0:
        return math.inf
    sizes = state_at(pair, drive, at, 0.0)
    own = load_error(pair, push.height, sizes) + abs(abs(pair.m2 * x2) - b) + 2.0 * UNIT * b
    part = pair.m2 / pair.mass
    off = part * spread.width(np.array([pair.a2, pair.a1, 0.0, 0.0])) + own
    late = min(point.late, 1.25 * off / slope)
    bend = jerk(pair, push, force - at.mode * b, at, late)
    # so much the loads of both are beside b for that long
    gap = late * (pair.mass / (pair.m1 * pair.m2) * (2.0 * off + 2.0 * slope * late) + bend * late)
    rest = (drift + pair.a1 * gap) * late / pair.m1
    spread.mapped(np.eye(4), np.array([gap * late, gap + rest * late, gap, gap * late]))
    return late


def jerk(pair: Pair, push: Push, force: float, at: Start, late: float) -> float:
    """Return a bound on |x1'''| within a time: by two derivatives and the growth of the next (flows/forced_jet.py)."""
    x2 = force / pair.m1
    x3 = (push.u1 - pair.a1 * x2 - pair.a2 * at.v1) / pair.m1
    x4 = (push.u2 - pair.a1 * x3 - pair.a2 * x2) / pair.m1
    most = math.hypot(math.sqrt(pair.a2 / pair.m1) * x3, x4) + push.third / pair.m1 * late
    return float(abs(x3) + 1.0001 * most * late)


def seen(
    pair: Pair, drive: Drive, box: Vector, starts: tuple[Start, Start], late: float
) -> tuple[float, float, float, float, float]:
    """Return bounds on the errors of an event: the path is off by `box`, the true event by a time."""
    before, at = starts
    b = drive.numbers[drive.places[at.piece][0] + 2]
    # both modes' accelerations, twice for their change meanwhile
    fast = 2.0 * max(accelerations(pair, drive, at, mode)[0] for mode in (before.mode, at.mode))
    speed = abs(at.v1) + box[_V1] + fast * late
    # body 2 is never accelerated by more than b/m2, and both have one velocity at an event
    v1, v2 = box[_V1] + fast * late, box[_V2] + b / pair.m2 * late
    if late > 0.0:
        v1 = v2 = min(v1, v2)
    return late, float(box[_X1] + speed * late), float(v1), float(box[_X2] + speed * late), float(v2)
