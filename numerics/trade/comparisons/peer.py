"""What every integrator that is compared with ours gives back: a function `prepare(scene, setting)` makes a call.

`prepare` builds and compiles everything once; the call that it returns is what is timed, and gives a PeerRun.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from numerics.errors import NumericsError


@dataclass(frozen=True)
class PeerRun:
    """What one run of an integrator says of a scene; SI units, approximate, in the integrator's own numbers."""

    modes: Sequence[Any]
    """The itinerary: the sign of v1 - v2 in every segment, 0 in stick; one more than there are events. On a surface
    words; none where the law is smoothed, which has no events."""
    times: Sequence[Any]
    """The times of the events, s."""
    final: Sequence[Any]
    """x1, v1, x2, v2 at the horizon, m and m/s; each by axes on a surface."""
    lost: Any = None
    """The energy that friction and viscosity took from t = 0 to the horizon, J; None where nobody counts it."""


Call = Callable[[], PeerRun]
Extra = Any
"""What a module of the extra `comparisons` makes; it is imported late and untyped."""


class PeerFailed(NumericsError):
    """A run that does not get to the horizon: too many steps or events, or its own error."""
