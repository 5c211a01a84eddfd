"""Proofs of polynomial statements for all reals, by two SMT solvers that read the same text.

A statement counts as proved where z3 and cvc5 both find its negation unsatisfiable, and both find the
assumptions alone satisfiable: the control that keeps a vacuous statement from passing.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec

import sympy as sp

from paper_checks.decide.process import answer
from paper_checks.decide.text import script
from paper_checks.errors import NotPolynomialError, ToolMissingError
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.formula import latex

SOLVERS = ("z3", "cvc5")
ENGINE = " and ".join(SOLVERS)


@dataclass(frozen=True)
class SolverAnswers:
    """One solver's answers, each `sat`, `unsat` or `unknown`."""

    control: str
    """Are there values that meet the assumptions?"""
    negation: str
    """Are there values that meet the assumptions and not the conclusion?"""
    model: str = ""
    """Such values, where the solver names them."""


def prove(
    statement: str,
    assumptions: Sequence[sp.Basic],
    conclusion: sp.Basic,
    *,
    seconds: float = 20.0,
) -> Evidence:
    """Prove that the assumptions imply the conclusion, for all real values of the symbols.

    `statement` is what the reader sees. Assumptions and conclusion are sympy relationals or Boolean
    combinations of them, polynomial, with exact coefficients; what sympy assumes of a symbol is taken as an
    assumption. Each solver has `seconds` for each of two questions. Passed is True where both solvers prove
    it, False (the model is the value) where both refute it, and None where one does not answer, they differ,
    or no case meets the assumptions. Raises NotPolynomialError, and ToolMissingError where a solver is not
    installed.
    """
    if conclusion == sp.true:
        raise NotPolynomialError("sympy simplified the conclusion to true: write it with evaluate=False")
    given = [assumption for assumption in assumptions if assumption != sp.true]
    control = script(given, also=conclusion.free_symbols)
    negation = script([*given, sp.Not(conclusion, evaluate=False)])
    passed, value = _judge([ask(solver, control, negation, seconds) for solver in SOLVERS])
    texts = tuple(f"${latex(assumption)}$" for assumption in given)
    return Evidence(EvidenceKind.SMT, ENGINE, statement, passed, 1, value, texts)


def _judge(answers: Sequence[SolverAnswers]) -> tuple[bool | None, str]:
    controls = [answer.control for answer in answers]
    negations = [answer.negation for answer in answers]
    if set(controls) != {"sat"}:
        return None, f"nothing is proved: the assumptions alone are {_spoken(controls)}"
    if set(negations) == {"unsat"}:
        return True, "negation unsat in both, assumptions alone sat in both"
    if set(negations) == {"sat"}:
        return False, f"counterexample: {answers[0].model}"
    return None, f"nothing is proved: the negation is {_spoken(negations)}"


def _spoken(answers: Sequence[str]) -> str:
    return ", ".join(f"{answer} ({solver})" for solver, answer in zip(SOLVERS, answers, strict=True))


def ask(solver: str, control: str, negation: str, seconds: float) -> SolverAnswers:
    """Put both texts to the solver, in a process that ends with the time limit.

    Raises ToolMissingError where it is not installed, RuntimeError where it fails.
    """
    if (solver in sys.modules and sys.modules[solver] is None) or find_spec(solver) is None:
        raise ToolMissingError(f"the SMT solver {solver} is not installed")
    try:
        reply = answer(solver, [control, negation], seconds)
    except RuntimeError as error:
        raise RuntimeError(f"{solver} failed: {error}") from error
    if reply is None:
        return SolverAnswers("unknown", "unknown")
    of_control, of_negation = reply["answers"]
    return SolverAnswers(of_control, of_negation, reply["model"])
