"""What both kinds of motion hand on."""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.float64 import ZERO
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text


class At(NamedTuple):
    """A state, and what friction (`spent`) and viscosity (`damped`) have taken from E/E_cr since the start of the run.

    X and V1, V2 are reduced (frame.py), Z = (x1 - x2)/L; w = E/E_cr - 1 is a variable of its own, accurate where the
    state would cancel.
    """

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number
    spent: Number
    damped: Number


@text
def no_damping() -> Number:
    """Return what viscosity takes where there is none."""
    return ZERO
