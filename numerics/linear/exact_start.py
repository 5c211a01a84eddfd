"""How a run begins, as far as it is known exactly: ties, touches, and jumps that meet an event.

Where the free part of a motion vanishes exactly, the state at a rational time is an exact number (sine_form.py), and
the guard under a polynomial force is a polynomial: its first root of odd multiplicity is found exactly, touches are
passed over, and a root that meets the time of a jump is recognised. Of a guard with one frequency the amplitude is
compared with b: a load that touches the edge for ever never leaves it. What is left over starts where numbers decide.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from numerics.linear.cells import cells_of
from numerics.linear.model import BELT
from numerics.linear.modes import MODES, Mode
from numerics.linear.pieces import ExactPiece, particular, pieces_of, polynomial_at
from numerics.linear.polynomial_root import first_crossing
from numerics.linear.sine_form import SineForm
from numerics.linear.ties import mode_after, signal_form
from numerics.scene import Law, Scene


class ExactKnot(NamedTuple):
    """The start of a segment, exact: where in which piece, the state, what follows, and why.

    `mode` follows with `order` derivatives of its guard vanishing; up to `quiet`, a time in the piece (s), it does
    not end.
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

    @property
    def state(self) -> tuple[SineForm, ...]:
        """Return x1, v1, x2, v2."""
        return self.x1, self.v1, self.x2, self.v2


def exact_knots(scene: Scene, pieces: Sequence[ExactPiece]) -> list[ExactKnot]:
    """Return the segments that are known exactly, in order; the last one goes on in numbers."""
    at = scene.initial
    x1, v1, x2, v2 = (SineForm(one) for one in (at.x1, at.v1, at.x2, at.v2))
    pieces = held_pieces(scene, pieces)
    if scene.pair.is_fixed:
        v2 = signal_form(pieces[0], BELT, Fraction(0))
    gap = (v1 - v2).sign()
    knot = ExactKnot(0, Fraction(0), x1, v1, x2, v2, gap, 0, False, True, Fraction(0))
    after: ExactKnot | None = knot if gap else _decided(scene, pieces, knot)._replace(is_event=False)
    found: list[ExactKnot] = []
    while after is not None:
        quiet, follows = _followed(scene, pieces, after)
        found.append(after._replace(quiet=quiet))
        after = follows
    return found


def held_pieces(scene: Scene, pieces: Sequence[ExactPiece]) -> Sequence[ExactPiece]:
    """Return the pieces with what friction can hold for b, if it depends on the place and the bodies begin stuck."""
    cells, at = cells_of(scene), scene.initial
    if cells is None or at.v1 != at.v2:
        return pieces
    held = cells.at_rest(at.x1 - at.x2) / scene.pair.b  # so long as the bodies stick it stays
    return [one.with_friction(one.b * held) for one in pieces]


def mode_at_start(scene: Scene) -> Mode:
    """Return the mode that follows the initial state of a scene; exact, every tie decided."""
    return MODES[float(exact_knots(scene, pieces_of(scene)[:1])[0].mode)]


class ExactMotion(NamedTuple):
    """The motion after a knot, exact: x1 is a polynomial of the time in the piece, plus sines with the force's phases.

    Of each sine the amplitudes in phase with it and a quarter turn ahead.
    """

    scene: Scene
    piece: ExactPiece
    knot: ExactKnot
    polynomial: list[Fraction]
    sines: list[tuple[Fraction, Fraction]]

    def body_1(self, local: Fraction) -> tuple[SineForm, SineForm]:
        """Return x1 and v1 at a time in the piece."""
        x = SineForm(polynomial_at(self.polynomial, local))
        v = SineForm(polynomial_at(_derivative(self.polynomial), local))
        for sine, (one, two) in zip(self.piece.sines, self.sines, strict=True):
            angle = sine.omega * (self.piece.start + local) + sine.phase
            x += SineForm.turned(angle, one, two)
            v += SineForm.turned(angle, -two * sine.omega, one * sine.omega)
        return x, v

    def at(self, local: Fraction) -> ExactKnot:
        """Return the knot moved to a later time in the piece."""
        knot, t = self.knot, local - self.knot.local
        x1, v1 = self.body_1(local)
        if knot.mode == 0:
            return knot._replace(local=local, x1=x1, v1=v1, x2=knot.x2 + (x1 - knot.x1), v2=v1)
        brake = knot.mode * self.piece.b / self.scene.pair.m2
        x2, v2 = knot.x2 + knot.v2 * t + brake * t * t / 2, knot.v2 + brake * t
        return knot._replace(local=local, x1=x1, v1=v1, x2=x2, v2=v2)

    def guards(self) -> list[list[Fraction]]:
        """Return the guards, which must not become negative, as polynomials of the time in the piece; without sines."""
        velocity, b, m2 = _derivative(self.polynomial), self.piece.b, self.scene.pair.m2
        if self.knot.mode == 0:
            load = [c * m2 for c in _derivative(velocity)] or [Fraction(0)]
            return [[b - side * load[0], *(-side * c for c in load[1:])] for side in (1, -1)]
        v2, brake = self.knot.v2.rational, b / m2
        if v2 is None:
            raise ArithmeticError("a slip without sines has rational velocities")
        guard = [self.knot.mode * c for c in velocity] + [Fraction(0)] * (2 - len(velocity))
        guard[0] += brake * self.knot.local - self.knot.mode * v2
        guard[1] -= brake
        return [guard]


