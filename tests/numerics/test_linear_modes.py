"""Motions as exponentials of ball matrices: ranges hold every point, and what is called proved of a mode is so."""

from __future__ import annotations

from fractions import Fraction

from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from strategies import decimals, forces, pairs, signed

from numerics.arithmetic.ball import Ball
from numerics.control.tracking import Derivative
from numerics.linear.system import LinearMode, W, is_positive_on
from numerics.scene import Pair, Piece, Sine


@given(pairs((-1, 1), damped=None), forces(1), st.sampled_from([-1, 0, 1]), st.data())
def test_the_range_over_a_ball_of_times_holds_the_values_at_its_points(pair, force, side, data):
    """Of the row and of its derivatives; the balls are as wide as a turn of the pair."""
    state = [float(data.draw(signed(decimals(-1, 1)))) for _ in range(4)]
    piece = force.pieces[0] if force.pieces else Piece(0)
    middle, radius = (float(data.draw(decimals(-2, 0))) for _ in range(2))
    with Ball(20).context():
        motion = LinearMode(pair, pair.b, side, piece).motion([arb(one) for one in state], Ball.number(piece.start))
        wide = arb(middle, radius)
        for row in (W, motion.mode.load):
            for order in range(3):
                found = motion.range(row, wide, order)
                for part in (-0.99, -0.5, 0.1, 0.99):
                    point = motion.range(row, arb(middle) + part * arb(radius), order)
                    assert found.overlaps(point), (order, part)


def test_a_slip_that_turns_back_in_between_is_not_called_a_slip():
    """w falls below 0 and comes back: its ends alone do not say so."""
    with Ball(20).context():
        mode = LinearMode(Pair(1, 1, 1, "0.01"), Fraction(1, 100), 1, Piece(0, (), [Sine(1, 20)]))
        motion = mode.motion([arb(0), arb("0.05"), arb(0), arb(0)], arb(0))
        period = 2 * arb.pi() / 20
        assert is_positive_on(lambda t: motion.range(W, t), arb(0), period)
        backwards = mode.motion([arb(0), arb("0.02"), arb(0), arb("0.06")], arb(0))
        assert not is_positive_on(lambda t: backwards.range(W, t), arb(0), period)


@st.composite
def strong_pieces(draw) -> Piece:
    """Polynomials up to the fifth degree and two sines, slow and fast, that outweigh the motion of a pair at rest."""
    powers = draw(st.lists(signed(decimals(-1, 2)), max_size=6))
    waves = st.builds(Sine, signed(decimals(0, 2)), decimals(-1, 2), signed(decimals(-1, 0)))
    return Piece(0, powers, draw(st.lists(waves, max_size=2)))


@given(pairs((-1, 1), damped=None), strong_pieces(), st.sampled_from([-1, 0, 1]), decimals(-2, 0), st.integers(2, 4))
def test_the_bound_by_energy_holds_every_derivative_at_every_point(pair, piece, side, length, order):
    with Ball(20).context():
        motion = LinearMode(pair, pair.b, side, piece).motion([arb(0)] * 4, arb(0))
        wide = Ball.number(length / 2) + arb(0, 1) * Ball.number(length / 2)
        over = motion.over(wide)
        bound = over._bounded(over.derivative(order))
        for k in range(1, 10):
            there = motion.over(Ball.number(length * k / 10)).derivative(order)
            for place in range(there.nrows()):
                assert bound[place, 0].overlaps(there[place, 0]), (place, bound[place, 0], there[place, 0])


@given(pairs((-1, 1), damped=None), strong_pieces(), decimals(-1, 0), decimals(-1, 0))
def test_the_force_of_a_motion_is_that_of_its_piece(pair, piece, begin, later):
    """u and u' as functions of z, at the start and after a flow, against the piece itself."""
    with Ball(20).context():
        motion = LinearMode(pair, pair.b, 1, piece).motion([arb(0)] * 4, Ball.number(begin))
        for order in (0, 1):
            exact = Derivative(piece, order)
            for t in (Fraction(0), later):
                found = motion.range(motion.mode.force, Ball.number(t), order)
                assert found.overlaps(exact(Ball.number(begin + t)))
