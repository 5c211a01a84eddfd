"""What is stated beyond the paper against the engine, at the ends of what is stated, and past them."""

import math
from fractions import Fraction

import pytest
from control_scenes import under
from sympy import N, Rational

from numerics import (
    Force,
    Friction,
    InvalidScene,
    Pair,
    Piece,
    Scene,
    Sine,
    State,
    Weakening,
    fastest_transfer,
    load_reference,
    load_scene,
    response,
    solve,
    thresholds,
    track,
)
from numerics.control.tracking import stuck_force
from theory import critical_resonance as critical
from theory import finite_slope
from theory import jumping_force as jump
from theory.forced_response import natural
from theory.symbols import b, epsilon, m1, q

HALF = Fraction(1, 2)

# at the resonance's threshold: the law t^(1/3), and what is next to it and does not grow

M1, M2, B, OMEGA = 2, Fraction(1, 2), Fraction(3, 4), Fraction(3, 2)
PAIR = Pair(M1, M2, M1 * OMEGA**2, B)
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
    known = {b: B, m1: M1, natural: OMEGA, critical.push: 4, critical.order: order}
    assert growth((4, order, 0.3)) == pytest.approx(float(critical.growth_by_one_part().subs(known)), rel=0.02)


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


# a force that jumps at the exit: the family of periodic motions

DECIMALS = 40
"""Decimals to which force, times and places are rounded: a slip ends within them of where the force drops."""


def decimal(value):
    return Fraction(str(N(value, DECIMALS + 5))).limit_denominator(10**DECIMALS)


def member(speed):
    """The member with this speed (m/s) at the exit, solved over a period."""
    half, pieces = jump.SLIP_TIME + jump.stick_time(), []
    for number in range(2):
        begin = number * half
        pieces += [
            Piece(decimal(begin), ((-1) ** number * decimal(jump.PUSH),)),
            Piece(decimal(begin + jump.SLIP_TIME), (0,)),
        ]
    place = decimal(jump.exit_state()[0].subs(jump.speed, Rational(speed)))
    scene = Scene(Pair(1, 1, 1, 1), State(place, speed, 0, speed), decimal(2 * half), force=Force(pieces))
    return solve(scene, digits=60, arithmetic="ball")


def test_the_family_ends_where_it_is_said_to():
    slowest, fastest = (Fraction(str(one.evalf(30))) for one in jump.slowest_and_fastest())
    hair = Fraction(1, 10**6)
    inside, beyond = (member(fastest + side * hair) for side in (-1, 1))
    for run in (member(slowest + hair), inside):
        assert run.signs[:4] == [1, 0, -1, 0]
    assert member(slowest - hair).signs[0] == 0  # the jump leaves the load inside
    assert [run.events[1].cause for run in (inside, beyond)] == ["jump", "guard"]  # the latter slips before the jump


# a finite slope of friction


@pytest.mark.parametrize(
    ("share", "fall"), [(HALF, 0), (HALF, 5), (HALF, -5), (Fraction(1, 5), 1), (Fraction(4, 5), 5)]
)
def test_an_excursion_gains_what_the_slope_adds(share, fall):
    """What 1/w gains in an excursion with w = 1e-8, in balls: another coefficient of the slope would be off by more."""
    speed = Fraction(1, 10**4)
    friction = Friction((), Weakening(last_slope=-fall * (1 - share)))
    scene = Scene(Pair(share, 1 - share, 1, 1 - share), State(1, speed, 0, speed), "0.01", friction=friction)
    run = solve(scene, digits=45, arithmetic="ball")
    with run.arithmetic.context():
        end = run.sol(scene.until)
        gained = float(1 / (end[0] ** 2 + end[1] ** 2 - 1) - 10**8) * float(4 * share / (9 * (1 - share)))
    terms = finite_slope.gain().subs({finite_slope.slope: fall, q: Rational(share), epsilon: Rational(speed)})
    assert gained == pytest.approx(float(terms), abs=1e-5)


# next to both thresholds of a sine

TWO_STOPS, NO_STOP = [-1, 0, 0, 1], [-1, 1]
NEAR = Fraction(1, 10**5)


def ends(pair, omega):
    """Both thresholds, N, as rational numbers."""
    found = thresholds(pair, omega, digits=12)
    return [Fraction(one.mid().str(12, radius=False)) for one in (found.entrainment, found.non_stop)]


def modes(pair, amplitude, omega):
    """The modes of the periodic motion in a period, sorted; none where the pair sticks permanently."""
    orbit = response(under(pair, amplitude, omega), digits=6).orbit
    return sorted(leg.side for leg in orbit.legs) if orbit else []


@pytest.mark.parametrize("damping", ["0", "0.5", "20", "80"])
@pytest.mark.parametrize("omega", ["7", "12"])
def test_two_stops_begin_and_end_at_the_thresholds(damping, omega):
    pair = Pair(1, 1, 200, "0.5", damping)
    first, last = ends(pair, omega)
    found = [modes(pair, end * (1 + side * NEAR), omega) for end in (first, last) for side in (-1, 1)]
    assert found == [[], TWO_STOPS, TWO_STOPS, NO_STOP]


def test_below_the_second_threshold_two_stops_need_the_condition_there():
    """Here the relative velocity changes its sign at U**: there are more turns below and above."""
    pair, omega = Pair("0.172", "0.653", "22.7", "0.28", "0.0988"), "1.82"
    last = ends(pair, omega)[1]
    assert modes(pair, last * (1 - NEAR), omega) != TWO_STOPS
    assert modes(pair, last * (1 + NEAR), omega) != NO_STOP


# friction read literally


def test_read_literally_friction_gives_what_a_reference_asks():
    """sgn(0) = 0 with a stick that is never left: body 2 follows too-fast."""
    rest, reference = load_scene("at-rest").replace(law="three-valued-sgn", until=2), load_reference("too-fast")
    force = stuck_force(rest.pair, Force(reference))
    assert solve(rest.replace(force=force)).sol(2) == pytest.approx([0.1, 0, 0.1, 0], abs=1e-9)
    for asked in (lambda: track(rest, reference), lambda: fastest_transfer(rest, "0.01")):
        with pytest.raises(InvalidScene, match="law"):
            asked()
