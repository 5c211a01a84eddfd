"""Stick and slip under a force: where a mode ends, what follows, and how far the motion may be from the true one.

The path that is followed starts anew from a point at every knot: an event, a jump of u or b, or a seam (where a long
piece was cut for the sake of its phases). Between knots it is a true motion but for the short times by which a knot may
be misplaced. Two motions under the same u never part in N = sqrt(a2 x1^2 + m1 v1^2 + m2 v2^2) of their difference,
across all events; so its error is at most the sum of the local ones, and bounds grow linearly. While friction is off by
2 b for a time d, N grows by 2 b sqrt(kappa) d at most; while the force is off by D, by D d/sqrt(m1).
"""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.float64 import UNIT, ZERO, middle, positive, rough, size, spread
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.contact.forced import ENDLESS, NEVER, NONE, ROOT, isolate, refine
from numerics.flows.forced_jet import load_at, load_error, push_at, state_at
from numerics.flows.forced_records import ROUNDINGS, Drive, Moved, Pair, Push, Start

GUARD, JUMP, SEAM, DOUBTFUL, CALM, TOO_FAR = 0, 1, 2, 3, 4, 5
"""What a knot is: a root of a guard, a jump of u or b, a seam; or that it is in doubt; or stick for the whole piece; or
that it is too many steps away."""


class Knot(NamedTuple):
    """Where a mode, or a piece, ends: what it is, when after the start, and how far off that time may be.

    `slope` is the guard's there; `side` the one of stick.
    """

    kind: int
    side: int
    tau: Number
    window: Number
    slope: Number


class Seen(NamedTuple):
    """The bounds on the errors of an event: of t, x1, v1 = v2 and x2."""

    late: Number
    x1: Number
    v1: Number
    x2: Number
    v2: Number


@text_apart
def locate(pair: Pair, drive: Drive, start: Start) -> Knot:
    """Return the knot at which a mode ends."""
    place = drive.places[start.piece]
    length = drive.numbers[place[0] + 1]
    limit = middle(length - start.local)
    # a boundary is misplaced by the rounding of its time, which counts where something jumps there
    window = spread(length) + spread(length - start.local) + UNIT * size(length) + ZERO
    kind = JUMP if place[3] == 1 else SEAM
    if not positive(limit):
        return Knot(kind, 0, ZERO, window, ZERO)
    found = isolate(pair, drive, start, limit)
    if found.how == NEVER:
        return Knot(CALM, 0, limit, window, ZERO)
    if found.how == NONE:
        return Knot(kind, 0, limit, window, ZERO)
    if found.how == ENDLESS:
        return Knot(TOO_FAR, 0, found.low, window, ZERO)
    if found.how != ROOT:
        return Knot(DOUBTFUL, found.side, found.low, window, ZERO)
    root = refine(pair, drive, start, found)
    # the true root is off by so much; next to it the slope must be known to hardly change
    norm = (pair.load_norm if start.mode == 0 else pair.guard_norm) * start.norm
    late = norm / size(root.slope) + root.window
    is_sure = root.sure and positive(found.high - found.low - 64 * late)
    return Knot(GUARD if is_sure else DOUBTFUL, found.side, root.tau, root.window, size(root.slope))


@text
def norm_of(pair: Pair, x: Number, v1: Number, v2: Number) -> Number:
    """Return a bound on N of errors that are this large: the sum of its parts."""
    return pair.root_a2 * x + pair.root_m1 * v1 + pair.root_m2 * v2


@text
def driven_at(pair: Pair, drive: Drive, start: Start, here: Moved, tau: Number) -> tuple[Number, Number, Number]:
    """Return x2 and v2 at tau after the start of a mode, where body 1 is `here`; and what a slip adds to v2."""
    gain = start.mode * (drive.numbers[drive.places[start.piece][0] + 2] / pair.m2) * tau
    if start.mode == 0:
        return start.x2 + (here.x - start.x1), here.v, gain
    return start.x2 + (start.v2 + gain / 2) * tau, start.v2 + gain, gain


@text_apart
def arrive(pair: Pair, drive: Drive, start: Start, knot: Knot) -> tuple[Start, Moved]:
    """Return the path at a knot as the start of a mode yet to be chosen, errors grown, and the sizes of its sums."""
    here, tau = state_at(pair, drive, start, knot.tau), knot.tau
    x2, v2, gain = driven_at(pair, drive, start, here, tau)
    x_off = spread(here.x) + ROUNDINGS * UNIT * here.x_size
    v_off = spread(here.v) + ROUNDINGS * UNIT * here.v_size
    v2_size = abs(rough(start.v2)) + abs(rough(gain)) if start.mode != 0 else 0.0
    v2_off = spread(v2) + ROUNDINGS * UNIT * v2_size if start.mode != 0 else v_off
    x2_size = abs(rough(start.x2)) + v2_size * rough(tau) if start.mode != 0 else here.x_size + abs(rough(x2))
    norm = start.norm + norm_of(pair, x_off, v_off, v2_off)
    # x1 - x2 is kept in stick, and slides apart by |w| at most
    apart = pair.guard_norm * start.norm * tau if start.mode != 0 else ZERO
    place = start.place + apart + spread(x2) + x_off + ROUNDINGS / 4.0 * UNIT * x2_size
    local = start.local + tau
    x1, v1 = middle(here.x), middle(here.v)
    at = Start(start.mode, 0, start.piece, middle(local), x1, v1, middle(x2), middle(v2), norm, place, ZERO)
    return at, here


