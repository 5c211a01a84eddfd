"""How much larger bounds are than what they bound can be, in the norm in which motions never part.

N^2 = x1.A2 x1 + v1.M1 v1 + v2.M2 v2 of an error never grows of itself, and every bound follows from one on N. A single
error may be far below its own: it passes through 0, an event does not feel the axis that is off, friction forgets. So a
bound is held against what E, the largest N of an error of its run, can do to the same number:

    |x1_i| <= E sqrt((A2^-1)_ii),  |v_i| <= E/sqrt(m_i),  |x1_i - x2_i| <= t E sqrt(1/m1_i + 1/m2_i),

and a time: in E/(W Y) a motion of the run's largest N, Y, at its slowest rate W goes as far as E; or the largest error
of a time, if that is more. What is not asked: whether a bound knows on which axis an error is, and from when on.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def slack(pair: Any, values: NDArray[np.float64], errors: NDArray[np.float64], bounds: NDArray[np.float64]) -> float:
    """Return the largest bound over what the largest error in N can do.

    A row of each is t, x1, v1, x2, v2, each by axes, at an event or the end of a run of a pair on a line or a surface.
    """
    m1, m2 = (np.atleast_1d(np.array(given, dtype=float)) for given in (pair.m1, pair.m2))
    a2 = np.atleast_2d(np.array(pair.a2, dtype=float))
    soft, apart = np.sqrt(np.diag(np.linalg.inv(a2))), np.sqrt(1 / m1 + 1 / m2)
    slowest = np.sqrt(np.linalg.eigvalsh(a2 / np.sqrt(np.outer(m1 + m2, m1 + m2)))[0])

    def norm(rows: NDArray[np.float64]) -> float:
        x1, v1, _, v2 = np.split(rows[:, 1:], 4, axis=1)
        return float(np.sqrt(np.max(np.sum(x1 @ a2 * x1 + m1 * v1**2 + m2 * v2**2, axis=1))))

    most, off = norm(values), norm(errors)
    late = max(off / (slowest * most) if most else 0.0, errors[:, 0].max())
    able = np.array([[late, *soft * off, *off / np.sqrt(m1), *(soft + apart * t) * off, *off / np.sqrt(m2)]
                     for t in values[:, 0]])  # fmt: skip
    return float(np.max(bounds[able > 0] / able[able > 0], initial=0.0))
