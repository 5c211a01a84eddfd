"""A stick that nothing ends before its piece does: proved calm, and stepped over by powers of exp(A h)."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.arithmetic.pair import TwoFloats, plus, product
from numerics.linear.columns import Now, Problem, Room, force_columns, state_columns
from numerics.linear.error_set import norm_of, take_in
from numerics.linear.evolve import end_step, full_step
from numerics.linear.ledger import of_square
from numerics.linear.table import FIRST, PAIR_UNIT, UNIT, V1, X1


class Calm(NamedTuple):
    """Whether the rest of the piece is stick; the step at which to look next, and that at which the segment began."""

    is_calm: bool
    look: int
    begun: int


@compilable
def step_over(problem: Problem, room: Room, now: Now, calm: Calm, step: int) -> tuple[Now, Calm]:
    """Stick through the rest of a piece but for less than a step, if it is long, and time to look, and calm."""
    pair, kind, N = problem.pair, problem.drive.places[now.piece, 4], now.N
    left = problem.drive.length[now.piece, 0] - room.clock[0, 0]
    if now.mode != 0 or now.order != 0 or step < calm.look or not left > 8.0 * problem.tables.h[kind, 1]:
        return now, calm
    if not (pair.literal or rest_is_calm(problem, room, now)):
        return now, Calm(False, 2 * (step + 1) - calm.begun, calm.begun)  # seldom, where it stays in vain
    damped, size, added = long_step(problem, room, now)
    N += added
    # of the difference of two motions damping takes at most N^2/2, all told
    room.ledger[1] += pair.a1 * damped
    room.ledger[2] += 64.0 * UNIT * pair.a1 * size + N * (math.sqrt(2.0 * pair.a1 * abs(damped)) + N / 2.0)
    return Now(now.piece, 0, 0, now.edge, now.since, norm_of(room.E, room.R)), Calm(True, step, calm.begun)


@compilable
def rest_is_calm(problem: Problem, room: Room, now: Now) -> bool:
    """Return whether |Lambda| < b is proved from here to the end of the piece, however late that is.

    Lambda/m2 = x'' is the steady state's, at most the sum of its amplitudes, and that of a free motion y, of which
    y^2 + (M/a2) y'^2 never grows. Only for polynomials up to t^2, whose part of x'' is constant, away from resonance.
    """
    pair, drive, z = problem.pair, problem.drive, room.z
    place, b = drive.places[now.piece], drive.b[now.piece]
    terms, first_sine, sines = place[1], place[2], place[3]
    if terms > 3:
        return False
    u0 = z[FIRST] if terms > 0 else 0.0
    u1 = z[FIRST + 1] if terms > 1 else 0.0
    steady = 2.0 * z[FIRST + 2] / pair.a2 if terms > 2 else 0.0
    first = FIRST + terms
    for i in range(sines):
        u0 += z[first + 2 * i]
        u1 += drive.sines[first_sine + i, 1, 0] * z[first + 2 * i + 1]
    x, v = room.y[0], room.y[1]
    bend = (u0 - pair.a2 * x - pair.a1 * v) / pair.mass
    free, rate = bend - steady, (u1 - pair.a1 * bend - pair.a2 * v) / pair.mass
    most = abs(steady)
    rounding = abs(bend) + most + abs(rate) * math.sqrt(pair.mass / pair.a2)
    for i in range(sines):
        omega = drive.sines[first_sine + i, 1, 0]
        stiff, drag = pair.a2 - pair.mass * omega * omega, pair.a1 * omega
        square = stiff * stiff + drag * drag
        if not square > 1e-12 * pair.a2 * pair.a2:
            return False
        sine, cosine = z[first + 2 * i], z[first + 2 * i + 1]
        scale = omega * omega / square
        free += scale * (stiff * sine - drag * cosine)
        rate += scale * omega * (stiff * cosine + drag * sine)
        peak = scale * math.sqrt(square * (sine * sine + cosine * cosine))
        most += peak
        rounding += peak * (1.0 + omega * math.sqrt(pair.mass / pair.a2))
    most += math.sqrt(free * free + pair.mass / pair.a2 * rate * rate) + 1e-13 * rounding
    return pair.m2 * most + pair.lam * now.N < (1.0 - 1e-9) * b


@compilable_with(makes_arrays=True, forceinline=False)
def long_step(problem: Problem, room: Room, now: Now) -> tuple[float, float, float]:
    """Stick to the end of the piece but for less than a step, the longest powers of exp(A h) first.

    Return int v1^2 dt, its size, and what the steps add to N.
    """
    (pair, drive, tables, _), length = problem, problem.drive.length[now.piece, 0]
    kind = drive.places[now.piece, 4]
    h, count = tables.h[kind, 1], tables.count[kind]
    levels = 1 + max(0, math.floor(math.log2((length - room.clock[0, 0]) / h)))
    powers, forms = doubled(problem, tables.ends[kind, 1], tables.squares[kind, 1], count, levels)
    take_in(room.E, room.R, room.basis, room.column)
    damped = size = grown = 0.0
    state_columns(room, 0, drive.b[now.piece])
    while True:
        left = length - room.clock[0, 0]
        level = min(levels - 1, math.floor(math.log2(left / h))) if left >= h else -1
        if level < 0:
            return damped, size, grown
        if pair.a1 > 0.0:
            taken, its_size = of_square(forms[level], room.z, count)
            damped, size = damped + taken, size + its_size
        # each squaring doubles the relative error of the power
        off, power = UNIT + math.ldexp(PAIR_UNIT, level), powers[level, 0]
        full_step(room, power, count, off)
        grown += end_step(pair, room, 0, TwoFloats(math.ldexp(h, level), 0.0), power[X1, V1], power[V1, V1])
        take_in(room.E, room.R, room.basis, room.column)
        force_columns(room, drive, now.piece, 0.0)
        state_columns(room, 0, drive.b[now.piece])


@compilable_with(makes_arrays=True, forceinline=False)
def doubled(problem: Problem, end: Any, square: Any, count: int, levels: int) -> tuple[Any, Any]:
    """Return exp(A h 2^k) of stick, and int v1^2 dt over that time, a quadratic form of z.

    exp(2 A t) is the square of exp(A t): formed in pairs, as each squaring doubles the relative error.
    """
    powers, forms = np.zeros((levels, 2, count, count)), np.zeros((levels, count, count))
    powers[0] = end[:, :count, :count]
    forms[0] = square[:count, :count]
    for level in range(1, levels):
        before, power = powers[level - 1], powers[level]
        for i in range(count):
            for k in range(count):
                if before[0, i, k] != 0.0:
                    for j in range(count):
                        term = product(
                            TwoFloats(before[0, i, k], before[1, i, k]), TwoFloats(before[0, k, j], before[1, k, j])
                        )
                        power[0, i, j], power[1, i, j] = plus(TwoFloats(power[0, i, j], power[1, i, j]), term)
        if problem.pair.a1 > 0.0:
            half, form = np.zeros((count, count)), forms[level]
            for i in range(count):
                for k in range(count):
                    for j in range(count):
                        half[i, j] += forms[level - 1, i, k] * before[0, k, j]
            for i in range(count):
                for j in range(count):
                    form[i, j] = forms[level - 1, i, j]
                    for k in range(count):
                        form[i, j] += before[0, k, i] * half[k, j]
    return powers, forms
