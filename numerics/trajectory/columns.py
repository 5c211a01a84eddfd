"""Types of arrays, and room for them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from numerics.scene.decimals import Quantity

Array = NDArray[Any]
"""Of floats, or of the numbers of an arithmetic."""
Floats = NDArray[np.float64]
Counts = NDArray[np.int64]
STATE = ("x1", "v1", "x2", "v2")


class Moment(NamedTuple):
    """A state in SI units: m and m/s."""

    x1: Quantity
    v1: Quantity
    x2: Quantity
    v2: Quantity


def room(what: str, *shape: int) -> Floats:
    """Return an array that is not filled yet. Raises ValueError, naming what takes more memory than there is."""
    try:
        return np.empty(shape)
    except (MemoryError, ValueError):
        size = f"{8 * math.prod(shape) / 2**30:.3g} GiB"
        raise ValueError(f"{what} take {size}, more memory than there is; ask for fewer at a time") from None
