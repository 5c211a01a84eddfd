"""A force that jumps at the exit: the family of periodic motions against the engine, at its ends and beyond them."""

from fractions import Fraction

import pytest

from numerics import Mode, solve
from paper_checks.claims import claim_named, jumping_force
from paper_checks.decide.enclosure import solved
from theory import jumping_force as jump

IN_TURN = (Mode.SLIP_PLUS, Mode.STICK, Mode.SLIP_MINUS, Mode.STICK)


def distance(one, two):
    """Return N between two states (x1, v1, x2, v2) of unit masses on a spring of 1 N/m."""
    return float(sum((one[place] - two[place]) ** 2 for place in (0, 1, 3))) ** 0.5


def test_two_members_come_back_and_keep_their_distance():
    one, two = (solved(jumping_force.member(Fraction(speed), 3)) for speed in ("-0.55", "-0.37"))
    apart = [distance(one.sol(time), two.sol(time)) for time in (0, Fraction(9, 2), 10, Fraction(51, 2))]
    assert one.modes == two.modes
    assert one.modes[:12] == 3 * IN_TURN
    assert apart == pytest.approx([0.18 * 3**0.5] * 4, rel=1e-15)
    assert max(abs(one.sol(one.scene.until)[place] - one.sol(0)[place]) for place in (0, 1, 3)) < 1e-30


def test_what_starts_beside_one_of_them_does_not_come_nearer():
    member = jumping_force.member(Fraction(-46, 100), 10)
    other = jumping_force.member(Fraction(-47, 100), 10)
    ends = [solve(scene).sol(float(scene.until)) for scene in (member, other)]
    assert distance(*ends) == pytest.approx(0.01 * 3**0.5, rel=1e-9)


def test_the_family_ends_where_it_is_said_to():
    slowest, fastest = (Fraction(str(one.evalf(30))) for one in jump.slowest_and_fastest())
    hair = Fraction(1, 10**6)
    for speed in (slowest + hair, fastest - hair):
        assert solved(jumping_force.member(speed)).modes[:4] == IN_TURN
    assert solved(jumping_force.member(slowest - hair)).modes[0] is Mode.STICK  # the jump leaves the load inside
    inside, beyond = (solved(jumping_force.member(fastest + side * hair)) for side in (-1, 1))
    assert [run.events[1].cause for run in (inside, beyond)] == ["jump", "guard"]  # the latter slips before the jump


def test_the_force_is_not_continuous_where_they_leave():
    before, after, _ = jump.loads()
    assert (after - before).is_positive
    stated = next(one for one in claim_named("forced-periodic-response").clauses if one.id == "undamped").text
    assert "at which $u$ is continuous" in stated
