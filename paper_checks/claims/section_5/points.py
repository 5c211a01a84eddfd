"""Points of state and parameter space at which counterexamples stand, as exact rationals in SI units."""

from collections.abc import Iterator, Mapping
from fractions import Fraction

import sympy as sp
from sympy import Rational, Symbol

from numerics.scene import Pair, Scene, State
from theory.symbols import a1, a2, b, m1, m2, u, v1, v2, x1, x2

Values = Mapping[Symbol, Rational | int]


# Unit masses on a spring of 200 N/m, b = 0.5 N, no damper, no control: the pair of Section IV; S0 is |x1| <= 0.005.
EXAMPLE_PAIR: dict[Symbol, Rational | int] = {m1: 1, m2: 1, a1: 0, a2: 200, b: Rational(1, 2), u: 0}


def at_rest(position: str) -> dict[Symbol, Rational | int]:
    """Return the pair of Section IV with b = 0.5 N, both bodies at rest, x1 = position (m, decimal text)."""
    return {**EXAMPLE_PAIR, x1: Rational(position), v1: 0, v2: 0}


# The start of the paper's Fig. 4 (a), beyond the edge of S0; a point inside it; the edge itself.
START_AT_6MM = at_rest("0.006")
AT_4MM = at_rest("0.004")
AT_5MM = at_rest("0.005")


def scene_at(point: Values, until: str) -> Scene:
    """Return the scene that starts at a point, with the horizon `until` (s); what the point has no value for is 0."""

    def values(*symbols: Symbol) -> Iterator[Fraction]:
        return (Fraction(str(point.get(symbol, 0))) for symbol in symbols)

    return Scene(Pair(*values(m1, m2, a2, b, a1)), State(*values(x1, v1, x2, v2)), Fraction(until))


PULL = sp.Symbol(r"\ddot{x}_1", real=True)
