"""The engine of the free pair: one motion in every arithmetic, the same bits compiled, ties decided exactly."""

import json
import math
import threading
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from extremes.regenerate import ANSWERS, scene
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import decimals, long_slips, near_critical, scenes, signed

from numerics.arithmetic import compiled as compiling
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.errors import EventUndecided, NoForceHere, OutOfRange
from numerics.free.bound_steps import passing
from numerics.free.bounds import initial
from numerics.free.contact import contact
from numerics.free.engine import begin_exactly, in_halves, mode_at_start, run_free, scene_row
from numerics.free.rows import UNKNOWN, solve_row, solve_rows, solve_start
from numerics.linear.modes import Mode
from numerics.linear.record import AT, END_ROW, ROW, How
from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene

FLOATS, PAIRS = Float64(), DoubleDouble()
ARITHMETICS = {"float64": FLOATS, "double-double": PAIRS, "mpmath": Multiprecision(300), "ball": Ball(1000)}
ANSWER = json.loads(ANSWERS.read_text("utf-8"))
UNDAMPED = [name for name in ANSWER if not scene(name).pair.a1 and not scene(name).is_forced]
PAPER = load_scene("relative-motion-b05")
any_scene = st.one_of(
    scenes(size=(-2, 2)),
    scenes(exponents=(-9, 9)),
    near_critical(exponents=(3, 80)),
    long_slips(),
    scenes(law=Law.THREE_VALUED_SGN),
)


def number(x):
    return float(x.mid()) if isinstance(x, arb) else float(x)


def events(record):
    """t, x1, v1, x2, v2 at the events, in floats."""
    if isinstance(record.rows, list):
        return [[number(getattr(row, name)) for name in ("local", "x1", "v1", "x2", "v2")] for row in record.rows[1:]]
    return record.rows[1:, [AT[name] for name in ("local", "x1", "v1", "x2", "v2")]].tolist()


@pytest.mark.parametrize("way", ARITHMETICS)
@pytest.mark.parametrize("name", UNDAMPED)
def test_every_arithmetic_has_the_events_of_the_reference(name, way):
    """The reference shares no code (tests/extremes); a point arithmetic may refuse, or say that it is not certain."""
    truth = [[float(mpmath.mpf(one)) for one in event] for event in ANSWER[name]["events"]]
    try:
        found = run_free(scene(name), ARITHMETICS[way], len(truth))
    except OutOfRange:
        assert way in {"float64", "double-double", "mpmath"}
        return
    if not found.certain:
        return
    ours = events(found)
    assert len(ours) == len(truth)
    width, rate = float(scene(name).pair.half_width), float(scene(name).pair.a2 / scene(name).pair.mass) ** 0.5
    scales = [1 / rate, width, width * rate, width, width * rate]
    for one, two in zip(ours, truth, strict=True):
        assert all(abs(x - y) <= 1e-8 * abs(y) + 1e-9 * size for x, y, size in zip(one, two, scales, strict=True))


@given(any_scene)
@example(PAPER)
def test_double_double_lies_in_the_balls(case):
    """Every number is within its bound of the ball, which knows it to many more digits."""
    try:
        found, truth = run_free(case, PAIRS, 20), run_free(case, Ball(120), 20)
    except (OutOfRange, EventUndecided):
        return
    if not found.certain:
        return
    assert [row[0] for row in found.rows] == [row.mode for row in truth.rows]
    names = {"local": "late"} | {name: f"{name}_error" for name in ("x1", "v1", "x2", "v2", "excess")}
    with Ball(120).context():
        for ours, theirs in [*zip(found.rows, truth.rows, strict=True), (found.end, truth.end)]:
            for name, bound in names.items():
                off = abs(arb(ours[AT[name]]) + arb(ours[AT[name] + 1]) - getattr(theirs, name))
                assert off <= ours[AT[bound]] + 1e-300, name
        assert abs(arb(found.friction.high) + arb(found.friction.low) - truth.friction) <= found.dissipated_error


def begun(case, arithmetic):
    with arithmetic.context():
        at, given_ = begin_exactly(case, arithmetic)
        if arithmetic is PAIRS:
            at, given_ = (in_halves(one, arithmetic.halves) for one in (at, given_))
    return at, initial(at.at, at.start, at.V1, at.V2), given_


@pytest.mark.slow
@pytest.mark.parametrize("arithmetic", [FLOATS, PAIRS], ids=lambda one: one.name)
def test_compiled_code_has_the_same_bits(arithmetic):
    if not can_compile():
        pytest.skip("numba is not installed")

    @given(any_scene)
    @example(PAPER)
    def check(case):
        rows, end = [[0.0] * ROW for _ in range(61)], [0.0] * END_ROW
        try:
            arguments = begun(case, arithmetic)
            count = solve_start(*arguments, 60, rows, end)
        except (OutOfRange, ArithmeticError, ValueError):
            return
        fast, fast_end = np.zeros((61, ROW)), np.zeros(END_ROW)
        assert compiled(solve_start)(*arguments, 60, fast, fast_end) == count
        assert np.array_equal(rows, fast, equal_nan=True)
        assert np.array_equal(end, fast_end, equal_nan=True)

    check()


