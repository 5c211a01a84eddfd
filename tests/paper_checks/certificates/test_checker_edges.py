"""False claims next to the edge of what is true: the checker rejects each, and accepts the true one beside it."""

import json
from fractions import Fraction
from itertools import pairwise

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from paper_checks.certificates import checker

TEXT = checker.CERTIFICATE.read_text("utf-8")


def refused(change):
    data = json.loads(TEXT)
    change(data)
    return checker.objections(json.dumps(data)) != []


HAIR = Fraction(1, 10**30)


def ball(value):
    """A number next to an edge; text names the edge that no rational is."""
    if isinstance(value, tuple):
        return ball(value[0]) + ball(value[1])
    level = {"level": HALF_SHARE * (arb.pi() / 2 - 1) ** 2, "too high": HALF_SHARE * (arb.pi() / 2) ** 2}
    return level[value] if isinstance(value, str) else arb(Fraction(value).numerator) / Fraction(value).denominator


HALF_SHARE = arb("0.5")


@pytest.mark.parametrize(
    ("outcome", "gap", "push", "excess", "proved"),
    [
        ("creeps", -1, 1, ("level", -HAIR), True),
        ("creeps", -1, 1, ("level", HAIR), False),
        ("creeps", -1, 1, ("too high", -HAIR), False),
        ("creeps", -1, 1, HAIR, True),
        ("creeps", -1, 1, -HAIR, False),
        ("creeps", (-4, -HAIR), 1, HAIR, False),
        ("creeps", HAIR, 1, HAIR, False),
        ("merges", -1, 1, -HAIR, True),
        ("merges", -1, 1, HAIR, False),
        ("opposite", -1, -HAIR, 1, True),
        ("opposite", -1, HAIR, 1, False),
        ("opposite", -1, -HAIR, -HAIR, False),
        ("opposite", (-4, -HAIR), -HAIR, 1, False),
        ("same", -1, HAIR, 1, True),
        ("same", -1, -HAIR, 1, False),
        ("same", HAIR, HAIR, 1, False),
        ("crosses", (-4, -HAIR), 1, 1, True),
        ("crosses", (-4, HAIR), 1, 1, False),
    ],
)
def test_an_outcome_is_proved_up_to_its_edge(outcome, gap, push, excess, proved):
    """For q = 1/2 the other edge of S0 is at the gap -4."""
    found = checker._outcome(outcome, HALF_SHARE, ball(gap), ball(push), ball(excess))
    assert (found[0] is None) is proved


def truth(share, phi):
    """sin^4 w'/q on the ray, and sin^2 of the least w'/q over all gaps, from h and c and the quadratic in T."""
    sine, cosine = phi.sin(), phi.cos()
    height = (phi - sine * cosine) / sine**2
    deep = 2 - 2 * phi * cosine / sine
    centre = phi * cosine / sine
    vertex = share * (1 - centre) / (1 / sine**2 - share)
    least = vertex**2 * (1 / sine**2 - share) - 2 * share * vertex * (1 - centre) + phi**2 + centre**2 - 1
    return sine**4 * (height**2 - share * deep**2), sine**2 * (least - share * (1 - centre) ** 2)


@pytest.mark.parametrize("share", ["0.1", "0.5", "0.557", "0.9"])
@pytest.mark.parametrize("phi", ["0.3", "1", "1.5708", "1.8986", "3"])
def test_the_polynomials_of_the_surface_are_the_excess(share, phi):
    share, phi = arb(share), arb(phi)
    on_ray, anywhere, worst = checker._surface_values(share, phi)
    expected = truth(share, phi)
    assert on_ray.overlaps(expected[0])
    assert anywhere.overlaps(expected[1])
    assert on_ray.rad() < 1e-60
    assert worst is bool(2 * share * phi.sin() ** 2 <= 1)


def test_just_beyond_the_threshold_the_ray_itself_merges():
    on_ray, *_ = checker._surface_values(arb("0.5579"), arb("1.898637871626"))
    assert on_ray < 0
    on_ray, *_ = checker._surface_values(arb("0.5578"), arb("1.898637871626"))
    assert on_ray > 0


def test_the_ray_speaks_for_the_surface_only_where_it_is_the_worst_start():
    """Where 2 r sin^2 > 1 the excess on the ray may be positive and that beyond the edge not: "ray" proves nothing."""

    def relabel(data):
        cells = data["surface"]["cells"]
        place = next(n for n, cell in enumerate(cells) if Fraction(cell[0]) <= Fraction(3, 2) < Fraction(cell[1]))
        low, high = map(Fraction, cells[place][:2])
        ends = [str(low + (high - low) * n / 300) for n in range(301)]
        finer = [[first, last, "ray", "1/1000000"] for first, last in pairwise(ends)]
        assert all(checker._surface_values(arb("0.557"), checker._ball(*cell[:2]))[0] > 1e-6 for cell in finer)
        cells[place : place + 1] = finer

    assert refused(relabel)


@pytest.mark.parametrize("share", ["5579/10000", "-1/10", "0", "1", "6/5"])
def test_a_share_that_is_not_covered_is_refused(share):
    assert refused(lambda data: data["surface"].update(share=share))


@pytest.mark.parametrize("shift", ["1e-50", "-1e-50"])
def test_bounds_of_the_half_angle_that_miss_it_by_a_hair_are_refused(shift):
    def move(data):
        low, high = map(Fraction, data["constants"]["half_angle"])
        by = Fraction(shift)
        data["constants"]["half_angle"] = [str(low + by), str(high + by)]

    assert refused(move)


@pytest.mark.parametrize("name", ["share", "m1_over_m2", "m2_over_m1"])
@pytest.mark.parametrize("sign", [1, -1])
def test_bounds_of_a_constant_that_miss_it_by_a_hair_are_refused(name, sign):
    def move(data):
        low, high = map(Fraction, data["constants"][name])
        by = sign * 2 * (high - low)
        data["constants"][name] = [str(low + by), str(high + by)]

    assert refused(move)


def turning(x):
    sine, cosine = x.sin_cos()
    return x - sine * cosine - arb(2).sqrt() * (sine - x * cosine)


@given(st.integers(26, 314), st.integers(26, 314))
def test_the_mean_value_form_encloses_on_wide_balls(one, other):
    """The slope on the whole ball, not in its middle: K rises and falls on it."""
    low, high = sorted((one, other))
    ball = (arb(low) / 100).union(arb(high) / 100)
    enclosed = checker._turning_value(ball)
    for n in range(9):
        assert enclosed.overlaps(turning(arb(low) / 100 + (arb(high) - arb(low)) * n / 800))


@given(st.integers(1, 627), st.integers(0, 50), st.integers(-40, 40))
def test_the_contact_function_and_the_depth_are_theirs(angle, gap, push):
    theta, gap, push = arb(angle) / 100, arb(gap) / 10, arb(push) / 10
    half = theta / 2
    guard = (theta - theta.sin()) - gap * half.cot() * (1 - theta.cos()) - push * (1 - theta.cos())
    assert (checker._contact(theta, gap, push) * (1 - theta.cos())).overlaps(guard)
    assert checker._depth(theta).overlaps(2 - theta * half.cos() / half.sin())


@pytest.mark.parametrize("end", [0, 1])
def test_a_bracket_that_misses_the_end_of_its_slip_is_refused(end):
    """Both ends on one side of the contact, by less than the bracket is wide."""

    def move(data):
        slip = data["bands"][0]["slips"][0]
        low, high = Fraction(slip[0]), Fraction(slip[1])
        width = high - low
        by = width if end else -width
        slip[0], slip[1] = str(low + by), str(high + by)

    assert refused(move)
