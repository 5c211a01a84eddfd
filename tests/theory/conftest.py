"""How the theory's tests compare expressions, draw numbers and plant faults."""

import random
from collections.abc import Callable

import pytest
from sympy import Expr, Rational, Symbol, simplify

Point = dict[Symbol, Rational]


def draw(symbols: set[Symbol], seed: int) -> Point:
    """Rationals in (0, 3), with random sign where the symbol may be negative, q in (0, 1)."""
    source = random.Random(seed)
    point = {}
    for symbol in sorted(symbols, key=str):
        value = Rational(source.randint(1, 299), 100)
        if symbol.name == "q":
            value = Rational(source.randint(1, 99), 100)
        if symbol.is_nonnegative is None and source.random() < 0.5:
            value = -value
        point[symbol] = value
    return point


@pytest.fixture
def at_random() -> Callable[..., list[Point]]:
    """Three (or ``cases``) reproducible rational points for the symbols of some expressions."""

    def points(*expressions: Expr, cases: int = 3) -> list[Point]:
        symbols = set().union(*(expression.free_symbols for expression in expressions))
        return [draw(symbols, seed) for seed in range(cases)]

    return points


@pytest.fixture
def same(at_random) -> Callable[[Expr, Expr], bool]:
    """Equality twice over: as an identity for the simplifier, and in 40 digits at random rationals."""

    def compare(left: Expr, right: Expr) -> bool:
        difference = left - right
        numerically = all(abs(difference.subs(point).evalf(40)) < 1e-30 for point in at_random(difference))
        identically = simplify(difference) == 0
        assert numerically == identically, f"simplifier and numbers disagree on {difference}"
        return identically

    return compare
