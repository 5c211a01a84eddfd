"""The exact solutions: residuals, limits between the regimes, and faults."""

from dataclasses import replace

import pytest
from sympy import exp, limit

from theory import closed_forms
from theory.closed_forms import Regime, decay, rate
from theory.symbols import t

MODES = pytest.mark.parametrize("mode", ["stick", "slip+", "slip-"])
REGIMES = pytest.mark.parametrize("regime", list(Regime))


@MODES
@REGIMES
def test_the_solution_leaves_nothing(mode, regime):
    assert closed_forms.residual(closed_forms.solution(mode, regime)) == (0,) * 6


@REGIMES
def test_every_planted_fault_leaves_something(regime):
    found = closed_forms.solution("slip+", regime)
    faults = [
        replace(found, x1=-found.x1),
        replace(found, x1=2 * found.x1),
        replace(found, x1=found.x1.subs(rate, 2 * rate) if regime is not Regime.CRITICAL else found.x1 * exp(t)),
        replace(found, x2=found.x2 + t**2 / 2),
        replace(found, x2=-found.x2),
        replace(found, mode="slip-"),
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
