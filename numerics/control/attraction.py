"""How a pair converges to its periodic motion: a contraction of the period map, proved over a neighbourhood.

From a time at which a trajectory is in a leg of the orbit and within eps of it in the norm N, both are followed as one
box of states that have the same events (`one_round`). The derivative of the period map over the box bounds how much a
period shrinks distances; N never grows in between. If k periods shrink it by theta < 1, then

    int |w - w*| dt <= sqrt(kappa) k T eps/(1 - theta)    from then on, as |w - w*| <= sqrt(kappa) N.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_mat

from numerics.arithmetic.ball import exact_middle, undecided, working_digits
from numerics.control.answers import number, rounded
from numerics.control.orbit import Orbit, one_round, without_x2
from numerics.scene import Pair

_DOUBLINGS = 10
"""The period map is taken up to 2^n times in a row until it shrinks all distances."""


def slide_left(orbit: Orbit, t: arb, reach: arb) -> arb:
    """Return a bound of int |w - w*| dt from a time on, for all motions in the mode of the orbit within `reach` of it.

    Raises EventUndecided.
    """
    pair, slopes = orbit.drive.pair, _period_slopes(orbit, t.mid(), reach)
    for doubling in range(_DOUBLINGS):
        shrunk = _norm(pair, slopes)
        if shrunk < arb("0.9"):
            return (speed_bound(pair) * 2**doubling * orbit.drive.period * reach / (1 - shrunk)).upper()
        slopes = slopes * slopes
    raise undecided("does the period map shrink distances?", shrunk)


def speed_bound(pair: Pair) -> arb:
    """Return the largest |w| where N = 1, sqrt(kappa)."""
    return number(pair.mass / (pair.m1 * pair.m2)).sqrt()


def energy_norm(pair: Pair, state: Sequence[arb]) -> arb:
    """Return an upper bound of N, N^2 = a2 x1^2 + m1 v1^2 + m2 v2^2, of (x1, v1, x2, v2)."""
    parts = (weight * one * one for weight, one in zip(_weights(pair), without_x2(state), strict=True))
    return sum(parts, arb(0)).abs_upper().sqrt().upper()


def _weights(pair: Pair) -> list[arb]:
    return [number(one) for one in (pair.a2, pair.m1, pair.m2)]


def _norm(pair: Pair, slopes: arb_mat) -> arb:
    """Return an upper bound of the norm of a linear map of (x1, v1, v2) that belongs to N (Frobenius)."""
    weights = _weights(pair)
    parts = (weights[row] * slopes[row, k] ** 2 / weights[k] for row in range(3) for k in range(3))
    return sum(parts, arb(0)).abs_upper().sqrt()


def _period_slopes(orbit: Orbit, t: arb, reach: arb) -> arb_mat:
    """Return the derivative of (x1, v1, v2) a period after t by that at t, over the box within `reach` of the orbit."""
    at = without_x2(orbit.passage_at(t).at(t))
    start = [rounded(one, working_digits()) for one in at]
    off = max(abs(one - number(near)).upper() for one, near in zip(at, start, strict=True))
    radius = (off + reach / min(_weights(orbit.drive.pair)).sqrt()).upper()
    return one_round(orbit.drive, exact_middle(t), start, len(orbit.legs), radius).slopes
