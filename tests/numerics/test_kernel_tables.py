"""The kernel's tables and what is formed with them, against the exact generator in many digits; and rounding."""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_runs import STATE, a_scene, exact

from numerics import Force, Pair, Piece, Scene, Sine, State
from numerics.linear.columns import UNIT, force_columns, make_room, product, state_columns
from numerics.linear.next_event import slip_guard, stick_guards
from numerics.linear.prepare import prepare
from numerics.linear.table import ORDERS, fill

seeds = st.integers(0, 2**32 - 1)


def number(x):
    return mpmath.mpf(x.numerator) / x.denominator


def generator(scene, piece, mode):
    """A of z' = A z, from the equations of motion, in SI units."""
    pair, terms, n = scene.pair, len(piece.polynomial), 5 + len(piece.polynomial) + 2 * len(piece.sines)
    A = mpmath.zeros(n)
    A[0, 1] = A[2, 3] = 1
    acting = [5] * (terms > 0) + [5 + terms + 2 * k for k in range(len(piece.sines))]
    for row, mass in ((1, pair.m1 if mode else pair.mass), (3, pair.mass)):
        if mode and row == 3:
            continue
        A[row, 0], A[row, 1] = -number(pair.a2 / mass), -number(pair.a1 / mass)
        for column in acting:
            A[row, column] = 1 / number(mass)
    if mode:
        A[1, 4], A[3, 4] = -1 / number(pair.m1), 1 / number(pair.m2)
    for k in range(terms - 1):
        A[5 + k, 6 + k] = k + 1
    for k, sine in enumerate(piece.sines):
        at = 5 + terms + 2 * k
        A[at, at + 1], A[at + 1, at] = number(sine.omega), -number(sine.omega)
    return A


def column_units(scene, piece, units):
    """What each component of z is counted in: a power of 2, SI."""
    length, speed, force = units.of(length=1), units.of(length=1, time=-1), units.of(mass=1, length=1, time=-2)
    waves = [force] * (2 * len(piece.sines))
    return [
        length,
        speed,
        length,
        speed,
        force,
        *(force - k * units.time for k in range(len(piece.polynomial))),
        *waves,
    ]


@st.composite
def acted_on(draw):
    """Scenes of any size and damping under polynomials and sines, some of them in resonance."""
    masses = [exact(draw(st.floats(0.01, 9)), 3) * 10 ** draw(st.integers(0, 3)) for _ in range(2)]
    a1 = exact(draw(st.sampled_from([0, 0.3, 2, 30])))
    pair = Pair(*masses, 4 * masses[0], exact(draw(st.floats(0.1, 9))), a1)
    waves = [
        Sine(1, draw(st.sampled_from([2, "0.37", "31.7"])), exact(draw(st.floats(-9, 9))))
        for _ in range(draw(st.integers(0, 2)))
    ]
    polynomial = [exact(draw(st.floats(0.1, 2))) for _ in range(draw(st.integers(0, 4)))]
    return Scene(
        pair,
        State("0.3", 1, "-0.2", 2),
        draw(st.sampled_from([5, "0.001"])),
        force=Force([Piece(0, polynomial, waves)]),
    )


@given(acted_on(), st.booleans(), st.sampled_from([0, 1]))
@settings(max_examples=10)
def test_rows_and_ends_are_those_of_the_exponential(scene, wide, mode):
    prepared = prepare(scene, wide=wide)
    tables, side, piece = prepared.tables, int(mode == 0), prepared.pieces[0]
    units, n = column_units(scene, piece, prepared.units), int(tables.count[0])
    with mpmath.workdps(50):
        step = mpmath.ldexp(mpmath.mpf(float(tables.h[0, side])), prepared.units.time)
        A = generator(scene, piece, mode) * step
        power, total = mpmath.eye(n), mpmath.zeros(n)
        for k in range(60):
            scaled = lambda i, j, m=power: mpmath.ldexp(m[i, j], units[j] - units[i])  # noqa: E731
            for i in range(2) if k < tables.rows.shape[5] else ():
                for j in range(n):
                    high, low = tables.rows[0, side, :, i, j, k]
                    assert (
                        abs(scaled(2 * i, j) - high - low)
                        <= 2.0**-95 * abs(tables.rows[0, side, 0, :, j, k]).max() + 1e-60
                    )
                    assert high == 0 or k < tables.degrees[0, side, i, j]
            total += power
            power = A * power / (k + 1)
        for i in range(n):
            for j in range(n):
                high, low = tables.ends[0, side, :, i, j]
                assert abs(scaled(i, j, total) - high - low) <= 2.0 ** (-95 if wide else -65) * (abs(high) + 0.01)


def acting(scene, piece, t):
    """The columns of z that belong to u, at a time of the piece, SI; and u'."""
    polynomial, slope = piece.polynomial, mpmath.mpf(0)
    found = [
        sum((number(c) * math.comb(n, k) * t ** (n - k) for n, c in enumerate(polynomial) if n >= k), mpmath.mpf(0))
        for k in range(len(polynomial))
    ]
    slope = found[1] if len(polynomial) > 1 else mpmath.mpf(0)
    for sine in piece.sines:
        phase, amplitude = number(sine.omega) * t + number(sine.phase), number(sine.amplitude)
        found += [amplitude * mpmath.sin(phase), amplitude * mpmath.cos(phase)]
        slope += number(sine.omega) * found[-1]
    return found, slope


