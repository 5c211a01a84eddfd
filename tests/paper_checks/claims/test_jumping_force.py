"""A force that jumps at the exit: the family of periodic motions against the engine, at its ends and beyond them."""

from fractions import Fraction

import sympy as sp

from numerics import Force, Mode, Pair, Piece, Scene, State
from numerics.solver.solve import solve
from theory import jumping_force as jump

DECIMALS = 40
"""Decimals to which force, times and places are rounded: a slip ends within them of where the force drops."""
IN_TURN = (Mode.SLIP_PLUS, Mode.STICK, Mode.SLIP_MINUS, Mode.STICK)


def decimal(value):
    return Fraction(str(sp.N(value, DECIMALS + 5))).limit_denominator(10**DECIMALS)


def member(speed):
    """The member with this speed (m/s) at the exit, solved over a period."""
    half, pieces = jump.SLIP_TIME + jump.stick_time(), []
    for number in range(2):
        begin = number * half
        pieces += [
            Piece(decimal(begin), ((-1) ** number * decimal(jump.PUSH),)),
            Piece(decimal(begin + jump.SLIP_TIME), (0,)),
        ]
    place = decimal(jump.exit_state()[0].subs(jump.speed, sp.Rational(speed)))
    scene = Scene(Pair(1, 1, 1, 1), State(place, speed, 0, speed), decimal(2 * half), force=Force(pieces))
    return solve(scene, digits=60, arithmetic="ball")


def test_the_family_ends_where_it_is_said_to():
    slowest, fastest = (Fraction(str(one.evalf(30))) for one in jump.slowest_and_fastest())
    hair = Fraction(1, 10**6)
    inside, beyond = (member(fastest + side * hair) for side in (-1, 1))
    for run in (member(slowest + hair), inside):
        assert run.modes[:4] == IN_TURN
    assert member(slowest - hair).modes[0] is Mode.STICK  # the jump leaves the load inside
    assert [run.events[1].cause for run in (inside, beyond)] == ["jump", "guard"]  # the latter slips before the jump
