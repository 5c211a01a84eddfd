"""Ground and belt, walls, forces on body 2, b(t) and measured samples: read exactly, proved, or refused in one line."""

import copy
import math
import pickle
import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import brought_scenes, magnitudes

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
    Weakening,
    cheapest_transfer,
    damping,
    fastest_transfer,
    load_reference,
    response,
    ring_entry,
    scene_text,
    solve,
    thresholds,
    track,
)
from numerics.errors import NoProof
from numerics.free.energy import energy_at
from numerics.scene.file import load_scene, parse_scene
from numerics.scene.model import parameters, require_plain
from numerics.trajectory.theorem import theorem

PAIR = Pair(m1=1, m2=1, a2=200, b="0.5")
GROUND = Pair(m1=1, m2="inf", a2=200, b="0.5")
PUSH = Signal.step(0, 1)


@given(brought_scenes())
def test_a_scene_of_a_new_kind_survives_its_text_and_its_copies(scene):
    for again in (
        parse_scene(scene_text(scene)),
        pickle.loads(pickle.dumps(scene)),
        copy.deepcopy(scene),
        replace(scene),
    ):
        assert again == scene
        assert hash(again) == hash(scene)
    assert len(repr(scene.pair)) < 200


@given(brought_scenes())
def test_a_scene_is_plain_or_forced_and_says_what_is_extra(scene):
    if scene.is_plain:
        require_plain(scene, "a ring")
        assert parameters(scene).keys() >= {"m2", "v2"}
        return
    assert scene.is_forced
    with pytest.raises(InvalidScene, match="a ring is not available for"):
        require_plain(scene, "a ring")


EXTRA = {
    "a2 = 0": Scene(replace(PAIR, a2=0), State(), 1),
    "b = 0": Scene(PAIR, State(), 1, friction=Friction([(0, 0)])),
    'm2 = "inf"': Scene(GROUND, State(), 1),
    "b_static": Scene(replace(PAIR, b_static="0.5"), State(), 1),
    "a force on body 2": Scene(PAIR, State(), 1, force_2=PUSH),
    "a wall that moves": Scene(PAIR, State(), 1, wall=PUSH),
    "friction that varies within a piece": Scene(PAIR, State(), 1, friction=Friction([Piece(0, (1, 1))])),
}


@pytest.mark.parametrize("kind", EXTRA)
def test_each_new_kind_alone_is_forced_and_not_plain(kind):
    scene = EXTRA[kind]
    assert (scene.extra, scene.is_plain, scene.is_forced) == (kind, False, True)
    assert Scene(PAIR, State(), 1).is_plain
    assert not Scene(PAIR, State(), 1).is_forced


ASKED = {
    "response": lambda scene: response(scene, amplitude=1, omega=3),
    "ring_entry": lambda scene: ring_entry(scene, "0.01"),
    "damping": lambda scene: damping(scene, "0.01"),
    "track": lambda scene: track(scene, load_reference("s-curve")),
    "fastest_transfer": lambda scene: fastest_transfer(scene, 1),
    "cheapest_transfer": lambda scene: cheapest_transfer(scene, 1, 9),
    "energy_at": lambda scene: energy_at(scene, 1),
    "theorem": lambda scene: theorem(solve(scene)),
}


@pytest.mark.parametrize("kind", EXTRA)
@pytest.mark.parametrize("asked", ASKED)
def test_what_knows_plain_scenes_only_refuses_each_new_kind(asked, kind):
    with pytest.raises(InvalidScene if asked != "theorem" else NoProof, match=f"{re.escape(kind)}; leave that out"):
        ASKED[asked](EXTRA[kind])


@pytest.mark.parametrize("pair", [replace(PAIR, a2=0), replace(PAIR, b=0), GROUND, replace(PAIR, b_static=1)])
def test_thresholds_refuse_a_pair_that_they_do_not_know(pair):
    with pytest.raises(InvalidScene, match=f"thresholds are not available for {re.escape(pair.extra)}; leave"):
        thresholds(pair, 3)


def test_ground_and_belt_carry_body_2():
    belt = Signal.step(0, "0.25") + Signal.sine(1, 3)
    on_belt = Scene(GROUND, State(x1=1), 1, belt=belt)
    assert on_belt.initial == State(x1=1, v2="0.25")
    assert Scene(GROUND, on_belt.initial, 1, belt=belt) == on_belt
    assert on_belt.energy == 100  # of body 1 alone
    assert Scene(GROUND, State(), 1, belt=Signal.sine(1, 3, 1)).initial.v2 == 0  # sin(1) has no decimal
    assert (GROUND.share, GROUND.share_2, GROUND.half_width) == (0, 1, Fraction(1, 400))
    assert GROUND.critical_energy == Fraction(1, 1600)
    assert Pair(1, math.inf, 200, "0.5") == GROUND != PAIR
    assert parse_scene("[pair]\nm1 = 1\nm2 = inf\na2 = 200\nb = 0.5\n[run]\nuntil = 1").pair == GROUND


