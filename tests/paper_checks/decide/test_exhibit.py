"""Exact points: true, false, open and inexact relations."""

import pytest
import sympy as sp

from paper_checks.claims.section_5.points import AT_5MM, START_AT_6MM, scene_at
from paper_checks.decide.exhibit import exhibit, value_at
from paper_checks.evidence.evidence import EvidenceKind
from theory.energy import critical_energy, energy

x, y = sp.symbols("x y", real=True)


@pytest.mark.parametrize(
    ("relation", "passed"),
    [("<", False), ("<=", True), ("=", True), ("!=", False), (">=", True), (">", False)],
)
def test_equality_is_told_from_strict_inequality(relation, passed):
    evidence = exhibit("at the edge", {x: sp.Rational(1, 3)}, (3 * x, relation, 1))
    assert (evidence.passed, evidence.kind) == (passed, EvidenceKind.EXACT)


def test_one_false_relation_is_enough_to_fail_and_an_open_one_to_stay_open():
    assert exhibit("both", {x: 1}, (x, ">", 0), (x, "<", 0)).passed is False
    assert exhibit("open", {x: 1}, (x, ">", 0), (y, ">", 0)).passed is None
    assert exhibit("irrational", {x: 2}, (sp.sqrt(x), ">", 1)).passed is None
    assert exhibit("nothing", {x: 1}).passed is None


def test_an_inexact_value_is_refused():
    with pytest.raises(TypeError, match="not a rational"):
        exhibit("float", {x: 0.006}, (x, ">", 0))
    with pytest.raises(ValueError, match="no rational value"):
        value_at(x, {})


def test_a_point_and_its_scene_are_the_same_state():
    for point in (START_AT_6MM, AT_5MM):
        scene = scene_at(point, "5")
        assert sp.Rational(str(scene.energy)) == energy().subs(point)
        assert sp.Rational(str(scene.pair.critical_energy)) == critical_energy().subs(point)
    assert scene_at(AT_5MM, "5").energy_excess == 0
