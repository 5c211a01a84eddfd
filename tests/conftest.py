"""Hypothesis profiles, and the process-wide precisions that every test must leave as it found them."""

import os
from collections.abc import Iterator

import flint
import mpmath
import pytest
from hypothesis import HealthCheck, settings

_SLOW_IS_FINE = [HealthCheck.too_slow]
settings.register_profile("dev", deadline=None, max_examples=15, suppress_health_check=_SLOW_IS_FINE)
settings.register_profile(
    "ci", deadline=None, max_examples=1000, derandomize=True, database=None, suppress_health_check=_SLOW_IS_FINE
)
settings.register_profile("nightly", deadline=None, max_examples=5000, suppress_health_check=_SLOW_IS_FINE)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))

FLINT_BITS, MPMATH_BITS = 53, 53


@pytest.fixture(autouse=True)
def precision_is_left_alone() -> Iterator[None]:
    """flint.ctx.prec and mpmath.mp.prec are global: a test starts at 53 bits and has to end there."""
    flint.ctx.prec, mpmath.mp.prec = FLINT_BITS, MPMATH_BITS
    yield
    left = flint.ctx.prec, mpmath.mp.prec
    flint.ctx.prec, mpmath.mp.prec = FLINT_BITS, MPMATH_BITS
    assert left == (FLINT_BITS, MPMATH_BITS), f"precision left at {left} bits (flint, mpmath)"
