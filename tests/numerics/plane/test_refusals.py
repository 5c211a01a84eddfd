"""What is no scene on a surface, or cannot be asked of one, is refused in one sentence that says what to do."""

import math

import numpy as np
import pytest

from numerics import Force, Pair, PlanePair, PlaneScene, solve
from numerics.errors import InvalidScene

PAIR = PlanePair(m1=1, m2=1, a2=200, b="0.5")


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"m1": [1, math.nan]}, r"m1\[1\] must be a finite"),
        ({"m1": [1, 1], "m2": [1, 1, 1]}, "m1 has 2 numbers and the scene 3 axes"),
        ({"m2": [1, 0]}, "m2 = 0 on y must be > 0"),
        ({"shape": "elipsoid"}, "is not one of ellipsoid, box"),
        ({"axes": 0}, "axes = 0 must be 2"),
        ({"a2": [200, 0]}, "a2 has the minor 0 on y, which must be > 0"),
        ({"a2": [[1, 2], [2, 1]]}, "a2 has the minor -3 on x, y"),
        ({"a2": [[1, 2], [3, 9]]}, r"a2\[0\]\[1\] = 2 and a2\[1\]\[0\] = 3 must be equal"),
        ({"a2": [[1, 2], [2]]}, r"a2\[1\] has 1 numbers"),
        ({"a1": [[0, 1], [1, 0]]}, "a1 has the minor -1 on x, y"),
    ],
)
def test_a_pair(given, told):
    with pytest.raises(InvalidScene, match=told):
        PlanePair(**({"m1": 1, "m2": 1, "a2": 200, "b": "0.5"} | given))


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"pair": Pair(1, 1, 200, 1)}, "must be a PlanePair, not Pair"),
        ({"until": 0}, "until = 0 must be > 0"),
        ({"x1": [0, 0, 0]}, "x1 has 3 numbers and the scene 2 axes"),
        ({"force": Force.sine(1, 1)}, "force = .* must be a list of one Force"),
        ({"force": [Force()] * 3}, "3 forces for 2 axes"),
        ({"friction": [(1, 2, 3)]}, "a pair"),
        ({"friction": [(-1, 1)]}, "from = -1 must be >= 0"),
        ({"friction": [(1, [1, 0])]}, "b = 0 on y must be > 0"),
    ],
)
def test_a_scene(given, told):
    with pytest.raises(InvalidScene, match=told):
        PlaneScene(**({"pair": PAIR, "until": 1} | given))


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ({"t_eval": [0, 2]}, "outside"),
        ({"digits": 10, "arithmetic": "float64"}, "leave digits out"),
        ({"arithmetic": "mpmath"}, "is available on a line only: a surface is solved in balls"),
        ({"arithmetic": "float64"}, "is available on a line only: a surface is solved in balls"),
    ],
)
def test_a_solve_before_anything_is_computed(asked, told):
    with pytest.raises((ValueError, TypeError), match=told):
        solve(PlaneScene(PAIR, 1, v1=["0.1", 0]), **asked)


def test_arrays_and_tuples_are_read_as_lists():
    pair = PlanePair(m1=np.array([1.0, 0.1]), m2=(1, 1), a2=np.diag([200, 120]), b="0.5")
    assert pair == PlanePair(m1=[1, "0.1"], m2=1, a2=[200, 120], b=["0.5", "0.5"])
    assert PlaneScene(pair, 1, x1=np.zeros(2)) == PlaneScene(pair, 1)
