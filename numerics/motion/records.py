"""What both kinds of motion hand on."""

from __future__ import annotations

from typing import NamedTuple

from numerics.arithmetic.float64 import ZERO
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text


class ReducedState(NamedTuple):
    """A point of the reduced state space; w is a variable of its own, accurate where E/E_cr - 1 would cancel."""

    X: Number
    V1: Number
    V2: Number
    Z: Number
    w: Number


class At(NamedTuple):
    """A reduced state, and what friction (`spent`) and viscosity (`damped`) have taken from E/E_cr since the start."""

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
