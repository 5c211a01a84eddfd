"""Faults to plant in theory, in the steps of an argument or in what is printed: each takes the original."""

import itertools
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from paper_checks.decide.polynomial import RELATIONAL
from theory.filippov import EdgeContact


def negated(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong sign."""
    return lambda *arguments, **named: -original(*arguments, **named)


def doubled(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong factor."""
    return lambda *arguments, **named: 2 * original(*arguments, **named)


def squared(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong exponent."""
    return lambda *arguments, **named: original(*arguments, **named) ** 2


def halved(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong factor, on the other side."""
    return lambda *arguments, **named: original(*arguments, **named) / 2


def other_sign(original: Callable[..., Any]) -> Callable[..., Any]:
    """The field, rate or branch of the other half-space."""
    return lambda sign, *arguments, **named: original(-sign, *arguments, **named)


def plus(term: Any) -> Callable[..., Any]:
    """Return a fault that adds a term to a scalar."""
    return lambda original: lambda *arguments, **named: original(*arguments, **named) + term


def without(*symbols: Any) -> Callable[..., Any]:
    """Return a fault that drops the terms with these symbols."""
    return lambda original: lambda *arguments, **named: original(*arguments, **named).subs(dict.fromkeys(symbols, 0))


def confused(relation: str, read_as: str, *uses: int) -> Callable[..., Any]:
    """Return the fault for a module's name `prove`: a relation is another one, in these of its uses or in all.

    They are counted from the first proof on, in each the assumptions before the conclusion.
    """

    def planted(original: Any) -> Any:
        seen = itertools.count()

        def read(formula: Any) -> Any:
            if isinstance(formula, sp.And):
                return sp.And(*map(read, formula.args))
            wrong = isinstance(formula, RELATIONAL[relation]) and (next(seen) in uses or not uses)
            return RELATIONAL[read_as](formula.lhs, formula.rhs, evaluate=False) if wrong else formula

        return lambda statement, given, conclusion: original(statement, [*map(read, given)], read(conclusion))

    return planted


def mistaken(relation: str, read_as: str, *uses: int) -> Callable[..., Any]:
    """Return the fault for a module's name `signed`: a relation is another one, in these of its uses or in all."""

    def planted(original: Any) -> Any:
        seen = itertools.count()

        def signed(expression: Any, said: str) -> Any:
            wrong = said == relation and (next(seen) in uses or not uses)
            return original(expression, read_as if wrong else said)

        return signed

    return planted


def entry(index, change):
    """Change one of several expressions."""
    return lambda original: (
        lambda *given: tuple(change(one) if place == index else one for place, one in enumerate(original(*given)))
    )


def raised(value):
    """One per cent of 1 more."""
    return value + sp.Rational(1, 100)


def failing(original):
    """A step that has failed."""
    return lambda *given: replace(original(*given), passed=False)


def limit_changed(name, change):
    """Change one of the limits along a trajectory to the critical orbit."""
    return lambda limits: lambda: replace(limits(), **{name: change(getattr(limits(), name))})


def with_entry(change):
    """Change one printed pair of right sides."""
    return lambda printed: lambda *sign: printed(*sign) + sp.Matrix(change)


def inwards_missed(excursion):
    """The excursion with re-entry on the other side of the edge."""
    return lambda: replace(excursion(), position=2 - excursion().position)


def unbounded_sign(_):
    """Friction that may exceed b on S."""
    return lambda value, velocity: sp.And(sp.Le(sp.Abs(value), 2), sp.Lt(sp.Abs(velocity), 1))


def reversed_contact(contact):
    """A slip that touches S and curves back into the half-space that it came from."""
    return lambda side: EdgeContact(contact(side).first, -contact(side).second, contact(side).third)


def crossing_contact(contact):
    """A guard without the double root."""
    return lambda side: EdgeContact(contact(side).second, contact(side).second, contact(side).third)


def other_weight(weight):
    """The weight of Phi_- in the place of that of Phi_+."""
    return lambda: 1 - weight()


def not_strict(beyond):
    """The edge of the strip counted with S_+ and S_-."""
    return lambda side, strict=True: beyond(side, strict=False)


def squared_load(load):
    """A load that does not obey the oscillator's equation."""
    return lambda damped: load(damped) ** 2
