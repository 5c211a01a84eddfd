"""The records that flows under a force are told with, and the layout of their table of numbers."""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.protocol import Number
from numerics.flows.oscillator import Oscillator

HEAD, SINE = 3, 7
"""Numbers of a piece before its polynomials: start (s), length (s), b (N); and of each sine: amplitude, omega, phase at
the start of the piece, then for slip and for stick the frequency squared less omega^2, and a2 - m omega^2."""

ROUNDINGS = 16.0
"""Roundings that a number takes, counted in the size of what it is a sum of."""
PHASES = 4.0
"""A phase takes so many times fewer roundings: those of the phase at the start, of omega, of their product and sum."""


class Swing(NamedTuple):
    """The oscillator of one mode: mass (kg), a1, a2; `rate` a bound on |roots| (1/s).

    `light`: resonance is so sharp that it needs its own formula. Power series serve where (rate + omega) tau <=
    `short`, and take so many `terms`.
    """

    mass: Number
    a1: Number
    a2: Number
    of: Oscillator
    rate: float
    light: bool
    short: float
    terms: int


class Drive(NamedTuple):
    """All pieces of force and friction: `numbers` flat; `places` (n, 4): first number, coefficients, sines, is jump."""

    numbers: Any
    places: Any


class Moved(NamedTuple):
    """Position and velocity, and the sizes of what they are sums of: rounding is counted in those."""

    x: Number
    v: Number
    x_size: float
    v_size: float


class Pair(NamedTuple):
    """The pair: SI parameters, both oscillators, and what turns a distance N between two motions into errors.

    `from_norm` is sqrt(kappa), which bounds |w|, and the bound on |Lambda|; the roots are those of a2, m1 and m2.
    """

    m1: Number
    m2: Number
    mass: Number
    a1: Number
    a2: Number
    slip: Swing
    stick: Swing
    root_a2: Number
    root_m1: Number
    root_m2: Number
    guard_norm: Number
    load_norm: Number
    literal: bool


class Start(NamedTuple):
    """The start of a mode: sign of v1 - v2, how many derivatives of its guard vanish there, the piece, the time in it.

    The state is a point. `norm` bounds the distance to the true motion in N = sqrt(a2 x1^2 + m1 v1^2 + m2 v2^2), and
    `place` the error of x1 - x2. Up to `quiet` (time in the piece) it is known that nothing happens.
    """

    mode: int
    order: int
    piece: int
    local: Number
    x1: Number
    v1: Number
    x2: Number
    v2: Number
    norm: Number
    place: Number
    quiet: Number


class Push(NamedTuple):
    """u and its first three derivatives (N, N/s, ...), the size of u's terms, bounds on the third and fourth."""

    u0: Number
    u1: Number
    u2: Number
    u3: Number
    height: float
    third: float
    fourth: float


class Jet(NamedTuple):
    """A guard's value, less its error, and two derivatives; |g'''| <= bound + growth h for the next h seconds."""

    value: float
    slope: float
    bend: float
    bound: float
    growth: float
    error: float
