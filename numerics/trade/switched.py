"""A scene as a user of an integrator writes it down: y' = B y in slip and in stick, in coordinates that lose nothing.

The matrices are those of linear/model.py. Towards one edge of the sliding region, s = +1 or -1 (in slip the sign of
v1 - v2), all but the friction signal is multiplied by s, so that slip + stands for both slips. The coordinates are

    b_static - Lambda,   b_static + Lambda,   v1 - v2,   v1,   x1,   x2,   and the signals of z

In slip the third falls to 0 at the event; in stick the first or the second does. At an exit two of them are 0 exactly,
and the rates are formed of these, so a slip of any length can be computed to full relative accuracy.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from operator import add, mul
from typing import Any, NamedTuple

import numpy as np

from numerics.errors import NumericsError
from numerics.linear.exact_start import mode_at_start
from numerics.linear.model import BELT, FIRST, FRICTION, SLIP, STICK, V1, V2, X1, X2, Layout, exact_rows
from numerics.linear.modes import MODES
from numerics.linear.pieces import ExactPiece, pieces_of
from numerics.linear.sine_form import SineForm
from numerics.linear.ties import exact_z, signal_form
from numerics.scene import Law, Pair, Scene
from numerics.trade.judge import Call, Run

Number = Any
"""A number of the integrator's format: float or numpy.longdouble."""
Row = list[tuple[int, Number]]
"""A linear function of y: places and coefficients."""
NEAR, FAR, APART, SPEED, FIRST_X, SECOND_X, SIGNALS = range(7)
"""The coordinates: the guards of stick and of slip, v1, x1, x2, and where those of the signals begin."""
MAX_ARCS = 300_000
_BITS = 192


class PeerFailed(NumericsError):
    """A run that does not get to the horizon: too many steps or events, or its own error."""


def unknown(scene: Any) -> str | None:
    """Return in words what is written down here of no such scene; None where it is known."""
    if not isinstance(scene, Scene):
        return "a surface"
    if scene.law is not Law.FILIPPOV:
        return f'law = "{scene.law.value}"'
    if not (scene.pair.a2 and scene.pair.b):
        return "a2 = 0 or b = 0"
    return "friction that depends on the state" if scene.friction.weakening else None


class Matrices(NamedTuple):
    """What a pair, and number and frequencies of the terms of its signals, make of a scene."""

    to_y: Any
    """The rows of y in z, exact."""
    rates: list[list[Row]]
    """B, of slip and of stick."""
    bends: list[Row]
    """The first three derivatives of v1 - v2 in slip."""
    width: Row
    """2 b_static, the sum of the first two coordinates."""
    signs: list[int]
    """What y is multiplied by towards the other edge, where the first two change places."""

    def y_of(self, piece: ExactPiece, local: Fraction, *state: SineForm) -> Any:
        """Return y at a time in a piece (s), of a state, else of what is 0 but for the velocity of a belt; exact."""
        moves = state or [SineForm()] * 3 + [signal_form(piece, BELT, local)]
        return np.array(exact_z(piece, 1, local, moves), dtype=object) @ self.to_y.T

    def turned(self, y: Sequence[Number]) -> list[Number]:
        """Return the coordinates towards the other edge."""
        return [y[FAR], y[NEAR], *map(mul, self.signs, y[APART:])]

    def falls(self, y: Sequence[Number]) -> bool:
        """Return whether the bodies that stick get nearer to the edge."""
        return bool(dot(self.rates[STICK][NEAR], y) < 0)

    def after_contact(self, y: Sequence[Number]) -> int:
        """Return the mode after v1 = v2: 0, or 1 for a slip towards this edge, -1 towards the other one.

        Exactly on an edge the bodies part if the load goes on outwards along stick; where it turns back they stick.
        """
        for side, gap in ((1, y[NEAR]), (-1, y[FAR])):
            if gap < 0 or (gap == 0 and self.falls(y if side > 0 else self.turned(y))):
                return side
        return 0


def dot(row: Row, y: Sequence[Number]) -> Number:
    """Return the value of a row."""
    value = 0 * y[0]
    for k, c in row:
        value += c * y[k]
    return value


@cache
def matrices(pair: Pair, layout: Layout, kind: type) -> Matrices:
    """Return the matrices of a pair under signals of a layout: formed exactly, and rounded once."""

    def row(numbers: Any) -> Row:
        exact = ((k, Fraction(c)) for k, c in enumerate(numbers) if c)
        return [(k, kind(str(c.numerator)) / kind(str(c.denominator))) for k, c in exact]

    rows, unit = exact_rows(pair, layout), np.eye(layout.size, dtype=int).astype(object)
    near, far = rows.guards[STICK]
    to_y = np.array([near, far, *rows.guards[SLIP][:1], unit[V1], unit[X1], unit[X2], *unit[FIRST:]])
    to_z = np.eye(len(to_y), dtype=int).astype(object)[[NEAR, SPEED, SECOND_X, SPEED, *range(SIGNALS, len(to_y))]]
    to_z[X1, SPEED], to_z[X1, SIGNALS:], to_z[V2, APART] = -near[V1], -near[FIRST:], -1
    to_z[X1] /= near[X1]
    slip, stick = (to_y @ rows.A[mode] @ to_z for mode in (SLIP, STICK))
    bends = (slip[APART], slip[APART] @ slip, slip[APART] @ slip @ slip)
    first, terms, sines, waves = layout.blocks[FRICTION]
    friction = {*range(first, first + terms), *range(sines, sines + 2 * waves)}
    signs = [-1] * (SIGNALS - APART) + [1 if k in friction else -1 for k in range(FIRST, layout.size)]
    return Matrices(to_y, [[*map(row, slip)], [*map(row, stick)]], [*map(row, bends)], row((near + far) @ to_z), signs)


