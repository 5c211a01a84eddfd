"""What control engineers write by hand under a force: Karnopp's dead zone, and friction smoothed by tanh, in SciPy.

One call of solve_ivp over the whole run, no events. With w = v1 - v2 and the load F = u - a2 x1 - a1 v1, friction is

    Karnopp:  |w| < zone: what stick needs, m2 F/(m1+m2), cut off at +-b; outside b sgn(w)
    tanh:     b tanh(w/zone)

The zone is the setting, in units of L Omega, the speed of the pair at the edge of the sliding region. Karnopp's field
jumps, so steps are kept below a hundredth of a radian; the smoothed one is stiff and goes to LSODA. rtol is 1e-6, the
usual choice. Events are read off the steps: the pair sticks where |w| is below the zone (three zones with tanh, where
friction is at b within 0.5 %) and, with Karnopp, friction is not cut off.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib.util import find_spec
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from numerics.motion.modes import MODES, event_kind
from numerics.scene import Scene
from numerics.trade.comparisons.forced_pair import ForcedPair
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun
from numerics.trade.comparisons.switching import EventLog

Vector = NDArray[np.float64]
RTOL = 1e-6
_PLATEAU = 3.0


class HandWrittenPeer:
    """One of the two regularisations, at a width of its zone."""

    knob = "zone (L Omega)"
    settings: tuple[float, ...] = (0.1, 0.01, 1e-3)
    forced = True

    def __init__(self, kind: Literal["Karnopp", "tanh"]) -> None:
        """Take which."""
        self.kind = kind
        self.method = "RK45" if kind == "Karnopp" else "LSODA"
        self.name = "Karnopp's dead zone" if kind == "Karnopp" else "tanh smoothing"
        self.use = f"SciPy {self.method}, one call, rtol 1e-6"

    def missing(self) -> str | None:
        """Name SciPy if it is not installed."""
        return None if find_spec("scipy") else "scipy (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Write the field down. Raises Unsupported."""
        import scipy.integrate

        pair, dead = ForcedPair.of(scene), self.kind == "Karnopp"
        length = pair.held(pair.spans[0]) / pair.a2
        zone = setting * length * math.sqrt(pair.a2 / pair.mass)
        rubbed = friction(pair, zone, dead)
        size, speed = pair.scales
        options: dict[str, Extra] = {"method": self.method, "rtol": RTOL, "atol": RTOL * min(size, speed)}
        if dead:
            options["max_step"] = 0.01 * math.sqrt(pair.m1 / pair.a2)
        a1, a2, m1, m2, until = pair.a1, pair.a2, pair.m1, pair.m2, pair.spans[-1].end

        def field(t: float, y: Vector) -> list[float]:
            x1, v1, _, v2, _ = y.tolist()
            u, phi = rubbed(t, x1, v1, v2)
            return [v1, (u - a2 * x1 - a1 * v1 - phi) / m1, v2, phi / m2, phi * (v1 - v2) + a1 * v1 * v1]

        def run() -> PeerRun:
            found = scipy.integrate.solve_ivp(field, (0.0, until), [*pair.y, 0.0], **options)
            if found.status != 0:
                raise PeerFailed(f"SciPy at t = {found.t[-1]:.9g} s: {found.message}")
            limit = zone if dead else _PLATEAU * zone
            signs = [_sign(pair, rubbed, t, y, limit, dead) for t, y in zip(found.t.tolist(), found.y.T, strict=True)]
            log = EventLog()
            for n in np.flatnonzero(np.diff(signs)) + 1:
                log.add(event_kind(MODES[signs[n - 1]], MODES[signs[n]]), float(found.t[n]))
            y = found.y[:, -1]
            return PeerRun(tuple(log.kinds), np.array(log.times), y[:4].copy(), float(y[4]), len(found.t) - 1)

        return run


def friction(pair: ForcedPair, zone: float, dead: bool) -> Callable[..., tuple[float, float]]:
    """Return the function of t, x1, v1, v2 that gives u and the friction force, N."""
    spans, a1, a2, share = pair.spans, pair.a1, pair.a2, pair.m2 / pair.mass
    starts, forces = np.array([span.start for span in spans]), [span.force() for span in spans]

    def rubbed(t: float, x1: float, v1: float, v2: float) -> tuple[float, float]:
        n = max(int(np.searchsorted(starts, t, side="right")) - 1, 0)
        u, b, apart = forces[n](t), spans[n].b, v1 - v2
        if not dead:
            return u, b * math.tanh(apart / zone)
        if abs(apart) < zone:
            return u, min(max(share * (u - a2 * x1 - a1 * v1), -b), b)
        return u, math.copysign(b, apart)

    return rubbed


def _sign(
    pair: ForcedPair, rubbed: Callable[..., tuple[float, float]], t: float, y: Vector, limit: float, dead: bool
) -> int:
    """Return the mode at a step: 0 stick, +-1 slip."""
    x1, v1, _, v2, _ = y.tolist()
    apart = v1 - v2
    if abs(apart) >= limit:
        return 1 if apart > 0 else -1
    if dead:
        u, phi = rubbed(t, x1, v1, v2)
        needed = pair.m2 / pair.mass * (u - pair.a2 * x1 - pair.a1 * v1)
        if needed != phi:
            return 1 if phi > 0 else -1
    return 0
