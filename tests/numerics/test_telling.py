"""One text, told in every arithmetic: what it says is right in each, and a fault in it shows in each."""

import json
import math
import threading

import mpmath
import pytest
from extremes.regenerate import ANSWERS, scene
from flint import arb

from numerics.arithmetic import ball_words, compiling, double_words, float64, multiprecision
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.double_words import DOUBLE_DOUBLE
from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.arithmetic.multiprecision import Multiprecision
from numerics.arithmetic.telling import Telling, can_compile, text
from numerics.arithmetic.words import WORDS, words_of
from numerics.errors import NumericsError
from numerics.flows import oscillator
from numerics.motion import damped, undamped
from numerics.motion.begin import begin, in_halves
from numerics.run.families import run_telling
from numerics.run.row import solve_start
from numerics.run.rows import Growing
from numerics.sensitivity.duals import dual
from numerics.trajectory.record import Record, end_length, row_length

ANSWER = json.loads(ANSWERS.read_text("utf-8"))
UNDAMPED, DAMPED = "excess-1e-3", "damping-critical-slip"
ARITHMETICS = {
    "float64": Float64(),
    "double-double": DoubleDouble(),
    "mpmath": Multiprecision(40),
    "ball": Ball(40),
    "dual": dual(Float64()),
}


def with_fault(function, fault):
    """The text with its answer changed."""

    def faulty(*given):
        return fault(function(*given))

    return faulty


FAULTS = {
    "where a slip lands": (UNDAMPED, undamped.landing, lambda found: found._replace(theta=found.theta * 1025 / 1024)),
    "where a landing is": (UNDAMPED, undamped.after_landing, lambda found: found._replace(Z=-found.Z)),
    "how a stick phase ends": (UNDAMPED, undamped.stick_reach, lambda found: found._replace(below=found.below * 2)),
    "the damped motion": (DAMPED, oscillator.propagate, lambda found: (found[0], -found[1])),
    "how long a damped motion lasts": (
        DAMPED,
        undamped.locate,
        lambda found: (found[0], found[1] * 1025 / 1024, found[2]),
    ),
    "the state after damping": (DAMPED, damped.land, lambda found: found._replace(Z=2 * found.Z)),
}


def told(name, way, instead):
    """The events of an extreme scene as floats (t, x1, v1, x2, v2), told with some texts replaced."""
    case, arithmetic, width = scene(name), ARITHMETICS[way], 2 if way == "double-double" else 1
    base = DOUBLE_DOUBLE if way == "double-double" else arithmetic.telling
    telling = run_telling(base, is_damped=case.pair.a1 > 0).but("planted", instead) if instead else None
    telling = telling or run_telling(base, is_damped=case.pair.a1 > 0)
    with arithmetic.context():
        begun = begin(case, arithmetic)
        begun = in_halves(begun, arithmetic.halves) if width == 2 else begun
        rows, end = Growing(row_length(width), 12), [0.0] * end_length(width)
        telling(solve_start)(*begun, 12, rows, end)
        record = Record(rows.rows, end, width)
        length, rate = (number(record.end(unit)) for unit in ("length_unit", "rate"))
        numbers = [
            [number(record.number(index, one)) for one in ("tau", "X", "V", "Z")] for index in range(len(rows.rows))
        ]
    return [(t / rate, length * X, length * rate * V, length * (X - Z), length * rate * V) for t, X, V, Z in numbers]


def number(x):
    x = getattr(x, "value", x)
    return float(x.mid()) if isinstance(x, arb) else float(x)


def is_right(name, way, instead=None):
    """Whether the events are those of the reference, which shares no code, to 9 digits of each unit."""
    truth = [[float(mpmath.mpf(one)) for one in event] for event in ANSWER[name]["events"]]
    found = told(name, way, instead)
    return len(found) == len(truth) and all(
        math.isclose(one, two, rel_tol=1e-8, abs_tol=1e-9)
        for ours, theirs in zip(found, truth, strict=True)
        for one, two in zip(ours, theirs, strict=True)
    )


@pytest.mark.parametrize("way", ARITHMETICS)
@pytest.mark.parametrize("name", [UNDAMPED, DAMPED])
def test_every_arithmetic_tells_the_motions_right(name, way):
    assert is_right(name, way)


@pytest.mark.parametrize("way", ARITHMETICS)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_in_the_one_text_shows_in_every_arithmetic(fault, way):
    name, planted, change = FAULTS[fault]
    arithmetic = ARITHMETICS[way]
    base = DOUBLE_DOUBLE if way == "double-double" else arithmetic.telling
    honest = run_telling(base, is_damped=name == DAMPED)
    try:
        right = is_right(name, way, {planted: with_fault(honest(planted), change)})
    except (ArithmeticError, ValueError, NumericsError):  # refused, which is as good as seen
        right = False
    assert not right


@pytest.mark.parametrize("module", [float64, double_words, multiprecision, ball_words], ids=lambda one: one.__name__)
def test_every_arithmetic_has_every_word(module):
    assert set(words_of(module)) == set(WORDS)


@text
def doubled(x):
    """Twice the root."""
    return 2 * float64.sqrt(x)


def test_a_text_is_told_once_and_keeps_its_own_words():
    telling = Telling("shouting", {"sign": lambda x, question: 7}, words_of(float64))
    assert telling(doubled) is doubled  # attributes are no words
    told_once = telling(undamped.exit_side)
    assert told_once is telling(undamped.exit_side)
    assert told_once is not undamped.exit_side
    assert FLOAT64(undamped.exit_side) is undamped.exit_side


def test_what_is_compiled_is_the_text():
    if not can_compile():
        pytest.skip("numba is not installed")
    assert FLOAT64.compiled(undamped.no_landing)() == undamped.no_landing()


def test_one_process_compiles_while_the_others_wait(tmp_path):
    pytest.importorskip("fcntl")
    begun, may_end, second_is_in = threading.Event(), threading.Event(), threading.Event()

    def slow(types):
        begun.set()
        assert may_end.wait(60)
        return types

    path = tmp_path / "new" / "one.lock"  # each opens the file anew, as another process does
    first = threading.Thread(target=compiling._one_process_at_a_time(slow, path), args=((),))
    first.start()
    assert begun.wait(60)
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
