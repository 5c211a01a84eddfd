"""Numbers as balls: flint's process-wide settings, set and restored; a rational as a ball, a ball as text."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction

import flint
from flint import arb, fmpq

DIGITS = 50
"""Digits that a constant is enclosed to."""


@contextmanager
def precision(digits: int = DIGITS) -> Iterator[None]:
    """Set flint's process-wide precision, with guard digits, and restore it."""
    before, flint.ctx.prec = flint.ctx.prec, math.ceil((2 * digits + 20) * math.log2(10))
    try:
        yield
    finally:
        flint.ctx.prec = before


@contextmanager
def terms(number: int) -> Iterator[None]:
    """Set flint's process-wide length of series, and restore it."""
    before, flint.ctx.cap = flint.ctx.cap, number
    try:
        yield
    finally:
        flint.ctx.cap = before


def point(value: Fraction | int) -> arb:
    """Return a ball around a rational number."""
    return arb(fmpq(value.numerator, value.denominator))


def shown(value: arb, digits: int = DIGITS) -> str:
    """Return a ball with all of its proved digits, at most `digits`, and its radius."""
    return str(value.str(digits))
