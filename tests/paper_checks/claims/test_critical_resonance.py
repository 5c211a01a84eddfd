"""At the resonance's threshold: the law t^(1/3) against the engine, and what is next to it and does not grow."""

import math
from fractions import Fraction

import pytest

from numerics import Force, Pair, Piece, Scene, Sine, State, solve
from theory import critical_resonance as critical
from theory.forced_response import natural
from theory.symbols import b, m1

M1, M2, B, OMEGA = 2, Fraction(1, 2), Fraction(3, 4), Fraction(3, 2)
PAIR = Pair(M1, M2, M1 * OMEGA**2, B)
HALF = Fraction(1, 2)
PERIODS, START = 300, 100


def growth(*parts):
    """Mean rate of |A|^3 over thousands of natural periods, from START m/s on; parts p cos(r omega t + psi)."""
    edge = Sine(4 * float(B) / math.pi, OMEGA, math.pi / 2)
    sines = [edge, *(Sine(push, order * OMEGA, phase + math.pi / 2) for push, order, phase in parts)]
    until = PERIODS * 24 * math.pi / float(OMEGA)
    run = solve(Scene(PAIR, State(v1=START), until=until, force=Force([Piece(0, (), sines)])), max_events=100_000)
    assert len(run.events) >= 2 * 12 * PERIODS
    cubes = [math.hypot(float(OMEGA) * x, v) ** 3 for x, v, *_ in map(run.sol, (until / 2, until))]
    return (cubes[1] - cubes[0]) / (until / 2)


@pytest.mark.parametrize("order", [HALF, Fraction(1, 3), Fraction(3, 2)])
def test_one_part_at_a_fraction_grows_as_stated(order):
    push = 4
    known = {b: B, m1: M1, natural: OMEGA, critical.push: push, critical.order: order}
    assert growth((push, order, 0.3)) == pytest.approx(float(critical.growth_by_one_part().subs(known)), rel=0.02)


@pytest.mark.parametrize(
    ("parts", "grows"),
    [
        ([(4, 2, 0.3)], False),
        ([(4.5, HALF, 0.3), (2.5, 3 * HALF, -0.3)], False),  # they cancel: not every part at a fraction makes it grow
        ([(4.5, HALF, 0.3), (2.5, 3 * HALF, 0.3)], True),
    ],
)
def test_without_moments_nothing_grows(parts, grows):
    assert (growth(*parts) > 1e-3) == grows
