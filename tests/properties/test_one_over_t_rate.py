"""Where the free pair never merges, E - E_cr falls as 1/t: between c1/t and c2/t, and with one sharp constant.

Times count from an exit from S0 with w = E/E_cr - 1 = q y_0, y_0 <= (pi/2 - 1)^2: from there on the constants of theory
hold. Each law is a function of its exponent or its constant, and is seen to answer no for one next to it. The laws,
and their tests:

  is_between    c1/t <= E - E_cr <= c2/t: test_the_excess_is_between_two_constants_over_the_time
  is_sharp      t (E - E_cr) tends to K, with an error: test_the_time_times_the_excess_tends_to_the_sharp_constant
"""

from fractions import Fraction
from typing import NamedTuple

import pytest
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import late_times, motions_of_energy, near_critical
from theory_values import energy_of, exact, excess_of, excursion_of, of_pair, reduced_time

from numerics import EventUndecided, OutOfRange, Pair, Scene, State, load_scene, solve
from numerics.arithmetic.ball import digits_within, precision
from numerics.free.energy import energy_at
from numerics.linear.modes import EventKind
from paper_checks.claims.beyond.uniform_rate import rate_with_error
from theory.energy import critical_energy
from theory.long_time import leading_coefficient, logarithm_weight
from theory.near_critical import rate_constant
from theory.rate_bounds import cycle_times, excess_bounds

pytestmark = pytest.mark.rate

SLOW = Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 1)
SLOW_ONES = pytest.mark.parametrize("scene", [SLOW, load_scene("itinerary-that-creeps")])
creeping = st.one_of(
    near_critical((1, 60), exponents=(-9, 9), ratios=(-2, 2)), motions_of_energy((-12, -1), ratios=(-2, 2))
)


@pytest.fixture(autouse=True)
def many_digits():
    with precision(300):
        yield


class Exit(NamedTuple):
    """The exit from which on the constants hold: its time, s, and y_0, theta_0 and c_0 by name."""

    scene: Scene
    begin: arb
    letters: dict[str, arb]

    def value(self, expression, **more):
        """An expression of theory at this exit."""
        return of_pair(expression, self.scene.pair, **self.letters, **more)

    def at(self, t: Fraction) -> tuple[arb, arb]:
        """The reduced time since the exit, and w, by the jump; LeftOut before it, or where too many events come first.

        It never merges.
        """
        s = reduced_time(self.scene.pair, exact(t) - self.begin)
        if not s > 0:
            raise LeftOut
        try:
            found = energy_at(self.scene, t, digits=20, max_steps=5000)
        except (OutOfRange, EventUndecided):
            raise LeftOut from None
        w = found.energy_excess
        assert found.energy.overlaps(of_pair(critical_energy(), self.scene.pair) * (1 + w))
        assert w > 0
        assert digits_within(w.rad(), w, arb(1)) >= found.digits
        return s, w


def first_exit(scene: Scene) -> Exit:
    """The first exit that is close enough to the critical orbit; LeftOut where the pair merges, or comes there late."""
    pair, at = scene.pair, scene.initial
    if abs(at.x1) == pair.half_width and at.v1 == at.v2 and at.x1 * at.v1 > 0:
        found = [(arb(0), arb(excess_of(scene)))]
    else:
        long = Scene(pair, at, Fraction(float(60 * arb.pi() / reduced_time(pair, 1))))
        run, critical = solve(long, digits=60, arithmetic="ball", max_events=60), of_pair(critical_energy(), pair)
        exits = (event for event in run.events if event.kind is EventKind.EXIT)
        found = [(event.t, energy_of(pair, event.y) / critical - 1) for event in exits]
    for begin, w in found:
        y = w / exact(pair.share)
        if y <= (arb.pi() / 2 - 1) ** 2:
            return Exit(scene, begin, excursion_of(y))
    raise LeftOut


