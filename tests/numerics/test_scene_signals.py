"""Ground and belt, walls, forces on body 2, b(t) and measured samples: exact, proved, or refused in one line."""

import copy
import pickle
import tomllib
from contextlib import nullcontext
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pandas
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from strategies import MODERATE, brought_scenes, decimals, forces, magnitudes, signed, weakened_scenes

from numerics import (
    Force,
    Friction,
    InvalidScene,
    Pair,
    Piece,
    Scene,
    Signal,
    Sine,
    State,
    scene_text,
)
from numerics.scene.decimals import decimal_text, exact_decimal
from numerics.scene.file import load_scene, parse_scene
from numerics.scene.model import require_plain

PAIR = Pair(m1=1, m2=1, a2=200, b="0.5")
GROUND = Pair(m1=1, m2="inf", a2=200, b="0.5")
PUSH = Signal.step(0, 1)


@given(brought_scenes() | weakened_scenes())
def test_a_scene_of_a_new_kind_survives_its_text_and_its_copies_and_is_plain_or_forced(scene):
    for again in (parse_scene(scene_text(scene)), pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene)):
        assert again == scene
        assert hash(again) == hash(scene)
    assert scene.is_forced or not scene.extra
    with pytest.raises(InvalidScene, match="a ring is not available for") if scene.extra else nullcontext():
        require_plain("ring_entry", scene, "a ring")


def test_ground_and_belt_carry_body_2():
    belt = Signal.step(0, "0.25") + Signal.sine(1, 3)
    on_belt = Scene(GROUND, State(x1=1), 1, belt=belt)
    assert on_belt.initial == State(x1=1, v2="0.25")
    assert Scene(GROUND, on_belt.initial, 1, belt=belt) == on_belt
    assert on_belt.energy == 100  # of body 1 alone
    assert Scene(GROUND, State(), 1, belt=Signal.sine(1, 3, 1)).initial.v2 == 0  # sin(1) has no decimal
    assert GROUND.critical_energy == Fraction(1, 1600)
    assert parse_scene("[pair]\nm1 = 1\nm2 = inf\na2 = 200\nb = 0.5\n[run]\nuntil = 1").pair == GROUND != PAIR


def test_a_wall_that_does_not_jump_may_have_a_damper():
    wall = Signal.sweep("0.01", [3, 5], 1) + Signal.step(0, "0.2") + Signal.ramp(2, 3, 1)
    assert Scene(replace(PAIR, a1=1), State(), 5, wall=wall).wall == wall


numbers = st.integers(-20, 20).map(lambda k: Fraction(k, 10))
waves = st.builds(Sine, numbers, magnitudes(-1, 0), numbers)


@given(st.lists(numbers, max_size=4), st.lists(waves, max_size=3), st.integers(0, 3), st.sampled_from([-1, 1]))
def test_friction_beside_its_least_value_is_proved_above_it_and_refused_below(polynomial, sines, start, side):
    wave = Signal([Piece(start, polynomial, sines)])
    times = [start + Fraction(k * (5 - start), 500) for k in range(501)]
    least = min(float(wave(t)) for t in times)
    steepest = sum(abs(c) * k * 5 ** (k - 1) for k, c in enumerate(polynomial) if k)
    steepest += sum(abs(s.amplitude) * s.omega for s in sines)
    near = 0 if side < 0 else float(steepest) * 0.005  # between two of the times
    lifted = Signal.step(start, Fraction(side * 1e-6 - least + near)) + wave
    with nullcontext() if side > 0 else pytest.raises(InvalidScene) as refused:
        Scene(PAIR, State(), 5, friction=Friction([lifted.pieces[0]]))
    if side < 0:
        place, value = str(refused.value).split("at t = ")[1].split(" s, where only b >= ")
        assert start <= float(place) <= 5
        assert float(value.split(" N")[0]) < 1.5


