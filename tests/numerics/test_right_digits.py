"""How many digits are right: one rule for bounds and radii, and the arithmetic that has as many as were asked for."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from hypothesis import given
from scene_files import scenes_in
from strategies import decimals, signed
from three_scenes import DAMPED, PAPER

from numerics import Force, Pair, Scene, State, load_scene, solve, solve_scenes
from numerics.arithmetic.ball import Ball, exact_middle, widened
from numerics.linear.record import AT
from numerics.trajectory.digits import proved_digits
from numerics.trajectory.rendering import with_radius
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory

FORCED = PAPER.replace(b="0.05", a1="0.5", force=Force.sine("0.35", 5))
SCENES = [PAPER, DAMPED, FORCED]


@pytest.mark.parametrize(("speed", "digits"), [("2e-12", 5), ("6.6e-8", 2), ("6.6e-8", 4)])
def test_the_worst_ball_counts_beside_one_that_contains_zero(speed, digits):
    scene = Scene(Pair(1, 1, 1, 1), State(x1=2, v1=speed, v2=speed), until=40)
    found = solve(scene, digits=digits, arithmetic="ball", max_events=6)
    with found.arithmetic.context():
        positions, velocities = (found.y[rows, :].ravel() for rows in ((0, 2), (1, 3)))
        for row in (*found.event_times[:, None], positions, velocities, found.energy[-1:]):
            size = max(abs(one).lower() for one in row)
            assert all(one.rad() < size / 10**digits for one in row)


def doubtful(run, place, k, off):
    """The run if a number of a row of its record were off by so much: time, x1, v1, x2, v2, in balls the excess.

    The last row is the end.
    """
    rows = [*run.record.rows, run.record.end]
    if run.bounded:
        rows[place] = rows[place].copy()
        rows[place][AT["late"] + k] = off
    else:
        name = ("local", "x1", "v1", "x2", "v2", "excess")[k]
        with run.context():
            rows[place] = rows[place]._replace(**{name: widened(getattr(rows[place], name), arb(off))})
    *rows, end = rows
    record = run.record._replace(rows=np.array(rows) if run.bounded else rows, end=end)
    return Trajectory(run.scene, run.arithmetic, record)


@pytest.mark.parametrize("how", [{"arithmetic": "float64"}, {"arithmetic": "ball", "digits": 30}])
@pytest.mark.parametrize("scene", SCENES)
def test_each_number_of_a_trajectory_counts_by_its_radius_or_its_bound(scene, how):
    """Times and states of all events, and the end: any one that is known to a part in 10^9 alone leaves 8 digits."""
    run = solve(scene, **how)
    far, fast = abs(run.floats(run.y)).max(axis=1).reshape(2, 2).max(axis=0)
    ends = [*zip(run.event_rows, run.floats(run.event_times), strict=True), (-1, None)]
    for place, t in ends:
        for k, size in enumerate((t, far, fast, far, fast)):
            assert size is None or doubtful(run, place, k, 1.1e-9 * size).right_digits in {8, 9}, (place, k)


def test_a_position_that_passes_zero_has_the_digits_of_its_neighbours():
    """At a quarter of a period x1 is 1e-17 of its amplitude: relative to itself no digit of it would be right."""
    run = solve(PAPER.replace(x1="0.004", v1=0, until="0.157079632679489661923"))
    assert abs(run.final_state[0]) < 1e-16
    assert run.accuracy.digits >= 12


@pytest.mark.parametrize("scene", [*SCENES, *map(load_scene, ("relative-motion-b05", "velocities"))])
def test_one_digit_more_than_float64_has_is_answered_by_balls(scene):
    has = solve(scene, arithmetic="float64").accuracy.digits
    assert solve(scene, digits=has).arithmetic.name == "float64"
    more = solve(scene, digits=has + 1)
    assert more.arithmetic.name == "ball"
    assert f"float64 has {has} right digits" in more.tried
    assert proved_digits(more) >= has + 1


@pytest.mark.parametrize("scene", [load_scene("friction-damper"), *scenes_in("rest-to-rest").values()])
def test_bodies_that_rest_at_every_event_have_the_digits_of_their_speed_on_the_way(scene):
    """The scale is a speed that is attained: never above the largest one, nor far below it."""
    run, balls = solve(scene), solve(scene, digits=30, arithmetic="ball")
    assert not any(float(one) for one in run.y[1][[0, -1]])
    assert run.right_digits >= 12
    assert balls.right_digits >= 30
    fastest = abs(run.floats(run.sol(np.linspace(0, float(scene.until), 3001)))[1]).max()
    assert not run.bounded or run.right_digits <= -np.log10(run.accuracy.final[1] / fastest)
    assert solve_scenes([scene], keep_events=len(run.events)).digits.tolist() == [min(run.right_digits, 15)]
    assert solve_scenes([scene]).digits[0] >= 12
    assert solve(scene, digits=5).arithmetic.name == run.arithmetic.name


# the ladder


@pytest.mark.parametrize("scene", SCENES)
def test_a_sequence_in_doubt_is_settled_by_the_next_arithmetic_and_nothing_is_called_what_it_is_not(scene):
    """The horizon is 1e-18 s after the third event: float64 cannot tell whether that comes before."""
    third = solve(scene, digits=40, arithmetic="ball").events[2].t.mid().str(30, radius=False)
    run = solve(scene.replace(until=Fraction(str(third)) + Fraction(1, 10**18)))
    assert run.arithmetic.name == "ball"
    assert run.certain
    assert len(run.events) == 3
    assert "float64" in run.tried
    if scene is not PAPER:  # whose float64 leaves it open, and does not refuse
        assert solve(run.scene, digits=8).arithmetic.name == run.arithmetic.name
    assert solve(scene).arithmetic.name == "float64"
    assert solve(scene).tried == ""


@given(signed(decimals(-9, 9, 18)), decimals(-30, 5))
def test_what_is_printed_of_a_ball_holds_it(value, error):
    ball = arb(Ball.number(value), Ball.number(error))
    text, radius = map(Fraction, with_radius("x", ball, 15).values())
    assert abs(exact_middle(ball) - text) + exact_middle(ball.rad()) <= radius


# quantities of which no digit is right

STOPPED = 17.006802727687074
"""x1 at its end, m: of a closed form."""


@pytest.mark.parametrize(("name", "place"), [("on-a-soft-spring", 0), ("on-a-heavy-body", 2)])
def test_a_soft_spring_costs_no_digits_of_positions(name, place):
    found = solve(scene := scenes_in("slides-to-a-stop")[name])
    assert found.success
    assert float(found.final_state[place]) == pytest.approx(STOPPED, rel=1e-9)
    assert solve_scenes([scene]).success.all()


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
def test_an_answer_without_a_right_digit_is_no_success(arithmetic):
    found = doubtful(solve(PAPER, arithmetic=arithmetic), -1, 1, 1e5)
    assert (found.status, found.success) == (Status.NO_RIGHT_DIGIT, False)
    assert found.without_digits[0] == "positions"
    assert "no digit of positions" in found.message
    if arithmetic == "ball":
        assert doubtful(solve(PAPER, arithmetic=arithmetic), -1, 5, 1e5).without_digits == ("energy excess",)


def test_a_quantity_of_which_float64_has_no_digit_is_found_by_balls(monkeypatch):
    monkeypatch.setattr(Trajectory, "without_digits", property(lambda run: ("positions",) * run.bounded))
    assert solve(PAPER).tried == "float64 has no right digit of the positions"


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
@pytest.mark.parametrize("u", ["0", "0.2", "0.9"])
def test_velocities_that_are_0_all_along_are_no_lost_digits(u, arithmetic):
    """At rest in balance with the force, or with nothing, which is known exactly."""
    run = solve(PAPER.replace(x1=Fraction(u) / 200, v1=0, force=Force.constant(u)), arithmetic=arithmetic)
    assert run.success
    assert run.right_digits > (14 if u == "0" else 0)


def test_a_run_that_ends_where_it_began_is_a_success_without_kept_events_too():
    """Of a motion from rest to rest and back the ends say no more than that it may have rested all along."""
    for a2 in (0, "1e-9"):
        scene = scenes_in("far-out")["there-and-back-on-a-soft-spring"].replace(a2=a2)
        run = solve(scene, arithmetic="float64")
        assert run.right_digits >= 10
        short = solve_scenes([scene])
        assert short.success.all()
        assert 0 < short.digits[0] <= run.right_digits


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
def test_times_that_are_asked_for_change_no_digits(arithmetic):
    scene = load_scene("velocities")
    own = solve(scene, arithmetic=arithmetic)
    for times in ([], [0], ["0.001", 5]):
        asked = solve(scene, arithmetic=arithmetic, t_eval=times)
        assert asked.right_digits == own.right_digits
        assert asked.without_digits == own.without_digits
