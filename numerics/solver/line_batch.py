"""The answers of scenes on a line, read off the rows that their runs wrote."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compiled
from numerics.linear.errors_of import errors_of_rows
from numerics.linear.ledger import TINY
from numerics.linear.record import AT, BOUNDS, How
from numerics.trajectory.columns import STATE, Counts, Floats
from numerics.trajectory.digits import FEW_DIGITS, ROUNDING
from numerics.trajectory.rendering import MOST_DIGITS
from numerics.trajectory.status import Status

DRAWN = ("dissipated", "energy_excess", "events", "mode", "digits", "t", *STATE)
_SENTENCES = np.array([one.sentence for one in sorted(Status)], dtype=object)


@dataclass(frozen=True, eq=False)
class Rows:
    """SI numbers (n, 10) of scenes on a line, rows that the runs wrote (linear/record.py), the shape of all answers.

    Rows are of ends, and of start and first events; in these the time counts from the start of the run. `form` writes
    to the ends what was taken where that is nan; `walls` says where a wall moves.
    """

    numbers: Floats
    ends: Floats
    kept: Floats
    shape: tuple[int, ...]
    form: Callable[[Floats], None]
    walls: Any

    def taken(self) -> Floats:
        """Return what friction and viscosity took, J, and its bound, (2, *shape)."""
        self.form(self.ends)
        friction, viscous, error, how = self.ends.T[
            [AT[name] for name in ("friction", "viscous", "ledger_error", "how")]
        ]
        found = np.where(how == How.OUT_OF_RANGE, np.nan, [friction + viscous, 2.0 * error + TINY])
        return found.reshape(2, *self.shape)

    def answers(self) -> dict[str, Any]:
        """Return the arrays of a batch by their names."""
        ends, kept, shape = self.ends, self.kept, self.shape
        how = ends[:, AT["how"]].astype(np.int64).reshape(shape)
        out, (m1, m2, a2, b, *_, until, _) = how == How.OUT_OF_RANGE, (one.reshape(shape) for one in self.numbers.T)

        def end(*names: str) -> Floats:
            return np.where(out, np.nan, ends.T[[AT[name] for name in names]].reshape(len(names), *shape))

        def event(*names: str) -> Floats:
            found = kept.T[[AT[name] for name in names], 1:].swapaxes(1, 2)
            return found.reshape(len(names), *shape, kept.shape[1] - 1)

        y, certain = end(*STATE), how < How.OUT_OF_RANGE
        x1, v1, _, v2 = y
        with np.errstate(all="ignore"):
            excess_error, worst = np.reshape(compiled(errors_of_rows)(self.numbers, kept, ends, ROUNDING), (2, *shape))
            right = np.clip(np.floor(-np.log10(np.maximum(worst, ROUNDING))), 0, MOST_DIGITS)
            energy = a2 * x1**2 / 2 + m1 * v1**2 / 2 + np.where(np.isinf(m2), 0.0, m2 * v2**2 / 2)
            excess = energy / ((b * (1 + m1 / m2)) ** 2 / (2 * a2)) - 1
        digits = np.where(certain, right, 0).astype(np.int64)
        status = np.where((how < How.EVENT_LIMIT) & (digits == 0), int(Status.NO_RIGHT_DIGIT), how)
        status = np.where(how == How.DOUBT, int(Status.SEQUENCE_OPEN), status)
        message, t = np.array(_SENTENCES[status], dtype=object), event("local")[0]
        few = (status <= Status.STUCK_FOR_EVER) & (digits <= FEW_DIGITS)
        message[few] = [
            f"{one}; right digits: only {n}; use solve(scene, digits=N)"
            for one, n in zip(message[few], digits[few], strict=True)
        ]
        return {
            "status": status,
            "message": message,
            "events": whole(end("events")[0]),
            "mode": whole(end("mode")[0]),
            "t": np.where(how < How.EVENT_LIMIT, until, end("local")[0]),
            "y": y,
            "y_error": end(*BOUNDS[1:5]),
            "digits": digits,
            "certain": certain,
            "energy_excess": np.where((a2 * b > 0) & ~self.walls, excess, np.nan),
            "energy_excess_error": np.where(out | self.walls, np.nan, excess_error),
            "event_t": t,
            "event_y": event(*STATE),
            "event_mode": whole(event("mode")[0]),
            "event_t_error": event("late")[0] + 4 * ROUNDING * t,
            "event_y_error": event(*BOUNDS[1:5]),
        }


def whole(numbers: Floats) -> Counts:
    """Return whole numbers, 0 for nan."""
    return np.nan_to_num(numbers).astype(np.int64)