def is_between(begun: Exit, t: Fraction, power: Fraction = Fraction(1)) -> bool:
    """Whether c_1(s)/s^power <= w <= c_2(s)/s^power: theory's bounds times s lie between constants from s = pi on."""
    s, w = begun.at(t)
    low, high = (s * begun.value(one, s=s) for one in excess_bounds())
    scaled = w * s ** exact(power)  # in 20 digits: next to an exit, w that has hardly changed is on its bound in these
    return not (scaled < low or scaled > high)


def is_sharp(begun: Exit, t: Fraction, factor: Fraction = Fraction(1), power: Fraction = Fraction(1)) -> bool:
    """Whether K/(E - E_cr) is t^power up to a stated error, K `factor` times the sharp constant of theory, J s.

    Of claim `rate-with-error`: C/w_n + pi B ln(w_n/w_0) = C/w_0 + tau_n + R_n at the exits. In between w lies between
    its values at both, which are at most T_+ apart in time, and in ratio at most 1 - r c_0^2/y_0. So
    |C/w + pi B ln(w/w_0) - C/w_0 - s| is at most T_+ + |R_n| - pi |B| ln(1 - r c_0^2/y_0): C/w over s tends to 1.
    """
    pair, (_, longest) = begun.scene.pair, cycle_times()
    s, w = begun.at(t)
    critical, y, r = of_pair(critical_energy(), pair), begun.letters["y_0"], exact(1 - pair.share)
    sharp, rate = exact(factor) * of_pair(rate_constant(), pair), reduced_time(pair, 1)
    weight = arb.pi() * of_pair(logarithm_weight(), pair)
    formulas = rate_with_error.clauses[0].formulas
    ends = [abs(begun.value(formulas[name].right, r=r)) for name in ("lower", "upper")]
    first = y * exact(pair.share)
    error = begun.value(longest) + ends[0].max(ends[1]) - abs(weight) * (1 - r * begun.letters["c_0"] ** 2 / y).log()
    passed = sharp / critical * rate * (1 / w - 1 / first) + weight * (w / first).log()
    return not abs(passed - s ** exact(power)) > error


@reaching
@given(creeping, late_times())
@example(SLOW, Fraction(10) ** 100)
@example(load_scene("itinerary-that-creeps"), Fraction(10) ** 9)
def test_the_excess_is_between_two_constants_over_the_time(scene, t):
    assert is_between(first_exit(scene), t)


@reaching
@given(creeping, late_times())
@example(SLOW, Fraction(10) ** 100)
@example(SLOW, Fraction(10) ** 12)
def test_the_time_times_the_excess_tends_to_the_sharp_constant(scene, t):
    assert is_sharp(first_exit(scene), t)


# each law is seen to fail

LATE = Fraction(10) ** 60


@SLOW_ONES
@pytest.mark.parametrize(
    ("obeys", "power"), [(is_between, "0.9"), (is_between, "1.1"), (is_sharp, "0.999"), (is_sharp, "1.001")]
)
def test_another_exponent_is_found(scene, obeys, power):
    begun = first_exit(scene)
    assert obeys(begun, LATE)
    assert not obeys(begun, LATE, power=Fraction(power))


@SLOW_ONES
@pytest.mark.parametrize("factor", [Fraction(999_999, 10**6), Fraction(1_000_001, 10**6)])
def test_another_constant_is_found(scene, factor):
    assert not is_sharp(first_exit(scene), LATE, factor=factor)


@SLOW_ONES
def test_the_constants_close_on_the_sharp_one(scene):
    """As y_0 -> 0 and s -> oo both bounds of s w tend to the sharp constant: one wider by a factor is found."""
    begun, late = Exit(scene, arb(0), excursion_of(arb(10) ** -40)), arb(10) ** 80
    sharp = of_pair(leading_coefficient(), scene.pair)
    assert all(abs(late * begun.value(one, s=late) / sharp - 1) < 1e-15 for one in excess_bounds())
