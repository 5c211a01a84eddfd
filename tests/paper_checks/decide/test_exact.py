"""Identities pass, near misses fail at a point, and a silent simplifier is no pass."""

import pytest
import sympy as sp

from paper_checks.decide import exact
from paper_checks.decide.exact import identity
from paper_checks.evidence.evidence import EvidenceKind

x, y = sp.symbols("x y", real=True)
m = sp.Symbol("m", positive=True)
k = sp.Symbol("k", integer=True)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ((x + y) ** 2, x**2 + 2 * x * y + y**2),
        (1 / (1 - x) - 1, x / (1 - x)),
        (sp.sin(x) ** 2, 1 - sp.cos(x) ** 2),
        (sp.sqrt(m**2), m),
        (sp.cos(sp.pi * k) ** 2, 1),
        (sp.Matrix([x * (x + 1), 0]), sp.Matrix([x**2 + x, 0])),
        (sp.Matrix([x - x]), 0),
        (sp.Abs(x) ** 2, x**2),
    ],
)
def test_an_identity_passes(left, right):
    evidence = identity("identity", left, right)
    assert evidence.passed is True, evidence.value
    assert evidence.kind is EvidenceKind.EXACT
    assert evidence.cases >= 5


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ((x + y) ** 2, x**2 + 2 * x * y - y**2),
        (sp.sqrt(x**2), x),
        (sp.sin(x), x),
        (sp.Matrix([x, y]), sp.Matrix([x, x])),
        (m**2, m**2 + sp.Rational(1, 10**40)),
        (sp.ceiling(m / 2), -sp.ceiling(m / 2)),
        (sp.ceiling(m / 2), sp.floor(m / 2)),
        (sp.ceiling(sp.sqrt(m)), sp.ceiling(2 * sp.sqrt(m))),
        (sp.sin(x) * (1 + sp.Rational(1, 10**70)), sp.sin(x)),
        (sp.I * sp.exp(400), sp.I * sp.exp(400 + sp.Rational(1, 10**150))),
        (1, 2),
    ],
)
def test_a_near_miss_fails_and_names_the_point(left, right):
    evidence = identity("near miss", left, right)
    assert evidence.passed is False
    assert evidence.value.startswith("difference")


def test_one_entry_that_the_simplifier_does_not_settle_leaves_the_matrix_open(monkeypatch):
    one = sp.sin(y) ** 2 + sp.cos(y) ** 2
    assert identity("both", sp.Matrix([x, one]), sp.Matrix([x, 1])).passed is True
    monkeypatch.setattr(exact, "simplifies_to_zero", lambda difference: not difference.has(y))
    assert identity("one", sp.Matrix([x, one]), sp.Matrix([x, 1])).passed is None


@pytest.mark.parametrize("nowhere", [1 / (sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1), sp.erf(x)], ids=str)
def test_a_simplifier_without_a_point_is_no_pass(nowhere, monkeypatch):
    monkeypatch.setattr(exact, "simplifies_to_zero", lambda difference: True)
    evidence = identity("matrix", sp.Matrix([x, nowhere]), sp.Matrix([x, 0]))
    assert evidence.passed is None
    assert evidence.value == "1 of the differences could be evaluated nowhere"


@pytest.mark.parametrize(
    ("left", "right"), [(sp.sqrt(m**2 + 2 * m + 1), m + 1), (sp.atan(m) + sp.atan(1 / m), sp.pi / 2)]
)
def test_what_neither_normal_form_nor_sympy_decides_is_undecided(left, right):
    evidence = identity("true", left, right)
    assert evidence.passed is None
    assert evidence.value == "the simplifier does not reach 0"


def test_lists_of_two_lengths_are_not_compared():
    with pytest.raises(ValueError, match="zip"):
        identity("short", [x], [x, y])


def test_the_same_seed_gives_the_same_evidence():
    assert identity("s", x, y, seed=3) == identity("s", x, y, seed=3)
    assert identity("s", x, y, seed=3) != identity("s", x, y, seed=4)


def test_points_meet_the_assumptions():
    negative = sp.Symbol("v", negative=True)
    assert identity("sign", sp.Abs(negative) + m + sp.Abs(k), -negative + sp.Abs(m) + sp.Abs(k)).passed is True


def test_a_function_that_is_only_named_tells_different_arguments_apart():
    c, x = sp.Function("c"), sp.Symbol("x", positive=True)
    assert identity("the same", c(x) + 1, 1 + c(x)).passed is True
    assert identity("twice", sp.Min(c(x), 1), 2 * sp.Min(c(x), 1)).passed is False
    assert identity("elsewhere", c(x), c(2 * x)).passed is False
    assert identity("another function", c(x), sp.Function("d")(x)).passed is False
