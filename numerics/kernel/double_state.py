"""What a double-double run is made of: the records of state.py with two halves for each number."""

from __future__ import annotations

from typing import NamedTuple

from numerics.kernel.compilation import kernel
from numerics.kernel.double_double import Double
from numerics.kernel.state import End, Pair, Start

UNIT = 2.0**-105
"""What errors are counted in, relative to the result; the tests hold each below so many of it.

Sums 1.5, roots 2, products 2.5, quotients 5 (proved, see double_double.py). Sine, cosine and arcus tangent 3, versine,
x - sin x and sin x - x cos x 4, rise 6, depth 8, x^2/2 - 1 + cos x 16 (next to 2 it cancels): tested against balls,
not proved. Sine and cosine are off by |x| 2^-160 more, absolutely, as pi/2 has three parts: next to a zero that counts.
The angle of a contact 32, its depth 64.
"""
COLUMNS = (
    *("mode", "kind", "side"),
    *("tau", "tau low", "length", "length low", "X", "X low", "push", "push low", "Z", "Z low", "w", "w low"),
    *("gap", "gap low", "driven", "driven low"),
    *("late", "x", "v", "place", "excess"),
)
"""A recorded event, as in state.py, each number as its two halves."""


class DoublePair(NamedTuple):
    """The reduced parameters, and whether v1 = v2 is never left."""

    q: Double
    r: Double
    sqrt_q: Double
    literal: bool


class DoubleStart(NamedTuple):
    """The start of a mode of motion (state.Start)."""

    kind: int
    side: float
    X: Double
    guard: Double
    gap: Double
    push: Double
    driven: Double
    turns: bool
    Z: Double
    w: Double
    tau: Double
    rest: Double
    spent: Double


class DoubleLanding(NamedTuple):
    """The end of a slip (state.Landing); 1 - cos theta and the lowest minimum serve the bounds only."""

    theta: Double
    gap: Double
    slid: Double
    w: Double
    versine: float
    spared: float


class DoubleEnd(NamedTuple):
    """The state at the end of a run; `bounds` has the same in binary64, and the bounds on the errors of both."""

    X: Double
    V1: Double
    V2: Double
    Z: Double
    w: Double
    spent: Double
    bounds: End


@kernel
def rounded_pair(pair: DoublePair) -> Pair:
    """Return the pair in binary64, for the bounds."""
    return Pair(pair.q.high, pair.r.high, pair.sqrt_q.high, pair.literal)


@kernel
def rounded_start(at: DoubleStart) -> Start:
    """Return a start in binary64, for the bounds."""
    numbers = at.X.high, at.guard.high, at.gap.high, at.push.high, at.driven.high
    X, guard, gap, push, driven = numbers
    return Start(
        at.kind,
        at.side,
        X,
        guard,
        gap,
        push,
        driven,
        at.turns,
        at.Z.high,
        at.w.high,
        at.tau.high,
        at.rest.high,
        at.spent.high,
    )
