"""How a run begins, as far as it is known exactly: ties, touches, and jumps that meet an event.

Where the free part of a motion vanishes exactly, the state at a rational time is an exact number (sine_form.py), and
the guard under a polynomial force is a polynomial: its first root of odd multiplicity is found exactly, touches are
passed over, and a root that meets the time of a jump is recognised. Of a guard with one frequency the amplitude is
compared with b: a load that touches the edge for ever never leaves it. What is left over starts where numbers decide.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import factorial
from typing import NamedTuple

from numerics.linear.cells import cells_of
from numerics.linear.model import BELT, FIRST, V1, V2, X1
from numerics.linear.modes import MODES, Mode
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.polynomial_root import first_crossing
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode, Row, sparse
from numerics.linear.ties import applied, exact_z, mode_after, signal_form
from numerics.scene import Law, Scene

_NONE, _SINE, _COSINE = Fraction(0), (Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))


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


class ExactMotion:
    """The motion after a knot for as long as its mode lasts, exact: steady answers to sines, and what is left of it.

    `terms` are the Taylor coefficients of that, if it `ends`: then it is a polynomial of the time since the knot.
    """

    def __init__(self, scene: Scene, piece: ExactPiece, knot: ExactKnot) -> None:
        """Form them. Raises ZeroDivisionError at a resonance without damping."""
        self.knot, self.piece, self.mode = knot, piece, LinearMode(scene.pair, knot.mode, piece)
        sines, self.A = self.mode.sine_places, [dict(sparse(row)) for row in self.mode.generator()]
        self.answers = {place: self._answer(place) for place in sines}
        z = exact_z(piece, knot.mode, knot.local, knot.state)
        y = [one - two for one, two in zip(z, self.steady(z), strict=False)] + z[FIRST : sines.start]
        self.terms: list[list[SineForm]] = []
        while any(one.sign() for one in y) and len(self.terms) < len(y) + 4:
            self.terms.append(y)
            rates = (tuple(one for one in row.items() if one[0] < len(y)) for row in self.A[: len(y)])
            y = [applied(row, y) * Fraction(1, len(self.terms)) for row in rates]
        self.ends = not any(one.sign() for one in y)

    def _answer(self, sine: int) -> dict[int, tuple[Fraction, Fraction]]:
        """Return the steady answer to a sine of what stands in z: so much of the sine, and of its cosine."""
        omega, found = self.A[sine][sine + 1], {sine: _SINE, sine + 1: _COSINE}
        for V in (V1, V2):
            row = self.A[V]
            on_sine, on_cosine = (row.get(place, _NONE) for place in (sine, sine + 1))
            # in stick both bodies go together
            stiff, drag = -row.get(X1, _NONE) - omega**2, -row.get(V1, _NONE) * omega
            square = stiff**2 + drag**2
            one, two = (on_sine * stiff + on_cosine * drag) / square, (on_cosine * stiff - on_sine * drag) / square
            found |= {V - 1: (one, two), V: (-two * omega, one * omega)}
        return found

    def steady(self, z: Sequence[SineForm]) -> list[SineForm]:
        """Return x1, v1, x2, v2 of all steady answers."""
        found = [SineForm()] * FIRST
        for place, answer in self.answers.items():
            for k in range(FIRST):
                found[k] = found[k] + z[place] * answer[k][0] + z[place + 1] * answer[k][1]
        return found

    def at(self, local: Fraction) -> ExactKnot:
        """Return the knot moved to a later time in the piece."""
        state = self.steady(exact_z(self.piece, self.knot.mode, local, self.knot.state))
        for n, term in enumerate(self.terms):
            state = [one + c * (local - self.knot.local) ** n for one, c in zip(state, term, strict=False)]
        x1, v1, x2, v2 = state
        return self.knot._replace(local=local, x1=x1, v1=v1, x2=x2, v2=v2)

    def guard(self, row: Row) -> list[Fraction] | None:
        """Return the Taylor coefficients of a guard without its sines; None if they are not rational."""
        row = tuple((place, c * (self.knot.mode or 1)) for place, c in row if place < self.mode.sine_places.start)
        found = [applied(row, term).rational for term in self.terms]
        return [one for one in found if one is not None] if None not in found else None

    def guards(self) -> list[list[Fraction]] | None:
        """Return the guards, which must not become negative, as polynomials of the time since the knot, if they are."""
        found = [one for one in map(self.guard, self.mode.guards) if one is not None]
        return None if self.answers or not self.ends or len(found) < len(self.mode.guards) else found

    def stays(self) -> bool:
        """Return whether stick never ends: its guards are a constant but for one oscillation, and may touch 0 for ever.

        That is the steady answer to a sine, or the free motion of an undamped pair.
        """
        k = -self.A[V1].get(X1, _NONE) or Fraction(1)
        for row in self.mode.guards:
            terms = self.guard(row)
            if self.knot.mode or terms is None:
                return False
            terms += [_NONE] * (3 * self.ends)
            value, rate, bend, *later = (c * factorial(n) for n, c in enumerate(terms))
            if any(two + k * one for one, two in zip((rate, bend, *later), later, strict=False)):
                return False
            swing, squares = -bend / k, [(bend / k) ** 2 + rate**2 / k]
            for answer, size in zip(self.answers.values(), self.mode.amplitudes, strict=True):
                parts = (sum(c * answer[place][n] for place, c in row if place in answer) for n in (0, 1))
                squares.append(size**2 * sum(one**2 for one in parts))
            room = value - swing
            if room < 0 or sum(squares) > room**2 or sum(map(bool, squares)) > 1:
                return False
        return True


def exact_motion(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> ExactMotion | None:
    """Return the motion of the mode, None at a resonance without damping, and for what is followed in numbers only."""
    if knot.mode and scene.friction.weakening:
        return None
    try:
        return ExactMotion(scene, piece, knot)
    except ZeroDivisionError:
        return None


def _followed(scene: Scene, pieces: Sequence[ExactPiece], knot: ExactKnot) -> tuple[Fraction, ExactKnot | None]:
    """Return up to when a mode does not end after a knot, and the next knot if it is exact."""
    piece, is_root = pieces[knot.piece], False
    motion = exact_motion(scene, piece, knot)
    if motion is None:
        return knot.local, None
    lasts, guards = motion.stays() or (knot.mode == 0 and scene.law is Law.THREE_VALUED_SGN), motion.guards()
    if not motion.ends or (guards is None and not lasts):
        return piece.length if motion.stays() else knot.local, None
    until = piece.length
    if not lasts and guards is not None:
        until, is_root = first_crossing(guards, Fraction(0), until - knot.local)
        until += knot.local
    if until < piece.length:
        return until, _decided(scene, pieces, motion.at(until)._replace(is_jump=False)) if is_root else None
    if knot.piece + 1 == len(pieces):
        return until, None
    # a slip that ends where a piece begins ends by itself; stick there ends by what jumps
    jumped = motion.at(until)._replace(piece=knot.piece + 1, local=Fraction(0), is_jump=knot.mode == 0 or not is_root)
    if scene.pair.is_fixed:
        jumped = jumped._replace(v2=signal_form(pieces[jumped.piece], BELT, Fraction(0)))
    side = (jumped.v1 - jumped.v2).sign()
    if side == 0:
        return until, _decided(scene, pieces, jumped)
    return until, jumped._replace(mode=side, order=0, is_event=side != knot.mode)


def _decided(scene: Scene, pieces: Sequence[ExactPiece], at: ExactKnot) -> ExactKnot:
    """Return a knot with v1 = v2 as the start of the mode that follows there."""
    literal = scene.law is Law.THREE_VALUED_SGN
    mode, order = mode_after(scene.pair, pieces[at.piece], at.local, at.state, literal=literal)
    return at._replace(mode=mode, order=order, is_event=mode != at.mode)
