"""Closed forms of motion put into the printed equations: they solve them, and nothing beside them does.

What theory derives from the branches, the claims hold against what is typed there, and a fault in it turns their rows.
"""

from dataclasses import replace

import pytest
from sympy import exp, simplify

from theory import closed_forms, model, scaling
from theory.closed_forms import DampingRegime, rate
from theory.symbols import t, total_mass

REGIMES = pytest.mark.parametrize("regime", list(DampingRegime))


def test_whether_adhesion_has_a_sign_depends_on_the_branch():
    signs = {found.name: found.stiction_sign for found in model.branches()}
    assert signs == {"stick": -1, "slip+": None, "slip-": None, "half adhesion": 0, "broken adhesion": 1}


@pytest.mark.parametrize("mode", ["stick", "slip+", "slip-"])
@REGIMES
def test_the_exact_solution_leaves_nothing(mode, regime):
    assert closed_forms.residual(closed_forms.solution(mode, regime)) == (0,) * 6


@REGIMES
def test_every_fault_in_it_leaves_something(regime):
    found = closed_forms.solution("slip+", regime)
    faults = [
        replace(found, x1=2 * found.x1),
        replace(found, x1=found.x1.subs(rate, 2 * rate) if regime is not DampingRegime.CRITICAL else found.x1 * exp(t)),
        replace(found, x2=found.x2 + t**2 / 2),
        replace(found, x2=-found.x2),
        replace(found, mode="slip-"),
    ]
    assert all(set(closed_forms.residual(fault)) != {0} for fault in faults)


def test_the_canonical_pair_has_unit_length_frequency_and_mass():
    for size in (scaling.half_width(), scaling.stick_frequency(), total_mass()):
        assert simplify(size.subs(scaling.canonical_pair(), simultaneous=True)) == 1
