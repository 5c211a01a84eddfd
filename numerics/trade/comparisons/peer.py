"""One interface for every integrator that is compared with ours: prepare once, run and be timed, return a PeerRun."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from numerics.motion.modes import EventKind
from numerics.scene import Scene


@dataclass(frozen=True)
class PeerTexts:
    """The answers of a run in a format finer than binary64, as decimal text with all its digits; SI units."""

    last_event: str | None
    """The time of the last event, s; None without events."""
    final: tuple[str, ...]
    """x1, v1, x2, v2 at the horizon, m and m/s."""
    dissipated: str
    """Energy that friction and viscosity took, J."""


@dataclass(frozen=True)
class PeerRun:
    """What one run of an integrator says of a scene; SI units, approximate."""

    kinds: tuple[EventKind, ...]
    """The kinds of its events in their order."""
    t_events: NDArray[np.float64]
    """The times of its events, s, shape (k,)."""
    y_final: NDArray[np.float64]
    """(x1, v1, x2, v2) at the horizon, m and m/s."""
    dissipated: float
    """The energy that friction and viscosity took from t = 0 to the horizon, J, as its users would compute it."""
    steps: int
    """How many steps, or accepted steps, it took."""
    elapsed: float | None = None
    """The wall time that it measured itself, s, where it runs in a process of its own; None: time the call."""
    texts: Callable[[], PeerTexts] | None = None
    """Writes the same answers with all their digits, after the clock has stopped; None: they are floats."""


class Peer(Protocol):
    """An integrator in one way of use. It models what its documentation allows and its users would write."""

    name: str
    """Of the tool and its method: "SciPy DOP853"."""
    use: str
    """The way of use in a few words: "events restarted by mode"."""
    knob: str
    """What a setting is: "rtol = atol", "step (s)"."""
    settings: tuple[float, ...]
    """The values of the knob that are worth comparing, from coarse to fine."""
    forced: bool
    """Whether it is for scenes with a force or a friction in time; the others are for free scenes."""

    def missing(self) -> str | None:
        """Return what has to be installed before it can run, in words for a reader; None if nothing is missing."""

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Build and compile everything once; the function that is returned is what is timed. Raises Unsupported."""


class Unsupported(Exception):
    """This peer cannot run this scene; the message says why."""


class PeerFailed(RuntimeError):
    """A run that does not get to the horizon: too many steps or events, events on the spot, or its own error."""


Extra = Any
"""A module of the extra `comparisons`, imported late and untyped."""
