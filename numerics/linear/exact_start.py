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

from numerics.linear.cells import PLAIN, cells_of, first_mode
from numerics.linear.model import BELT, FIRST, V1, V2, X1
from numerics.linear.modes import MODES, Mode
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.polynomial_root import first_crossing
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode, Row, sparse
from numerics.linear.ties import applied, exact_z, mode_after, signal_form
from numerics.scene import Law, Scene

_NONE = Fraction(0)


class ExactKnot(NamedTuple):
    """The start of a segment, exact: where in which piece, the state, what follows, and why.

    `mode` follows with `order` derivatives of its guard vanishing; up to `quiet`, a time in the piece (s), it does
    not end. Where friction depends on the state it begins in a `cell`, with so many of the guards of that (cells.py).
    """

    piece: int
    local: Fraction
    state: tuple[SineForm, ...]
    """x1, v1, x2, v2"""
    mode: int
    order: int
    is_event: bool
    is_jump: bool
    quiet: Fraction
    cell: tuple[int, int] = PLAIN
    orders: tuple[int, int] = (0, 0)

    @property
    def gap(self) -> SineForm:
        """Return v1 - v2."""
        return self.state[V1] - self.state[V2]


def exact_knots(scene: Scene, pieces: Sequence[ExactPiece]) -> list[ExactKnot]:
    """Return the segments that are known exactly, in order; the last one goes on in numbers."""
    at, cells = scene.initial, cells_of(scene)
    x1, v1, x2, v2 = (SineForm(one) for one in (at.x1, at.v1, at.x2, at.v2))
    if scene.pair.is_fixed:
        v2 = signal_form(pieces[0], BELT, Fraction(0))
    state, side = (x1, v1, x2, v2), (v1 - v2).sign()
    knot = ExactKnot(0, Fraction(0), state, side, 0, False, True, Fraction(0))
    if side == 0:
        knot = _decided(scene, pieces, knot)._replace(is_event=False)
    after: ExactKnot | None = knot
    found: list[ExactKnot] = []
    while after is not None:
        cell, orders = PLAIN, (after.order, 0)
        if cells is not None:
            cell, orders = cells.start(pieces[after.piece], after.mode, after.local, after.state, after.order)
        quiet, follows = _followed(scene, pieces, after)
        found.append(after._replace(quiet=quiet, cell=cell, orders=orders))
        after = follows
    return found


def mode_at_start(scene: Scene) -> Mode:
    """Return the mode that follows the initial state of a scene; exact, every tie decided."""
    return MODES[float(exact_knots(scene, pieces_of(scene)[:1])[0].mode)]