def test_many_rows_are_solved_in_one_call():
    cases = [Scene(PAPER.pair, State(v1=Fraction(k, 100)), 2) for k in range(1, 9)]
    table, kept, ends = np.array([scene_row(one) for one in cases]), np.zeros((8, 4, ROW)), np.zeros((8, END_ROW))
    table[3] = np.nan
    (compiled(solve_rows) if can_compile() else solve_rows)(table, False, 100, kept, ends)
    assert ends[3, AT["how"]] == UNKNOWN
    for index, case in enumerate(cases):
        if index != 3:
            alone = run_free(case, FLOATS, 100)
            assert ends[index].tolist() == alone.end.tolist()
            assert kept[index, : len(alone.rows)].tolist() == alone.rows[:4].tolist()


def test_the_record_is_in_si_units():
    found = run_free(PAPER, FLOATS, 1000)
    first, end = found.rows[0], found.end
    assert (found.how, found.events, found.certain) == (How.REACHED, 32, True)
    assert [first[AT[name]] for name in ("local", "length", "x1", "v1", "x2", "v2")] == [0, 0, 0, 0.15, 0, 0]
    assert first[AT["excess"]] == float(PAPER.energy_excess)
    assert end[AT["local"]] == 5
    assert sum(found.rows[:, AT["length"]]) + end[AT["length"]] == pytest.approx(5, rel=1e-14)
    # what friction took is what the energy lost
    energy = (200 * end[AT["x1"]] ** 2 + end[AT["v1"]] ** 2 + end[AT["v2"]] ** 2) / 2
    assert found.friction == pytest.approx(float(PAPER.energy) - energy, rel=1e-13)
    assert found.rows[1:, AT["event"]].all()
    cut = run_free(PAPER, FLOATS, 7)
    assert (cut.how, cut.events, len(cut.rows)) == (How.EVENT_LIMIT, 7, 8)
    assert cut.end[AT["x1"]] == cut.rows[-1][AT["x1"]]


@pytest.mark.parametrize("way", ARITHMETICS)
def test_time_costs_nothing_where_nothing_happens(way):
    """A stuck pair, and a slip of 10^5 turns: the horizon is not stepped through."""
    stuck = run_free(Scene(PAPER.pair, State(x1="0.001"), 10**9), ARITHMETICS[way], 10)
    assert (stuck.how, stuck.events) == (How.STUCK, 0)
    turning = run_free(Scene(Pair(1, 1, 1, 1), State(v2=6 * 10**5), 5 * 10**5), ARITHMETICS[way], 10)
    assert (turning.how, turning.events) == (How.REACHED, 0)


@pytest.mark.parametrize(
    ("start", "law", "mode"),
    [
        (State(x1="0.005"), "filippov", Mode.STICK),  # on the edge, at rest: E = E_cr
        (State(x1="0.005", v1="1e-300", v2="1e-300"), "filippov", Mode.SLIP_MINUS),
        (State(x1="0.005", v1="-1e-300", v2="-1e-300"), "filippov", Mode.STICK),
        (State(x1="0.005", v1="1e-300"), "filippov", Mode.SLIP_PLUS),
        (State(x1=Fraction(5, 1000) + Fraction(1, 10**400)), "filippov", Mode.SLIP_MINUS),
        (State(x1=-1), "filippov", Mode.SLIP_PLUS),
        (State(x1=-1), "three-valued-sgn", Mode.STICK),
    ],
)
def test_ties_are_decided_on_exact_numbers(start, law, mode):
    assert mode_at_start(Scene(PAPER.pair, start, 1, law)) is mode


def test_what_is_not_free_is_refused():
    with pytest.raises(NoForceHere):
        run_free(load_scene("forced-step"), FLOATS, 10)
    with pytest.raises(NoForceHere):
        mode_at_start(Scene(Pair(1, 1, 200, "0.5", a1=3), State(v1=1), 5))


@pytest.mark.parametrize("arithmetic", [FLOATS, PAIRS, Multiprecision(40)], ids=lambda one: one.name)
def test_an_angle_beyond_the_digits_is_out_of_range(arithmetic):
    far = Scene(Pair(1, 1, 1, 1), State(v2=Fraction(10) ** 60), 10**62)
    with pytest.raises(OutOfRange, match=arithmetic.name):
        run_free(far, arithmetic, 10)
    assert run_free(far, Ball(200), 1).events == 1


