"""A force and a friction in time are read exactly, and what describes none is refused in one line."""

from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import MODERATE, decimals, forces, frictions, pairs, signed, states

from numerics.errors import InvalidScene
from numerics.scene import Force, Friction, Pair, Piece, Scene, State
from numerics.scene.decimals import decimal_text, exact_decimal
from numerics.scene.file import parse_scene
from numerics.scene.writing import scene_text

TIMES = st.integers(0, 40).map(lambda k: Fraction(k, 3))
VALID = """[pair]
m1 = 1
m2 = 1
a2 = 200
b = 0.5
[run]
until = 5
"""


@given(forces(), forces(), TIMES, st.sampled_from([-1, 1]))
def test_a_sum_of_forces_is_the_sum_of_their_values_on_both_sides_of_a_jump(f, g, t, side):
    both = (f + g)(t, side)
    assert both == pytest.approx(float(f(t, side)) + float(g(t, side)), rel=1e-9, abs=1e-6)


@given(forces(), TIMES, signed(decimals(*MODERATE)))
def test_a_multiple_of_a_force_and_its_opposite(f, t, factor):
    assert (factor * f)(t) == pytest.approx(float(factor) * float(f(t)), rel=1e-9, abs=1e-6)
    assert float((-f)(t)) == -float(f(t))


@given(forces())
def test_a_piece_that_is_moved_is_the_same_function_exactly(f):
    for piece in f.pieces:
        assert piece.moved(piece.start + Fraction(7, 3)).moved(piece.start) == piece


def test_the_ready_made_forces():
    half = Fraction(1, 2)
    step, ramp = Force.step(1, 2), Force.ramp(1, 3, "0.4")
    assert [step(t) for t in (0, half, 1, 9)] == [0, 0, 2, 2]
    assert (step(1, -1), ramp(1), ramp(2), ramp(3), ramp(9)) == (0, 0, Fraction(1, 5), Fraction(2, 5), Fraction(2, 5))
    hill = Force.trapezoid(1, 2, 1, "0.5", 3)
    assert [hill(t) for t in (1, 2, 3, half + 3, 4, 4 + half / 2, 4 + half, 5)] == [
        0,
        half * 3,
        3,
        3,
        3,
        half * 3,
        0,
        0,
    ]
    pulse = Force.trapezoid(0, 0, 1, 0, 3)
    assert [pulse(t) for t in (0, half, 1)] == [3, 3, 0]
    sweep = Force.sweep(2, [3, 5, "1/3"], 1, "0.5")
    for at in (Fraction(3, 2), Fraction(5, 2)):
        assert sweep(at, -1) == pytest.approx(sweep(at), abs=1e-12)
    assert Force.sine(2, 3).frequency == 3
    assert (Force.sine(2, "1/2") + Force.sine(1, "1/3")).frequency == Fraction(1, 6)
    assert Force.step(0, 1).frequency is None


@given(pairs(damped=None), st.data(), forces(), frictions())
def test_a_scene_survives_its_text(pair, data, force, friction):
    scene = Scene(pair, data.draw(states(pair)), 5, force=force, friction=friction)
    again = parse_scene(scene_text(scene))
    assert again == scene
    assert hash(again) == hash(scene)


@given(signed(decimals(-300, 300, 30)))
@example(Fraction(0))
@example(Fraction(10) ** 1000)
@example(Fraction(1, 10**1000))
@example(Fraction(2**80, 3))
def test_every_number_survives_its_text(value):
    assert exact_decimal(decimal_text(value), "x1") == value


def piece(text: str) -> str:
    return VALID + "[[force]]\n" + text + "\n"


def friction_of(text: str) -> str:
    return VALID + "[[friction]]\n" + text + "\n"


