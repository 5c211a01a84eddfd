"""What a run says, whoever made it, as text that crosses processes and carries any number of digits."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from decimal import Decimal
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.motion.modes import EventKind
from numerics.trajectory.comparison import as_fraction
from numerics.trajectory.trajectory import Trajectory

LETTERS = {EventKind.ENTRY: "n", EventKind.EXIT: "x", EventKind.CROSSING: "c"}
"""One letter an event, so that 10^5 of them stay a short text: eNtry, eXit, Crossing."""
_SPARE_DIGITS = 30


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


def trajectory_outcome(trajectory: Trajectory, write: Callable[[Any, int], str]) -> Outcome:
    """Return a trajectory as text; what it lost was summed slip by slip, where the difference of energies cancels."""
    arithmetic, record, times = trajectory.arithmetic, trajectory.record, trajectory.event_times
    with arithmetic.context():
        if trajectory.scene.is_forced:
            lost = trajectory.ledger.friction + trajectory.ledger.viscous
        else:
            lost = trajectory.units[2] * (record.end("spent") + record.end("damped"))
        digits = arithmetic.digits + _SPARE_DIGITS
        return Outcome(
            kinds=letters(trajectory.event_kinds),
            times=[float(arithmetic.to_float(t)) for t in times],
            last_event=write(times[-1], digits) if len(times) else None,
            final=[write(value, digits) for value in trajectory.final_state],
            dissipated=write(lost, digits),
            steps=len(times),
        )


def number_text(value: Any, digits: int) -> str:
    """Return a float exactly, an mpmath number or the middle of a ball with this many digits."""
    if isinstance(value, float):
        return float_text(value)
    if not isinstance(value, arb):
        exact = as_fraction(value)
        with Ball(digits).context():
            value = arb(exact.numerator) / arb(exact.denominator)
    return str(value.mid().str(digits, radius=False))
