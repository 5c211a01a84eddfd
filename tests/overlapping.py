"""Whether two answers in balls may be of the same motion."""

from typing import Any

import numpy as np
from flint import arb


def overlap(one: Any, two: Any) -> bool:
    """Whether balls have points in common, all of two sequences of them; whether all else is equal."""
    if isinstance(one, tuple | list | np.ndarray):
        return len(one) == len(two) and all(map(overlap, one, two))
    return bool(one.overlaps(two) if isinstance(one, arb) else one == two)
