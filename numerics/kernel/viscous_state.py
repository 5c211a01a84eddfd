"""What a viscous run carries: the pair, the start of a mode of motion, and the state at its end."""

from __future__ import annotations

from typing import NamedTuple

from numerics.kernel.viscous_oscillator import Oscillator


class ViscousPair(NamedTuple):
    """The reduced parameters, whether v1 = v2 is never left (the law three-valued-sgn), and both oscillators."""

    q: float
    r: float
    two_zeta: float
    literal: bool
    stick: Oscillator
    slip: Oscillator


class Start(NamedTuple):
    """The start of a mode of motion: -1, 0, +1 is the sign of V1 - V2; tau (with its rounding `rest`) the time.

    `rising` and `level` are what viscous.ViscousSlip and ViscousStick are told; `spent` and `damped` what friction and
    viscosity have taken from E/E_cr so far, sums of positive terms.
    """

    mode: int
    X: float
    V1: float
    V2: float
    Z: float
    w: float
    rising: bool
    level: bool
    tau: float
    rest: float
    spent: float
    damped: float


class Landing(NamedTuple):
    """The state at the end of a motion, before V1 and V2, or X, are snapped.

    `spared`: how far above 0 the guard of a slip stayed where it might have come down before.
    """

    X: float
    V1: float
    V2: float
    Z: float
    w: float
    spent: float
    damped: float
    spared: float
