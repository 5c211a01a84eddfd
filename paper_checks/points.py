"""Points of state and parameter space at which counterexamples stand, as exact rationals in SI units."""

from __future__ import annotations

from sympy import Rational, Symbol

from theory.symbols import a1, a2, b, m1, m2, u, v1, v2, x1

# Unit masses on a spring of 200 N/m, b = 0.5 N, no damper, no control: the pair of Section IV; S0 is |x1| <= 0.005.
EXAMPLE_PAIR: dict[Symbol, Rational | int] = {m1: 1, m2: 1, a1: 0, a2: 200, b: Rational(1, 2), u: 0}


def at_rest(position: str) -> dict[Symbol, Rational | int]:
    """Return the pair of Section IV with b = 0.5 N, both bodies at rest, x1 = position (m, decimal text)."""
    return {**EXAMPLE_PAIR, x1: Rational(position), v1: 0, v2: 0}


# The start of the paper's Fig. 3 (a), beyond the edge of S0; a point inside it; the edge itself.
FIGURE_3A = at_rest("0.006")
INSIDE = at_rest("0.004")
EDGE = at_rest("0.005")
