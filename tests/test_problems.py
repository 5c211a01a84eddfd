"""The shipped problems of other people as pairs: closed forms, and an independent solver that knows only the scene."""

import math

import numpy as np
import pytest
from scipy_reference import follow, require

from numerics import load_scene, solve
from numerics.scene.file import described_scenes

PROBLEMS = [name for name, what in described_scenes().items() if what.startswith("Your problem")]


def solved(name):
    return solve(load_scene(name), digits=12)


def times(run):
    return [float(one.t) for one in run.events]


@pytest.mark.parametrize("name", PROBLEMS)
def test_every_event_is_that_of_the_reference(name):
    require(solved(name), follow(load_scene(name)), 1e-8)


def test_there_are_nine():
    known = "ground belt incline moving-wall newmark-block friction-damper conveyor drill-string dither"
    assert sorted(known.split()) == PROBLEMS


def test_a_box_on_the_ground():
    run = solved("ground")
    assert times(run) == pytest.approx([3, 4.75], abs=1e-12)
    assert float(run.final.x1) == pytest.approx(59 / 48, rel=1e-12)
    assert float(run.dissipated) == pytest.approx(59 / 24, rel=1e-12)


def test_a_mass_on_a_belt_sticks_until_the_spring_bears_static_friction():
    omega, v, b, most, a2 = 10, 0.1, 3, 5, 100
    (*_, stuck, slips, again) = times(solved("belt"))
    assert slips - stuck == pytest.approx(2 * (most - b) / (a2 * v), rel=1e-10)
    assert again - slips == pytest.approx(2 / omega * (math.pi - math.atan(omega * (most - b) / a2 / v)), rel=1e-10)


@pytest.mark.long
def test_a_cycle_on_a_belt_goes_on_with_as_many_digits_as_lead_further():
    """Where friction falls errors grow: so long a run needs more digits than a tie is worth."""
    run = solve(load_scene("belt").replace(until=600))
    assert (run.success, run.arithmetic.digits) == (True, 1120)


def test_a_block_on_a_slope_turns_where_its_speed_is_gone():
    run, up, down = solved("incline"), 9.81 * (0.6 + 0.4), 9.81 * (0.6 - 0.4)
    (turn,) = times(run)
    assert turn == pytest.approx(3 / up, rel=1e-12)
    assert float(run.final.x1) == pytest.approx(9 / (2 * up) - down * (1 - turn) ** 2 / 2, abs=1e-12)


def test_newmarks_block_by_its_record():
    """Parabolas of speed between the samples, by the roots of polynomials."""
    t, u = np.loadtxt("numerics/scene/shipped/newmark-block.csv", delimiter=",", skiprows=1).T
    b, x, v = 1.5, 0.0, 0.0
    fine = np.linspace(0, 3, 600_001)
    push = np.interp(fine, t, u)
    for p, h in zip((push[:-1] + push[1:]) / 2, np.diff(fine), strict=True):
        if v == 0 and abs(p) <= b:
            continue
        side = math.copysign(1, v or p)
        after = v + (p - side * b) * h
        if side * after < 0:
            after = 0.0
        x, v = x + (v + after) / 2 * h, after
    assert float(solved("newmark-block").final.x1) == pytest.approx(x, abs=2e-6)
    assert x == pytest.approx(-0.0518582, abs=2e-6)  # as docs/your_problem.md says


def test_a_friction_damper_takes_as_much_of_each_half_swing():
    run = solved("friction-damper")
    omega = math.sqrt(40)
    assert times(run) == pytest.approx([k * math.pi / omega for k in (1, 2, 3)], rel=1e-12)
    assert [float(one.y[0]) for one in run.events] == pytest.approx([-0.035, 0.02, -0.005], rel=1e-10)


def test_the_rock_holds_the_bit_until_the_string_is_wound_up():
    assert times(solved("drill-string"))[0] == pytest.approx((12000 - 50 * 2) / (473 * 2), rel=1e-12)


def test_dither_makes_of_dry_friction_a_viscous_one():
    """The mean of b sgn(V + A sin) is (2 b/pi) asin(V/A), A = 30/2000 m/s; it equals the push of 0.4 N (averaging)."""
    run, period = solved("dither"), 2 * math.pi / 2000
    start, end = (run.floats(run.sol(t))[0] for t in (0.3, 0.3 + 200 * period))
    assert (end - start) / (200 * period) == pytest.approx(30 / 2000 * math.sin(math.pi * 0.4 / 2), rel=0.01)


def test_a_conveyor_moves_its_part():
    run = solved("conveyor")
    assert float(run.final.x1) == pytest.approx(0.0142, abs=1e-4)
