"""The exact solutions: residuals, limits between the regimes, an independent integrator, and faults."""

from dataclasses import replace

import mpmath
import pytest
from sympy import Rational, S, exp, limit

from theory import closed_forms
from theory.closed_forms import Regime, decay, rate
from theory.symbols import a1, a2, b, m1, m2, t, v1_0, v2_0, x1_0, x2_0

MODES = pytest.mark.parametrize("mode", ["stick", "slip+", "slip-"])
REGIMES = pytest.mark.parametrize("regime", list(Regime))
INITIAL = {x1_0: Rational(1, 3), v1_0: Rational(-2, 5), x2_0: Rational(1, 7), v2_0: Rational(1, 2)}


@MODES
@REGIMES
def test_the_solution_leaves_nothing(mode, regime):
    assert closed_forms.residual(closed_forms.solution(mode, regime)) == (0,) * 6


@MODES
@REGIMES
def test_every_planted_fault_leaves_something(mode, regime):
    found = closed_forms.solution(mode, regime)
    faults = [
        replace(found, x1=-found.x1),
        replace(found, x1=2 * found.x1),
        replace(found, x1=found.x1.subs(rate, 2 * rate) if regime is not Regime.CRITICAL else found.x1 * exp(t)),
        replace(found, x2=found.x2 + t**2 / 2),
        replace(found, x2=-found.x2),
        replace(found, mode="slip+" if mode == "slip-" else "slip-"),
    ]
    assert all(set(closed_forms.residual(fault)) != {0} for fault in faults)


@MODES
def test_regimes_meet(mode, same):
    """As omega -> 0 both neighbours tend to the critical solution; as beta -> 0 damping disappears."""
    critical = closed_forms.solution(mode, Regime.CRITICAL).x1
    for regime in (Regime.UNDERDAMPED, Regime.OVERDAMPED):
        assert same(limit(closed_forms.solution(mode, regime).x1, rate, 0), critical)
    under = closed_forms.solution(mode, Regime.UNDERDAMPED).x1
    assert same(under.subs(decay, 0), closed_forms.solution(mode, Regime.UNDAMPED).x1)


@pytest.mark.parametrize(
    ("regime", "viscosity"),
    [(Regime.UNDAMPED, S(0)), (Regime.UNDERDAMPED, S(1)), (Regime.CRITICAL, S(4)), (Regime.OVERDAMPED, S(7))],
)
@pytest.mark.parametrize("sign", [1, -1])
def test_against_a_taylor_integrator(regime, viscosity, sign):
    """mpmath integrates (5)-(7), typed here, in 25 digits; I = m1 = 2, a2 = 2, so a1 = 4 is critical."""
    numbers = {m1: S(2), m2: Rational(1, 2), a1: viscosity, a2: S(2), b: Rational(3, 4)}
    mode = {1: "slip+", -1: "slip-"}[sign]
    found = closed_forms.solution(mode, regime)
    meaning = {symbol: value.subs(numbers) for symbol, value in closed_forms.rates(mode, regime).items()}
    known = numbers | INITIAL | meaning | {t: Rational(3, 2)}
    with mpmath.workdps(25):
        mass1, mass2, damper, spring, friction = (
            mpmath.mpf(numbers[key].p) / numbers[key].q for key in (m1, m2, a1, a2, b)
        )

        def field(_, state):
            position, first, _second, _displacement = state
            force = sign * friction
            return [first, (-spring * position - damper * first - force) / mass1, force / mass2, _second]

        start = [mpmath.mpf(INITIAL[key].p) / INITIAL[key].q for key in (x1_0, v1_0, v2_0, x2_0)]
        end = mpmath.odefun(field, 0, start)(mpmath.mpf(3) / 2)
        expected = [found.x1, found.v1, found.v2, found.x2]
        assert all(
            abs(mpmath.mpf(str(value.subs(known).evalf(25))) - reached) < mpmath.mpf(10) ** -18
            for value, reached in zip(expected, end, strict=True)
        )
