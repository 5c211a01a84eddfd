"""Where polynomials with rational coefficients first change sign: exact, touches passed over."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import fmpz_poly

from numerics.arithmetic.ball import exact_middle
from numerics.arithmetic.precision import precision

_BITS = 256

Polynomials = Sequence[Sequence[Fraction]]


class _Root(NamedTuple):
    """A real root lies between low and high, far closer than roots are to each other; both are it if it is rational."""

    low: Fraction
    high: Fraction
    multiplicity: int


def first_crossing(polynomials: Polynomials, after: Fraction, until: Fraction) -> tuple[Fraction, bool]:
    """Return (t, whether t is a root) for the first root of odd multiplicity in (after, until] of any of them.

    A rational root is returned itself; of another one a time before it, past all touches that come before. Without any,
    (until, False).
    """
    before = after
    for root in _roots(polynomials):
        if root.low > until:
            break
        if root.low <= after:
            continue
        if root.multiplicity % 2 == 0:
            before = max(before, root.high)
        elif root.low == root.high:
            return root.low, True
        else:
            return (before + root.low) / 2, False
    return until, False


def touches(polynomials: Polynomials, after: Fraction, until: Fraction) -> bool:
    """Return whether one of them has a root of even multiplicity in (after, until]."""
    return any(one.multiplicity % 2 == 0 and after < one.low and one.high <= until for one in _roots(polynomials))


def _roots(polynomials: Polynomials) -> list[_Root]:
    """Return the real roots of all in order."""
    found: list[_Root] = []
    for polynomial in polynomials:
        below = math.lcm(*(c.denominator for c in polynomial))
        whole = fmpz_poly([int(c * below) for c in polynomial])
        if whole.degree() < 1:
            continue
        for factor, multiplicity in whole.factor()[1]:
            if factor.degree() == 1:
                root = Fraction(-int(factor[0]), int(factor[1]))
                found.append(_Root(root, root, multiplicity))
                continue
            with precision(_BITS):
                roots = [one.real for one, _ in factor.complex_roots() if one.imag.is_zero()]
                found += [_Root(exact_middle(one.lower()), exact_middle(one.upper()), multiplicity) for one in roots]
    return sorted(found)
