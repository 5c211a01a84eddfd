"""Power series over the rationals, and the values of polynomials in balls."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import flint
from flint import arb_poly, fmpq, fmpq_series


def angle_and_depth() -> tuple[fmpq_series, fmpq_series]:
    """Return theta(u) = h^-1(u) and c(u) as series in u: c' = h, so dc = u dtheta."""
    theta = fmpq_series([0, 1])
    height = shifted(theta - theta.sin(), -2) / shifted(1 - theta.cos(), -2)
    angle = height.reversion()
    return angle, (theta * angle.derivative()).integral()


def scaled(series: fmpq_series, q: fmpq, shift: int) -> fmpq_series:
    """Return sum s_k q^((shift - k)/2) eps^k of a series whose powers all have the parity of `shift`."""
    terms = [series[k] * (q ** ((shift - k) // 2) if series[k] else 0) for k in range(series.length())]
    return fmpq_series(terms)


def shifted_even(series: fmpq_series, q: fmpq) -> fmpq_series:
    """Return an even series in epsilon as one in y = epsilon^2/q."""
    return fmpq_series([series[2 * k] * q**k for k in range((series.length() + 1) // 2)])


def shifted(series: fmpq_series, by: int) -> fmpq_series:
    """Return the series divided by its variable to the power -by (its first coefficients being 0)."""
    return fmpq_series([series[k] for k in range(-by, series.length())])


def polynomial(coefficients: list[fmpq]) -> arb_poly:
    """Return c_1 x + c_2 x^2 + ..., a function of balls, with coefficients at the precision that is set."""
    return arb_poly([0, *coefficients])


@contextmanager
def series_terms(terms: int) -> Iterator[None]:
    """Set flint's process-wide series length, and restore it."""
    before, flint.ctx.cap = flint.ctx.cap, terms
    try:
        yield
    finally:
        flint.ctx.cap = before