BAD_PIECES = {
    "a ratio with nothing below": piece('from = "1/0"'),
    "an exponent out of range": piece('polynomial = ["1e1001"]'),
    "an exponent of nine digits": piece("polynomial = [1e999999999]"),
    "a number too long": piece(f'polynomial = ["{"1" * 1001}"]'),
    "a date for a time": piece("from = 1979-05-27"),
    "a phase that is nan": piece("sines = [{ amplitude = 1, omega = 1, phase = nan }]"),
    "an amplitude that is true": piece("sines = [{ amplitude = true, omega = 1 }]"),
    "a frequency in words": piece('sines = [{ amplitude = 1, omega = "fast" }]'),
    "a frequency barely negative": piece('sines = [{ amplitude = 1, omega = "-1e-300" }]'),
    "too many sines": piece(f"sines = [{', '.join(['{ amplitude = 1, omega = 1 }'] * 1001)}]"),
    "the same key twice": piece("from = 1\nfrom = 2"),
    "brackets without end": piece(f"polynomial = {'[' * 3000}{']' * 3000}"),
    "a key with a line break": piece('"a\\nb" = 1'),
    "control characters": piece('from = "\\u001b[31m1"'),
    "digits of another script": piece('from = "\u0661"'),
    "an underscore in a text": piece('from = "1_0"'),
    "too many pieces": VALID + "".join(f"[[force]]\nfrom = {k}\n" for k in range(100_001)),
    "friction that is inf": friction_of("from = 1\nb = inf"),
    "friction with a key it has not": friction_of("from = 1\nb = 1\nmu = 2"),
    "friction twice at one time": friction_of('from = 1\nb = 1\n[[friction]]\nfrom = "2/2"\nb = 2'),
    "order": piece("from = 2\n[[force]]\nfrom = 1"),
    "the same time twice": piece("from = 1\n[[force]]\nfrom = 1.0"),
    "negative time": piece("from = -1"),
    "frequency 0": piece("sines = [{ amplitude = 1, omega = 0 }]"),
    "negative frequency": piece("sines = [{ amplitude = 1, omega = -2 }]"),
    "no frequency": piece("sines = [{ amplitude = 1 }]"),
    "no amplitude": piece("sines = [{ omega = 1 }]"),
    "unknown key of a sine": piece("sines = [{ amplitude = 1, omega = 1, frequency = 2 }]"),
    "a sine that is a number": piece("sines = [1]"),
    "sines that are a table": piece("sines = { amplitude = 1, omega = 1 }"),
    "a polynomial that is a number": piece("polynomial = 1"),
    "a coefficient that is no number": piece('polynomial = [1, "one"]'),
    "a coefficient that is a list": piece("polynomial = [[1]]"),
    "a coefficient that is true": piece("polynomial = [true]"),
    "a time that is nan": piece("from = nan"),
    "too many coefficients": piece(f"polynomial = {[1] * 65}"),
    "unknown key": piece("start = 1"),
    "one table, not an array": VALID + "[force]\nfrom = 1\n",
    "numbers, not tables": "force = [1]\n" + VALID,
    "b = 0": VALID + "[[friction]]\nfrom = 1\nb = 0\n",
    "b negative": VALID + "[[friction]]\nfrom = 1\nb = -1\n",
    "friction before 0": VALID + "[[friction]]\nfrom = -1\nb = 1\n",
    "friction out of order": VALID + "[[friction]]\nfrom = 2\nb = 1\n[[friction]]\nfrom = 1\nb = 1\n",
    "friction without time": VALID + "[[friction]]\nb = 1\n",
    "friction without b": VALID + "[[friction]]\nfrom = 1\n",
}


@pytest.mark.parametrize("kind", BAD_PIECES)
def test_bad_pieces_are_refused_in_one_line(kind):
    with pytest.raises(InvalidScene) as caught:
        parse_scene(BAD_PIECES[kind])
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 300


@pytest.mark.parametrize(
    ("make", "name"),
    [
        (lambda: Force((1,)), "Piece"),
        (lambda: Piece(0, (), (1,)), "Sine"),
        (lambda: Friction((1,)), "friction"),
        (lambda: Force.ramp(1, 1, 2), "end - start"),
        (lambda: Force.trapezoid(1, 0, 0, 0, 2), "rise"),
        (lambda: Force.trapezoid(1, -1, 2, 1, 2), "rise"),
        (lambda: Force.sweep(1, [1, 0], 2), "omega"),
        (lambda: Scene(Pair(1, 1, 1, 1), State(), 1, force=1), "Force"),
        (lambda: Scene(Pair(1, 1, 1, 1), State(), 1, friction=((1, 1),)), "Friction"),
        (lambda: Force.step(0, 1) + 1, "unsupported"),
    ],
)
def test_what_is_no_force_is_refused_by_name(make, name):
    with pytest.raises((InvalidScene, TypeError), match=name):
        make()