class SwitchedPair:
    """A scene in an integrator's own numbers, SI units."""

    def __init__(self, scene: Scene, kind: type = float) -> None:
        """Take a scene of Filippov's law; the mode at t = 0 is decided on exact numbers."""
        pair, at, self.kind, self.mode = scene.pair, scene.initial, kind, mode_at_start(scene).sign
        self.quick = 0.5 * math.sqrt(pair.m1 / pair.a2)
        """Half a radian of slip, s."""
        self.spans = list[tuple[Number, Number, Matrices, list[Number]]]()
        """Of each piece of the signals where it begins, its length and matrices; what is added to y there."""
        before, moves = [SineForm()] * SIGNALS, [SineForm(one) for one in (at.x1, at.v1, at.x2, at.v2)]
        for piece in pieces_of(scene):
            own = matrices(pair, piece.layout, kind)
            begun = own.y_of(piece, Fraction(0), *moves)
            begun[:SIGNALS] -= before[:SIGNALS]
            exact = (SineForm(piece.start), SineForm(piece.length), *begun)
            start, length, *y = (kind(one.enclosed(_BITS).str(40, radius=False)) for one in exact)
            self.spans.append((start, length, own, y))
            before, moves = own.y_of(piece, piece.length), []
        force = max(float(abs(y[NEAR]) + abs(y[FAR])) for *_, y in self.spans)
        speed = force / math.sqrt(pair.m1 * pair.a2) + abs(float(at.v1)) + abs(float(at.v2))
        length = force / float(pair.a2) + abs(float(at.x1))
        self.sizes = [force, force, speed, speed, length, length]
        """Of the coordinates before the signals: what absolute tolerances are measured by."""

    def first_step(self, own: Matrices, y: Sequence[Number]) -> tuple[float, float]:
        """Return a step off the surface that ends within the slip, and when v1 - v2 comes back by its series, s.

        It starts as c1 t + c2 t^2/2 + c3 t^3/6; where it leaves steeply it is not asked, and the second number is 0.
        """
        c1, c2, c3 = (float(dot(row, y)) for row in own.bends)
        if c1 > abs(c2) * self.quick:
            return self.quick, 0.0
        inner = c2 * c2 / 4 - 2 * c1 * c3 / 3
        back = 3 * (-c2 / 2 - math.sqrt(inner)) / c3 if c3 < 0 <= inner else math.inf
        return min(back / 2, self.quick), back


Arc = Callable[[Matrices, bool, list[Number], Number], tuple[bool, Number, list[Number]]]
"""An integrator of both modes: from matrices, slip or not, coordinates and the time that is left (s), to whether it met
its event, the time that has passed and the coordinates there. It may stop before where the load turns back. Raises
PeerFailed."""


def switched(integrator: Callable[[SwitchedPair, float], Arc], kind: type = float) -> Callable[[Scene, float], Call]:
    """Return what prepares an integrator, in numbers of a format: it compiles once, and each call solves the scene."""

    def prepare(scene: Scene, setting: float) -> Call:
        pair = SwitchedPair(scene, kind)
        arc = integrator(pair, setting)
        return lambda: run(pair, arc)

    return prepare


def run(pair: SwitchedPair, arc: Arc) -> Run:
    """Run from event to event and from jump to jump. Raises PeerFailed."""
    s, mode, arcs, y = 1, pair.mode, 0, [pair.kind(0)] * SIGNALS
    modes, times, states = [mode], list[Number](), list[tuple[Number, ...]]()

    def note() -> None:
        """Keep the state."""
        states.append((s * y[FIRST_X], s * y[SPEED], s * y[SECOND_X], s * (y[SPEED] - y[APART])))

    for start, length, own, jumps in pair.spans:
        begun = jumps if s > 0 else own.turned(jumps)
        t, turns, y = pair.kind(0), False, [*map(add, y[:SIGNALS], begun), *begun[SIGNALS:]]
        after = s * (int(np.sign(y[APART])) or own.after_contact(y)) if states else mode
        while True:
            if after != mode or not states:
                note()
            if after != mode:
                modes.append(after)
                times.append(start + t)
            mode = after
            if t >= length:
                break
            side = mode or (s if own.falls(y) and not turns else -s)
            if side != s:
                y, s = own.turned(y), side
            left, arcs = length - t, arcs + 1
            met, taken, y = arc(own, mode != 0, y, left)
            t, turns = length if taken >= left else t + taken, not met
            if arcs > MAX_ARCS:
                raise PeerFailed(f"{len(times)} events by t = {start + t:.9g} s in {arcs} arcs")
            if met:
                y[APART] = pair.kind(0)
                if mode == 0:
                    y, s = (y, s) if y[NEAR] < y[FAR] else (own.turned(y), -s)
                    y[NEAR], y[FAR], after = pair.kind(0), dot(own.width, y), s
                else:
                    after = s * own.after_contact(y)
    note()
    return Run([MODES[one].value for one in modes], times, states)
