"""The regime under a sine of amplitude U and frequency omega, as a map of proved cells of one pair.

    entrained  U <= U* over the whole cell
    non-stop   U >= U** over the cell, and w > 0 between the reversals: w rises with U there, so the least U is
               looked at; where w is not proved > 0 the cell is undecided
    between    U* < U < U** over the cell: slips, and sticks or reverses more than twice a period

For a1 = 0 a verdict says that such a motion exists ("between": that neither of the others does; at a frequency whose
3rd, 5th, ... multiple is Omega that is so from U*/cos(pi omega/(2 Omega)) on).
"""

from __future__ import annotations

import math
from enum import Enum
from fractions import Fraction
from functools import partial
from itertools import pairwise
from pathlib import Path

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.control.answers import number
from numerics.control.thresholds import NonStop, entrainment_threshold, flattest_peak
from numerics.free.quadtree import CellMap, Progress, Side, Sides, map_of, side_of
from numerics.scene import Pair
from numerics.scene.decimals import decimal_text
from numerics.scene.model import require_kind

_DIGITS = 16
_SLICES = 8
"""Frequencies of a cell are taken in so many slices: what is proved of a narrow ball is sharper."""


class Regimes(Enum):
    """What is proved of a cell; the letter stands for it in checkpoints."""

    ENTRAINED = "e"
    BETWEEN = "b"
    NON_STOP = "n"
    UNDECIDED = "u"


def response_map(
    pair: Pair,
    amplitude: Side,
    omega: Side,
    depth: int,
    *,
    jobs: int = 1,
    dask: str | None = None,
    resume: Path | None = None,
    progress: Progress | None = None,
) -> CellMap:
    """Return the map of a window of amplitudes (N) and frequencies (rad/s), cells down to 2^-depth of its sides.

    In JSON a cell is [omega from, to, U from, to, verdict]. `jobs` (processes), `dask` (a scheduler's address) and
    `resume` (a checkpoint file) do not change the result.
    Raises InvalidMap, MissingTool, TypeError.

    >>> from numerics import Pair
    >>> found = response_map(Pair(1, 1, 200, "0.05", a1=1), ("0.1", 1), (4, 8), depth=3)
    >>> {regime.name: round(share, 3) for regime, share in found.shares().items()}
    {'ENTRAINED': 0.234, 'BETWEEN': 0.344, 'NON_STOP': 0.094, 'UNDECIDED': 0.328}
    """
    require_kind("response_map", pair, Pair, "build Pair(m1=..., m2=..., a2=..., b=...)")
    sides = {"amplitude": side_of("amplitude", amplitude), "omega": side_of("omega", omega)}
    numbers = {name: decimal_text(getattr(pair, name)) for name in ("m1", "m2", "a1", "a2", "b")}
    title = {"map": "response", "pair": numbers} | {name: [*map(str, side)] for name, side in sides.items()}
    return map_of(
        (sides["omega"], sides["amplitude"]),
        depth,
        partial(decide, pair),
        Regimes.UNDECIDED,
        title,
        jobs=jobs,
        dask=dask,
        resume=resume,
        progress=progress,
    )


def decide(pair: Pair, sides: Sides) -> Regimes:
    """Return what is proved of every (omega, U) of a cell."""
    (slow, fast), (weak, strong) = sides
    with Ball(_DIGITS).context():
        low, high = number(weak), number(strong)
        ends = [number(slow + (fast - slow) * Fraction(k, _SLICES)) for k in range(_SLICES + 1)]
        found = Regimes.UNDECIDED
        for one, two in pairwise(ends):
            here = _decide_slice(pair, one.union(two), low, high)
            if here is Regimes.UNDECIDED or found not in {Regimes.UNDECIDED, here}:
                return Regimes.UNDECIDED
            found = here
    return found


def _flattening(pair: Pair, omega: arb) -> arb:
    """Return the factor above U* up to which stuck motions may exist over a ball of frequencies."""
    if pair.a1 > 0:
        return arb(1)
    ratio = number(pair.a2 / pair.mass).sqrt() / omega
    odd = max(3, 2 * math.ceil((float(ratio.lower()) - 1) / 2 - 1e-9) + 1)  # the least odd number >= 3 in it, or below
    return 1 / flattest_peak(odd) if arb(odd) <= ratio.upper() else arb(1)


def _decide_slice(pair: Pair, omega: arb, low: arb, high: arb) -> Regimes:
    """Return what is proved of the amplitudes from low to high over a ball of frequencies."""
    stuck = entrainment_threshold(pair, omega)
    if high <= stuck:
        return Regimes.ENTRAINED
    slipping = NonStop(pair, omega)
    if low > stuck * _flattening(pair, omega) and high < slipping.threshold:
        return Regimes.BETWEEN
    if low > slipping.threshold and slipping.keeps_slipping(low):
        return Regimes.NON_STOP
    return Regimes.UNDECIDED
