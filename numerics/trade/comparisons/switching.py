"""The switched system as a user of an integrator writes it down: floats, one smooth field per mode, rules at v1 = v2.

Every mode is linear with a constant force. With the load F = a2 x1 + a1 v1 and held = b (m1+m2)/m2 = a2 L,

    slip of sign s:  m1 v1' = -F - b s,  m2 v2' = b s        until v1 - v2 reaches 0
    stick:           (m1+m2) v1' = (m1+m2) v2' = -F          until |F| exceeds held
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from numerics.motion.begin import mode_at_start
from numerics.motion.modes import MODES, EventKind, Mode
from numerics.scene import Law, Scene
from numerics.trade.comparisons.peer import PeerFailed, Unsupported

MAX_EVENTS = 300_000
MAX_ON_THE_SPOT = 100


@dataclass(frozen=True)
class SwitchedPair:
    """A scene in floats, SI units, with the rules of motion/modes.py (reading `filippov`) at float precision."""

    m1: float
    m2: float
    a1: float
    a2: float
    b: float
    until: float
    start: Mode
    y: tuple[float, float, float, float]

    @classmethod
    def of(cls, scene: Scene) -> SwitchedPair:
        """Return the scene in floats; the mode at t = 0 is decided on its exact numbers. Raises Unsupported."""
        if scene.law is not Law.FILIPPOV:
            raise Unsupported(f"only the law {Law.FILIPPOV.value} is written down for this integrator")
        pair, at = scene.pair, scene.initial
        m1, m2, a1, a2, b, until, *y = (
            float(value)
            for value in (pair.m1, pair.m2, pair.a1, pair.a2, pair.b, scene.until, at.x1, at.v1, at.x2, at.v2)
        )
        return cls(m1, m2, a1, a2, b, until, mode_at_start(scene), (y[0], y[1], y[2], y[3]))

    @property
    def held(self) -> float:
        """Return b (m1+m2)/m2, the largest load that friction holds in stick, N."""
        return self.b * (self.m1 + self.m2) / self.m2

    def load(self, x1: float, v1: float) -> float:
        """Return a2 x1 + a1 v1, N."""
        return self.a2 * x1 + self.a1 * v1

    def load_rate(self, x1: float, v1: float) -> float:
        """Return the time derivative of the load along the stick flow, N/s."""
        return self.a2 * v1 - self.a1 * self.load(x1, v1) / (self.m1 + self.m2)

    def accelerations(self, mode: Mode) -> tuple[float, float, float, float]:
        """Return (p1, f1, p2, f2) with v1' = f1 - p1 load and v2' = f2 - p2 load in a mode."""
        if mode is Mode.STICK:
            return 1 / (self.m1 + self.m2), 0.0, 1 / (self.m1 + self.m2), 0.0
        return 1 / self.m1, -self.b * mode.sign / self.m1, 0.0, self.b * mode.sign / self.m2

    def after(self, mode: Mode, x1: float, v1: float) -> Mode:
        """Return the mode that follows when the guard of `mode` is met at x1, v1."""
        load = self.load(x1, v1)
        if mode is Mode.STICK:
            return MODES[-1 if load > 0 else 1]
        beyond = mode.sign * load - self.held
        if beyond > 0 or (beyond == 0 and mode.sign * self.load_rate(x1, v1) > 0):
            return MODES[-mode.sign]
        return Mode.STICK

    def energy(self, x1: float, v1: float, v2: float) -> float:
        """Return E = (a2 x1^2 + m1 v1^2 + m2 v2^2)/2, J."""
        return (self.a2 * x1 * x1 + self.m1 * v1 * v1 + self.m2 * v2 * v2) / 2

    def lost(self, x1: float, v1: float, v2: float) -> float:
        """Return E(0) - E, J: what a run that does not integrate the work reports as dissipated."""
        return self.energy(self.y[0], self.y[1], self.y[3]) - self.energy(x1, v1, v2)

    @property
    def scales(self) -> tuple[float, float, float, float]:
        """Return the sizes of x1, v1, x2, v2 that E(0) allows, m and m/s: what absolute tolerances are measured by.

        A pair at rest in its middle has none; there the half width of the sliding region stands in.
        """
        energy = self.energy(self.y[0], self.y[1], self.y[3]) or self.held**2 / self.a2
        x, v1, v2 = (math.sqrt(2 * energy / value) for value in (self.a2, self.m1, self.m2))
        return x, v1, x, v2


@dataclass
class EventLog:
    """The events of a run in their order, with a stop for runs that would never end."""

    kinds: list[EventKind] = field(default_factory=list)
    times: list[float] = field(default_factory=list)
    limit: int = MAX_EVENTS
    on_the_spot: int = 0

    def add(self, kind: EventKind, t: float) -> None:
        """Note an event at time t (s). Raises PeerFailed after too many of them, or too many on the spot."""
        times = self.times
        self.on_the_spot = self.on_the_spot + 1 if times and t <= times[-1] else 0
        if self.on_the_spot >= MAX_ON_THE_SPOT:
            raise PeerFailed(f"{MAX_ON_THE_SPOT} events in a row at t = {t:.9g} s: it finds its own start again")
        if len(times) >= self.limit:
            raise PeerFailed(f"more than {self.limit} events by t = {t:.9g} s")
        self.kinds.append(kind)
        times.append(t)
