"""What is no scene on a surface, or cannot be asked of one, is refused in one sentence that says what to do."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from numerics import Force, Pair, PlanePair, PlaneScene, solve
from numerics.errors import InvalidScene
from numerics.scene.file import parse_scene

REFUSED = tomllib.loads(Path(__file__).with_name("refused.toml").read_text("utf-8"))
PAIR = PlanePair(m1=1, m2=1, a2=200, b="0.5")


@pytest.mark.parametrize(("given", "told"), REFUSED["pair"])
def test_a_pair(given, told):
    with pytest.raises(InvalidScene, match=told):
        PlanePair(**({"m1": 1, "m2": 1, "a2": 200, "b": "0.5"} | given))


@pytest.mark.parametrize(
    ("given", "told"),
    REFUSED["scene"]
    + [
        ({"pair": Pair(1, 1, 200, 1)}, "must be a PlanePair, not Pair"),
        ({"force": Force.sine(1, 1)}, "force = .* must be a list of one Force"),
        ({"force": {"x": Force()}}, "must be a list of one Force"),
        ({"force": "x"}, "must be a list of one Force"),
        ({"force": [1, 2]}, "a list of one Force for each axis; build them"),
        ({"force": [Force()] * 3}, "3 forces for 2 axes"),
    ],
)
def test_a_scene(given, told):
    with pytest.raises(InvalidScene, match=told):
        PlaneScene(**({"pair": PAIR, "until": 1} | given))


@pytest.mark.parametrize(("pair", "more", "told"), REFUSED["file"])
def test_a_file(pair, more, told):
    run = "" if "[run]" in more else "[run]\nuntil = 1\n"
    with pytest.raises(InvalidScene, match=told):
        parse_scene(f'[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = "0.5"\n{pair}\n{run}{more}\n')


@pytest.mark.parametrize(("asked", "told"), REFUSED["asked"])
def test_a_solve_before_anything_is_computed(asked, told):
    with pytest.raises((ValueError, TypeError), match=told):
        solve(PlaneScene(PAIR, 1, v1=["0.1", 0]), **asked)


def test_arrays_and_tuples_are_read_as_lists():
    pair = PlanePair(m1=np.array([1.0, 0.1]), m2=(1, 1), a2=np.diag([200, 120]), b="0.5")
    assert pair == PlanePair(m1=[1, "0.1"], m2=1, a2=[200, 120], b=["0.5", "0.5"])
    assert PlaneScene(pair, 1, x1=np.zeros(2)) == PlaneScene(pair, 1)
