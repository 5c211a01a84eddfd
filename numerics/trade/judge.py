"""How right a run is, held against a proved reference; every error in balls, so that 1e-1000 is a number.

- The event sequence is right if it has the reference's kinds in the reference's order, and each event's time lies
  within half the gap between the reference's event and its nearer neighbour; the start at t = 0 is a neighbour, the
  horizon is none.
- The state's error is the largest of |x_i - true|/L and |v_i - true|/(L Omega), with L = b M/(a2 m2) and
  Omega = sqrt(a2/M).
- The last event's error is that of its time, relative to the true time of the reference's last event.
- The energy's error is that of the dissipated energy, relative to the true one.
- The error of a run is the largest of the three.

All are upper bounds, as the decimal logarithm: inf where the run gives no number, None where there is nothing to
compare with (a reference without events, or without dissipation).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.motion.frame import Frame
from numerics.scene import Scene
from numerics.trade.outcome import LETTERS, Outcome

NAMES = {letter: kind.value for kind, letter in LETTERS.items()}
_MARGIN_DIGITS = 20


@dataclass(frozen=True)
class Verdict:
    """Whether the event sequence is right, the first difference if not, and the errors as decimal logarithms."""

    right: bool
    difference: str | None
    state: float | None
    last_event: float | None
    energy: float | None

    @property
    def error(self) -> float | None:
        """Return the largest of the errors that there are."""
        return max((one for one in (self.state, self.last_event, self.energy) if one is not None), default=None)

    def as_record(self) -> dict[str, Any]:
        """Return it as the object that JSON carries."""
        return finite({**asdict(self), "error": self.error})


def finite(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return a record with infinities and nan as text, which JSON has no numbers for."""
    return {
        name: str(value) if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in record.items()
    }


def judge(outcome: Outcome, reference: Outcome, digits: int, scene: Scene) -> Verdict:
    """Hold an outcome against a reference of so many digits."""
    difference = first_difference(outcome, reference)
    arithmetic = Ball(digits + _MARGIN_DIGITS)
    with arithmetic.context():
        frame = Frame(arithmetic, scene.pair)
        scales = (frame.length, frame.speed, frame.length, frame.speed)
        pairs = zip(outcome.final, reference.final, scales, strict=True)
        parts = [_log_error(found, true, scale) for found, true, scale in pairs]
        return Verdict(
            right=difference is None,
            difference=difference,
            state=max((part for part in parts if part is not None), default=None),
            last_event=_log_error(outcome.last_event, reference.last_event, None),
            energy=_log_error(outcome.dissipated, reference.dissipated, None),
        )


def _log_error(found: str | None, true: str | None, scale: arb | None) -> float | None:
    """Return log10 of an upper bound of |found - true|/scale, relative to the true value without a scale."""
    if true is None:
        return None
    proved = arb(true)
    size = abs(proved) if scale is None else scale
    if not size > 0:
        return None
    number = arb("nan" if found is None else found)
    if not number.is_finite():
        return math.inf
    bound = (abs(number - proved).upper() / size).upper()
    # through the logarithm of a ball, since the bound may be far below the range of a float
    return float((bound.log() / arb(10).log()).mid()) if bound > 0 else -float(10**9)


def first_difference(outcome: Outcome, reference: Outcome) -> str | None:
    """Return in words where the event sequence first departs from the reference's, None if it does not."""
    # the kinds first: from an exchanged kind on, times are compared with another event's
    for number, (one, other) in enumerate(zip(outcome.kinds, reference.kinds, strict=False), start=1):
        if one != other:
            return f"event {number} is {NAMES[one]}, not {NAMES[other]}"
    if len(outcome.kinds) != len(reference.kinds):
        return f"{len(outcome.kinds)} events, not {len(reference.kinds)}"
    before = [0.0, *reference.times]
    for index, (at, true) in enumerate(zip(outcome.times, reference.times, strict=True)):
        gap = true - before[index]
        if index + 1 < len(reference.times):
            gap = min(gap, reference.times[index + 1] - true)
        if not abs(at - true) <= gap / 2:
            return f"event {index + 1} is {abs(at - true):.1e} s off, its neighbour {gap:.1e} s away"
    return None
