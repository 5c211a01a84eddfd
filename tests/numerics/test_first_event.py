"""The first event is first: whole runs against an independent brute-force scan in 90 digits."""

from fractions import Fraction

import mpmath
import pytest
from brute_force import DIGITS, BruteForce, number
from hypothesis import example, given, settings
from strategies import long_slips, near_critical, scenes

from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene, shipped_scenes
from numerics.solver.solve import solve

EVENTS = 5


def as_mpf(ball):
    mantissa, exponent = ball.mid().man_exp()
    return mpmath.ldexp(mpmath.mpf(int(mantissa)), int(exponent))


def assert_same(scene: Scene, max_events: int = EVENTS) -> int:
    """Every event and the final state agree to 50 digits of the scale of each quantity; returns the events."""
    balls = solve(scene, digits=50, arithmetic="ball", max_events=max_events)
    with mpmath.workdps(DIGITS):
        happenings, final = BruteForce(scene).run(max_events)
        found = [(event.before.value, event.after.value) for event in balls.events]
        assert found == [(one.before, one.after) for one in happenings]
        with balls.arithmetic.context():
            rows = [(event.t, *event.y) for event in balls.events] + [(balls.t[-1], *balls.y[:, -1])]
        truths = [(one.t, *one.y) for one in happenings]
        truths.append((as_mpf(balls.t[-1]), *final))
        width, rate = number(scene.pair.half_width), mpmath.sqrt(number(scene.pair.a2 / scene.pair.mass))
        least = [mpmath.mpf(0), width, width * rate, width, width * rate]
        scales = [max(least[i], *(abs(row[i]) for row in truths)) for i in range(5)]
        for row, truth in zip(rows, truths, strict=True):
            for one, two, scale in zip(row, truth, scales, strict=True):
                assert abs(as_mpf(one) - two) <= mpmath.mpf(10) ** -49 * scale, (as_mpf(one), two)
    return len(happenings)


@given(scenes())
def test_undamped(scene):
    assert_same(scene)


@settings(max_examples=settings().max_examples // 2)
@given(scenes(damped=True))
@example(Scene(Pair(2, 1, 3, 1, a1=1), State(x1=Fraction(-1, 3), v2=-3), until=20))
@example(Scene(Pair(2, 1, 3, 1, a1=1), State(v1=Fraction(1, 5), v2=-3), until=20))
@example(Scene(Pair(1, 1, 3, 1, a1=2), State(Fraction(2, 9), Fraction(2, 3), 0, Fraction(2, 3)), until=20))
@example(Scene(Pair(1, 1, 1, 1, a1=2), State(x1=1, v1=5), until=20))
@example(
    Scene(Pair("0.5", "0.5", 3, 1, a1="2.4"), State("2.6", "2.4", 0, "-3.9"), until=20)
)  # a contact was passed over
@example(Scene(Pair("0.5", "0.5", 3, 1, a1="2.35"), State("3.2", "-0.5", 0, "-1.8"), until=20))
@example(Scene(Pair(1, "0.5", 3, 1, a1="2.6"), State("-3.9", "2.4", 0, "1.8"), until=20))  # an exit was passed over
@example(Scene(Pair(1, 1, 200, "0.5", a1=40), State(x1=1, v1=2), until=5))
def test_damped(scene):
    assert_same(scene)


@settings(max_examples=settings().max_examples // 3)
@given(long_slips(turns=(0, 0)))
def test_many_cycles_in_one_slip(scene):
    assert_same(scene, 3)


@settings(max_examples=settings().max_examples // 3)
@given(long_slips(damped=True, turns=(0, 0)))
def test_many_damped_cycles_in_one_slip(scene):
    assert_same(scene, 3)


@settings(max_examples=settings().max_examples // 3)
@given(near_critical((3, 16)))
def test_near_the_critical_energy(scene):
    assert_same(scene)


@pytest.mark.parametrize("name", [name for name in shipped_scenes() if not load_scene(name).is_forced])
def test_the_papers_scenes(name):
    scene = load_scene(name)
    assert assert_same(scene, 16) or "literal" in name or "3a" in name or scene.energy_excess <= 0


@given(scenes(damped=None, law=Law.THREE_VALUED_SGN))
def test_the_literal_law(scene):
    assert_same(scene)


@pytest.mark.parametrize("fraction", ["1e-9", "1e-15"])
@pytest.mark.parametrize("sign", [-1, 1])
def test_almost_a_graze(fraction, sign):
    """The guard's third minimum passes 0 by 1e-9 of its size, above or below: another first event."""
    with mpmath.workdps(60):
        theta = mpmath.pi / 6 + 2 * mpmath.pi
        guard = theta - 2 * (1 - mpmath.cos(theta)) + sign * mpmath.mpf(fraction)
        text = mpmath.nstr(guard, 40)
    scene = Scene(Pair(m1=1, m2=3, a2=4, b=3), State(Fraction(-3, 4), -1, 0, -1 - Fraction(text) / 2), until=20)
    first = solve(scene, digits=30, arithmetic="ball").events[0].t
    assert (first < 3.5) == (sign < 0)
