"""The two functions of a slip excursion's angle on which the steps about merging rest, in balls (dimensionless)."""

from __future__ import annotations

from flint import arb


def rise(theta: arb) -> arb:
    """Return h(theta) = (theta - sin theta)/(1 - cos theta)."""
    return (theta - theta.sin()) / (2 * (theta / 2).sin() ** 2)


def depth(theta: arb) -> arb:
    """Return c(theta) = 2 - theta cot(theta/2)."""
    return 2 - theta * (theta / 2).cot()