class ExactMotion:
    """The motion after a knot for as long as its mode lasts, exact: steady answers to sines, and what is left of it.

    `terms` are the Taylor coefficients of that, if it `ends`: then it is a polynomial of the time since the knot.
    """

    def __init__(self, mode: LinearMode, knot: ExactKnot) -> None:
        """Form them. Raises ZeroDivisionError at a resonance without damping."""
        self.knot, self.mode, self.first = knot, mode, mode.sine_places.start
        self.A = [dict(sparse(row)) for row in mode.generator()]
        self.steady = self._steady()
        """Of x1, v1, x2, v2 the rows of the steady answers."""
        z = self.z(knot.local)
        y = [one - applied(row, z) for one, row in zip(z, self.steady, strict=False)] + z[FIRST : self.first]
        self.terms: list[list[SineForm]] = []
        while any(one.sign() for one in y) and len(self.terms) < len(y) + 4:
            self.terms.append(y)
            rates = (tuple(one for one in row.items() if one[0] < len(y)) for row in self.A[: len(y)])
            y = [applied(row, y) * Fraction(1, len(self.terms)) for row in rates]
        self.ends = not any(one.sign() for one in y)

    def z(self, local: Fraction) -> list[SineForm]:
        """Return z at a time in the piece, with the state of the knot."""
        return exact_z(self.mode.piece, self.knot.mode, local, self.knot.state)

    def _steady(self) -> list[Row]:
        rows: list[dict[int, Fraction]] = [{} for _ in range(FIRST)]
        for sine in self.mode.sine_places:
            omega = self.A[sine][sine + 1]
            for V in (V1, V2):
                row = self.A[V]
                on_sine, on_cosine = (row.get(place, _NONE) for place in (sine, sine + 1))
                # in stick both bodies go together
                stiff, drag = -row.get(X1, _NONE) - omega**2, -row.get(V1, _NONE) * omega
                square = stiff**2 + drag**2
                one, two = (on_sine * stiff + on_cosine * drag) / square, (on_cosine * stiff - on_sine * drag) / square
                rows[V - 1] |= {sine: one, sine + 1: two}
                rows[V] |= {sine: -two * omega, sine + 1: one * omega}
        return [tuple(row.items()) for row in rows]

    def at(self, local: Fraction) -> ExactKnot:
        """Return the knot moved to a later time in the piece."""
        z, since = self.z(local), local - self.knot.local
        state = (
            sum((term[k] * since**n for n, term in enumerate(self.terms)), applied(row, z))
            for k, row in enumerate(self.steady)
        )
        return self.knot._replace(local=local, state=tuple(state))

    def guard(self, row: Row) -> list[Fraction] | None:
        """Return the Taylor coefficients of a guard without its sines; None if they are not rational."""
        row = tuple((place, c * (self.knot.mode or 1)) for place, c in row if place < self.first)
        found = [applied(row, term).rational for term in self.terms]
        return [one for one in found if one is not None] if None not in found else None

    def guards(self) -> list[list[Fraction]] | None:
        """Return the guards, which must not become negative, as polynomials of the time since the knot, if they are."""
        found = [one for one in map(self.guard, self.mode.guards) if one is not None]
        has_waves = self.first < self.mode.size
        return None if has_waves or not self.ends or len(found) < len(self.mode.guards) else found

    def stays(self, strictly: bool = False) -> bool:
        """Return whether stick never ends: its guards are a constant but for one oscillation, and may touch 0 for ever.

        That is the steady answer to a sine, or the free motion of an undamped pair. With `strictly` they may not touch.
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
            waves = [_NONE] * self.mode.size
            for place, c in row:
                for at, answer in self.steady[place] if place < FIRST else ((place, 1),):
                    waves[at] += c * answer
            amplitudes = zip(self.mode.sine_places, self.mode.amplitudes, strict=True)
            squares += [size**2 * (waves[n] ** 2 + waves[n + 1] ** 2) for n, size in amplitudes]
            room = value - swing
            is_over = sum(squares) >= room**2 if strictly else sum(squares) > room**2
            if room < 0 or is_over or sum(map(bool, squares)) > 1:
                return False
        return True


def exact_motion(scene: Scene, piece: ExactPiece, knot: ExactKnot) -> ExactMotion | None:
    """Return the motion of the mode, None at a resonance without damping, and for what is followed in numbers only."""
    if knot.mode and scene.friction.weakening:
        return None
    try:
        return ExactMotion(first_mode(scene, piece, knot.mode), knot)
    except ZeroDivisionError:
        return None


def _followed(scene: Scene, pieces: Sequence[ExactPiece], knot: ExactKnot) -> tuple[Fraction, ExactKnot | None]:
    """Return up to when a mode does not end after a knot, and the next knot if it is exact."""
    piece, is_root = pieces[knot.piece], False
    motion = exact_motion(scene, piece, knot)
    if motion is None:
        return knot.local, None
    stays, guards = motion.stays(), motion.guards()
    lasts = stays or (knot.mode == 0 and scene.law is Law.THREE_VALUED_SGN)
    if not motion.ends or (guards is None and not lasts):
        return piece.length if stays else knot.local, None
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
        jumped = jumped._replace(state=(*jumped.state[:V2], signal_form(pieces[jumped.piece], BELT, Fraction(0))))
    side = jumped.gap.sign()
    if side == 0:
        return until, _decided(scene, pieces, jumped)
    return until, jumped._replace(mode=side, order=0, is_event=side != knot.mode)


def _decided(scene: Scene, pieces: Sequence[ExactPiece], at: ExactKnot) -> ExactKnot:
    """Return a knot with v1 = v2 as the start of the mode that follows there."""
    mode, order = 0, 0
    if scene.law is not Law.THREE_VALUED_SGN:
        mode, order = mode_after(first_mode(scene, pieces[at.piece], 0), at.local, at.state)
    return at._replace(mode=mode, order=order, is_event=mode != at.mode)
