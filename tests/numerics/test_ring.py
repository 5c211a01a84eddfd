"""When the relative motion stays in its ring, and what is said of all later times: against samples and runs."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from control_scenes import outside
from flint import arb
from scene_files import scenes_in

from numerics import (
    Force,
    Friction,
    NotSettled,
    Pair,
    Scene,
    State,
    load_scene,
    response,
    ring_entry,
    solve,
)
from numerics.arithmetic.ball import Ball, exact_middle
from numerics.control import ring as rings
from numerics.control.orbit import Orbit, state_at, without_x2
from numerics.control.ring import Settled, periodic_settled, slide_left
from numerics.free.abel import creeping_place
from numerics.trajectory.run import run_scene

SCENES = scenes_in("settling")
CASES = """
velocities              0.001 20
itinerary-that-merges   0.001 1
a-sine-with-a-damper    0.005 1
a-constant-force        0.005 1
a-pulse                 0.005 1
a-step-without-a-damper 0.001 1
a-sine-then-a-constant  0.001 1
"""


@pytest.mark.parametrize("row", CASES.strip().splitlines())
def test_the_entry_is_the_last_sample_outside(row):
    name, radius, rate = row.split()
    found = ring_entry(SCENES.get(name) or load_scene(name), radius, rate=rate)
    entry = float(found.entry)
    assert 0 < entry - outside(found, 2 * entry)[-1] < 2.1 * entry / 4_000


def test_a_motion_under_another_force_is_held_against_the_periodic_one():
    scene = SCENES["a-step-then-a-sine"]
    found, run = ring_entry(scene, "0.03", digits=8), solve(scene, digits=20)
    assert found.entry < 1  # s, when the sine begins
    with Ball(24).context():
        for t, sign in ((found.entry - arb("1e-6"), 1), (found.entry + arb("1e-6"), -1)):
            x1, v1, x2, v2 = run.sol(t.mid()) - state_at(found.orbit.passage_at(t.mid()), t.mid())
            assert sign * ((x1 - x2 - found.centre) ** 2 + (v1 - v2) ** 2 - arb("0.0009")) > 0


def test_a_light_body_1_takes_no_finer_parts_for_ever():
    found = ring_entry(SCENES["a-light-body-1"], "0.001")
    assert float(found.entry) == pytest.approx(0.0856818353204)


def test_a_motion_that_never_leaves_the_ring_is_inside_from_the_start():
    found = ring_entry(SCENES["it-sticks-from-the-start"], 1)
    assert found.entry.is_zero()
    assert "sticks" in found.why


def test_the_ring_of_a_motion_that_slowly_closes_in_is_where_it_is_so_near_to_itself_many_periods_later():
    scene, later = load_scene("forced-sine-stick-slip"), 79 * 2 * np.pi / 5
    run, entry = solve(scene.replace(until=120)), float(ring_entry(scene, "0.001", digits=12).entry)
    t = np.array([entry - 1e-6, entry + 1e-6, *np.linspace(entry + 0.01, entry + 15, 400)])
    apart = run.sol(t) - run.sol(t + later)
    assert (np.hypot(apart[0] - apart[2], apart[1] - apart[3]) > 0.001).tolist() == [True, *[False] * 401]


def test_what_helps_where_a_motion_is_not_known_to_settle_is_said(monkeypatch):
    monkeypatch.setattr(rings, "_FORCED", (1, 2_000))
    scene = SCENES["a-weak-damper"]
    with pytest.raises(NotSettled, match="a later horizon or a larger radius may help"):
        ring_entry(scene, "0.1")
    assert ring_entry(scene.replace(until=3000), "0.1").why == "the pair sticks permanently"


# what is said of all later times

SLIDING, FAST = SCENES["it-slides-by"], SCENES["a-stiff-pair"]


@cache
def orbit_of(scene: Scene) -> Orbit:
    return response(scene, digits=30).orbit


def known(scene: Scene, near: float) -> Settled | None:
    orbit = orbit_of(scene)
    with Ball(24).context():
        return periodic_settled(run_scene(scene, Ball(24), 2_000), orbit, near)


def test_since_is_the_first_period_that_is_proved_to_stay_as_near_as_asked(monkeypatch):
    """The speed counts even where nothing is left to slide. One period earlier the speeds may be further apart."""
    monkeypatch.setattr(rings, "slide_left", lambda *_: arb(0))
    near, orbit, apart = 1e-3, orbit_of(FAST), []
    since = known(FAST, near).since
    with Ball(24).context():
        run = solve(FAST.replace(until="0.5"), arithmetic="ball", digits=20)
        for k in range(-1, 6):
            t = (since + k * orbit.drive.period).mid()
            off = [a - b for a, b in zip(run.sol(t), state_at(orbit.passage_at(t), t), strict=True)]
            apart.append(float(orbit.drive.norm.kappa * orbit.drive.norm.of(off)))
    assert apart[0] >= near > max(apart[1:])


def test_what_slides_in_the_periods_before_the_end_counts(monkeypatch):
    """In a period of 3 s more is slid, in metres, than the speed is in metres a second, which is well below `near`."""
    monkeypatch.setattr(rings, "slide_left", lambda *_: arb(0))
    scene = SCENES["a-long-period"]
    orbit = orbit_of(scene)
    with Ball(24).context():
        t = (Ball.number(20) - 3 * orbit.drive.period).mid()
        apart = run_scene(scene, Ball(24)).sol(t) - state_at(orbit.passage_at(t), t)
        near = 2 * float(orbit.drive.norm.kappa * orbit.drive.norm.of(apart))
    assert known(scene, near).since > t + 1


def test_a_push_out_of_the_ring_counts_also_where_the_motion_is_back_within_the_period():
    """@example of an entry before it: at all whole periods before the end the motion is near the periodic one."""
    sine, t = Force.sine(160, "0.5"), np.append(np.linspace(61, 65, 4_001), 120)
    own = Scene(Pair(1, 1, 100, "0.3", 20), State(), 120, force=sine)
    pushed = own.replace(force=sine + Force.step(61, 60) - Force.step("61.5", 60))
    x1, v1, x2, v2 = solve(pushed).sol(t) - solve(own).sol(t)
    z = x1 - x2
    last = t[np.hypot(z - z[-1], v1 - v2) > 0.5][-1]
    assert 0 < float(ring_entry(pushed, "0.5", digits=6).entry) - last < 0.0011


def test_what_can_still_slide_is_in_the_limit(monkeypatch):
    """@example of a fault that survived: it is far less than the last digits of balls."""
    monkeypatch.setattr(rings, "slide_left", lambda *_: arb("1e-6"))
    assert known(SLIDING, 1e-3).limit.rad() >= 1e-6


def test_no_motion_near_a_periodic_one_slides_further_than_is_said():
    """Of motions that begin so far away along x1, v1 and v2 the one that slides most; the bound is of use, too."""
    orbit, times = orbit_of(SLIDING), np.linspace(0, 20, 4_000)
    norm = orbit.drive.norm
    for fifth in range(1, 5):
        with Ball(30).context():
            t, reach = (orbit.legs[0].start + orbit.drive.period * fifth / 5).mid(), arb("1e-6")
            most, starts = float(slide_left(orbit, t, reach)), [[*without_x2(state_at(orbit.passage_at(t), t))]]
            for place, root in enumerate((norm.root_a2, norm.root_m1, norm.root_m2)):
                starts.append([one + reach / root * (k == place) for k, one in enumerate(starts[0])])
            scenes = [orbit.drive.one_period(exact_middle(t), [*map(exact_middle, one)]) for one in starts]
        y = [solve(one.replace(until=20)).sol(times) for one in scenes]
        own, *others = [v1 - v2 for _, v1, _, v2 in y]
        assert most / 6 < max(20 * abs(one - own).mean() for one in others) <= most


def test_a_piece_that_begins_after_the_horizon_counts():
    """The pair is at rest, and so it is under the last piece; one in between tears it apart."""
    scene = SCENES["a-piece-after-the-horizon"]
    found = ring_entry(scene, "0.0005", digits=8)
    assert found.entry > 3
    y = solve(scene.replace(until=10)).sol(float(found.entry.mid()) + np.linspace(1e-6, 5, 400))
    assert np.hypot(y[0] - y[2] - float(found.centre), y[1] - y[3]).max() <= 0.0005


# where a creeping pair comes to rest


@pytest.mark.parametrize("share", [Fraction(1, 5), Fraction(1, 2), Fraction(9, 10)])
def test_a_creeping_pair_stays_within_what_is_said(share):
    """From the event on x1 - x2 is within `reach` of the limit, v1 - v2 within `speed`, and both bounds are of use.

    The limit is the same, from whichever event it is read.
    """
    pair = Pair(m1=share, m2=1 - share, a2=1, b=1 - share)  # L = Omega = 1
    speed = Fraction(float(share * Fraction(12, 1000)) ** 0.5)
    run = run_scene(Scene(pair, State(x1=pair.half_width, v1=speed, v2=speed), 60), Ball(40))
    with run.arithmetic.context():
        found = creeping_place(run, pair, 1.0, Fraction(0))
        assert found.index < 4
        assert found.limit.overlaps(creeping_place(run, pair, 1.0, Fraction(40)).limit)
        far = [abs(one.y[0] - one.y[2] - found.limit) for one in list(run.events)[found.index :]]
        assert all(one <= found.reach for one in far)
        assert max(float(one) for one in far) > float(found.reach) / 3
    # a slip is fastest where its guard is largest; by slips of a hundredth of the time
    begin, end = (Fraction(float(run.events[found.index + n].t)) for n in (0, 1))
    states = (run.sol(begin + (end - begin) * Fraction(part, 100)) for part in range(1, 100))
    fastest = max(abs(float(v1 - v2)) for _, v1, _, v2 in states)
    assert float(found.speed) / 8 < fastest <= float(found.speed)


def test_friction_that_holds_for_a_moment_counts_also_where_the_motion_is_back_within_the_period():
    own = Scene(Pair(1, 1, 100, "0.3", 20), State(), 120, force=Force.sine(160, "0.5"))
    held = own.replace(friction=Friction([(61, 100), ("61.5", "0.3")]))
    assert ring_entry(held, "0.05", digits=6).entry > 61
