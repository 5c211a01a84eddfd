"""What a run says, whoever made it, as text that crosses processes and carries any number of digits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from decimal import Decimal
from typing import Any

from numerics.motion.modes import EventKind

LETTERS = {EventKind.ENTRY: "n", EventKind.EXIT: "x", EventKind.CROSSING: "c"}
"""One letter an event, so that 10^5 of them stay a short text: eNtry, eXit, Crossing."""


@dataclass(frozen=True)
class Outcome:
    """The answer of one run, SI units; numbers as decimal text, enclosures as "[middle +/- radius]"."""

    kinds: str
    """The kinds of the events in their order, one letter each."""
    times: list[float]
    """The times of the events, s, rounded to binary64: enough to tell neighbours apart."""
    last_event: str | None
    """The time of the last event, s, with all its digits; None without events."""
    final: list[str]
    """x1, v1, x2, v2 at the horizon, m and m/s."""
    dissipated: str
    """Energy that friction and viscosity took, J."""
    steps: int
    """Steps, or events where nothing is stepped."""

    def as_record(self) -> dict[str, Any]:
        """Return it as the object that JSON carries."""
        return asdict(self)


def letters(kinds: Sequence[EventKind]) -> str:
    """Return event kinds as one letter each."""
    return "".join(LETTERS[kind] for kind in kinds)


def float_text(value: float) -> str:
    """Return the exact decimal expansion of a float: its shortest text may be half an ulp off."""
    return str(Decimal(float(value)))