def test_progress_is_heard_of():
    heard = []
    run_free(Scene(PAPER.pair, PAPER.initial, 200), Ball(20), 1500, lambda *at: heard.append(at))
    assert heard
    assert heard[0][0] >= 999
    assert 0 < heard[0][1] < 1


def test_one_process_compiles_while_the_others_wait(tmp_path):
    pytest.importorskip("fcntl")
    begins, may_end, second_is_in = threading.Event(), threading.Event(), threading.Event()

    def slow(types):
        begins.set()
        assert may_end.wait(60)
        return types

    path = tmp_path / "new" / "one.lock"  # each opens the file anew, as another process does
    first = threading.Thread(target=compiling._one_process_at_a_time(slow, path), args=((),))
    first.start()
    assert begins.wait(60)
    second = threading.Thread(target=compiling._one_process_at_a_time(lambda _: second_is_in.set(), path), args=((),))
    second.start()
    assert not second_is_in.wait(0.2)
    may_end.set()
    first.join()
    second.join()
    assert second_is_in.is_set()


def test_a_folder_that_cannot_be_written_does_not_keep_anyone_from_compiling(tmp_path):
    (tmp_path / "file").write_text("")
    assert compiling._one_process_at_a_time(str, tmp_path / "file" / "one.lock")(3) == "3"


def test_a_graze_has_no_bound():
    assert passing(1e-3, 1.0, 1.0) == pytest.approx(1e-3, rel=1e-3)
    assert passing(1e-3, 0.01, 1.0) == math.inf


@reaching
@given(any_scene)
@example(PAPER)
def test_a_record_that_is_too_short_keeps_the_first_events(case):
    kept = []
    for room in (41, 3):
        rows, end = [[0.0] * ROW for _ in range(room)], [0.0] * END_ROW
        try:
            solve_start(*begun(case, FLOATS), 40, rows, end)
        except (OutOfRange, ArithmeticError, ValueError):
            raise LeftOut from None
        kept.append((rows[:3], end))
    assert str(kept[0]) == str(kept[1])  # nan is like nan


@reaching
@given(st.floats(0, 1), st.integers(-300, 12), st.floats(-1, 1), st.integers(-300, 8))
def test_the_contact_is_a_root(gap, of_gap, push, of_push):
    gap, push = gap * 2.0**of_gap, push * 2.0**of_push
    if gap == 0.0:
        push = abs(push)
    if max(gap, abs(push)) < 1e-60:
        raise LeftOut
    found = contact(gap, push)
    if found[0] < 1e-97:  # its powers are no normal numbers; a run refuses it
        raise LeftOut
    with Ball(200).context():
        for ours, exact in zip(found, contact(arb(gap), arb(push)), strict=True):
            assert abs(ours - exact) <= 8 * 2.0**-53 * abs(exact)


@st.composite
def rows_of_floats(draw):
    """A row of binary64 numbers as solve_many takes them, on the surface or near the edge now and then."""
    m1, m2, a2, b, until = (float(draw(decimals(-3, 3))) for _ in range(5))
    x1, v1, x2, v2 = (float(draw(st.one_of(st.just(Fraction(0)), signed(decimals(-3, 2))))) for _ in range(4))
    width = b * (m1 + m2) / (a2 * m2)
    x1 = draw(st.sampled_from([x1, x1, width, -width, width * (1 + 2.0**-40)]))
    return [m1, m2, a2, b, x1, v1, x2, draw(st.sampled_from([v2, v1])), until]


@reaching
@given(rows_of_floats(), st.booleans())
def test_arrays_are_prepared_to_the_bits_of_exact_rationals(row, literal):
    m1, m2, a2, b, x1, v1, x2, v2, until = map(Fraction, row)
    law = Law.THREE_VALUED_SGN if literal else Law.FILIPPOV
    case = Scene(Pair(m1, m2, a2, b), State(x1, v1, x2, v2), until, law)
    records = []
    for solve, start in ((solve_row, (scene_row(case).tolist(), literal)), (solve_start, begun(case, FLOATS))):
        rows, end = [[0.0] * ROW for _ in range(3)], [0.0] * END_ROW
        try:
            if solve(*start, 3, rows, end) == UNKNOWN:
                raise LeftOut  # left to exact rationals
        except (ArithmeticError, ValueError):
            raise LeftOut from None
        records.append((rows, end))
    assert str(records[0]) == str(records[1])


@pytest.mark.parametrize("row", [[1, 1, 200, 0.5, 0.005, 0, 0, 0, 5, 0], [1, 1, 1e300, 0.5, 0, 0.1, 0, 0, 5, 0]])
def test_a_start_that_106_bits_do_not_decide_is_left_to_exact_numbers(row):
    halves = [half for one in row for half in (float(one), 0.0)]
    assert solve_row(halves, False, 3, [[0.0] * ROW for _ in range(3)], [0.0] * END_ROW) == UNKNOWN
