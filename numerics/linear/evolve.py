"""Evolve: the state, the clock and the set of errors over a step, to an event, or over a long calm stick at once."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.arithmetic.compiled import compilable, compilable_with
from numerics.linear.columns import (
    FAST,
    Constants,
    Drive,
    Room,
    counted,
    force_columns,
    wide_product,
)
from numerics.linear.error_set import carry, take_in
from numerics.linear.first_root import value_slope
from numerics.linear.pairs import add, divide, multiply, times
from numerics.linear.table import FIRST, NODES, PRECISE, UNIT, V1, WEIGHTS, WIDE_UNIT, X1, Tables, parts


@compilable_with(forceinline=False)
def evaluate(X: Any, sh: float, sl: float, h: float, wide: bool) -> tuple[float, float, float, float]:
    """Return x and v of a body with coefficients X (2, terms) at s = t/h, pairs.

    Where `wide`, at sh, and from there by first derivatives: |sl| <= 2^-53 sh, and a term of second order, k^2/2 2^-106
    of that of s^k, is within the 2 k 2^-101 that are counted for this one.
    """
    if not wide:
        value, slope = value_slope(X[0], sh)
        return value, 0.0, slope / h, 0.0
    ah, bh = value_slope(X[0, PRECISE:], sh)
    al = bl = bend = 0.0
    for k in range(min(PRECISE, X.shape[1]) - 1, -1, -1):
        bend = bend * sh + bh
        bh, bl = times(bh, bl, sh)
        bh, bl = add(bh, bl, ah, al)
        ah, al = times(ah, al, sh)
        ah, al = add(ah, al, X[0, k], X[1, k])
    ah, al = add(ah, al, sl * bh, 0.0)
    bh, bl = add(bh, bl, 2.0 * sl * bend, 0.0)
    bh, bl = divide(bh, bl, h, 0.0)
    return ah, al, bh, bl


@compilable_with(**FAST)
def full_step(whole: Any, size: Any, z: Any, count: int, unit: float, y: Any, own: Any) -> None:
    """Move the state by exp(A h) in float64; form what that adds to its errors."""
    for i in range(4):
        row, value, most = whole[0, i], 0.0, 0.0
        for j in range(count):
            value += row[j] * z[0, j]
            most += abs(row[j]) * size[j]
        y[i, 0], own[i] = value, (count + 4) * most * unit


@compilable_with(forceinline=False)
def wide_step(whole: Any, z: Any, count: int, y: Any) -> None:
    """Move the state by exp(A h) in pairs."""
    y[:, :] = 0.0
    for j in range(count):
        for i in range(4):  # four sums at once
            p, e = multiply(whole[0, i, j], whole[1, i, j], z[0, j], z[1, j])
            y[i, 0], y[i, 1] = add(y[i, 0], y[i, 1], p, e)


@compilable
def partial_step(
    tables: Tables, at: tuple[int, int], s: tuple[float, float], unit: float, wide: bool, room: Room
) -> tuple[float, float]:
    """Move the state by a part s of a step; form what that adds to its errors; return how x1 and v1 go with v1."""
    kind, side = at
    y, own, sums, h = room.y, room.column, tables.state_own[kind, side], tables.h[kind, side]
    for i in range(2):
        X = room.X[:, i, :4] if i == 1 and side == 0 else room.X[:, i, :]  # body 2 goes on a parabola in a slip
        y[2 * i, 0], y[2 * i, 1], y[2 * i + 1, 0], y[2 * i + 1, 1] = evaluate(X, s[0], s[1], h, wide)
        own[2 * i] = unit * counted(sums[2 * i], room.size, tables.count[kind], s[0])
        own[2 * i + 1] = unit / h * counted(sums[2 * i + 1], room.size, tables.count[kind], s[0])
    value, slope = value_slope(tables.rows[kind, side, 0, 0, V1], s[0])
    return value, slope / h


@compilable
def evolve(
    pair: Constants,
    tables: Tables,
    room: Room,
    at: tuple[int, int],
    mode: int,
    s: tuple[float, float],
    is_wide: bool,
    wide: bool,
) -> tuple[float, float]:
    """Move state, errors and clock by s steps; return the time, and what the step adds to N.

    `is_wide`: the coefficients have been formed in pairs, where that is asked for.
    """
    kind, side = at
    h, count, unit, whole = tables.h[kind, side], tables.count[kind], WIDE_UNIT if wide else UNIT, tables.ends[at]
    if s[0] == 1.0 and s[1] == 0.0:
        full_step(whole, room.size, room.z, count, unit, room.y, room.column)
        if wide:
            wide_step(whole, room.z, count, room.y)
        reach, turn = whole[0, X1, V1], whole[0, V1, V1]
    else:
        if wide and not is_wide:
            wide_product(tables.rows[kind, side], tables.degrees[kind, side], room.z, count, room.X)
        reach, turn = partial_step(tables, at, s, unit, wide, room)
    time, low = multiply(s[0], s[1], h, 0.0)
    return time, end_step(pair, room, mode, (time, low), reach, turn)


@compilable
def end_step(pair: Constants, room: Room, mode: int, time: tuple[float, float], reach: float, turn: float) -> float:
    """Move clock and errors by a step of the state; return what it adds to N. reach, turn: how x1 and v1 go with v1."""
    own, scale = room.column, room.scale
    if mode == 0:
        room.y[3, 0], room.y[3, 1] = room.y[1, 0], room.y[1, 1]
        own[3] = own[1]
    for i in range(2):
        room.clock[i, 0], room.clock[i, 1] = add(room.clock[i, 0], room.clock[i, 1], time[0], time[1])
    added = own[0] * scale[0] + own[1] * scale[1] + own[3] * scale[3]
    carry(room.E, room.R, pair, mode, time[0], (reach, turn), added, own[2] * scale[2])
    return added


@compilable_with(**FAST)
def slid_and_damped(
    pair: Constants, tables: Tables, room: Room, at: tuple[int, int], mode: int, s: float
) -> tuple[float, float, float, float]:
    """Return how far the bodies slide, the size of its terms, int v1^2 dt and its size, up to s.

    The integral is a quadratic form of z over a whole step, by Gauss's rule over a part of one.
    """
    slid, size, damped, terms, h = 0.0, 0.0, 0.0, room.q.shape[0], tables.h[at[0], at[1]]
    if mode != 0:
        g, square, odd, odd_size = room.g, s * s, 0.0, 0.0
        for k in range(terms - 2, -1, -2):
            one, two = g[0, k] * room.inverse[k], g[0, k + 1] * room.inverse[k + 1]
            slid, odd = slid * square + one, odd * square + two
            size, odd_size = size * square + abs(one) * (k + 8.0), odd_size * square + abs(two) * (k + 9.0)
        slid, size = s * (slid + s * odd), s * (size + s * odd_size)
    if pair.a1 > 0.0 and s == 1.0:
        damped, damped_size = of_square(tables.squares[at[0], at[1]], room.z, tables.count[at[0]])
        return slid, size, damped, damped_size
    if pair.a1 > 0.0:
        X, place, v, cut = room.X[0, 0], room.nodes[0], room.nodes[1], parts(terms)
        for part in range(cut):
            for n in range(NODES.shape[0]):
                place[n], v[n] = s / cut * (part + NODES[n]), (terms - 1) * X[terms - 1]
            for k in range(terms - 3, 0, -2):  # two powers at a time: v is read and written half as often
                high, low = (k + 1) * X[k + 1], k * X[k]
                for n in range(NODES.shape[0]):
                    v[n] = (v[n] * place[n] + high) * place[n] + low
            for n in range(NODES.shape[0]):
                damped += WEIGHTS[n] * v[n] * v[n]
        damped *= s / (cut * h)
    return slid, size, damped, damped


@compilable_with(forceinline=False, **FAST)
def of_square(form: Any, z: Any, count: int) -> tuple[float, float]:
    """Return z F z, at least 0, and what its terms are at most together: n sum_i F_ii z_i^2, as F is one of squares."""
    value, size = 0.0, 0.0
    for i in range(count):
        total = 0.0
        for j in range(count):
            total += form[i, j] * z[0, j]
        value += total * z[0, i]
        size += form[i, i] * z[0, i] * z[0, i]
    return max(value, 0.0), count * size


@compilable
def rest_is_calm(pair: Constants, drive: Drive, room: Room, piece: int, b: float, N: float) -> bool:
    """Return whether |Lambda| < b is proved from here to the end of the piece, however late that is.

    Lambda/m2 = x'' is the steady state's, at most the sum of its amplitudes, and that of a free motion y, of which
    y^2 + (M/a2) y'^2 never grows. Only for polynomials up to t^2, whose part of x'' is constant, away from resonance.
    """
    terms, sines, z = drive.places[piece, 1], drive.places[piece, 3], room.z
    if terms > 3:
        return False
    u0 = z[0, FIRST] if terms > 0 else 0.0
    u1 = z[0, FIRST + 1] if terms > 1 else 0.0
    steady = 2.0 * z[0, FIRST + 2] / pair.a2 if terms > 2 else 0.0
    first = FIRST + terms
    for i in range(sines):
        u0 += z[0, first + 2 * i]
        u1 += drive.sines[drive.places[piece, 2] + i, 1, 0] * z[0, first + 2 * i + 1]
    x, v = room.y[0, 0], room.y[1, 0]
    bend = (u0 - pair.a2 * x - pair.a1 * v) / pair.mass
    free, rate = bend - steady, (u1 - pair.a1 * bend - pair.a2 * v) / pair.mass
    most = abs(steady)
    rounding = abs(bend) + most + abs(rate) * math.sqrt(pair.mass / pair.a2)
    for i in range(sines):
        omega = drive.sines[drive.places[piece, 2] + i, 1, 0]
        stiff, drag = pair.a2 - pair.mass * omega * omega, pair.a1 * omega
        square = stiff * stiff + drag * drag
        if not square > 1e-12 * pair.a2 * pair.a2:
            return False
        sine, cosine = z[0, first + 2 * i], z[0, first + 2 * i + 1]
        scale = omega * omega / square
        free += scale * (stiff * sine - drag * cosine)
        rate += scale * omega * (stiff * cosine + drag * sine)
        peak = scale * math.sqrt(square * (sine * sine + cosine * cosine))
        most += peak
        rounding += peak * (1.0 + omega * math.sqrt(pair.mass / pair.a2))
    most += math.sqrt(free * free + pair.mass / pair.a2 * rate * rate) + 1e-13 * rounding
    return pair.m2 * most + pair.lam * N < (1.0 - 1e-9) * b


@compilable_with(makes_arrays=True, forceinline=False)
def long_step(
    pair: Constants, tables: Tables, room: Room, drive: Drive, piece: int, at: tuple[int, int], wide: bool
) -> tuple[float, float, float]:
    """Stick to the end of the piece but for less than a step, by powers of exp(A h).

    Return int v1^2 dt, its size, and what the steps add to N.
    exp(2 A t) is the square of exp(A t); with it goes the quadratic form of int v1^2 dt, by doubling too.
    """
    kind, side = at
    h, count, unit = tables.h[kind, side], tables.count[kind], WIDE_UNIT if wide else UNIT
    total = drive.length[piece, 0] - room.clock[0, 0]
    levels = 1 + max(0, math.floor(math.log2(total / h)))
    powers, forms = np.zeros((levels, 2, count, count)), np.zeros((levels, count, count))
    powers[0] = tables.ends[kind, side][:, :count, :count]
    forms[0] = tables.squares[kind, side, :count, :count]
    for level in range(1, levels):
        before = powers[level - 1]
        for i in range(count):
            for k in range(count):
                if before[0, i, k] != 0.0:
                    for j in range(count):
                        p, q = multiply(before[0, i, k], before[1, i, k], before[0, k, j], before[1, k, j])
                        powers[level, 0, i, j], powers[level, 1, i, j] = add(
                            powers[level, 0, i, j], powers[level, 1, i, j], p, q
                        )
        if pair.a1 > 0.0:
            half = np.zeros((count, count))
            for i in range(count):
                for k in range(count):
                    for j in range(count):
                        half[i, j] += forms[level - 1, i, k] * before[0, k, j]
            for i in range(count):
                for j in range(count):
                    forms[level, i, j] = forms[level - 1, i, j]
                    for k in range(count):
                        forms[level, i, j] += before[0, k, i] * half[k, j]
    take_in(room.E, room.R, room.basis, room.column)
    damped = size = grown = 0.0
    while True:
        left = drive.length[piece, 0] - room.clock[0, 0]
        if not left >= h:
            return damped, size, grown
        level = min(levels - 1, math.floor(math.log2(left / h)))
        if level < 0:
            return damped, size, grown
        if pair.a1 > 0.0:
            taken, its_size = of_square(forms[level], room.z, count)
            damped, size = damped + taken, size + its_size
        # each squaring doubles the relative error of the power
        off = unit + math.ldexp(WIDE_UNIT, level)
        full_step(powers[level], room.size, room.z, count, off, room.y, room.column)
        if wide:
            wide_step(powers[level], room.z, count, room.y)
        reach, turn = powers[level, 0, X1, V1], powers[level, 0, V1, V1]
        grown += end_step(pair, room, 0, (math.ldexp(h, level), 0.0), reach, turn)
        take_in(room.E, room.R, room.basis, room.column)
        force_columns(room, drive, piece, 0.0, wide)
        for i in range(4):
            room.z[0, i], room.z[1, i], room.size[i] = room.y[i, 0], room.y[i, 1], abs(room.y[i, 0])
