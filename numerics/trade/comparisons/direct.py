"""A pair on n axes, or with friction of its speed, as a user of an integrator writes it down: y = (q1, v1, q2, v2).

    f = B^2 s/h(s) (1 + slope |s|/b),  h(s) = |B s|,  s = v1 - v2,  Lam = M2 (M1 + M2)^-1 (u - A2 q1 - A1 v1)

Smoothed: h(s)^2 + (b eps)^2 in the place of h(s)^2; eps is the setting, by the pair's own speed. There are no events.
By events, on a surface: stick until |B^-1 Lam| rises to 1; slip until h(s) is down to a tenth of the root of the
tolerance with Lam inside K, from where the time left is (f + Lam).s/(|f|^2 - |Lam|^2), in the norm of M1^-1 + M2^-1,
but for O(h^2). A slip begins along B^-2 Lam; its direction is frozen for a first step, since h(0) = 0.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.scene import Scene
from numerics.trade.comparisons.peer import Call, PeerFailed, PeerRun, Unsupported

Vector = Any
"""An array of numbers, or of heyoka's expressions."""


class Direct:
    """The numbers of a scene on n axes; one axis is the line."""

    def __init__(self, scene: Any) -> None:
        """Convert. Raises Unsupported."""
        pair, line = scene.pair, isinstance(scene, Scene)
        forces, at = ((scene.force,), scene.initial) if line else (scene.force, scene)
        if scene.friction.pieces if line else scene.friction or any(start for one in forces for start in one.starts):
            raise Unsupported("only one piece of force from t = 0 on and one b are written down for this integrator")
        self.m1, self.m2, self.b = (np.atleast_1d(np.array(one, float)) for one in (pair.m1, pair.m2, pair.b))
        self.a1, self.a2 = (np.atleast_2d(np.array(one, float)) for one in (pair.a1, pair.a2))
        self.start = np.hstack([np.array(getattr(at, name), float) for name in ("x1", "v1", "x2", "v2")])
        self.pieces, self.until = [one.piece_at(0) for one in forces], float(scene.until)
        mass, springs = self.m1 + self.m2, np.diag(self.a2)
        self.share, self.kappa, self.time = self.m2 / mass, 1 / self.m1 + 1 / self.m2, math.sqrt(max(mass / springs))
        self.speed = max(self.b / self.share / springs) / self.time
        self.sizes = np.repeat([self.speed * self.time, self.speed] * 2, len(self.b))
        weakening = scene.friction.weakening if line else None
        if weakening and (weakening.speed or weakening.place):
            raise Unsupported("friction is written down for this integrator as one slope of the speed")
        self.slope = float(weakening.last_slope) / self.b[0] if weakening else 0.0

    def load(self, t: Any, y: Vector, sin: Any = math.sin) -> Vector:
        """Return Lam."""
        q, v, *_ = np.split(y, 4)
        u = [
            sum((float(c) * t**k for k, c in enumerate(one.polynomial)), 0 * t)
            + sum(float(w.amplitude) * sin(float(w.omega) * t + float(w.phase)) for w in one.sines)
            for one in self.pieces
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


def smoothed(scene: Any, eps: float, integrator: str) -> Call:
    """Prepare SciPy's Radau or heyoka for the smoothed law; its error is about eps, Radau's tolerance eps/1000."""
    pair, tol = Direct(scene), eps / 1000
    least = (eps * pair.speed * max(pair.b)) ** 2

    def field(t: Any, y: Vector, sin: Any, sqrt: Any = math.sqrt) -> Vector:
        _, v1, _, v2 = np.split(y, 4)
        return pair.rates(pair.load(t, y, sin), y, pair.friction(v1 - v2, least, sqrt))

    def answer(good: bool, y: Vector) -> PeerRun:
        if not good:
            raise PeerFailed(f"{integrator} does not get to {pair.until:g} s")
        return PeerRun(None, (), tuple(y.tolist()), None)

    if integrator == "heyoka":
        import heyoka as hy

        y = np.array(hy.make_vars(*(f"y{k}" for k in range(len(pair.start)))))
        system = list(zip(y, field(hy.time, y, hy.sin, hy.sqrt), strict=True))
        one = hy.taylor_adaptive(system, pair.start, tol=1e-15)  # its steps are many: coarser ones add up

        def run() -> PeerRun:
            one.time, one.state[:] = 0.0, pair.start
            return answer(one.propagate_until(pair.until)[0] == hy.taylor_outcome.time_limit, one.state)

        return run
    from scipy.integrate import solve_ivp

    def stiff() -> PeerRun:
        options: Any = {"method": "Radau", "rtol": tol, "atol": tol * pair.sizes}
        found = solve_ivp(lambda t, y: field(t, y, math.sin), (0, pair.until), pair.start, **options)
        return answer(found.success, found.y[:, -1])

    return stiff


def by_events(scene: Any, rtol: float) -> Call:
    """Prepare SciPy's DOP853 from event to event of an ellipsoid. Raises Unsupported."""
    pair = Direct(scene)
    if len(pair.b) == 1:
        raise Unsupported("from event to event it is written down for a surface only")

    def run() -> PeerRun:
        t, y, events = 0.0, pair.start, list[tuple[str, float]]()
        _, v1, _, v2 = np.split(y, 4)
        out = pair.load(t, y) / pair.b
        first = mode = "slip" if (v1 != v2).any() or out @ out > 1 else "stick"
        while True:
            t, y, met = _arc(pair, rtol, t, y, mode)
            if not met:
                return PeerRun.of(first, events, y.tolist(), None)
            mode = "stick" if mode == "slip" else "slip"
            events.append((mode, t))

    return run


def _arc(pair: Direct, rtol: float, t: float, y: Vector, mode: str) -> tuple[float, Vector, bool]:
    """Return time and state at the end of a stick, of a slip, or of the run, and whether it is an event."""
    from scipy.integrate import solve_ivp

    options: Any = {"method": "DOP853", "rtol": rtol, "atol": rtol * pair.sizes}

    def slip(y: Vector) -> Vector:
        _, v1, _, v2 = np.split(y, 4)
        return v1 - v2

    def field(t: float, y: Vector, direction: Any = None) -> Vector:
        load = pair.load(t, y)
        f = load if mode == "stick" else pair.friction(slip(y) if direction is None else direction)
        return pair.rates(load, y, f)

    def guard(t: float, y: Vector) -> float:
        out = float(np.linalg.norm(pair.load(t, y) / pair.b))
        if mode == "stick":
            return 1 - out
        return max(float(np.linalg.norm(pair.b * slip(y))) / (max(pair.b) * pair.speed) - math.sqrt(rtol) / 10, out - 1)

    guard.terminal, guard.direction = True, -1  # type: ignore[attr-defined]
    if mode == "slip" and not slip(y).any():
        begun = min(t + 0.01 * math.cbrt(rtol) * pair.time, pair.until)
        y = solve_ivp(field, (t, begun), y, args=(pair.load(t, y) / pair.b**2,), **options).y[:, -1]
        t = begun
    found = solve_ivp(field, (t, pair.until), y, events=guard, **options)
    t, y = float(found.t[-1]), found.y[:, -1]
    if not found.success:
        raise PeerFailed(f"SciPy at t = {t:.9g} s: {found.message}")
    if found.status == 0 or mode == "stick":
        return t, y, bool(found.status)
    s, load, rate = slip(y), pair.load(t, y), field(t, y)
    f = pair.friction(s)
    left = float((f + load) @ s / (f @ (pair.kappa * f) - load @ (pair.kappa * load)))
    q1, v1, q2, v2 = np.split(y + left * rate, 4)
    bend = [left**2 / 2 * one for one in np.split(rate, 4)]
    v = (1 - pair.share) * v1 + pair.share * v2
    return t + left, np.concatenate([q1 + bend[1], v, q2 + bend[3], v]), True
