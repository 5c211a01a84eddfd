"""A trajectory held against one of balls: each of its events, and what a check finds that its numbers are off by."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from fractions import Fraction
from itertools import zip_longest
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.protocol import Number
from numerics.errors import NumericsError
from numerics.linear.modes import MODES


class SequenceDiffers(NumericsError):
    """A point arithmetic lost or invented an event; the balls' sequence is the proved one."""


@dataclass(frozen=True)
class Off:
    """The number of a quantity that is off the most; where some are off by more than their bounds, the most of those.

    `event`: counted from 1, None at the end. `error`: at most so much is it really off. `bound`: what the run said,
    None where it said nothing. `within`: whether it is not proved to be off by more.
    """

    quantity: str
    unit: str
    event: int | None
    error: float
    bound: float | None
    within: bool


@dataclass(frozen=True)
class Difference:
    """The first event that is not the true one, counted from 1; 0 is the start.

    Times (s), and the modes from then on, of the run and in truth; None of one that has no such event.
    """

    event: int
    t: float | None
    mode: str | None
    true_t: float | None
    true_mode: str | None

    def __str__(self) -> str:
        """Return it as a sentence."""
        pairs = ((self.mode, self.t), (self.true_mode, self.true_t))
        said, true = ("no such event" if mode is None else f"{mode} from {t:.12g} s on" for mode, t in pairs)
        return f"event {self.event} differs: {said}; in truth {true}"


@dataclass(frozen=True)
class Check:
    """What a run is really off by, quantity by quantity, held against balls of so many right digits.

    Where an event differs, the events before it are compared, and nothing at the end.
    """

    arithmetic: str
    digits: int
    events: int
    difference: Difference | None
    off: tuple[Off, ...]

    @property
    def right(self) -> bool:
        """Return whether the events are the true ones and no number is off by more than its bound."""
        return self.difference is None and all(one.within for one in self.off)

    def to_dict(self) -> dict[str, Any]:
        """Return it as what JSON holds."""
        return {"right": self.right} | asdict(self)

    def __str__(self) -> str:
        """Return it as a table below a sentence."""
        beyond = ", ".join(one.quantity for one in self.off if not one.within)
        events, compared = f"all {self.events} events are the true ones", "no number is off by more than its bound"
        if self.difference:
            events, compared = f"the sequence of events is wrong: {self.difference}", f"before it {compared}"
        if beyond:
            compared = f"off by more than the bound: {beyond}"
        if not self.off:
            return f"{self.arithmetic} against balls of {self.digits} digits: {events}; no number could be compared"
        lines = [
            f"{self.arithmetic} against balls of {self.digits} digits: {events}; {compared}",
            f"{'':15}{'really off by':18}{'bound':18}worst at",
        ]
        for one in self.off:
            bound = "none" if one.bound is None else f"{one.bound:.2g} {one.unit}"
            where = "the end" if one.event is None else f"event {one.event}"
            wrong = "" if one.within else ": MORE THAN THE BOUND"
            lines.append(f"{one.quantity:15}{f'{one.error:.2g} {one.unit}':18}{bound:18}{where}{wrong}")
        return "\n".join(lines)


def as_fraction(value: Number) -> Fraction:
    """Return the exact rational value of a float of any format, of a rational or of an mpmath number."""
    if hasattr(value, "man_exp"):
        mantissa, exponent = value.man_exp
        sign = -1 if value < 0 else 1
        return sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return Fraction(*value.as_integer_ratio())


def as_ball(value: Number) -> arb:
    """Return a ball that holds a number of any arithmetic, in the present precision; a ball as it is."""
    return value if isinstance(value, arb) else Ball.number(as_fraction(value))


def require_same_sequence(points: Any, balls: Any) -> None:
    """Raise SequenceDiffers, naming the first event at which the two itineraries part."""
    if difference := first_difference(points, balls):
        raise SequenceDiffers(f"{points.arithmetic.name}: {difference}; use ball arithmetic")


def first_difference(run: Any, truth: Any) -> Difference | None:
    """Return the first event after which the modes of two runs differ, or which one of them does not have."""
    for event, (one, two) in enumerate(zip_longest(run.signs, truth.signs)):
        if one != two:
            return Difference(event, *_after(run, event), *_after(truth, event))
    return None


def _after(run: Any, event: int) -> tuple[float | None, str | None]:
    """Return when an event is, s, and the mode from then on; None for one that is not there."""
    if event > len(run.event_times):
        return None, None
    return float(as_ball(run.event_times[event - 1]).mid()) if event else 0.0, MODES[run.signs[event]].value


def distance(value: Number, ball: arb) -> arb:
    """Return an enclosure of |value - true|, for a point number and the ball that holds the true one."""
    return abs(ball - as_ball(value))
