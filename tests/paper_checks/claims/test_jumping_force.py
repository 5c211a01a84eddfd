"""A force that jumps at the exit: the family of periodic motions against the engine, at its ends and beyond them."""

from fractions import Fraction

import pytest
import sympy as sp

from numerics import Force, Mode, Pair, Piece, Scene, State
from numerics.solver.solve import solve
from theory import jumping_force as jump

DECIMALS = 40
"""Decimals to which force, times and places are rounded: a slip ends within them of where the force drops."""
IN_TURN = (Mode.SLIP_PLUS, Mode.STICK, Mode.SLIP_MINUS, Mode.STICK)


def decimal(value):
    return Fraction(str(sp.N(value, DECIMALS + 5))).limit_denominator(10**DECIMALS)


def member(speed, periods=1):
    """The member with this speed (m/s) at the exit, solved over some periods."""
    half, pieces = jump.SLIP_TIME + jump.stick_time(), []
    for number in range(2 * periods):
        begin = number * half
        pieces += [
            Piece(decimal(begin), ((-1) ** number * decimal(jump.PUSH),)),
            Piece(decimal(begin + jump.SLIP_TIME), (0,)),
        ]
    place = decimal(jump.exit_state()[0].subs(jump.speed, sp.Rational(speed)))
    scene = Scene(Pair(1, 1, 1, 1), State(place, speed, 0, speed), decimal(2 * periods * half), force=Force(pieces))
    return solve(scene, digits=60, arithmetic="ball")


def test_two_members_come_back_and_keep_their_distance():
    """N between two states of unit masses on a spring of 1 N/m."""
    one, two = (member(Fraction(speed), 3) for speed in ("-0.55", "-0.37"))
    assert one.modes == two.modes
    assert one.modes[:12] == 3 * IN_TURN
    for time in (0, Fraction(9, 2), 10, one.scene.until):
        here, there = one.sol(time), two.sol(time)
        assert float(sum((here[n] - there[n]) ** 2 for n in (0, 1, 3))) ** 0.5 == pytest.approx(
            0.18 * 3**0.5, rel=1e-15
        )
    assert max(abs(here[n] - one.sol(0)[n]) for n in (0, 1, 3)) < 1e-30


def test_the_family_ends_where_it_is_said_to():
    slowest, fastest = (Fraction(str(one.evalf(30))) for one in jump.slowest_and_fastest())
    hair = Fraction(1, 10**6)
    inside, beyond = (member(fastest + side * hair) for side in (-1, 1))
    for run in (member(slowest + hair), inside):
        assert run.modes[:4] == IN_TURN
    assert member(slowest - hair).modes[0] is Mode.STICK  # the jump leaves the load inside
    assert [run.events[1].cause for run in (inside, beyond)] == ["jump", "guard"]  # the latter slips before the jump
