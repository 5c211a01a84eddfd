"""Where a motion has no derivative by its data: a neighbour's differs to first order on either side.

Events that numbers decide are strict. So only what is known exactly (exact_start.py) can sit on such a corner:

    an event where a piece begins    on one side of it the neighbour's comes before the jump, on the other after it
    a jump onto the edge, into slip  a neighbour may stick a little longer
    a touch in a slip                a neighbour sticks for a time sqrt(e), with friction off by sqrt(e)
    an event without a slope         its time moves by a root of e
    stick as slip's own motion       a neighbour slips by an amount of first order
    a contact on the horizon         a neighbour sticks, or does not
    a load as large as b_static      a neighbour slips, at a rate that does not vanish with e; a swing that comes to
                                     it at its peaks counts wherever these are

Else no corner is a tie that stick or slip leaves at once, at the start, at a contact or after a jump that leaves the
pair stuck: a neighbour slips, or sticks, for a time e^(1/k) with friction off by e, which is less than first order. Nor
is a touch of the load: beyond b by e for a time sqrt(e) at most.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import islice

from numerics.linear.cells import first_mode
from numerics.linear.exact_start import ExactKnot, ExactMotion, exact_knots, exact_motion
from numerics.linear.pieces import ExactPiece
from numerics.linear.polynomial_root import touches
from numerics.linear.ties import MARGINAL, applied, derivatives, exact_z, mode_after
from numerics.scene import Law, Scene

_REGULAR = 2
"""So many derivatives of a slip's guard vanish after an exit: the load went past b with a slope."""
_ON_EDGE = "the load is exactly what friction holds at rest"


def corner(scene: Scene, pieces: Sequence[ExactPiece], until: float) -> str | None:
    """Return what leaves a scene without derivatives, and when, if its motion meets that up to a time (s); exact."""
    knots = exact_knots(scene, pieces)
    for before, knot, after in zip([None, *knots], knots, [*knots[1:], None], strict=False):
        piece = pieces[knot.piece]
        begun = piece.start + knot.local
        if begun > until:
            return None
        motion = exact_motion(scene, piece, knot)
        what = _in_segment(scene, piece, motion, knot)
        leaves = before is not None and before.mode == 0 and before.piece == knot.piece
        if what is None and _is_kept(scene) and not leaves and _on_edge(scene, piece, knot):
            what = _ON_EDGE
        if what is not None:
            return f"after t = {float(begun):.6g} s {what}"
        if after is not None:
            at, what = pieces[after.piece].start + after.local, _between(scene, piece, knot, after)
        else:
            at, what = scene.until, _at_the_end(scene, motion, knot)
        if what is not None and at <= until:
            return f"at t = {float(at):.6g} s {what}"
    return None


def _in_segment(scene: Scene, piece: ExactPiece, motion: ExactMotion | None, knot: ExactKnot) -> str | None:
    """Return what is wrong with the motion from a knot to the next."""
    literal = scene.law is Law.THREE_VALUED_SGN and knot.mode == 0
    order = mode_after(first_mode(scene, piece, 0), knot.local, knot.state)[1] if literal else knot.order
    if order == MARGINAL:
        return "stick is the motion of a slip as well"
    if motion is None or not (knot.mode or (_is_kept(scene) and _is_loaded(scene, piece, knot))):
        return None
    guards = motion.guards()
    if guards is None or not touches(guards, Fraction(0), knot.quiet - knot.local):
        return _ON_EDGE if motion.stays() and not motion.stays(strictly=True) else None
    return "the bodies' velocities touch in a slip" if knot.mode else _ON_EDGE


def _is_kept(scene: Scene) -> bool:
    """Return whether friction holds more at rest than in slip, and a stick ends where it holds no more."""
    return scene.law is Law.FILIPPOV and scene.pair.b_static not in {None, scene.pair.b}


def _is_loaded(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> bool:
    """Return whether a stick needs friction, now or next: what comes to 0 together with friction makes no corner."""
    stick = first_mode(scene, piece, 0)
    return any(applied(stick.load, z).sign() for z in islice(derivatives(stick, knot.local, knot.state), 2))


def _on_edge(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> bool:
    """Return whether v1 = v2 at a knot, and the load is exactly as large as what friction holds at rest, and not 0."""
    z, stick = exact_z(piece, 0, knot.local, knot.state), first_mode(scene, piece, 0)
    is_tied = knot.gap == 0 and any(applied(row, z).sign() == 0 for row in stick.guards)
    return is_tied and applied(stick.load, z).sign() != 0


def _between(scene: Scene, before: ExactPiece, one: ExactKnot, two: ExactKnot) -> str | None:
    """Return what is wrong with the knot between two segments."""
    stick, ends_here = first_mode(scene, before, 0), one.piece == two.piece
    z = exact_z(before, 0, two.local if ends_here else before.length, two.state)
    load = applied(stick.load, z)
    is_at_edge = load * load.sign() == applied(stick.friction, z)
    if ends_here:
        has_slope = not (is_at_edge and load.sign() == one.mode)
        if one.mode == 0:
            _, rates, *_ = derivatives(stick, two.local, two.state)
            has_slope = all(applied(row, rates).sign() for row in stick.guards if applied(row, z).sign() == 0)
        return "an event comes without a slope" if two.is_event and not has_slope else None
    if one.mode != 0:
        return "a slip ends where a piece begins" if two.gap == 0 else None
    if two.is_event and is_at_edge:
        return "stick ends where a piece begins"
    return "a jump takes the load onto the edge" if two.is_event and two.order >= _REGULAR else None


def _at_the_end(scene: Scene, motion: ExactMotion | None, last: ExactKnot) -> str | None:
    """Return what is wrong with the horizon, if the motion is known exactly up to there."""
    if motion is None or not motion.ends or not (last.mode or _is_kept(scene)):
        return None
    piece = motion.mode.piece
    if piece.start + piece.length < scene.until or last.quiet < piece.length:
        return None
    end = motion.at(piece.length)
    if last.mode == 0:
        return _ON_EDGE if _on_edge(scene, piece, end) else None
    return "a slip ends on the horizon" if end.gap == 0 else None
