"""Motions as exponentials of ball matrices: what is called proved of a mode is so."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.linear.system import LinearMode, W, is_positive_on
from numerics.scene import Pair, Piece, Sine


def test_a_slip_that_turns_back_in_between_is_not_called_a_slip():
    """w falls below 0 and comes back: its ends alone do not say so."""
    with Ball(20).context():
        mode = LinearMode(Pair(1, 1, 1, "0.01"), Fraction(1, 100), 1, Piece(0, (), [Sine(1, 20)]))
        motion = mode.motion([arb(0), arb("0.05"), arb(0), arb(0)], arb(0))
        period = 2 * arb.pi() / 20
        assert is_positive_on(lambda t: motion.range(W, t), arb(0), period)
        backwards = mode.motion([arb(0), arb("0.02"), arb(0), arb("0.06")], arb(0))
        assert not is_positive_on(lambda t: backwards.range(W, t), arb(0), period)
