"""A trajectory under a force at any time: which row's segment holds it, and that segment's closed form."""

from __future__ import annotations

import bisect
from functools import cached_property
from typing import Any

from numerics.arithmetic.ball_words import widened
from numerics.arithmetic.protocol import Number
from numerics.flows.forced_jet import state_at
from numerics.flows.forced_records import Start
from numerics.motion.forced import driven_at
from numerics.motion.modes import MODES, Mode
from numerics.trajectory.dense import Side, exact_time
from numerics.trajectory.forced_units import unit_of_time


class ForcedDense:
    """The dense evaluation of one trajectory under a force; to be used in its arithmetic's context."""

    def __init__(self, trajectory: Any) -> None:
        """Evaluate this trajectory."""
        self._of, self._arithmetic, self._record = trajectory, trajectory.arithmetic, trajectory.record

    def _middle(self, x: Number) -> Number:
        return x.mid() if self._arithmetic.name == "ball" else x

    @cached_property
    def _starts(self) -> list[Number]:
        """Return when each row begins, s, as points."""
        return [self._middle(self._of.time_of(row)) for row in range(len(self._record.rows))]

    def time(self, t: Any) -> Number:
        """Return t as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        own, number = type(self._of.end_time), self._arithmetic.to_float
        end = float(self._of.scene.until) if self._of.reached else number(self._of.end_time)
        if own is not float and isinstance(t, own):
            if not 0 <= number(t) <= end:
                raise ValueError(f"t = {self._arithmetic.text(t)} s is outside the solved time [0, {end:g}] s")
            return t
        exact = exact_time(t)
        if not 0 <= exact <= (self._of.scene.until if self._of.reached else exact_time(end)):
            raise ValueError(f"t = {float(exact):g} s is outside the solved time [0, {end:g}] s; solve further")
        return self._arithmetic.number(exact)

    def _found(self, t: Any, side: Side) -> tuple[int, Number]:
        """Return the row whose segment holds a time, and how long after its start it is."""
        time = self.time(t)
        find = bisect.bisect_right if side == "right" else bisect.bisect_left
        row = max(0, find(self._starts, self._middle(time)) - 1)
        begin = self._of.pieces[int(self._record.rows[row][3])].start
        if time is t and not isinstance(t, float):
            since = time - self._arithmetic.number(begin)
        else:
            since = self._arithmetic.number(exact_time(t) - begin)
        return row, since - self._record.number(row, "local")

    def mode(self, t: Any, side: Side) -> Mode:
        """Return the mode at time t (s); at an event the one on the given side."""
        return MODES[float(self._record.rows[self._found(t, side)[0]][0])]

    def motion_of(self, row: int) -> Start:
        """Return the start of a row's segment, as the texts of motion/ know it."""
        code = self._record.rows[row]
        values = (self._record.number(row, name) for name in ("local", "x1", "v1", "x2", "v2", "norm", "place"))
        return Start._make((int(code[0]), int(code[4]), int(code[3]), *values, self._arithmetic.number(0)))

    def state(self, t: Any, side: Side) -> tuple[Number, ...]:
        """Return (x1, v1, x2, v2) at time t (s), m and m/s; enclosures for balls."""
        return self.after(*self._found(t, side))

    def after(self, row: int, tau: Number) -> tuple[Number, ...]:
        """Return the state at tau after the start of a row's segment."""
        followed = self._of.in_unit
        if followed is not self._of:
            number, unit = self._arithmetic.number, unit_of_time(self._of.scene)
            x1, v1, x2, v2 = followed.dense.after(row, tau * number(1 / unit))
            return x1, v1 * number(1 / unit), x2, v2 * number(1 / unit)
        start, (pair, drive) = self.motion_of(row), self._of.tables
        here = self._arithmetic.telling(state_at)(pair, drive, start, tau)
        x2, v2, _ = self._arithmetic.telling(driven_at)(pair, drive, start, here, tau)
        found = (here.x, here.v, x2, v2)
        if self._arithmetic.name != "ball":
            return found
        norm = start.norm
        x1 = norm / pair.root_a2
        place = start.place + x1 + (norm * pair.guard_norm * tau if start.mode else 0 * norm)
        bounds = x1, norm / pair.root_m1, place, norm / pair.root_m2
        return tuple(map(widened, found, bounds))
