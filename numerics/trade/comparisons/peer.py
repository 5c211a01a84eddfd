"""What every integrator that is compared with ours gives back: a function `prepare(scene, setting)` makes a call.

`prepare` builds and compiles everything once; the call that it returns is what is timed, and gives a PeerRun.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class PeerRun:
    """What one run of an integrator says of a scene; SI units, approximate, in the integrator's own numbers."""

    modes: tuple[Any, ...] | None
    """The itinerary: the sign of v1 - v2 in every segment, 0 in stick; one more than there are events. On a surface
    words; None where the law is smoothed, which has no events."""
    times: tuple[Any, ...]
    """The times of the events, s."""
    final: tuple[Any, ...]
    """x1, v1, x2, v2 at the horizon, m and m/s; each by axes on a surface."""
    lost: Any
    """The energy that friction and viscosity took from t = 0 to the horizon, J; None where nobody counts it."""

    @classmethod
    def of(cls, mode: Any, events: list[tuple[Any, Any]], final: Any, lost: Any) -> PeerRun:
        """Return a run that starts in a mode and enters another one at every event (mode, t)."""
        return cls((mode, *(one for one, _ in events)), tuple(t for _, t in events), tuple(final), lost)


Call = Callable[[], PeerRun]
Extra = Any
"""What a module of the extra `comparisons` makes; it is imported late and untyped."""


class Unsupported(Exception):
    """This peer cannot run this scene; the message says why."""


class PeerFailed(RuntimeError):
    """A run that does not get to the horizon: too many steps or events, or its own error."""