SENSELESS = {
    "no total mass": lambda: GROUND.mass,
    "no half width": lambda: replace(PAIR, a2=0).half_width,
    "has no half width": lambda: Scene(replace(PAIR, a2=0), State(), 1).energy_excess,
    "no critical energy": lambda: Scene(replace(PAIR, b=0), State(), 1).energy_excess,
    "v2 = 2 is not the belt's velocity at 0, 1;": lambda: Scene(GROUND, State(v2=2), 1, belt=PUSH),
    "v2 = 2 is not the belt's velocity at 0, 0;": lambda: Scene(GROUND, State(v2=2), 1),
    "at 0, 0.841471; leave v2 out": lambda: Scene(GROUND, State(v2=1), 1, belt=Signal.sine(1, 1, 1)),
    "at 0, 1.84147; leave v2 out": lambda: Scene(GROUND, State(v2=1), 1, belt=PUSH + Signal.sine(1, 1, 1)),
    "a force on body 2 does not move it": lambda: Scene(GROUND, State(), 1, force_2=PUSH),
    "a belt moves a body 2 of any mass": lambda: Scene(PAIR, State(), 1, belt=PUSH),
    "must be at least b = 0 > 0": lambda: Pair(1, 1, 1, 0, b_static=1),
    "b = -1 must be >= 0": lambda: Friction([(0, -1)]),
    "the wall jumps from 0 m to 1 m": lambda: Scene(replace(PAIR, a1=1), State(), 2, wall=Signal.step(1, 1)),
    "by constant steps": lambda: Scene(PAIR, State(), 1, friction=Friction([Piece(0, (1, 1))], Weakening())),
    "varies from t = 2 s": lambda: Friction([(0, 1), Piece(2, (1, 1))]).steps,
    "needs a Signal": lambda: Scene(PAIR, State(), 1, wall=3),
}


@pytest.mark.parametrize("said", SENSELESS)
def test_what_makes_no_sense_is_refused_in_one_sentence(said):
    with pytest.raises(InvalidScene, match=said) as caught:
        SENSELESS[said]()
    assert len(str(caught.value)) < 200


def test_a_wall_that_does_not_jump_may_have_a_damper():
    wall = Signal.sweep("0.01", [3, 5], 1) + Signal.step(0, "0.2") + Signal.ramp(2, 3, 1)
    assert Scene(replace(PAIR, a1=1), State(), 5, wall=wall).wall == wall
    assert Scene(PAIR, State(), 2, wall=Signal.step(1, 1)).wall.starts == (1,)


def proved(piece, until=5):
    """Whether b(t) >= 0 of one piece is proved; a refusal names a time of the piece, and a value."""
    try:
        Scene(PAIR, State(), until, friction=Friction([piece]))
    except InvalidScene as error:
        place, value = str(error).split("at t = ")[1].split(" s, where b = ")
        assert piece.start <= float(place) <= until
        assert float(value.split(" N")[0]) < 1.5
        return False
    return True


TINY = Fraction(1, 10**30)
SMOOTH = (1, 0, -3, 2)  # (1 - t)^2 (1 + 2 t), down to 0 at t = 1


@pytest.mark.parametrize(
    ("piece", "until", "is_proved"),
    [
        (Piece(0, (1,), (Sine(1, 1),)), 100, True),
        (Piece(0, (1 - TINY,), (Sine(1, 1),)), 100, False),
        (Piece(0, ("0.999999",), (Sine(1, 1),)), 100, False),
        (Piece(0, ("0.999999",), (Sine(1, 1),)), 4, True),  # until before the least value
        (Piece(0, (1, -1)), 1, True),
        (Piece(0, (1, -1)), 1 + TINY, False),
        (Piece(3, (1, -1)), 4, True),
        (Piece(0, SMOOTH), 1, True),
        (Piece(0, SMOOTH), "1.5", False),  # touches 0 within
        (Piece(0, (1, -2, 1 + TINY)), 1, True),
        (Piece(0, ("1.001", -2, 1)), 5, True),
        (Piece(0, ("0.999", -2, 1)), 5, False),
        (Piece(0, (1, "0.1"), (Sine(1, 1), Sine("0.05", 2))), 5, True),
        (Piece(0, (1, "-0.1"), (Sine(1, 1), Sine("0.05", 2))), 5, False),
        (Piece(0, (1,), (Sine("0.9", 1), Sine("0.2", 2))), 10**9, True),  # by its period
        (Piece(0, (1,), (Sine("0.9", 1), Sine("0.3", 2))), 10**9, False),
        (Piece(0, (0,)), 5, True),
        (Piece(0, (-1,)), 5, False),
        (Piece(6, (-1,)), 5, True),  # which begins after the horizon
    ],
)
def test_friction_is_proved_and_refused_next_to_the_edge(piece, until, is_proved):
    assert proved(piece, Fraction(until)) == is_proved