@given(st.lists(st.tuples(magnitudes(-2, 1), numbers), min_size=1, max_size=9), st.floats(0, 1), st.booleans())
def test_samples_are_what_is_between_them(steps, part, is_held):
    t, u = np.cumsum([one for one, _ in steps]), [value for _, value in steps]
    signal = Signal.samples(t, u, "hold" if is_held else "linear")
    for k, (at, value) in enumerate(zip(t, u, strict=True)):
        assert signal(at) == value
        if k + 1 < len(t):
            between = at + Fraction(part) * (t[k + 1] - at)
            assert signal(between, -1 if part == 1 else 1) == value + (not is_held) * Fraction(part) * (
                u[k + 1] - value
            )
    assert signal(t[0], -1) == 0
    assert signal(t[-1] + 7) == u[-1]


FORCED = "[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.5\n[run]\nuntil = 5\n[[force]]\nbody = 2\nfile = 'u.csv'\n"
MEASURED = "[[friction]]\nfile = 'u.csv'\n"


@pytest.mark.parametrize(
    "text",
    ["0,1\n0.5,2\n", "t,u\n0,1\n0.5,2", "t,u\r0,1\r0.5,2\r", '\ufeff"t (s)", "u (N)"\r\n0 , 1\r\n5e-1, 2\r\n\r\n'],
)
def test_a_file_of_samples_is_read_beside_its_scene(tmp_path, text):
    (tmp_path / "u.csv").write_text(text, encoding="utf-8", newline="")
    (tmp_path / "scene.toml").write_text(FORCED + MEASURED, encoding="utf-8")
    scene, samples = load_scene(tmp_path / "scene.toml"), Signal.samples([0, "0.5"], [1, 2])
    assert (scene.force_2, scene.friction) == (samples, Friction(samples))
    assert parse_scene(scene_text(scene)) == scene


SAMPLES = tomllib.loads((Path(__file__).parents[1] / "refused.toml").read_text("utf-8"))["samples"]


@pytest.mark.parametrize("said", SAMPLES)
def test_a_file_that_holds_no_samples_is_refused_by_row_and_value(tmp_path, said):
    (tmp_path / "u.csv").write_text(SAMPLES[said], encoding="utf-8")
    with pytest.raises(InvalidScene, match=said) as caught:
        parse_scene(FORCED, str(tmp_path / "scene.toml"))
    assert str(caught.value).startswith("[[force]] number 1: ")
    assert str(caught.value).isprintable()


# arithmetic of signals, and their texts


TIMES = st.integers(0, 40).map(lambda k: Fraction(k, 3))


@given(forces(), forces(), TIMES, st.sampled_from([-1, 1]), signed(decimals(*MODERATE)))
def test_a_sum_and_a_multiple_of_forces_are_those_of_their_values_on_both_sides_of_a_jump(f, g, t, side, factor):
    value = float(factor) * float(f(t, side)) - float(g(t, side))
    assert (factor * f - g)(t, side) == pytest.approx(value, rel=1e-9, abs=1e-6)


def test_samples_may_be_columns_of_a_table():
    table = pandas.DataFrame({"t": [0, 1, 2], "u": [0.0, 1.0, 0.5]})
    assert Force.samples(table["t"], table["u"]) == Force.samples([0, 1, 2], [0, 1, 0.5])


@given(forces())
def test_a_piece_that_is_moved_is_the_same_function_exactly(f):
    for piece in f.pieces:
        assert piece.moved(piece.start + Fraction(7, 3)).moved(piece.start) == piece


TRAPEZOIDS = {
    Force.trapezoid(1, 2, 1, "0.5", 3): {1: "0 0", 2: "1.5 1.5", 3: "3 3", 4: "3 3", "4.25": "1.5 1.5", 5: "0 0"},
    Force.trapezoid(0, 0, 1, 0, 3): {0: "0 3", "0.5": "3 3", 1: "3 0"},
}


@pytest.mark.parametrize("force", TRAPEZOIDS)
def test_a_trapezoid_is_what_it_says_on_both_sides_of_a_time(force):
    for t, values in TRAPEZOIDS[force].items():
        assert [force(t, side) for side in (-1, 1)] == [*map(Fraction, values.split())]


@given(signed(decimals(-300, 300, 30)))
@example(Fraction(0))
@example(Fraction(10) ** 1000)
@example(Fraction(1, 10**1000))
@example(Fraction(2**80, 3))
def test_every_number_survives_its_text(value):
    assert exact_decimal(decimal_text(value), "x1") == value