@given(acted_on(), st.booleans())
@settings(max_examples=10)
def test_the_force_later_is_that_of_the_scene_and_changes_by_no_more_than_it_says(scene, wide):
    prepared = prepare(scene, wide=wide)
    piece, units, late = prepared.pieces[0], prepared.units, float(prepared.tables.h[0, 0]) / 32
    exponents, room = column_units(scene, piece, units)[5:], make_room(prepared.tables.rows.shape[4], 24)
    room.clock[0, 0] = at = float(prepared.drive.length[0, 0]) * 0.7
    u, speed, size = force_columns(room, prepared.drive, 0, late, wide)
    with mpmath.workdps(50):
        times = [mpmath.ldexp(mpmath.mpf(at) + k * late, units.time) for k in (0, -1, 1)]
        expected = acting(scene, piece, times[0])[0]
        for j, (value, exponent) in enumerate(zip(expected, exponents, strict=True), start=5):
            off = abs(mpmath.ldexp(value, -exponent) - room.z[0, j] - room.z[1, j])
            assert off <= (2.0**-95 if wide else UNIT) * room.size[j]
        total = sum([*expected[: min(1, len(piece.polynomial))], *expected[len(piece.polynomial) :: 2]])
        force = units.of(mass=1, length=1, time=-2)
        assert u == pytest.approx(math.ldexp(float(total), -force), rel=1e-9, abs=1e-12 * size)
        slopes = [abs(math.ldexp(float(acting(scene, piece, t)[1]), units.time - force)) for t in times]
    assert speed >= max(slopes) * (1 - 1e-12)
    assert size >= abs(u)
    if len(piece.sines) < 2 and not piece.polynomial:
        assert speed <= 1.1 * max(slopes) + 1e-12


def wholly(prepared, mode, order, wide):
    """A room at the start of a run, the guard of a mode formed in it, and its columns."""
    tables, side = prepared.tables, int(mode == 0)
    room, count = make_room(tables.rows.shape[4], tables.rows.shape[5]), int(tables.count[0])
    force_columns(room, prepared.drive, 0, 0.0, wide)
    room.y[:, 0] = prepared.start[STATE]
    state_columns(room, mode, prepared.drive.b[0])
    return room, tables.rows[0, side], tables.degrees[0, side], count


def guard_of(room, rows, degrees, count, mode, order):
    product(rows, degrees, room.z, count, room.X)
    if mode:
        slip_guard(room, mode, order, False)
    else:
        stick_guards(room, (0.0, 0.0), order, 1)
    return room.q.copy()


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("mode", [-1, 0, 1])
def test_what_is_rounded_moves_a_guard_by_no_more_than_its_sums(mode, order):
    """Planted roundings of z, all in the worst direction, and those of the products; the sums are not far above."""
    random, largest = np.random.default_rng(3), 0.0
    for _ in range(10):
        prepared = prepare(a_scene(random), wide=False)
        room, rows, degrees, count = wholly(prepared, mode, order, False)
        sums = (prepared.tables.slip_sums if mode else prepared.tables.load_sums)[0, order]
        before, z = guard_of(room, rows, degrees, count, mode, order), room.z[0].copy()
        size, k = room.size[:count].copy(), np.arange(order + 1, rows.shape[3] - 1)
        first, second = abs(rows[0, :, :count])
        terms = k * (first + second)[:, k] if mode else k * (k + 1) * second[:, k + 1]
        assert (sums[:count] >= (count + 8) * terms.sum(1)).all()  # each has as many roundings at least
        for sign in (random.choice([-1, 1], count) for _ in range(20)):
            room.z[0, :count] = z[:count] + 2.0**-20 * sign * size
            moved = abs(guard_of(room, rows, degrees, count, mode, order) - before).sum()
            largest = max(largest, moved / (2.0**-20 * (size @ sums[:count])))
    assert 0.02 < largest < 0.2


class Filled:
    def __init__(self, n, terms):
        self.rows, self.degrees, self.end = (
            np.zeros((2, 2, n, terms)),
            np.zeros((2, n), dtype=np.int64),
            np.zeros((2, n, n)),
        )
        self.slip, self.load = np.zeros((ORDERS, n)), np.zeros((ORDERS, n))

    def parts(self):
        return self.rows, self.degrees, self.end, self.slip, self.load


@pytest.mark.parametrize("terms", [4, 6, 9])
def test_what_is_cut_off_is_within_the_sums(terms):
    """Tables of a few terms, where truncation is all there is, beside those of many."""
    scene = Scene(Pair(1, 2, 3, 1, "0.4"), State(1, 1, 0, 2), 9, force=Force([Piece(0, [1, 2], [Sine(1, "1.1", 0)])]))
    for mode, side in ((1, 0), (0, 1)):
        full = prepare(scene, wide=False).tables
        n, h = int(full.count[0]), float(full.h[0, side])
        A = np.array(generator(scene, prepare(scene, wide=False).pieces[0], mode).tolist(), dtype=float)
        places = np.argwhere(A)
        entries = np.array([[A[i, j], 0.0] for i, j in places])
        many, few = (Filled(n, count) for count in (24, terms))
        for table in (many, few):
            fill(entries, places, h, n, table.rows.shape[3], *table.parts())
        weights = np.arange(1, 23)
        slip = (weights * np.diff(many.rows[0][::-1], axis=0)[0][:, 1:23])[:, terms - 1 :]
        load = ((weights + 1) * weights * many.rows[0, 1, :, 2:])[:, terms - 2 :]
        for cut, sums in ((slip, few.slip), (load, few.load)):
            assert (abs(cut).sum(1) <= sums[ORDERS - 1] * UNIT * (1 + 1e-9) + 1e-16).all()
