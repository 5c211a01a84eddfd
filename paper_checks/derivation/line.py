"""A line of the derivation: what was done, the formula that came out, how it is checked, and the claims that it carries.

The check decides the formula that is shown, so a wrong sign in either turns the line, and with it the claims.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp

from paper_checks.claims import claim_named
from paper_checks.decide.deciders import Decide
from paper_checks.decide.exact import identity
from paper_checks.evidence.clause import Clause, Formula
from paper_checks.evidence.evidence import Evidence, Steps, one_line
from theory.symbols import b

_NAMED = re.compile(r"line D(\d+) of the derivation: ")


@dataclass(frozen=True)
class Line:
    """One line: `done` says what was done, `formulas` is what came out; `carries` names clauses as `claim/clause`.

    `steps` are checks of an inference in words. `kernel` names theorems of the proof kernel that state what the line
    states, or more. Texts are prose with LaTeX between dollars.
    """

    done: str
    carries: str
    formulas: Callable[[], Formula | Sequence[Formula]] = field(default=tuple, compare=False)
    steps: Callable[[], Steps] = field(default=tuple, compare=False)
    kernel: str = ""

    def __post_init__(self) -> None:
        """Write the text, which may be written over several lines, with single spaces."""
        object.__setattr__(self, "done", one_line(self.done))

    @property
    def clauses(self) -> tuple[str, ...]:
        """The clauses that it carries, each as claim/clause."""
        return tuple(self.carries.split())

    @property
    def claims(self) -> tuple[str, ...]:
        """The ids of the claims that it carries, each once."""
        return tuple(dict.fromkeys(one.partition("/")[0] for one in self.clauses))

    def made(self) -> tuple[Formula, ...]:
        """Return its formulas; none where it is an inference in words."""
        found = self.formulas()
        return (found,) if isinstance(found, Formula) else tuple(found)

    def latex(self) -> str:
        """Return what came out, as displayed formulas."""
        return "".join(f"$${one.latex}$$" for one in self.made())

    def evidence(self, number: int) -> Steps:
        """Return what its checks find; each statement begins with the number of the line."""
        found = (*(one.evidence() for one in self.made()), *self.steps())
        return tuple(replace(one, statement=f"{named(number)}: {one.statement}") for one in found)


def named(number: int) -> str:
    """Return how the evidence of a line begins.

    >>> named(7)
    'line D7 of the derivation'
    """
    return f"line D{number} of the derivation"


def number_in(step: Evidence) -> int | None:
    """Return the number of the line that a step belongs to; None for a step of no line."""
    found = _NAMED.match(step.statement)
    return int(found[1]) if found else None


def zero(of: Callable[[sp.Basic], object]) -> Decide:
    """Decide a formula by expressions in its right side that have to be 0 for all values of their symbols."""

    def decide(formula: Formula) -> Evidence:
        return identity(f"${formula.latex}$", of(sp.sympify(formula.right).doit()))

    return decide


def tidy(expression: sp.Expr) -> sp.Expr:
    """Return a fraction as one writes it: b (m1 + m2) for both its terms, and (b - x)/m for -(x - b)/m."""
    top, bottom = sp.fraction(expression)
    top = sp.expand(top)
    sign = -1 if all(one.could_extract_minus_sign() for one in sp.Add.make_args(top)) else 1
    return sign * (sp.collect(sp.expand(sign * top), b, sp.factor) / bottom)


def gathered(product: sp.Expr) -> sp.Expr:
    """Return a product with one square root for all its factors of the power 1/2 and -1/2, not evaluated."""
    half = [one for one in sp.Mul.make_args(product) if one.is_Pow and abs(one.exp) == sp.Rational(1, 2)]
    inside = sp.Mul(*(one**2 for one in half))
    others = sp.Mul(*(one for one in sp.Mul.make_args(product) if one not in half))
    root = sp.Pow(inside, sp.Rational(1, 2), evaluate=False)
    return root if others == 1 else sp.Mul(others, root, evaluate=False)


def of_clause(key: str, *names: str) -> Callable[[], tuple[Formula, ...]]:
    """Return formulas of the clause `claim/clause` by their names: what is claimed there, and how it is decided."""

    def found() -> tuple[Formula, ...]:
        formulas = clause_named(key).formulas
        return tuple(formulas[name] for name in names)

    return found


def equation(left: str, right: sp.Basic, expected: sp.Basic, relation: str = "=") -> Formula:
    """Return a formula whose right side theory finds; it is decided by what it has to be, written down without theory."""
    return Formula(left, relation, right, zero(lambda found: found - expected))


def clause_named(key: str) -> Clause:
    """Return the clause `claim/clause`. Raises KeyError where there is none."""
    name, _, part = key.partition("/")
    claim = claim_named(name)
    return {one.id: one for one in (*claim.clauses, *claim.correction)}[part]


@dataclass(frozen=True)
class Stage:
    """A stage of the derivation: its anchor, its title, what is assumed in it, and its paragraphs, figures and lines in order."""

    id: str
    title: str
    assumed: str
    parts: tuple[str | Line, ...]

    @property
    def lines(self) -> tuple[Line, ...]:
        """Its lines."""
        return tuple(part for part in self.parts if isinstance(part, Line))
