"""What a check of a run has found: what each of its numbers is really off by, and the first event that differs."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


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
