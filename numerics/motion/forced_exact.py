"""How a run under a force begins, as far as it can be told exactly: ties, touches, and jumps that meet an event.

Where the free part of a motion vanishes exactly, the state at a rational time is an exact number (sine_form.py), and
the guard of a polynomial force is a polynomial: its first root of odd multiplicity is found exactly, touches are passed
over, and a root that meets the time of a jump is seen. Of a guard with one frequency the amplitude is compared with b:
a load that touches the edge for ever never leaves it. What is left over starts where numbers decide.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from numerics.contact.polynomial_root import first_crossing
from numerics.motion.forced_pieces import ExactPiece, ExactPieces, particular
from numerics.motion.forced_rules import MARGINAL, load_form, mode_after
from numerics.motion.sine_form import SineForm
from numerics.scene import Law, Scene


class ExactKnot(NamedTuple):
    """The start of a segment, exact: where in which piece, the state, what follows, and why.

    Up to `quiet` (time in the piece) nothing happens; `mode` follows with `order` derivatives of its guard vanishing.
    """

    piece: int
    local: Fraction
    x1: SineForm
    v1: SineForm
    x2: SineForm
    v2: SineForm
    mode: int
    order: int
    is_event: bool
    is_jump: bool
    quiet: Fraction


class Motion(NamedTuple):
    """The particular motion of a mode on a piece: a polynomial, and for every sine in-phase and behind parts of x1."""

    polynomial: list[Fraction]
    sines: list[tuple[Fraction, Fraction]]


def exact_knots(scene: Scene, pieces: ExactPieces) -> list[ExactKnot]:
    """Return the segments that are known exactly, in order; the last one goes on in numbers."""
    at = scene.initial
    x1, v1, x2, v2 = (SineForm(one) for one in (at.x1, at.v1, at.x2, at.v2))
    gap = (at.v1 > at.v2) - (at.v1 < at.v2)
    mode, order = (gap, 0) if gap else _mode_after(scene, pieces[0], Fraction(0), x1, v1)
    knot = ExactKnot(0, Fraction(0), x1, v1, x2, v2, mode, order, False, True, Fraction(0))
    found = []
    while True:
        quiet, after = _followed(scene, pieces, knot)
        found.append(knot._replace(quiet=quiet))
        if after is None:
            return found
        knot = after


def _mode_after(scene: Scene, piece: ExactPiece, local: Fraction, x: SineForm, v: SineForm) -> tuple[int, int]:
    return mode_after(scene.pair, piece, local, x, v, literal=scene.law is Law.THREE_VALUED_SGN)


def _followed(scene: Scene, pieces: ExactPieces, knot: ExactKnot) -> tuple[Fraction, ExactKnot | None]:
    """Return up to when nothing happens after a knot, and the next one if it is exact."""
    piece = pieces[knot.piece]
    motion = exact_motion(scene, piece, knot)
    if motion is None:
        return (piece.length if _touches_at_most(scene, piece, knot) else _start_of(scene, piece, knot)), None
    literal = scene.law is Law.THREE_VALUED_SGN
    if knot.mode == 0 and (literal or (piece.sines and _amplitude_below(scene, piece, motion))):
        return piece.length, _next_piece(scene, pieces, knot, motion)
    if piece.sines:
        return _start_of(scene, piece, knot), None
    return _to_first_root(scene, pieces, knot, motion)


def _to_first_root(
    scene: Scene, pieces: ExactPieces, knot: ExactKnot, motion: Motion
) -> tuple[Fraction, ExactKnot | None]:
    """Return the same where the guards are polynomials."""
    piece = pieces[knot.piece]
    known, root = piece.length, None
    for guard in guards(scene, piece, knot, motion):
        before, exact = first_crossing(guard, knot.local, known)
        if exact is not None or before < known:
            known, root = before, exact
    if root is not None:
        return known, _at_root(scene, pieces, knot, motion, root)
    return known, _next_piece(scene, pieces, knot, motion) if known == piece.length else None


def exact_motion(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> Motion | None:
    """Return the particular motion of the mode if the state lies on it exactly, else None."""
    pair, mass = scene.pair, scene.pair.m1 if knot.mode else scene.pair.mass
    polynomial = list(piece.polynomial) or [Fraction(0)]
    polynomial[0] -= knot.mode * piece.b
    sines = []
    for sine in piece.sines:
        stiff, drag = pair.a2 - mass * sine.omega**2, pair.a1 * sine.omega
        if stiff == 0 and drag == 0:
            return None
        scale = sine.amplitude / (stiff**2 + drag**2)
        sines.append((stiff * scale, -drag * scale))
    motion = Motion(particular(tuple(polynomial), mass, pair.a1, pair.a2), sines)
    x, v = _state(piece, motion, knot.local)
    return motion if x == knot.x1 and v == knot.v1 else None


def _state(piece: ExactPiece, motion: Motion, local: Fraction) -> tuple[SineForm, SineForm]:
    """Return x1 and v1 of a particular motion at a time in its piece."""
    x = SineForm(sum((c * local**k for k, c in enumerate(motion.polynomial)), Fraction(0)))
    v = SineForm(sum((k * c * local ** (k - 1) for k, c in enumerate(motion.polynomial) if k), Fraction(0)))
    for sine, (one, two) in zip(piece.sines, motion.sines, strict=True):
        angle = sine.omega * (piece.start + local) + sine.phase
        x += SineForm.turned(angle, one, two)
        v += SineForm.turned(angle, -two * sine.omega, one * sine.omega)
    return x, v


def guards(scene: Scene, piece: ExactPiece, knot: ExactKnot, motion: Motion) -> list[list[Fraction]]:
    """Return the guards of a mode as polynomials of the time in the piece; they must not become negative."""
    p = motion.polynomial
    if knot.mode == 0:
        load = [(k + 2) * (k + 1) * c * scene.pair.m2 for k, c in enumerate(p[2:])] or [Fraction(0)]
        return [[piece.b - load[0], *(-c for c in load[1:])], [piece.b + load[0], *load[1:]]]
    v2 = knot.v2.rational
    assert v2 is not None  # a slip without sines, whose v1 and v2 were equal or given
    brake = piece.b / scene.pair.m2
    guard = [knot.mode * (k + 1) * c for k, c in enumerate(p[1:])]
    guard += [Fraction(0)] * (2 - len(guard))
    guard[0] += -knot.mode * v2 + brake * knot.local
    guard[1] -= brake
    return [guard]


def _amplitude_below(scene: Scene, piece: ExactPiece, motion: Motion) -> bool:
    """Return whether the load of a stuck motion with one sine never gets past b; it may touch it for ever."""
    if len(piece.sines) != 1 or any(motion.polynomial[3:]):
        return False
    constant = 2 * motion.polynomial[2] if len(motion.polynomial) > 2 else Fraction(0)
    one, two = motion.sines[0]
    return _fits(scene, piece, constant, (one**2 + two**2) * piece.sines[0].omega ** 4)


def _touches_at_most(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> bool:
    """Return whether the load of an undamped stuck pair under a force up to t^2 never gets past b, exactly."""
    x, v, pair = knot.x1.rational, knot.v1.rational, scene.pair
    if knot.mode or pair.a1 or piece.sines or len(piece.polynomial) > 3 or x is None or v is None:
        return False
    steady = Motion(particular(piece.polynomial, pair.mass, pair.a1, pair.a2), [])
    x_steady, v_steady = (one.rational or Fraction(0) for one in _state(piece, steady, knot.local))
    constant = 2 * steady.polynomial[2] if len(steady.polynomial) > 2 else Fraction(0)
    stiff = pair.a2 / pair.mass
    return _fits(scene, piece, constant, stiff**2 * (x - x_steady) ** 2 + stiff * (v - v_steady) ** 2)


def _fits(scene: Scene, piece: ExactPiece, constant: Fraction, square: Fraction) -> bool:
    """Return whether m2 (|constant| + sqrt(square)) <= b."""
    room = piece.b / scene.pair.m2 - abs(constant)
    return room >= 0 and square <= room * room


def _start_of(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> Fraction:
    """Return up to when it is known that nothing happens, at the start of a segment that goes on in numbers."""
    if knot.order <= 2:
        return knot.local
    if knot.order == MARGINAL:
        return knot.local
    from numerics.motion.forced_tie import quiet_after_tie

    return quiet_after_tie(scene.pair, piece, knot)


def moved_exactly(scene: Scene, piece: ExactPiece, knot: ExactKnot, motion: Motion, local: Fraction) -> ExactKnot:
    """Return the state at a later time in the piece."""
    x1, v1 = _state(piece, motion, local)
    t = local - knot.local
    if knot.mode == 0:
        return knot._replace(local=local, x1=x1, v1=v1, x2=knot.x2 + (x1 - knot.x1), v2=v1)
    brake = knot.mode * piece.b / scene.pair.m2
    return knot._replace(
        local=local, x1=x1, v1=v1, x2=knot.x2 + knot.v2 * t + brake * t * t / 2, v2=knot.v2 + brake * t
    )


def _at_root(scene: Scene, pieces: ExactPieces, knot: ExactKnot, motion: Motion, root: Fraction) -> ExactKnot | None:
    """Return the event at an exact root; where a piece ends there, what follows is decided in the next one."""
    piece = pieces[knot.piece]
    at = moved_exactly(scene, piece, knot, motion, root)
    if root == piece.length:
        return _into_next(scene, pieces, at, is_jump=knot.mode == 0)
    mode, order = _mode_after(scene, piece, root, at.x1, at.v1)
    return at._replace(mode=mode, order=order, is_event=mode != knot.mode, is_jump=False)


def _next_piece(scene: Scene, pieces: ExactPieces, knot: ExactKnot, motion: Motion) -> ExactKnot | None:
    """Return the start of the next piece, exact; None after the last one."""
    piece = pieces[knot.piece]
    return _into_next(scene, pieces, moved_exactly(scene, piece, knot, motion, piece.length), is_jump=True)


def _into_next(scene: Scene, pieces: ExactPieces, at: ExactKnot, *, is_jump: bool) -> ExactKnot | None:
    """Return a state at the end of a piece as the start of the next one, the mode decided where v1 = v2."""
    if at.piece + 1 == len(pieces):
        return None
    mode, order = at.mode, 0
    if at.v1 == at.v2:
        mode, order = _mode_after(scene, pieces[at.piece + 1], Fraction(0), at.x1, at.v1)
    return at._replace(
        piece=at.piece + 1, local=Fraction(0), mode=mode, order=order, is_event=mode != at.mode, is_jump=is_jump
    )


__all__ = ["ExactKnot", "exact_knots", "load_form"]
