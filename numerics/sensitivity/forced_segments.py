"""One segment of a run under a force over dual numbers; and its field, y' = (v1, v1', v2, v2')."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple

from numerics.arithmetic.ball_words import widened
from numerics.arithmetic.dual import Dual
from numerics.arithmetic.dual_number import DualNumber
from numerics.arithmetic.protocol import Number
from numerics.flows.forced_jet import load_at, push_at, state_at
from numerics.flows.forced_records import Start
from numerics.motion.forced import driven_at
from numerics.sensitivity.forced_parameters import OWN, LocalPiece, local_piece


class Partial(NamedTuple):
    """Partial derivatives of x1, v1, x2, v2 (4, n) and of the guard (n,) at the end of a segment; names from OWN on."""

    state: Any
    guard: Any
    names: list[str]


class Segments:
    """The segments of a trajectory; to be used in the dual arithmetic's context."""

    def __init__(self, trajectory: Any, arithmetic: Dual) -> None:
        """Read this trajectory."""
        self.of, self.arithmetic, self.record = trajectory, arithmetic, trajectory.record
        self.pair, self.drive = trajectory.tables
        self.modes, self.pieces, self.events = (
            [int(one) for one in self.record.codes(name)] for name in ("mode", "piece", "event")
        )
        self._known: tuple[int, LocalPiece] | None = None
        self._known_units: dict[int, Any] = {}

    @cached_property
    def zero(self) -> Number:
        """Return 0."""
        return self.arithmetic.base.number(0)

    def array(self, values: Any) -> Any:
        """Return numbers as an array."""
        return self.arithmetic.array(values)

    def local(self, row: int) -> Number:
        """Return the time in the piece at which the segment of a row begins, s; in balls it encloses the true one."""
        found = self.record.number(row, "local")
        return widened(found, self.record.number(row, "late")) if self.arithmetic.name == "ball" else found

    def length(self, row: int) -> Number:
        """Return how long the segment of a row lasts, s."""
        piece, after = self.pieces[row], row + 1
        if after < len(self.modes) and self.pieces[after] == piece:
            return self.local(after) - self.local(row)
        return self.whole(piece) - self.local(row)

    def whole(self, piece: int) -> Number:
        """Return how long a piece lasts, s."""
        return self.drive.numbers[self.drive.places[piece][0] + 1]

    def friction(self, piece: int) -> Number:
        """Return b in a piece, N."""
        return self.drive.numbers[self.drive.places[piece][0] + 2]

    def force(self, piece: int, local: Number) -> Number:
        """Return u at a time in a piece, N."""
        return self.arithmetic.base.telling(push_at)(self.drive, piece, local).u0

    def field(self, state: Any, u: Number, b: Number, mode: int | None) -> Any:
        """Return y' in a mode; None: in that which follows v1 = v2."""
        pair, (x1, v1, _, v2) = self.pair, state
        pull = u - pair.a2 * x1 - pair.a1 * v1
        push = mode * b if mode else pair.m2 / pair.mass * pull
        if mode is None:
            push = push.min(b).max(-b) if self.arithmetic.name == "ball" else max(-b, min(b, push))
        return self.array([v1, (pull - push) / pair.m1, v2, push / pair.m2])

    def partial(self, row: int, side: int) -> Partial:
        """Return the partial derivatives at the end of the segment of a row; `side`: that at which stick ends, or 0."""
        here, mode, told = self._local_piece(self.pieces[row]), self.modes[row], self.arithmetic.telling
        count = OWN + len(here.names)
        given = [*self.of.enclosed(row), self.local(row), self.length(row)]
        x1, v1, x2, v2, local, tau = map(DualNumber, given, self._units(count))
        none = DualNumber(self.zero)
        start = Start(mode, 0, 0, local, x1, v1, x2, v2, none, none, none)
        moved = told(state_at)(here.pair, here.drive, start, tau)
        x2, v2, _ = told(driven_at)(here.pair, here.drive, start, moved, tau)
        if mode:
            guard = moved.v - v2
        else:
            load = told(load_at)(here.pair, here.drive, 0, local + tau, moved.x, moved.v)
            guard = here.drive.numbers[2] - side * load
        rows = [self._row(one, count) for one in (moved.x, moved.v, x2, v2, guard)]
        return Partial(self.array(rows[:4]), rows[4], here.names)

    def _units(self, count: int) -> Any:
        """Return so many derivatives of each of a segment's own numbers."""
        if count not in self._known_units:
            one = self.arithmetic.base.number(1)
            self._known_units[count] = [
                self.array([one if k == index else self.zero for k in range(count)]) for index in range(OWN)
            ]
        return self._known_units[count]

    def _row(self, x: DualNumber, count: int) -> Any:
        return self.array([self.zero] * count) if x.gradient is None else x.gradient

    def _local_piece(self, piece: int) -> LocalPiece:
        """Return a piece over dual numbers; segments in a row often share it."""
        if self._known is None or self._known[0] != piece:
            self._known = piece, local_piece(self.of.scene, self.of.pieces[piece], self.arithmetic)
        return self._known[1]
