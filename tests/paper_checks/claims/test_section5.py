"""Section V: faults that must turn them."""

from fractions import Fraction

import pytest
import sympy as sp

from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from paper_checks.claims import discussion, energy, synchronisation
from paper_checks.claims.points import INSIDE, START_AT_6MM
from paper_checks.evidence.finding import Verdict
from theory.symbols import a1, b, m1, v2

from .conftest import CHECKS, doubled, finding_of, negated, squared, two_of_each

SYNCHRONISATION = "paper_checks.claims.synchronisation."
DISCUSSION = "paper_checks.claims.discussion."
DISSIPATION = "paper_checks.claims.energy."
SOLUTIONS = "paper_checks.claims.filippov."
SLIPS = "paper_checks.claims.itineraries."


def test_samples_alone_do_not_settle_synchronisation():
    finding = finding_of(CHECKS["synchronisation-all-parameters"])
    assert sum(item.kind.decisive for item in finding.evidence) >= 8
    assert [item.kind.value for item in finding.evidence].count("property") == 1


def without(*symbols):
    """Return a fault that drops the terms with these symbols from an expression."""
    return lambda original: lambda: original().subs(dict.fromkeys(symbols, 0))


STEP_FAULTS = [
    ("synchronisation-all-parameters", DISSIPATION + "slip_rate", negated),
    ("synchronisation-all-parameters", DISSIPATION + "slip_rate", doubled),
    ("synchronisation-all-parameters", DISSIPATION + "stick_rate", without(a1)),
    ("synchronisation-all-parameters", DISSIPATION + "energy", lambda energy: lambda: energy() / 2),
    ("synchronisation-all-parameters", DISSIPATION + "energy", lambda energy: lambda: energy() - m1 * v2**2),
    ("synchronisation-all-parameters", DISSIPATION + "lipschitz_constant", without(b)),
    ("synchronisation-all-parameters", DISSIPATION + "lipschitz_constant", lambda bound: lambda: bound() / 2),
    ("synchronisation-all-parameters", DISSIPATION + "sliding_field", lambda _: lambda damped: sp.Matrix([0, b, -b])),
    ("finite-time-then-alternation", SLIPS + "half_angle_slope", lambda slope: lambda: (2 * slope()[0], slope()[1])),
    ("finite-time-then-alternation", SLIPS + "exact", lambda exact: lambda _: exact(1)),
    ("finite-time-then-alternation", SLIPS + "next_excess", doubled),
    ("finite-time-then-alternation", SLIPS + "next_excess", squared),
    ("finite-time-then-alternation", SLIPS + "r", lambda r: 3 * r),
    ("finite-time-then-alternation", SYNCHRONISATION + "INSIDE", lambda _: START_AT_6MM),
    ("finite-time-then-alternation", "paper_checks.claims.capture.critical_energy", doubled),
    ("viscous-accelerates", SYNCHRONISATION + "captive_energy", lambda level: lambda: level() / 2),
    ("viscous-accelerates", DISSIPATION + "captive_energy", squared),
    ("viscous-accelerates", DISSIPATION + "load", negated),
    ("viscous-accelerates", DISSIPATION + "load_threshold", doubled),
    ("viscous-accelerates", SYNCHRONISATION + "DAMPED", lambda point: {**point, a1: 0}),
    ("two-descriptions", DISCUSSION + "APART", lambda apart: 2 * apart),
    ("two-descriptions", DISCUSSION + "START_AT_6MM", lambda _: INSIDE),
    ("two-descriptions", DISCUSSION + "phi", lambda phi: lambda sign: phi(-sign)),
    ("two-descriptions", DISCUSSION + "sliding_field", doubled),
    ("two-descriptions", SOLUTIONS + "contraction_rate", negated),
    ("acceleration-bound", DISCUSSION + "START_AT_6MM", lambda _: INSIDE),
    ("acceleration-bound", DISCUSSION + "b", lambda b: 2 * b),
    ("acceleration-bound", DISCUSSION + "load_threshold", doubled),
    ("acceleration-bound", DISCUSSION + "sliding_field", lambda field: lambda damped=False: 2 * field(damped)),
]


@pytest.mark.parametrize(("claim_id", "target", "fault"), two_of_each(STEP_FAULTS))
def test_a_fault_in_a_step_or_a_point_turns_the_claim(plant, claim_id, target, fault):
    plant(target, fault)
    assert finding_of(CHECKS[claim_id]).verdict is Verdict.UNDECIDED


def test_a_strict_bound_of_the_acceleration_fails_at_the_edge(plant):
    """|x2''| < b/m2 instead of <=: the edge of S0 is a counterexample."""
    plant(DISCUSSION + "sp", strict)
    assert discussion.bounded_in_stick().passed is False


class strict:  # noqa: N801  stands in for the module sympy
    """Sympy, but a conclusion with <= is one with <; the assumption keeps its own."""

    def __init__(self, original):
        self.original, self.calls = original, 0

    def __getattr__(self, name):
        return getattr(self.original, name)

    def Le(self, left, right):
        self.calls += 1
        return self.original.Le(left, right) if self.calls == 1 else self.original.Lt(left, right)


def test_the_price_is_not_paid_with_a_smaller_bound_of_the_acceleration(monkeypatch):
    """The sampled inequality is sharp enough to notice a Lipschitz constant that is too small."""
    pair = Pair(m1=Fraction(1), m2=Fraction(1), a2=Fraction(200), b=Fraction(1, 2))
    trajectory = solve(Scene(pair, State(x1=Fraction(-1, 100), v1=Fraction(1, 10)), until=Fraction(2)))
    times = [Fraction(number, 500) for number in range(500)]
    assert all(synchronisation.pays(trajectory, time) is not False for time in times)
    bound = energy.lipschitz_constant()
    monkeypatch.setattr(energy, "lipschitz_constant", lambda: bound / 4)
    assert any(synchronisation.pays(trajectory, time) is False for time in times)
