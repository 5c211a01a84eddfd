"""All ways to a yes: an identity, two solvers, balls, a point, the kernel; what claims are written with is named here."""

from paper_checks.decide.deciders import (
    Decide,
    condition,
    decimal,
    equal,
    equals,
    fails_at,
    holds_at,
    implied,
    sharp,
)
from paper_checks.decide.exact import identity
from paper_checks.decide.exhibit import exhibit, value_at
from paper_checks.decide.polynomial import cleared, signed
from paper_checks.decide.smt import prove

__all__ = [
    "Decide",
    "cleared",
    "condition",
    "decimal",
    "equal",
    "equals",
    "exhibit",
    "fails_at",
    "holds_at",
    "identity",
    "implied",
    "prove",
    "sharp",
    "signed",
    "value_at",
]
