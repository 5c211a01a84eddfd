"""What a claim is written with, from one place: every module of this room begins with `from paper_checks.claims.words import *`.

The words are those that `paper_checks.evidence` and `paper_checks.decide` list, the letters those of `theory.symbols`, and
what formulas are made of is sympy's.
"""

from sympy import (
    Abs,
    And,
    Basic,
    Expr,
    Integer,
    Matrix,
    Rational,
    Symbol,
    cos,
    expand,
    oo,
    pi,
    sin,
    sqrt,
    symbols,
)

from paper_checks.decide import *
from paper_checks.evidence import *
from theory.symbols import *
