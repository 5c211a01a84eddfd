"""A pair on n axes, or with friction of its speed, as a user of an integrator writes it down: y = (q1, v1, q2, v2).

    f = B^2 s/h(s) (1 + slope |s|/b),  h(s) = |B s|,  s = v1 - v2,  Lam = M2 (M1 + M2)^-1 (u - A2 q1 - A1 v1)

Smoothed, by heyoka: h(s)^2 + (b eps)^2 in the place of h(s)^2; eps is the setting, by the pair's own speed, and about
the error. There are no events.
By events, by SciPy on a surface: stick until |B^-1 Lam| rises to 1; slip until h(s) is down to a tenth of the root of
the tolerance with Lam inside K, from where the time left is -h/h' but for O(h^2). A slip begins along B^-2 Lam; its
direction is frozen for a first step, since h(0) = 0.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.scene import Scene
from numerics.trade.comparisons.peer import Call, PeerFailed, PeerRun

Vector = Any
"""An array of numbers, or of heyoka's expressions."""


class Direct:
    """The numbers of a scene on n axes; one axis is the line."""

    def __init__(self, scene: Any) -> None:
        """Convert a scene of one piece: sines from t = 0 on, one b, and on a line perhaps one slope of it by speed."""
        pair, line = scene.pair, isinstance(scene, Scene)
        forces, at = ((scene.force,), scene.initial) if line else (scene.force, scene)
        weakening = scene.friction.weakening if line else None
        self.m1, self.m2, self.b = (np.atleast_1d(np.array(one, float)) for one in (pair.m1, pair.m2, pair.b))
        self.a1, self.a2 = (np.atleast_2d(np.array(one, float)) for one in (pair.a1, pair.a2))
        self.start = np.hstack([np.array(one, float) for one in (at.x1, at.v1, at.x2, at.v2)])
        self.waves = [[wave for piece in one.pieces for wave in piece.sines] for one in forces]
        self.until = float(scene.until)
        mass, springs = self.m1 + self.m2, np.diag(self.a2)
        self.share, self.time = self.m2 / mass, math.sqrt(max(mass / springs))
        self.speed = max(self.b / self.share / springs) / self.time
        self.slope = float(weakening.last_slope) / self.b[0] if weakening else 0.0

    def load(self, t: Any, y: Vector, sin: Any = math.sin) -> Vector:
        """Return Lam."""
        q, v, *_ = np.split(y, 4)
        u = [
            sum((float(one.amplitude) * sin(float(one.omega) * t + float(one.phase)) for one in waves), 0 * t)
            for waves in self.waves
        ]
        return self.share * (np.array(u) - self.a2 @ q - self.a1 @ v)

    def friction(self, s: Vector, least: float = 0.0, sqrt: Any = math.sqrt) -> Any:
        """Return f, with h(s)^2 + least for h(s)^2."""
        h = sqrt(sum((self.b * s) ** 2) + least)
        return self.b**2 * s * ((1.0 + self.slope * h / self.b[0]) / h)

    def rates(self, load: Vector, y: Vector, f: Vector) -> Vector:
        """Return y'."""
        _, v1, _, v2 = np.split(y, 4)
        return np.concatenate([v1, (load / self.share - f) / self.m1, v2, f / self.m2])


def slip(y: Vector) -> Vector:
    """Return s."""
    _, v1, _, v2 = np.split(y, 4)
    return v1 - v2


def smoothed(scene: Any, eps: float) -> Call:
    """Prepare heyoka for the smoothed law."""
    import heyoka as hy

    pair = Direct(scene)
    y = np.array(hy.make_vars(*(f"y{k}" for k in range(len(pair.start)))))
    friction = pair.friction(slip(y), (eps * pair.speed * max(pair.b)) ** 2, hy.sqrt)
    system = list(zip(y, pair.rates(pair.load(hy.time, y, hy.sin), y, friction), strict=True))
    one = hy.taylor_adaptive(system, pair.start, tol=1e-15)  # its steps are many: coarser ones add up

    def run() -> PeerRun:
        one.time, one.state[:] = 0.0, pair.start
        outcome = one.propagate_until(pair.until)[0]
        if outcome != hy.taylor_outcome.time_limit:
            raise PeerFailed(f"heyoka at t = {one.time:.9g} s: {outcome}")
        return PeerRun((), (), one.state.copy())

    return run


def by_events(scene: Any, rtol: float) -> Call:
    """Prepare SciPy's DOP853 from event to event of an ellipsoid."""
    from scipy.integrate import solve_ivp

    pair = Direct(scene)
    sizes = np.repeat([pair.speed * pair.time, pair.speed] * 2, len(pair.b))

    def arc(t: float, until: float, y: Vector, field: Any, **more: Any) -> Any:
        found = solve_ivp(field, (t, until), y, method="DOP853", rtol=rtol, atol=rtol * sizes, **more)
        if not found.success:
            raise PeerFailed(f"SciPy at t = {found.t[-1]:.9g} s: {found.message}")
        return found

    def stick(t: float, y: Vector) -> Vector:
        load = pair.load(t, y)
        return pair.rates(load, y, load)

    def sliding(t: float, y: Vector, direction: Any = None) -> Vector:
        return pair.rates(pair.load(t, y), y, pair.friction(slip(y) if direction is None else direction))

    def inside(t: float, y: Vector) -> float:
        return 1 - float(np.linalg.norm(pair.load(t, y) / pair.b))

    def ends(t: float, y: Vector) -> float:
        h = float(np.linalg.norm(pair.b * slip(y))) / (max(pair.b) * pair.speed)
        return max(h - math.sqrt(rtol) / 10, -inside(t, y))

    for guard in (inside, ends):
        guard.terminal, guard.direction = True, -1  # type: ignore[attr-defined]

    def run() -> PeerRun:
        t, y, modes, times = 0.0, pair.start, ["stick"], list[float]()
        if slip(y).any() or inside(t, y) < 0:
            modes = ["slip"]
        while True:
            sticks = modes[-1] == "stick"
            if not (sticks or slip(y).any()):
                begun, along = min(t + 0.01 * math.cbrt(rtol) * pair.time, pair.until), pair.load(t, y) / pair.b**2
                t, y = begun, arc(t, begun, y, sliding, args=(along,)).y[:, -1]
            field, guard = (stick, inside) if sticks else (sliding, ends)
            found = arc(t, pair.until, y, field, events=guard)
            t, y = float(found.t[-1]), found.y[:, -1]
            if found.status == 0:
                return PeerRun(modes, times, y)
            if not sticks:
                rate, across = sliding(t, y), pair.b**2 * slip(y)
                left = -float(across @ slip(y) / (across @ slip(rate)))
                q1, v1, q2, v2 = np.split(y + left * rate, 4)
                v = (1 - pair.share) * v1 + pair.share * v2
                bend = [left**2 / 2 * one for one in np.split(rate, 4)]
                t, y = t + left, np.concatenate([q1 + bend[1], v, q2 + bend[3], v])
            modes.append("slip" if sticks else "stick")
            times.append(t)

    return run
