"""The package's answers against the frozen ones of tests/oracle: modes, causes, every number, sensitivities, control.

A default run takes some scenes of each kind, other ones every time; a failure names its scenes.
"""

import json
from random import Random, SystemRandom

import pytest
from oracle.controls import answers as questions
from oracle.draws import KINDS, drawn
from oracle.holding import exact, held, same
from oracle.reading import ANSWERS, data

from numerics import Pair, Scene, State, solve
from numerics.errors import NumericsError

SCENES = data()["scenes"]
BY_KIND = {kind: [one for one in SCENES if one["name"].startswith(f"{kind}/")] for kind in (*KINDS, "shipped")}
SOME = 8
ANSWERED_SINCE = {
    "ring: forced-sine-stick-slip of 0.001, 1": {
        "centre": "0.00020336086749105576062434594",
        "entry": "4.9405304722687342852827967",
    }
}
"""What was refused when the rest was frozen; held against the motion itself in tests/numerics/test_ring_forced.py."""


def require(answers, way, *, slopes=False):
    outcomes = [held(one, way, slopes=slopes) for one in answers]
    wrong = {one.name: one.differences for one in outcomes if one.differences}
    assert not wrong, json.dumps(wrong, indent=1)
    assert any(not one.left_open for one in outcomes), "nothing was compared"


@pytest.mark.parametrize("way", ["ball", "default"])
@pytest.mark.parametrize("kind", BY_KIND)
def test_some_scenes_are_answered_as_ever(kind, way):
    """In balls, and without a word on how: compiled float64, which climbs where it is in doubt."""
    require(SystemRandom().sample(BY_KIND[kind], SOME), way)


@pytest.mark.parametrize("way", ["float64", "double-double", "mpmath", "digits=12", "digits=20"])
def test_some_scenes_are_answered_as_ever_by_name(way):
    require(SystemRandom().sample(SCENES, 40), way)


def test_some_derivatives_are_as_ever():
    require(SystemRandom().sample([one for one in SCENES if "slopes" in one], 20), "ball", slopes=True)


@pytest.mark.long
@pytest.mark.parametrize("part", range(20))
@pytest.mark.parametrize("way", ["ball", "default", "float64", "double-double", "digits=12", "digits=20"])
def test_all_scenes_are_answered_as_ever(way, part):
    require(SCENES[part::20], way, slopes=way in {"ball", "default"})


@pytest.mark.parametrize(
    "kind",
    [
        "response",
        "thresholds",
        "transfer",
        "track",
        "ring: v",
        "ring: r",
        pytest.param("ring: f", marks=pytest.mark.long),
    ],
)
def test_control_answers_as_ever(kind):
    frozen = data()["control"] | ANSWERED_SINCE
    for name, ask in questions().items():
        if name.startswith(kind):
            try:
                got = ask()
            except NumericsError as error:
                got = {"refused": type(error).__name__}
            assert same(frozen[name], got), (name, got)


def test_the_scenes_are_those_that_the_seeds_draw():
    for one in Random(1).sample([one for one in SCENES if "scene" in one], 100):
        kind, number = one["name"].split("/")
        assert drawn(kind, int(number)) == one["scene"]


def test_the_data_are_small():
    assert ANSWERS.stat().st_size < 1_500_000
    assert len(SCENES) > 3200


@pytest.mark.parametrize("way", ["ball", "float64"])
def test_a_wrong_answer_is_seen(way):
    """By one unit in the 22nd digit in balls, beyond the bound in float64; by an event more, a cause, an energy."""
    name, by = "forced-sine-stick-slip", {"ball": 1 + 1e-15, "float64": 1 + 1e-6}[way]
    right = next(one for one in SCENES if one["name"] == f"shipped/{name}")
    assert not held(right, way).differences
    wrong = [
        {"modes": right["modes"] + "0"},
        {"causes": "j" + right["causes"][1:]},
        {"final": [str(float(one) * by) for one in right["final"]]},
        {"events": right["events"] | {"3": [str(float(one) * by) for one in right["events"]["3"]]}},
        {"ledger": [str(float(one) * by) for one in right["ledger"]]},
        {"excess": str(float(right["excess"]) * by)},
    ]
    assert [bool(held(right | one, way).differences) for one in wrong] == [True] * len(wrong)


def test_numbers_are_read_exactly():
    found = solve(Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), until=1), arithmetic="ball", digits=20)
    middle, radius = exact(found.final_state[1])
    assert abs(float(middle) - float(found.final_state[1].mid())) < 1e-16
    assert 0 < radius < 1e-20
