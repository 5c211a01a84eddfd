"""heyoka where events are hard to write down, on n axes or with friction of the speed: the law is smoothed.

    M1 q1'' + A1 q1' + A2 q1 = u - f,   M2 q2'' = f,   f = B^2 s/h (1 + slope h/b),   s = q1' - q2'
    h^2 = |B s|^2 + (b eps)^2

There are no events. `eps`, the setting, is by the pair's own speed, and about the error.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.scene import Scene
from numerics.trade.comparisons.switched import Call, PeerFailed, PeerRun


def smoothed(scene: Any, eps: float) -> Call:
    """Prepare heyoka for one piece: sines from t = 0 on, one b, and on a line perhaps one slope of it by speed."""
    import heyoka as hy

    pair, line = scene.pair, isinstance(scene, Scene)
    forces, at = ((scene.force,), scene.initial) if line else (scene.force, scene)
    m1, m2, b = (np.atleast_1d(np.array(one, float)) for one in (pair.m1, pair.m2, pair.b))
    a1, a2 = (np.atleast_2d(np.array(one, float)) for one in (pair.a1, pair.a2))
    start = np.hstack([np.array(one, float) for one in (at.x1, at.v1, at.x2, at.v2)])
    slope = float(scene.friction.weakening.last_slope) / b[0] if line and scene.friction.weakening else 0.0
    held, rate = max(b * (m1 + m2) / (m2 * np.diag(a2))), math.sqrt(min(np.diag(a2) / (m1 + m2)))
    y = np.array(hy.make_vars(*(f"y{k}" for k in range(len(start)))))
    q1, v1, _, v2 = np.split(y, 4)
    s, u = v1 - v2, np.full(len(b), 0.0 * hy.time)
    for axis, force in enumerate(forces):
        for wave in force.piece_at(scene.until).sines:
            u[axis] += float(wave.amplitude) * hy.sin(float(wave.omega) * hy.time + float(wave.phase))
    h = hy.sqrt(sum((b * s) ** 2) + (eps * held * rate * max(b)) ** 2)
    friction = b**2 * s * ((1.0 + slope * h / b[0]) / h)
    rates = np.concatenate([v1, (u - a2 @ q1 - a1 @ v1 - friction) / m1, v2, friction / m2])
    # its steps are many: coarser ones add up
    one = hy.taylor_adaptive(list(zip(y, rates, strict=True)), start, tol=1e-15)

    def run() -> PeerRun:
        one.time, one.state[:] = 0.0, start
        outcome = one.propagate_until(float(scene.until))[0]
        if outcome != hy.taylor_outcome.time_limit:
            raise PeerFailed(f"heyoka at t = {one.time:.9g} s: {outcome}")
        return PeerRun((), (), one.state.copy())

    return run
