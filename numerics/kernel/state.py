"""What a run of the kernels is made of: the kinds of motion, how a run ends, and the records that are handed on."""

from __future__ import annotations

from typing import Any, NamedTuple

STICK, RAY, SURFACE, FREE = 0, 1, 2, 3
"""Kinds of motion: stick; slips from an exit ray, from elsewhere on the switching surface, from off it."""
REACHED, STUCK, EVENT_LIMIT, ROWS_FULL, OUT_OF_RANGE, MOVING = 0, 1, 2, 3, 4, 5
"""How a run ended; or that it has not."""
COLUMNS = (
    "mode",
    "kind",
    "tau",
    "length",
    "X",
    "push",
    "Z",
    "w",
    "gap",
    "side",
    "V",
    "late",
    "x",
    "v",
    "place",
    "excess",
)
"""A recorded event: mode (-1, 0, +1) and kind of motion after it, its time, how long the motion before it lasted,
how the motion after it starts (Start), and bounds on the errors of tau, X, V, Z and w there."""


class Pair(NamedTuple):
    """The reduced parameters, and whether v1 = v2 is never left (the law three-valued-sgn)."""

    q: float
    r: float
    sqrt_q: float
    literal: bool


class Start(NamedTuple):
    """The start of a mode of motion. In stick X = side (1 + gap) and V = push; in a slip the variables of slip_flow.py.

    `driven` is side V2/sqrt(q); `turns` belongs to a free slip; tau (with its rounding `rest`) is the reduced time;
    `spent` is what friction has taken from E/E_cr so far, a sum of positive terms that never cancels.
    """

    kind: int
    side: float
    X: float
    guard: float
    gap: float
    push: float
    driven: float
    turns: bool
    Z: float
    w: float
    tau: float
    rest: float
    spent: float


class Landing(NamedTuple):
    """The end of a slip: its angle, the gap there, K, the excess w, 1 - cos theta (from S), the lowest minimum left."""

    theta: float
    gap: float
    slid: float
    w: float
    versine: float
    spared: float


class EventErrors(NamedTuple):
    """Bounds on the errors of X and V at an event, and on the relative error of t, x1, v and x2."""

    x: float
    v: float
    relative: float


class End(NamedTuple):
    """The state at the horizon (or at the last event, where the run stopped there), with bounds on its errors."""

    mode: int
    X: float
    V1: float
    V2: float
    Z: float
    w: float
    spent: float
    x_error: float
    v1_error: float
    v2_error: float
    place_error: float
    w_error: float
    spent_error: float
    worst: float
    """A bound on the relative error of every t, x1, v and x2 at an event."""
    certain: bool
    """Whether these bounds leave no doubt about the sequence of events."""


class Bounds(NamedTuple):
    """What the kernels say of their own rounding: `events` (k, 4), errors of tau, X, V and Z at each event; the end.

    `damped` is the error of what viscosity has taken from E/E_cr.
    """

    events: Any
    end: End
    damped: float = 0.0
