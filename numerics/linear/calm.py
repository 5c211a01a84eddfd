"""A stick that nothing ends before its piece does: proved calm, and stepped over by powers of exp(A h).

Only where the signals are u, of a polynomial up to t^2 and sines, and constants, none of them of a belt. Along a stick
the load is that of the steady answer, at most the sum of its amplitudes, and that of a free motion y: y'' there has the
equation of y, of which y^2 + (M/a2) y'^2 never grows.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with, inlined
from numerics.arithmetic.pair import TwoFloats
from numerics.linear.evolve import moved
from numerics.linear.model import EDGE, FORCE, FORCE_2, FRICTION, LOAD, STICK, V1, WALL, X1
from numerics.linear.room import Now, Run, dot, enter, form_z, load_off, place_of
from numerics.linear.table import OTHERS, RATES, STATE, UNIT

_MOST_COLUMNS, _MOST_STEPS = 64, 2.0**36
"""Columns of a matrix whose powers are formed; steps beyond which floats keep no phase."""


class Calm(NamedTuple):
    """Whether the rest of the piece is stick; the step at which to look next, and that at which the segment began."""

    is_calm: bool
    look: int
    begun: int


@inlined
def look_ahead(run: Run, now: Now, calm: Calm, step: int, is_end: bool) -> Calm:
    """Return whether the rest is calm where that is open: at the end, and if it is time to look and much is left."""
    is_time = now.order == 0 and step >= calm.look and is_long(run, now)
    if now.mode != 0 or not (is_time or (is_end and not calm.is_calm)):
        return calm
    if run.norm.root_m2 > 0.0 and (run.literal or rest_is_calm(run, now)):
        return Calm(True, step, calm.begun)
    return Calm(False, 2 * (step + 1) - calm.begun, calm.begun)  # seldom, where it stays in vain


@compilable
def is_long(run: Run, now: Now) -> bool:
    """Return whether more than a few steps of stick are left of the piece."""
    return bool(run.drive.length[now.piece, 0] - run.clock[0, 0] > 8.0 * run.tables.steps[place_of(now)])


@inlined
def step_over(run: Run, now: Now, calm: Calm) -> Now:
    """Stick through the rest of a piece but for less than a step, if it is calm and long."""
    if not (calm.is_calm and is_long(run, now) and len(run.z) <= _MOST_COLUMNS):
        return now
    if run.drive.length[now.piece, 0] - run.clock[0, 0] > _MOST_STEPS * run.tables.steps[now.kind, STICK]:
        # with an error beyond all range
        return Now(now.piece, 0, now.kind, 0, now.edge, now.late, math.inf, now.far, now.far_2, now.apart, math.inf)
    return long_step(run, now)


@compilable
def rest_is_calm(run: Run, now: Now) -> bool:
    """Return whether |Lambda| < b is proved from here to the end of the piece, however late that is."""
    tables, kind, z = run.tables, now.kind, run.z
    A, others, blocks = tables.A[kind, STICK], tables.lines[kind, STICK, OTHERS:RATES], tables.blocks[kind]
    first, terms, sines, waves = blocks[FORCE]
    numbers, constants = 0, min(blocks[FORCE_2, 1], 1) + min(blocks[WALL, 1], 1)
    for block in blocks:
        numbers += block[1] + 2 * block[3]
    if numbers != terms + 2 * waves + 1 + constants or blocks[FRICTION, 1] != 1 or terms > 3 or A[V1, X1] == 0.0:
        return False
    load, edge, stiff, drag = others[LOAD], others[EDGE], -A[V1, X1], -A[V1, V1]
    value, rate, size = dot(load, z), 0.0, 0.0
    for i in range(len(z)):
        size += abs(load[i] * z[i])
        for j in range(len(z)):
            rate += load[i] * A[i, j] * z[j]
            size += abs(load[i] * A[i, j] * z[j]) / math.sqrt(stiff)
    # of u = p t^2/2 the steady answer has x'' = p/a2, and the load -(load of x1) x''/(M's own stiffness)
    most = load[first] / stiff * z[first + 2] if terms > 2 else 0.0
    most -= z[blocks[FORCE_2, 0]] if blocks[FORCE_2, 1] > 0 else 0.0  # which friction alone holds
    free, most = value - most, abs(most)
    for k in range(waves):
        at = sines + 2 * k
        omega = A[at, at + 1]
        spring, damper = stiff - omega * omega, drag * omega
        square = spring * spring + damper * damper
        if not square > 1e-12 * stiff * stiff:
            return False
        # x = (spring s - damper c)/square/M, and the load is m2 x''
        scale, s, c = -load[at] * omega * omega / square, z[at], z[at + 1]
        free -= scale * (spring * s - damper * c)
        rate -= scale * omega * (spring * c + damper * s)
        peak = abs(scale) * math.sqrt(square * (s * s + c * c))
        most += peak
        size += peak * (1.0 + omega / math.sqrt(stiff))
    most += math.sqrt(free * free + rate * rate / stiff) + 1e-13 * size
    return most + load_off(run, kind, now) < (1.0 - 1e-12) * dot(edge, z)


@compilable_with(makes_arrays=True, forceinline=False)
def long_step(run: Run, now: Now) -> Now:
    """Stick to the end of the piece but for less than a step, the longest powers of exp(A h) first."""
    norm, tables, length = run.norm, run.tables, run.drive.length[now.piece, 0]
    h, count, scale = tables.steps[now.kind, STICK], len(run.z), (norm.root_a2, norm.root_m1, 0.0, norm.root_m2)
    levels = 1 + max(0, math.floor(math.log2((length - run.clock[0, 0]) / h)))
    powers = doubled(tables.A[now.kind, STICK], h, levels)
    while True:
        left = length - run.clock[0, 0]
        level = min(levels - 1, math.floor(math.log2(left / h))) if left >= h else -1
        if level < 0:
            return now
        own = np.zeros(STATE)
        for i in range(STATE):
            row = powers[level, i]
            run.y[i], most = dot(row, run.z), 0.0
            for j in range(count):
                most += abs(row[j]) * run.size[j]
            own[i] = math.ldexp((count + 8) * UNIT, level + 2) * most  # each squaring doubles what is off
        added = scale[0] * own[0] + (scale[1] + scale[3]) * own[1]
        now = moved(run, now, TwoFloats(math.ldexp(h, level), 0.0), (added, own[0], own[2]), 1.0)
        form_z(run, now.piece)
        enter(run, now.piece, 0)


@compilable_with(makes_arrays=True, forceinline=False)
def doubled(A: Any, h: float, levels: int) -> Any:
    """Return exp(A h 2^k) for k < levels."""
    count = A.shape[0]
    powers, terms = np.zeros((levels, count, count)), np.zeros((2, count, count))
    for i in range(count):
        powers[0, i, i] = terms[0, i, i] = 1.0
    for k in range(1, 40):
        term = terms[k % 2]
        put_product(terms[(k - 1) % 2], A, h / k, term)
        add(term, powers[0])
    for level in range(1, levels):
        put_product(powers[level - 1], powers[level - 1], 1.0, powers[level])
    return powers


@compilable_with(forceinline=False)
def put_product(A: Any, B: Any, factor: float, to: Any) -> None:
    """Write A B times a factor; without a library for it, which would have to be installed."""
    count = A.shape[0]
    for i in range(count):
        for j in range(count):
            to[i, j] = 0.0
        for k in range(count):
            if A[i, k] != 0.0:
                for j in range(count):
                    to[i, j] += factor * A[i, k] * B[k, j]


@compilable
def add(A: Any, to: Any) -> None:
    """Add a matrix to another one."""
    for i in range(A.shape[0]):
        for j in range(A.shape[1]):
            to[i, j] += A[i, j]