@text
def with_window(pair: Pair, at: Start, force: Number, window: Number) -> Start:
    """Return a start whose errors have grown by a time for which forces were off by `force`."""
    slip = force * window * pair.guard_norm
    apart = slip * pair.guard_norm * window if at.mode != 0 else ZERO
    return Start(
        at.mode, at.order, at.piece, at.local, at.x1, at.v1, at.x2, at.v2, at.norm + slip, at.place + apart, at.quiet
    )


@text
def slid(pair: Pair, at: Start, late: Number) -> Start:
    """Return a start whose error of x1 - x2 has grown while one motion may slip where the other sticks."""
    apart = 2 * pair.guard_norm * at.norm * late
    return Start(at.mode, at.order, at.piece, at.local, at.x1, at.v1, at.x2, at.v2, at.norm, at.place + apart, at.quiet)


@text
def joined(pair: Pair, at: Start) -> Start:
    """Return the start after a slip, both velocities made one."""
    gap = size(at.v1 - at.v2)
    return Start(
        at.mode,
        at.order,
        at.piece,
        at.local,
        at.x1,
        at.v2,
        at.x2,
        at.v2,
        at.norm + pair.root_m1 * gap,
        at.place,
        at.quiet,
    )


@text
def begun(at: Start, mode: int, order: int) -> Start:
    """Return the start of a mode at this state."""
    return Start(mode, order, at.piece, at.local, at.x1, at.v1, at.x2, at.v2, at.norm, at.place, at.quiet)


@text
def load_and_error(pair: Pair, drive: Drive, at: Start, here: Moved) -> tuple[Number, Number]:
    """Return the load at v1 = v2, and how far off this path's own load may be."""
    load = load_at(pair, drive, at.piece, at.local, at.x1, at.v1)
    push = push_at(drive, at.piece, at.local)
    return middle(load), spread(load) + load_error(pair, push.height, here)


@text
def after_slip(pair: Pair, drive: Drive, at: Start, here: Moved) -> tuple[bool, Start]:
    """Return whether it is decided, and the start of what follows a slip that ends at v1 = v2 inside a piece."""
    joint = joined(pair, at)
    load, own = load_and_error(pair, drive, joint, here)
    error = own + pair.load_norm * joint.norm
    b = drive.numbers[drive.places[at.piece][0] + 2]
    inside, outside = b - size(load) - error, -at.mode * load - b - error
    if pair.literal or positive(inside):
        return True, begun(joint, 0, 0)
    return positive(outside), begun(joint, -at.mode, 1)


@text
def after_stick(pair: Pair, drive: Drive, at: Start, knot: Knot, here: Moved) -> tuple[bool, Start]:
    """Return the slip that starts where the load gets past b: both guard and slope are 0 there."""
    _, error = load_and_error(pair, drive, at, here)
    push, b = push_at(drive, at.piece, at.local), drive.numbers[drive.places[at.piece][0] + 2]
    x2 = (push.u0 - pair.a2 * at.x1 - pair.a1 * at.v1) / pair.mass
    x3 = (push.u1 - pair.a1 * x2 - pair.a2 * at.v1) / pair.m1
    bend = knot.side * x3
    # where the slope of the guard is not quite 0, the slip starts a little later than here
    later = 4 * (error + knot.window * knot.slope) / (pair.m1 * size(bend))
    slipped = with_window(pair, at, 2 * b, later)
    return positive(middle(bend)), begun(slipped, knot.side, 2)


@text
def after_jump(pair: Pair, drive: Drive, at: Start, here: Moved) -> tuple[bool, Start]:
    """Return the start of what follows in stick where u or b has jumped: the load decides."""
    load, own = load_and_error(pair, drive, at, here)
    error = own + pair.load_norm * at.norm
    b = drive.numbers[drive.places[at.piece][0] + 2]
    outside = size(load) - b
    if pair.literal or positive(-outside - error):
        return True, begun(at, 0, 0)
    return positive(outside - error), begun(at, 1 if positive(load) else -1, 1)


@text
def misplaced(drive: Drive, piece: int, before: Push) -> Number:
    """Return how far the force may be off where a piece begins at a slightly wrong time."""
    after = push_at(drive, piece, ZERO)
    return size(after.u0 - before.u0) + (size(before.u1) + size(after.u1)) * 2.0**-40


@text
def next_piece(pair: Pair, drive: Drive, at: Start, knot: Knot) -> Start:
    """Return the same state in the next piece."""
    before, b = push_at(drive, at.piece, at.local), drive.numbers[drive.places[at.piece][0] + 2]
    moved_on = Start(at.mode, 0, at.piece + 1, ZERO, at.x1, at.v1, at.x2, at.v2, at.norm, at.place, ZERO)
    return with_window(pair, moved_on, misplaced(drive, at.piece + 1, before) + 2 * b, knot.window)


@text
def seen(pair: Pair, drive: Drive, at: Start, knot: Knot, was_stick: bool) -> Seen:
    """Return bounds on the errors of an event: the path is off by N, and the true event by a time `late`."""
    norm = (pair.load_norm if was_stick else pair.guard_norm) * at.norm
    late = knot.window * 0
    if knot.kind == GUARD:
        late = (norm / knot.slope + knot.window) * 1.25
    push, b = push_at(drive, at.piece, at.local), drive.numbers[drive.places[at.piece][0] + 2]
    pull = (size(push.u0 - pair.a2 * at.x1 - pair.a1 * at.v1) + b) / pair.m1 + b / pair.m2
    speed = size(at.v1) + pull * late
    x1, v1, v2 = at.norm / pair.root_a2, at.norm / pair.root_m1, at.norm / pair.root_m2
    x2 = at.place + x1
    return Seen(late, x1 + speed * late, v1 + pull * late, x2 + speed * late, v2 + pull * late)
