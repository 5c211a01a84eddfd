"""How a pair converges to its periodic motion: a contraction of the period map, proved over a neighbourhood.

From a time at which a trajectory is in a leg of the orbit and within eps of it in the norm N, both are followed as one
box of states that have the same events (`one_round`). The derivative of the period map over the box bounds how much a
period shrinks distances; N never grows in between. If k periods shrink it by theta < 1, then

    int |w - w*| dt <= kappa k T eps/(1 - theta)    from then on, as |w - w*| <= kappa N.
"""

from __future__ import annotations

from flint import arb, arb_mat

from numerics.arithmetic.ball import exact_middle, undecided, working_digits
from numerics.control.answers import number, rounded
from numerics.control.orbit import Orbit, one_round, state_at, without_x2

_DOUBLINGS = 10
"""The period map is taken up to 2^n times in a row until it shrinks all distances."""


def slide_left(orbit: Orbit, t: arb, reach: arb) -> arb:
    """Return a bound of int |w - w*| dt from a time on, for all motions in the mode of the orbit within `reach` of it.

    Raises EventUndecided.
    """
    norm, slopes = orbit.drive.norm, _period_slopes(orbit, t.mid(), reach)
    for doubling in range(_DOUBLINGS):
        x1, v1, v2 = (norm.most((x, v, arb(0), w)) for x, v, w in slopes.tolist())
        shrunk = norm.of((x1, v1, arb(0), v2))
        if shrunk < arb("0.9"):
            return (norm.kappa * 2**doubling * orbit.drive.period * reach / (1 - shrunk)).upper()
        slopes = slopes * slopes
    raise undecided("does the period map shrink distances?", shrunk)


def _period_slopes(orbit: Orbit, t: arb, reach: arb) -> arb_mat:
    """Return the derivative of (x1, v1, v2) a period after t by that at t, over the box within `reach` of the orbit."""
    at, norm = without_x2(state_at(orbit.passage_at(t), t)), orbit.drive.norm
    start = [rounded(one, working_digits()) for one in at]
    off = max(abs(one - number(near)).upper() for one, near in zip(at, start, strict=True))
    radius = (off + reach / min(norm.root_a2, norm.root_m1, norm.root_m2)).upper()
    return one_round(orbit.drive, exact_middle(t), start, len(orbit.legs), radius).slopes