def test_a_piece_of_friction_ends_where_the_next_one_begins():
    assert Scene(PAIR, State(), 9, friction=Friction([Piece(0, (1, -1)), (1, 0), Piece(2, (0, 1))])).is_forced
    with pytest.raises(InvalidScene, match="from t = 0 s"):
        Scene(PAIR, State(), 9, friction=Friction([Piece(0, (1, -1)), (2, 1)]))


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
    assert proved(lifted.pieces[0]) == (side > 0)


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


def test_samples_of_numpy_are_read_as_their_shortest_decimals():
    assert Force.samples(np.array([0.1, 0.3]), np.array([1.0, 0.5])).pieces == (
        Piece("0.1", (1, "-2.5")),
        Piece("0.3", ("0.5",)),
    )


FORCED = "[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.5\n[run]\nuntil = 5\n[[force]]\nbody = 2\nfile = 'u.csv'\n"


@pytest.mark.parametrize(
    "text", ["0,1\n0.5,2\n", "t,u\n0,1\n0.5,2", '\ufeff"t (s)", "u (N)"\r\n0 , 1\r\n5e-1, 2\r\n\r\n']
)
def test_a_file_of_samples_is_read_beside_its_scene(tmp_path, text):
    (tmp_path / "u.csv").write_text(text, encoding="utf-8", newline="")
    (tmp_path / "scene.toml").write_text(FORCED, encoding="utf-8")
    scene = load_scene(tmp_path / "scene.toml")
    assert scene.force_2 == Signal.samples([0, "0.5"], [1, 2])
    assert parse_scene(scene_text(scene)) == scene


FILES = {
    "t in row 1": "nan,1\n1,2",
    "u in row 3 must be a finite decimal number, not 'nan'": "t,u\n0,1\n1,nan",
    "u in row 2 must be a finite decimal number, not 'inf'": "0,1\n1, inf",
    "t = 1 in row 4 is not after 1": "t,u\n0,1\n1,2\n1,3",
    "t = 0.5 in row 3 is not after 1": "0,1\n1,2\n0.5,3",
    "t in row 1 = -1 must be >= 0": "-1,1",
    "row 1 of 'u.csv', '0,5;1,25', is not a t and a u": "0,5;1,25",
    "row 2 of 'u.csv', '0;1,5', is not a t and a u": "t;u,\n0;1,5",
    "row 2 of 'u.csv', '', is not a t and a u": "0,1\n\n1,2",
    "row 2 of 'u.csv', '1,2,3', is not": "0,1\n1,2,3",
    "'u.csv' holds no samples; give": "",
    "t in row 2 must be a finite decimal number, not 't'": "t,u\nt,u\n0,1",
    "holds no samples": "t,u\n",
}


@pytest.mark.parametrize("said", FILES)
def test_a_file_that_holds_no_samples_is_refused_by_row_and_value(tmp_path, said):
    (tmp_path / "u.csv").write_text(FILES[said], encoding="utf-8")
    with pytest.raises(InvalidScene, match=said) as caught:
        parse_scene(FORCED, str(tmp_path / "scene.toml"))
    assert str(caught.value).startswith("[[force]] number 1: ")
    assert str(caught.value).isprintable()


@pytest.mark.parametrize(
    ("t", "u", "said"),
    [
        ([0, 1], [1], "t has 2 samples and u 1"),
        (0, [1], "t = 0 must be a list"),
        ([0, 1], [1, math.nan], "u in row 2"),
        ([0, True], [1, 2], "t in row 2"),
        ([0, 0], [1, 2], "t = 0 in row 2 is not after 0"),
    ],
)
def test_samples_that_are_none_are_refused(t, u, said):
    with pytest.raises(InvalidScene, match=said):
        Force.samples(t, u)
    with pytest.raises(InvalidScene, match="kind = 'cubic' is not one of linear, hold"):
        Force.samples([0], [1], "cubic")


def test_a_constant_b_is_written_as_b():
    text = scene_text(Scene(PAIR, State(), 5, friction=Friction([(1, 0), Piece(2, (1, 1)), (3, "0.25")])))
    assert [line for line in text.splitlines()[12:] if line.startswith(("b", "poly"))] == [
        "b = 0",
        "polynomial = [1, 1]",
        "b = 0.25",
    ]


def test_the_numbers_of_a_scene_have_names():
    friction = Friction([Piece(1, (1, 1), (Sine("0.5", 1),)), (2, 0)])
    scene = Scene(replace(GROUND, b_static=1), State(), 5, belt=PUSH, wall=Signal.step(1, 3), friction=friction)
    found = parameters(scene)
    assert not {"m2", "v2"} & found.keys()
    wanted = {"b_static": 1, "belt[0].polynomial[0]": 1, "wall[0].from": 1, "friction[0].polynomial[1]": 1}
    wanted |= {"friction[0].sines[0].amplitude": Fraction(1, 2), "friction[1].from": 2, "friction[1].b": 0}
    assert wanted.items() <= found.items()
