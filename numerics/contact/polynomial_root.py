"""Where a polynomial with rational coefficients first changes sign: exact, touches passed over."""

from __future__ import annotations

import math
from fractions import Fraction

from flint import arb, fmpq, fmpz_poly

from numerics.arithmetic.ball_words import precision

_BITS = 256


def first_crossing(polynomial: list[Fraction], after: Fraction, until: Fraction) -> tuple[Fraction, Fraction | None]:
    """Return (t, root) for the first root of odd multiplicity in (after, until].

    A rational root is given, with t = root. For another one root is None and t lies before it, with no root of odd
    multiplicity and no touch between t and it. Without any, (until, None).
    """
    found = _roots(polynomial)
    if found is None:
        return until, None
    before = after
    for low, high, exact, multiplicity in found:
        if low <= after:
            continue
        if low > until:
            break
        if multiplicity % 2 == 0:
            before = max(before, high)
            continue
        if exact is not None:
            return exact, exact
        return max(before, min(low, until)), None
    return until, None


def touches(polynomial: list[Fraction], after: Fraction, until: Fraction) -> bool:
    """Return whether it has a root of even multiplicity in (after, until]."""
    return any(n % 2 == 0 and after < low and high <= until for low, high, _, n in _roots(polynomial) or [])


def _roots(polynomial: list[Fraction]) -> list[tuple[Fraction, Fraction, Fraction | None, int]] | None:
    """Return the real roots in order: bounds, the root if it is rational (of odd multiplicity), its multiplicity.

    None for a constant.
    """
    below = math.lcm(*(c.denominator for c in polynomial))
    whole = fmpz_poly([int(c * below) for c in polynomial])
    if whole.degree() < 1:
        return None
    found: list[tuple[Fraction, Fraction, Fraction | None, int]] = []
    _, factors = whole.factor()
    for factor, multiplicity in factors:
        if factor.degree() == 1:
            root = Fraction(-int(factor[0]), int(factor[1]))
            found.append((root, root, root if multiplicity % 2 else None, multiplicity))
        else:
            found += [(*ends, None, multiplicity) for ends in _real_roots(factor)]
    return sorted(found, key=lambda one: one[0])


def _real_roots(factor: fmpz_poly) -> list[tuple[Fraction, Fraction]]:
    """Return bounds of the real roots of an irreducible polynomial, far closer than roots are to each other."""
    with precision(_BITS):
        roots = [one.real for one, _ in factor.complex_roots() if one.imag.is_zero()]
        return [(_fraction(one.lower()), _fraction(one.upper())) for one in roots]


def _fraction(x: arb) -> Fraction:
    exact = x.fmpq() if hasattr(x, "fmpq") else fmpq(*_ratio(x))
    return Fraction(int(exact.p), int(exact.q))


def _ratio(x: arb) -> tuple[int, int]:
    mantissa, exponent = (int(part) for part in x.man_exp())
    return (mantissa << exponent, 1) if exponent >= 0 else (mantissa, 1 << -exponent)
