"""Under a force and on a surface, where no row and no run of numerics says it: ties, friction along a slip, growth."""

import math
import random

import pytest
import sympy as sp

from theory import forced, plane
from theory.symbols import a2, b, m1, m2, t, total_mass, v1

SEEDS = pytest.mark.parametrize("seed", range(20))


def test_at_a_tie_slip_and_stick_part_by_the_first_derivative_only(same):
    # x1 chosen so that the load is sign b, and its rate zero: the second derivative of both loads is (m2/M) p''
    for mode in ("stick", "slip-"):
        assert same(forced.deviation_force(mode, -1), forced.imbalance(-1))
    assert same(forced.imbalance(-1).subs(t, 0), total_mass() / m2 * (forced.load() + b))


def test_the_load_is_what_holds_body_2():
    field = forced.forced_system(forced.load() / b)
    assert sp.simplify((field[1] - field[2]).subs(sp.Symbol("v2", real=True), v1)) == 0


@SEEDS
def test_friction_along_the_slip_never_drives_two_motions_apart(seed):
    source = random.Random(seed)
    slip, other = ([source.uniform(-1, 1) for _ in range(2)] for _ in range(2))
    shares = [part / math.hypot(*one) for one in (slip, other) for part in one]
    letters = (*plane.SLIP, *plane.OTHER, *plane.SHARE, *plane.SHARE_OTHER)
    values = dict(zip(letters, (*slip, *other, *shares), strict=True))
    assert plane.contraction_by_friction().subs(values).subs(b, 1) <= 0


def test_by_components_the_axes_matter_and_by_direction_they_do_not():
    eighth, *_ = between = [float(plane.against_slip(sp.pi * k / 8).subs(b, 1)) for k in (1, 2, 3)]
    assert between == pytest.approx([eighth, math.sqrt(2), eighth])
    assert eighth == pytest.approx(math.cos(math.pi / 8) + math.sin(math.pi / 8))
    for k in (1, 3, 7):
        line = plane.along(sp.Rational(k))
        assert sp.simplify(plane.by_direction(line).dot(line) - b) == 0


@SEEDS
def test_the_distance_holds_places_and_relative_velocities_as_the_rates_of_growth_say(seed):
    source = random.Random(seed)
    one = {symbol: source.uniform(0.1, 5) for symbol in (m1, m2, a2)}
    place, first, second = (source.uniform(-1, 1) for _ in range(3))
    squared = one[a2] * place**2 + one[m1] * first**2 + one[m2] * second**2
    by_place, by_speed = (float(rate(1).subs(one)) for rate in (forced.growth_by_place, forced.growth_by_speed))
    assert abs(place) * abs(first - second) <= by_place * squared
    assert (first - second) ** 2 <= by_speed * squared
