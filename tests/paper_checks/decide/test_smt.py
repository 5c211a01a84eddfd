"""Two solvers, one text, and a control: true, false, vacuous and foreign statements."""

import sys

import pytest
import sympy as sp

from paper_checks.decide import smt
from paper_checks.decide.polynomial import cleared
from paper_checks.decide.smt import SolverAnswers, prove
from paper_checks.decide.text import script
from paper_checks.errors import NotPolynomialError, ToolMissingError

from .formulas import ASKED, asked, formula, m, n, x, y


@pytest.mark.parametrize(("formulas", "passed"), asked("statements"))
def test_a_statement_is_proved_or_refuted_with_a_model(formulas, passed):
    *given, conclusion = map(formula, formulas)
    evidence = prove("", given, conclusion)
    assert evidence.passed is passed
    assert passed or evidence.value.startswith("counterexample: ")


def test_a_sign_that_sympy_leaves_open_is_left_open():
    """At 0 a number that is only not negative is not positive; one that is not 0 has a positive square."""
    k, w = sp.Symbol("k", nonnegative=True), sp.Symbol("w", real=True, nonzero=True)
    assert prove("beyond 0", [], k + k**2 > 0).passed is False
    assert prove("strict at the edge", [x >= 1], x > 1).value == "counterexample: x = 1"
    assert prove("a square", [], sp.Gt(w**2, 0, evaluate=False)).passed is True
    for may_be_0_or_negative in (k, w):
        with pytest.raises(ValueError, match="not manifestly positive"):
            cleared(x / may_be_0_or_negative)
    assert cleared(x / w**2) == x
    assert cleared(x / (-m - n)) == -x


@pytest.mark.parametrize("given", ASKED["vacuous"])
def test_a_vacuous_statement_proves_nothing(given):
    evidence = prove("vacuous", [*map(formula, given)], y > 7)
    assert evidence.passed is None
    assert "the assumptions alone are unsat (z3), unsat (cvc5)" in evidence.value


@pytest.mark.parametrize("conclusion", ASKED["refused"])
def test_what_is_not_an_exact_polynomial_over_the_reals_is_refused(conclusion):
    with pytest.raises(NotPolynomialError):
        prove("foreign", [], formula(conclusion))


@pytest.mark.parametrize(
    "other", [SolverAnswers("sat", "unknown"), SolverAnswers("sat", "sat"), SolverAnswers("unknown", "unsat")]
)
@pytest.mark.parametrize("silent", [("z3",), ("cvc5",), ("z3", "cvc5")])
def test_what_one_solver_leaves_open_is_not_proved(monkeypatch, silent, other):
    """Of the negation, or of the control; only what both refute is false."""
    monkeypatch.setattr(smt, "ask", lambda name, *_: other if name in silent else SolverAnswers("sat", "unsat"))
    evidence = prove("a square", [x > 1], x**2 > 1)
    both_refute = len(silent) == 2 and "unknown" not in (other.control, other.negation)
    assert evidence.passed is (False if both_refute else None)
    assert both_refute or f" ({silent[0]})" in evidence.value


def test_a_solver_that_fails_is_an_error():
    with pytest.raises(RuntimeError, match="cvc5 failed"):
        smt.ask("cvc5", "(nonsense", "", 60.0)  # a busy machine takes its time to start a solver


@pytest.mark.parametrize("missing", ["z3", "cvc5"])
def test_a_missing_solver_is_named(monkeypatch, missing):
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(ToolMissingError, match=missing):
        prove("a square", [x > 1], x**2 > 1)


GIVEN_UP = """(set-logic NRA)
(declare-const y Real)
(assert (forall ((x Real)) (> (+ (* x x y) (* x y y)) (* (- 3.0) y y y y))))
"""


def test_what_a_solver_has_no_time_for_is_unknown():
    """Whether it gives up itself, or is ended; z3 may fail under such a limit, which is an error."""
    letters = sp.symbols("a:h", real=True)
    hard = sum(letter**7 for letter in letters) <= sp.prod(letters) ** 3
    for text in (GIVEN_UP, script([sp.Eq(sum(letter**5 for letter in letters), 1), hard])):
        assert smt.ask("cvc5", text, text, 0.05).negation == "unknown"
