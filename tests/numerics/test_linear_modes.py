"""Motions as exponentials of ball matrices: what is called proved of a mode is so."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.control.orbit import require_mode
from numerics.errors import EventUndecided
from numerics.linear.system import LinearMode, W, is_positive_on
from numerics.scene import Pair, Piece, Sine


def stuck(*sines: Sine, speed: str = "0") -> tuple[LinearMode, arb]:
    """A stuck pair at rest at 0, or moving, under sines, and a quarter turn of the first one."""
    mode = LinearMode(Pair(1, 1, 1, 1), Fraction(1), 0, Piece(0, (), sines))
    v = Ball.number(Fraction(speed))
    return mode.motion([arb(0), v, arb(0), v], arb(0)), arb.pi() / Ball.number(sines[0].omega)


@pytest.mark.parametrize("side", [1, -1])
def test_a_load_that_passes_the_other_edge_is_not_called_stuck(side):
    """Lambda is about 1.5 b sin(20 t + phase): past one edge in the middle, at the other one at the end."""
    with Ball(20).context():
        motion, half = stuck(Sine(side * 3, 20))
        # past b in the first half turn; at its end the load is near 0, in the next one it gets to -b
        for t in (half, half + half / 5):
            for exit_side in (1, -1):
                with pytest.raises(EventUndecided):
                    require_mode(motion, t, 0, exit_side)
        small, half = stuck(Sine(Fraction(side), 20))
        require_mode(small, half, 0, 0)


def test_a_slip_that_turns_back_in_between_is_not_called_a_slip():
    """w falls below 0 and comes back: its ends alone do not say so."""
    with Ball(20).context():
        mode = LinearMode(Pair(1, 1, 1, "0.01"), Fraction(1, 100), 1, Piece(0, (), [Sine(1, 20)]))
        motion = mode.motion([arb(0), arb("0.05"), arb(0), arb(0)], arb(0))
        period = 2 * arb.pi() / 20
        assert is_positive_on(lambda t: motion.range(W, t), arb(0), period)
        backwards = mode.motion([arb(0), arb("0.02"), arb(0), arb("0.06")], arb(0))
        assert not is_positive_on(lambda t: backwards.range(W, t), arb(0), period)
        with pytest.raises(EventUndecided):
            require_mode(backwards, period, 1, 0)
