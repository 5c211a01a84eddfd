"""How much larger bounds on a surface are than what they bound can be, in the norm in which motions never part.

N^2 = x1.A2 x1 + v1.M1 v1 + v2.M2 v2 of an error never grows of itself, and every bound follows from one on N. A single
error may be far below its own: it passes through 0, an event does not feel the axis that is off, friction forgets. So a
bound is held against what E, the largest N of an error of its run, can do to the same number:

    |x1_i| <= E sqrt((A2^-1)_ii),  |v_i| <= E/sqrt(m_i),  |x1_i - x2_i| <= t E sqrt(1/m1_i + 1/m2_i),

and a time: in E/(W Y) a motion of the run's largest N, Y, at its slowest rate W goes as far as E; or the largest error
of a time, if that is more. What is not asked: whether a bound knows on which axis an error is, and from when on.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from numerics.trajectory.columns import STATE

Figure: TypeAlias = tuple[str, Fraction, Fraction | None]
"""What it is of, its value, and the bound on its error, None where there is none; exact."""


def slack(scene: Any, found: Iterable[Figure], truth: Iterable[Figure]) -> float:
    """Return the largest bound over what the largest error in N can do, of the times and states of a run."""
    pair, n = scene.pair, scene.pair.axes
    a2, m1, m2 = (np.array(given, dtype=float) for given in (pair.a2, pair.m1, pair.m2))
    soft, apart = np.sqrt(np.diag(np.linalg.inv(a2))), np.sqrt(1 / m1 + 1 / m2)
    slowest = math.sqrt(np.linalg.eigvalsh(a2 / np.sqrt(np.outer(m1 + m2, m1 + m2)))[0])

    def norm(state: Any) -> float:
        x1, v1, _, v2 = np.reshape(state, (4, n))
        return math.sqrt(x1 @ a2 @ x1 + m1 @ v1**2 + m2 @ v2**2)

    rows = defaultdict[bool, list[list[float]]](list)
    for (name, value, bound), (_, true, _) in zip(found, truth, strict=True):
        if name in {"t", *STATE}:
            rows[name == "t"].append([float(value), float(abs(value - true)), float(bound or 0)])
    states = np.array(rows[False]).reshape(-1, 4 * n, 3)
    times = [*rows[True], [float(scene.until), 0.0, 0.0]]
    start = np.array([scene.x1, scene.v1, scene.x2, scene.v2], dtype=float)
    most = max(map(norm, (start, *states[:, :, 0])))
    off = max(map(norm, states[:, :, 1]))
    late, worst = max(off / (slowest * most) if most else 0.0, *(error for _, error, _ in times)), 0.0
    for (t, _, far), state in zip(times, states, strict=True):
        able = np.hstack([late, soft * off, off / np.sqrt(m1), (soft + apart * t) * off, off / np.sqrt(m2)])
        bounds = np.array([far, *state[:, 2]])
        worst = max(worst, *(bounds[able > 0] / able[able > 0]), 0.0)
    return worst