def exact_motion(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> ExactMotion | None:
    """Return the particular motion of the mode if the state lies on it exactly, else None."""
    if knot.mode and scene.friction.weakening:
        return None  # followed in numbers only
    motion = _particular_motion(scene, piece, knot)
    return motion if motion is not None and motion.body_1(knot.local) == (knot.x1, knot.v1) else None


def _particular_motion(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> ExactMotion | None:
    """Return the motion of the mode in which nothing swings freely; None at resonance without damping.

    None, too, where more acts than u and one b: such motions are followed in numbers.
    """
    pair = scene.pair
    if not (piece.is_plain and pair.a2) or pair.is_fixed or pair.b_static:
        return None
    mass = pair.m1 if knot.mode else pair.mass
    force, sines = list(piece.polynomial) or [Fraction(0)], []
    force[0] -= knot.mode * piece.b
    for sine in piece.sines:
        stiff, drag = pair.a2 - mass * sine.omega**2, pair.a1 * sine.omega
        if stiff == 0 and drag == 0:
            return None
        scale = sine.amplitude / (stiff**2 + drag**2)
        sines.append((stiff * scale, -drag * scale))
    return ExactMotion(scene, piece, knot, particular(force, mass, pair.a1, pair.a2), sines)


def _derivative(polynomial: list[Fraction]) -> list[Fraction]:
    return [k * c for k, c in enumerate(polynomial)][1:]


def _followed(scene: Scene, pieces: Sequence[ExactPiece], knot: ExactKnot) -> tuple[Fraction, ExactKnot | None]:
    """Return up to when a mode does not end after a knot, and the next knot if it is exact."""
    piece, is_root = pieces[knot.piece], False
    motion = exact_motion(scene, piece, knot)
    lasts = _stays_below(scene, piece, knot)
    if motion is None:
        return piece.length if lasts else knot.local, None
    if lasts or (knot.mode == 0 and scene.law is Law.THREE_VALUED_SGN):
        until = piece.length
    elif piece.sines:
        return knot.local, None
    else:
        until, is_root = first_crossing(motion.guards(), knot.local, piece.length)
    if until < piece.length:
        return until, _decided(scene, pieces, motion.at(until)._replace(is_jump=False)) if is_root else None
    if knot.piece + 1 == len(pieces):
        return until, None
    # a slip that ends where a piece begins ends by itself; stick there ends by what jumps
    jumped = motion.at(until)._replace(piece=knot.piece + 1, local=Fraction(0), is_jump=knot.mode == 0 or not is_root)
    if jumped.v1 == jumped.v2:
        return until, _decided(scene, pieces, jumped)
    return until, jumped._replace(order=0, is_event=False)


def _decided(scene: Scene, pieces: Sequence[ExactPiece], at: ExactKnot) -> ExactKnot:
    """Return a knot with v1 = v2 as the start of the mode that follows there."""
    literal = scene.law is Law.THREE_VALUED_SGN
    mode, order = mode_after(scene.pair, pieces[at.piece], at.local, at.state, literal=literal)
    return at._replace(mode=mode, order=order, is_event=mode != at.mode)


def _stays_below(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> bool:
    """Return whether a load that is constant but for one oscillation never gets past b in a stick; exact.

    The oscillation is a sine of the force, or the free one of an undamped pair; it may touch b for ever.
    """
    if knot.mode or len(piece.polynomial) > 3 or len(piece.sines) > 1:
        return False
    steady, pair = _particular_motion(scene, piece, knot), scene.pair
    if steady is None:
        return False
    x, v = steady.body_1(knot.local)
    y, w, stiff = (knot.x1 - x).rational, (knot.v1 - v).rational, pair.a2 / pair.mass
    if y is None or w is None or ((y or w) and (pair.a1 or piece.sines)):
        return False
    waves = ((one**2 + two**2) * s.omega**4 for s, (one, two) in zip(piece.sines, steady.sines, strict=True))
    square = pair.m2**2 * (stiff**2 * y**2 + stiff * w**2 + sum(waves, Fraction(0)))
    room = piece.b - abs(pair.m2 * 2 * sum(steady.polynomial[2:3], Fraction(0)))
    return room >= 0 and square <= room * room
