"""Under a force, binary64 whose own bounds leave too little is made up for by balls that are rounded to it."""

import pickle
from fractions import Fraction

import pytest
from forced.catalogue import scene as scene_of

from numerics import Force, Pair, Piece, Scene, State, solve
from numerics.errors import EventUndecided, OutOfRange
from numerics.run.forced import run_forced_scene
from numerics.run.forced_sharp import Seamed, run_forced_sharply
from numerics.trajectory.forced_rounded import rounded_to_float64


@pytest.mark.parametrize("name", ["sine-barely-above-threshold", "jump-just-before-contact", "mass-ratio-1e-6"])
def test_what_rounding_hides_is_told_by_balls(name):
    """@example of found faults: refusals, and no digits left, in scenes without any tie."""
    scene = scene_of(name)
    found, balls = solve(scene), solve(scene, digits=20, arithmetic="ball")
    assert found.arithmetic.name == "float64"
    assert "balls with" in found.tried
    assert found.accuracy.digits >= 14
    assert found.modes == balls.modes
    for one, two, bounds in zip(found.event_states.T, balls.event_states.T, found.accuracy.y, strict=True):
        assert all(abs(a - b.mid()) <= bound for a, b, bound in zip(one, two, bounds, strict=True))
    assert pickle.loads(pickle.dumps(found)) == found
    assert found.sol(found.scene.until / 3)[0] == pytest.approx(float(balls.sol(found.scene.until / 3)[0]), rel=1e-9)


def test_what_binary64_does_well_is_its_own():
    scene = scene_of("triangular-wave")
    assert solve(scene).tried == ""
    assert solve(scene) == run_forced_sharply(scene, 10)


def test_a_touch_that_no_digits_decide_is_refused():
    with pytest.raises(EventUndecided):
        solve(scene_of("touches-at-irrational-times"))


def test_bounds_count_what_rounding_adds():
    """A bound of the balls alone, without the rounding of the numbers to binary64, is found out."""
    scene = scene_of("sine-stick-slip")
    balls = run_forced_scene(scene, Seamed(40), 100)
    found = rounded_to_float64(balls)
    assert found.record.rows[:, 13:].max() < 1e-15
    with balls.arithmetic.context():
        missed = [abs(a - b.mid()) > 1e-25 for a, b in zip(found.final_state, balls.final_state, strict=True)]
    assert all(missed)


def test_what_is_beyond_the_range_is_refused_in_one_line():
    scene = scene_of("mass-ratio-1e-6")
    balls = run_forced_scene(scene, Seamed(40), 2)
    for row in balls.record.rows:
        row[6] = row[6] * 10**400
    with pytest.raises(OutOfRange, match="range of float64"):
        rounded_to_float64(balls)


@pytest.mark.parametrize("way", ["float64", "ball"])
def test_a_force_too_fast_to_be_followed_is_refused_at_once(way):
    """@example of a found fault: a sine of 10^9 rad/s on a load next to the edge was followed without an end."""
    scene = Scene(Pair(1, 1, 200, "0.05"), State(v1="4.5e-3", v2="4.5e-3"), 10, force=Force.sine("0.02", "1e9"))
    with pytest.raises(OutOfRange, match="more than a million steps; shorten the horizon"):
        solve(scene, arithmetic=way)


@pytest.mark.parametrize("off", ["1e-18", "-1e-18"])
def test_next_to_a_tie_of_high_order_steps_grow(off):
    """@example of a found fault: u = 0.1 + 5 t^2 + t^4, a tie, with 5 + off was refused as too fast."""
    force = Force((Piece(0, ("0.1", 0, 5 + Fraction(off), 0, 1)),))
    found = solve(Scene(Pair(1, 1, 200, "0.05"), State(), 1, force=force), arithmetic="ball")
    modes = {"1e-18": ["slip+"], "-1e-18": ["stick", "slip+"]}
    assert [mode.value for mode in found.modes] == modes[off]
