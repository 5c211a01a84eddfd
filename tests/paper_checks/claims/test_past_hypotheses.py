"""What a theorem leaves out fails: a counterexample for each hypothesis that a sentence once lacked."""

import inspect
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from numerics import (
    Force,
    Friction,
    InvalidScene,
    Mode,
    Pair,
    Piece,
    PlanePair,
    PlaneScene,
    Scene,
    Sine,
    State,
    fastest_transfer,
    load_reference,
    load_scene,
    solve,
    solve_many,
    solve_scenes,
    thresholds,
    track,
)
from numerics.control.tracking import stuck_force
from paper_checks import explore
from paper_checks.claims import claim_named, entrainment, onset, tolerance
from paper_checks.proofs.cited import CITED
from paper_checks.report.content import under_a_force

NOTEBOOKS = Path(__file__).parents[3] / "notebooks"


def sentence(row, clause):
    claim = claim_named(row)
    return next(one.text for one in (*claim.clauses, *claim.correction) if one.id == clause)


def reason(row):
    """Return the words of a row's module with its line breaks taken away: the case itself would take seconds."""
    return " ".join(inspect.getsource(claim_named(row).case).split())


def page(name):
    return (Path(explore.__file__).parent / name).read_text(encoding="utf-8")


def half_turn(inertia, stiffness, omega, friction, place, start, end):
    """Carry (x, v), linear in (x0, v0, U_sin, U_cos, 1), from start to end: no damper, friction against body 1."""
    pace, gain = math.sqrt(stiffness / inertia), 1 / (stiffness - inertia * omega**2)

    def forced(t):
        s, c = gain * math.sin(omega * t), gain * math.cos(omega * t)
        return np.array([[0, 0, s, c, -friction / stiffness], [0, 0, omega * c, -omega * s, 0]])

    c, s = math.cos(pace * (end - start)), math.sin(pace * (end - start))
    return np.array([[c, s / pace], [-pace * s, c]]) @ (place - forced(start)) + forced(end)


def two_stop_amplitude(stiffness, omega, slip):
    """Return U of the conditions of two stops over U_*: unit masses, b = 1 N, no damper, a slip of the time slip."""
    begin = np.eye(5)[:2]
    end = half_turn(1, stiffness, omega, 1, begin, 0, slip)
    back = half_turn(2, stiffness, omega, 0, end, slip, math.pi / omega) + begin
    at_end = end[1] - begin[1] - np.array([0, 0, 0, 0, slip])
    rows = np.array([[-stiffness, 0, 0, 1, -2], at_end, *back])
    _, _, in_sine, in_cosine = np.linalg.solve(rows[:, :4], -rows[:, 4])
    return math.hypot(in_sine, in_cosine) * omega**2 / abs(stiffness - 2 * omega**2)


def test_short_slips_lead_to_the_first_threshold_but_at_odd_multiples():
    assert two_stop_amplitude(2, 0.8, 0.02) == pytest.approx(1, rel=1e-3)
    assert two_stop_amplitude(18, 1, 0.02) == pytest.approx(9 / 8, rel=1e-3)  # Omega = 3 omega
    assert two_stop_amplitude(50, 1, 0.02) == pytest.approx(25 / 24, rel=1e-3)  # Omega = 5 omega
    assert "neither $\\Omega$ nor $\\omega_1$ be an odd multiple" in sentence("entrainment-threshold", "two-ends")


def test_a_slip_that_follows_a_slip_may_be_short_and_cheap():
    """Unit masses and spring, b_k = 1 N, b_s = 2 N: a slip of sign 1 goes over into the other at |Lambda| = 1.01 N."""
    place, speed, before = 2.02, -1.0, 0.5
    past = (-1 + (place + 1) * math.cos(before) - speed * math.sin(before),)
    past += ((place + 1) * math.sin(before) + speed * math.cos(before), speed - before)
    energy = sum(one**2 for one in past) / 2
    assert past[1] > past[2]  # it comes from a slip of sign 1
    run = solve(Scene(Pair(m1=1, m2=1, a2=1, b=1), State(x1="2.02", v1=-1, v2=-1), until=1))  # by kinetic friction
    assert run.modes[:2] == (Mode.SLIP_MINUS, Mode.STICK)
    lasts = float(run.events[0].t)
    least = 1 / (math.sqrt(2 * energy) + 1)
    assert lasts < least / 5
    end = run.sol(lasts)
    lost = (place**2 + 2 * speed**2) / 2 - (end[0] ** 2 + end[1] ** 2 + end[3] ** 2) / 2
    assert 0 < lost < 2 * least**2 / 16 / 500
    assert "also where a slip ends" in sentence("static-friction-stops-creeping", "costs")


def test_a_slip_that_starts_no_stick_may_be_short_and_cheap_too():
    """Unit masses and spring, b_k = 1 N, b_s = 2 N: from v1 = 1 um/s one slip, where E(0)/e_0 is far below 1."""
    run = solve(Scene(Pair(m1=1, m2=1, a2=1, b=1), State(v1="1e-6"), until=1))
    assert run.modes == (Mode.SLIP_PLUS, Mode.STICK)
    least = 1 / (math.sqrt(2 * run.energy[0]) + 1)
    assert run.energy[0] < 1e-10 * 2 * least**2 / 16
    for name in ("static-slip-costs", "static-few-slips", "static-sticks-at-last"):
        assert "sticks are kept" in CITED[name][1] or "keeps its sticks" in CITED[name][1]
    assert "from a contact" in CITED["static-slip-costs"][1]


def test_body_1_tracks_but_for_the_offset_of_the_force():
    """x_ref = 0: under its force with gamma = 1/2 the pair rests with body 1 at 1/2, and others come to rest there."""
    pair, force = Pair(m1=1, m2=1, a1=1, a2=1, b=1), Force.step(0, "1/2")
    for start in (State(x1="1/2"), State(x1=-1, v1=2)):
        end = solve(Scene(pair, start, until=60, force=force)).sol(60)
        assert end[[0, 1, 3]] == pytest.approx([0.5, 0, 0], abs=1e-6)
    assert "$x_1$ does but for the $\\gamma$" in sentence("damping-for-tracking", "velocity")


def test_below_resonance_body_2_may_be_carried_away():
    """Two harmonics without a damper, both off the frequency 1 of body 1: U_1 = 0, and x2 falls by 0.9 m a second."""
    quarter = "1.5707963267948966"
    force = Force([Piece(0, (), (Sine(4, 2, quarter), Sine(4, 4, quarter)))])
    run = solve(Scene(Pair(m1=1, m2=1, a2=1, b=1), State(), until=200, force=force))
    half, end = run.sol([100, 200]).T
    assert np.all(np.abs([*half[[0, 1, 3]], *end[[0, 1, 3]]]) < 4)
    assert half[2] < -80
    assert end[2] - half[2] < -80
    assert "body 2 may be carried away" in sentence("forced-resonance-bound", "bounded")


def test_a_motion_that_never_stops_may_do_with_less_than_two_turns_need():
    """At a fifth of U** = 5.18 N: six turns a period, friction's third harmonic being at the frequency of body 1."""
    scene = replace(entrainment.LIGHT, until=40)
    late = [event.after for event in solve(scene).events if event.t > 40 - 2 * math.pi / 10]
    assert late in (3 * [Mode.SLIP_MINUS, Mode.SLIP_PLUS], 3 * [Mode.SLIP_PLUS, Mode.SLIP_MINUS])
    assert thresholds(scene.pair, 10).non_stop > 5
    assert "A motion that turns more often may do with less" in sentence("entrainment-threshold", "more-turns")
    stops = solve(replace(scene, force=Force.sine("0.02", 10))).events
    assert any(event.after == Mode.STICK for event in stops if event.t > 40 - 2 * math.pi / 10)


def test_no_level_of_the_energy_decides_under_a_friction_that_varies_in_time():
    """Omega = 1, L = b; b is 2 N near each half turn of the stuck pair, else 1 N: of one energy, one start sticks."""
    half_turns = [str(round(n * math.pi + side, 6)) for n in range(12) for side in (1.1, math.pi - 1.1)]
    friction = Friction(list(zip(half_turns, 12 * [1, 2], strict=True)))
    pair = Pair(m1=1, m2=1, a2=2, b=2)
    sticks, slips = (
        solve(Scene(pair, start, until=37, friction=friction)) for start in (State(x1="1.5"), State(v1="1.5", v2="1.5"))
    )
    assert sticks.energy[0] == slips.energy[0] == 2.25
    assert sticks.modes == (Mode.STICK,)
    assert len(slips.modes) > 6
    assert slips.energy[-1] < 1.1
    assert any("varies with the time" in one for one in claim_named("varying-interface").open)


def test_circles_that_are_too_large_may_slip_more_than_once():
    """A light body 1 on a surface, a circle 2 % too large: it slips twice before it sticks for ever."""
    pair = PlanePair(m1="0.05", m2="0.95", a2=1, b="0.95")
    run = solve(PlaneScene(pair, 10, x1=["1.02", 0], v1=[0, "1.02"], v2=[0, "1.02"]))
    assert run.modes == ("slip", "stick", "slip", "stick")
    assert "slips once or a few times" in page("surface.html")


def test_a_body_2_at_rest_is_met_before_the_heavy_damper_has_settled():
    """A slip from x1 = 2.1 m that lasts 0.19 m1/a1: at its end the load is near b, not b m2/M, and the pair sticks."""
    run = solve(Scene(Pair(m1=1, m2=1, a1=1000, a2=1, b=1), State(x1="2.1"), until=2))
    assert run.modes == (Mode.SLIP_MINUS, Mode.STICK)
    place, velocity = run.events[0].y[:2]
    assert 0.9 < abs(float(place) + 1000 * float(velocity)) / 2 < 1


def test_the_first_slip_under_a_heavy_damper_may_cross():
    """Body 2 at rest, body 1 at 1 m/s: where they first meet the load is beyond -b, the more so the larger a1 is."""
    loads = []
    for damper in (1000, 100000):
        run = solve(Scene(Pair(m1=1, m2=1, a1=damper, a2=1, b=1), State(v1=1), until=1))
        assert run.modes == (Mode.SLIP_PLUS, Mode.SLIP_MINUS, Mode.STICK)
        place, velocity = map(float, run.events[0].y[:2])
        loads.append(-(place + damper * velocity) / 2)
        assert float(run.events[1].t) < 10 * math.log(damper) / damper
    assert loads[1] < loads[0] - 2 < -4
    assert "The first slip may cross $S$" in tolerance.heavy_damping().statement


def test_under_a_force_the_relative_displacement_need_not_have_a_limit():
    """Two harmonics and a damper: (x1, v1, v2) repeats, and in each period x2 moves on by 0.31 m."""
    force = Force([Piece(0, (), (Sine(2, 1), Sine(2, 2, "1.5707963267948966")))])
    run = solve(Scene(Pair(m1=1, m2=1, a1=1, a2=1, b=1), State(), until=120, force=force))
    late = run.sol([100, 100 + 2 * math.pi, 100 + 4 * math.pi]).astype(float)
    assert np.ptp(late[[0, 1, 3]], axis=1) == pytest.approx([0, 0, 0], abs=1e-9)
    assert np.diff(late[2]) == pytest.approx([0.30973, 0.30973], abs=1e-4)
    assert "only be centred on a limit of the motion's own" in sentence("ring-of-tolerance", "displacement")


def test_the_oscillation_of_body_1_may_grow_until_the_bodies_synchronise():
    """The case study from x1 = 0 at rest with v2 = -0.03 m/s: one slip, then stick for ever with 1.5 mm."""
    run = solve(Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(v2="-0.03"), until=3))
    assert run.modes == (Mode.SLIP_PLUS, Mode.STICK)
    assert np.max(np.abs(run.sol(np.linspace(2, 3, 500))[0])) == pytest.approx(0.001494, rel=1e-3)
    assert "takes the amplitude" not in Path(onset.__file__).read_text(encoding="utf-8")


def test_a_heavy_body_1_may_merge_by_a_slip_that_does_not_start_on_the_surface():
    """Fig. 3 (a), equal masses: one slip takes the pair from 3.84 E_cr to 0.49 E_cr."""
    scene = load_scene("itinerary-that-merges")
    run, critical = solve(scene), float(scene.pair.critical_energy)
    assert run.modes == (Mode.SLIP_PLUS, Mode.STICK)
    assert run.energy[0] > 3.8 * critical > 0.5 * critical > run.energy[-1]
    assert "no slip that starts on S does" in page("explore.html")


def test_a_slip_on_a_surface_may_end_at_the_rate_0():
    """On a line of it, all constants 1: the slip that touches at x1 = L = 2 with v = 1, where |Lambda| = b."""

    def function(t):
        slip = -math.sin(t) + math.cos(t) - 1 + t
        load = -(1 + math.cos(t) + math.sin(t)) / 2
        return abs(slip) + load * slip

    assert function(-0.1) > function(-0.01) > 0
    assert function(-0.001) / 0.001 < 0.002
    assert "if $|\\Lambda|<b$" in sentence("stuck-ellipses", "lands")


def test_a_slip_on_a_surface_that_is_not_straight_may_end_against_the_load():
    """All constants 1: followed back from s = 0 at x1 = (0.8, 0), v = (0, 1), where it meets the load head-on."""

    def rates(state):
        first, second = state[2:4], state[4:6]
        friction = (first - second) / np.linalg.norm(first - second)
        return np.concatenate([first, -state[:2] - friction, friction])

    step = 1e-3
    state = np.array([0.8, -step, 1.4 * step, 1, -1.4 * step, 1])  # s = 2 (|Lambda| + 1) times the time left, along x
    for _ in range(700):  # Runge and Kutta, back in time
        k1 = rates(state)
        k2 = rates(state - step / 2 * k1)
        k3 = rates(state - step / 2 * k2)
        k4 = rates(state - step * k3)
        state = state - step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    x, y = state[2:4] - state[4:6]
    assert math.atan2(y, x) < -0.19  # so it turns by 11 degrees until it ends along +x, the load being (-0.4, 0)
    assert "But for exceptions, exactly straight slips among them" in page("surface.html")


def landing(share, excess):
    """Return y = w/q at the first re-entry of a pair with r = share that left a ray with y = excess; by bisection."""
    q, gap, push = 1 - share, 0.0, math.sqrt(excess)
    while True:
        low, high = 1e-9, 2 * math.pi - 1e-9
        for _ in range(60):
            angle = (low + high) / 2
            rise = (angle - math.sin(angle)) / (1 - math.cos(angle))
            low, high = (low, angle) if rise > push + gap / math.tan(angle / 2) else (angle, high)
        k = 1 / math.tan(angle / 2)
        reach = 2 - angle * k + gap
        if reach <= 2 / q:
            return rise**2 - 2 * (1 - rise * k) * reach + (k**2 + q) * reach**2
        gap, push = reach - 2 / q, rise + k * reach


def test_at_the_critical_share_more_than_one_energy_merges_in_the_end():
    """The one energy that merges by its first slip is where another one lands, between y = 25 and y = 36 on the ray."""
    share, angle = 0.557839090721526312, 2 * 1.89863787162680043
    merging = ((angle - math.sin(angle)) / (1 - math.cos(angle))) ** 2
    assert landing(share, merging) == pytest.approx(0, abs=1e-12)
    assert landing(share, 25) < merging < landing(share, 36)
    assert "at $r^*$ it does from some energies" in NOTEBOOKS.joinpath("past_the_paper.py").read_text(encoding="utf-8")


def late_rest(share, count):
    """Return the rest R_n of the 1/t law for r = share from y_0 = (pi/2 - 1)^2, its cycles summed one by one."""
    q, y, angle, rest = 1 - share, (math.pi / 2 - 1) ** 2, math.pi / 2, 0.0
    for _ in range(count):
        push = math.sqrt(y)
        for _ in range(3):
            versine, depth = 2 * math.sin(angle / 2) ** 2, 2 - angle / math.tan(angle / 2)
            angle -= ((angle - math.sin(angle)) / versine - push) * versine / depth
        depth = 2 - angle / math.tan(angle / 2)
        lost = share * depth**2
        place, speed = 1 - q * depth, math.sqrt(q) * (push - angle)
        time = math.sqrt(q) * angle - math.atan(math.sqrt(q * (y - lost))) + math.atan(speed / place)
        gain = 4 * lost / (9 * share * y * (y - lost)) - 1 + (1 - 2 / (5 * share)) * math.log1p(-lost / y)
        rest, y = rest + math.pi * gain - time, y - lost
    return rest


def test_the_lower_bound_of_the_rest_needs_its_factor():
    """From r = 0.02 to 0.01 the rest falls by what pi/r times the integral of 4/(9 y^2) + 2/(5 y) - 1/c^2 falls by."""
    integral = -0.0136878 / math.pi  # over all y up to (pi/2 - 1)^2, from 30 digits
    fallen = late_rest(0.01, 8000) - late_rest(0.02, 4000)
    assert fallen == pytest.approx(math.pi * integral * (100 - 50), rel=0.05)
    assert "The lower one does" in " ".join(claim_named("rate-with-error").open)


def test_a_body_1_that_is_but_a_little_lighter_never_merges_by_one_slip():
    """For q = m1/M from 0.4422 to 1/2 no slip from a ray ends below E_cr: (h/c)^2 >= r^* > 1 - q."""
    angle = np.linspace(1e-2, 2 * math.pi - 1e-2, 10_000)
    rise, depth = (angle - np.sin(angle)) / (1 - np.cos(angle)), 2 - angle / np.tan(angle / 2)
    assert np.min((rise / depth) ** 2) == pytest.approx(0.557839, abs=1e-6)
    assert "m_1/m_2<0.7926" in NOTEBOOKS.joinpath("one_over_t_law.py").read_text(encoding="utf-8")


def test_body_2_follows_at_the_limit_of_friction_while_the_pair_slips():
    """x_ref = t^2/2 asks for b/m2 = 1: under 10 N body 1 runs ahead all the second, and body 2 follows exactly."""
    run = solve(Scene(Pair(m1=1, m2=1, a2=1, b=1), State(), until=1, force=Force.step(0, 10)))
    assert run.modes == (Mode.SLIP_PLUS,)
    assert run.sol([0.5, 1])[2:].astype(float) == pytest.approx(np.array([[0.125, 0.5], [0.5, 1]]))
    assert "A pair that sticks does it" in "".join(Path(under_a_force.__file__).read_text().split('"\n        "'))


def test_without_a_damper_a_free_oscillation_may_die_beside_a_reference():
    """The stuck response to U_* = 1.75 N: at each of its peaks whatever is added breaks the pair, and is worn down."""
    force = Force([Piece(0, (), (Sine("1.75", 2),))])
    stuck, other = (
        solve(Scene(Pair(m1=1, m2=1, a2=1, b=1), State(x1=start, v1="-0.5", v2="-0.5"), until=300, force=force))
        for start in (0, "0.3")
    )
    assert stuck.modes == (Mode.STICK,)
    apart = np.linalg.norm((other.sol([0, 100, 300]) - stuck.sol([0, 100, 300])).astype(float)[[0, 1, 3]], axis=0)
    assert apart[1] < apart[0] / 2
    assert apart[2] < apart[0] / 4
    assert "without a damper a free oscillation may stay" in reason("damping-for-tracking")


def test_without_a_damper_a_force_that_favours_no_side_may_carry_body_2_away():
    """omega_1 = 2 omega: v1 + 0.2 cos 2t and v2 + 0.2 beside a motion that never stops reverse when that does."""
    quarter = "1.57079632679489661923132169163975144"
    force = Force([Piece(0, (), (Sine("-4.71238898038468985769396507491925433", 1), Sine(-9, 1, quarter)))])
    for added, speed in (
        ("-1.57079632679489661923132169163975144", 0),
        ("-1.37079632679489661923132169163975144", 0.2),
    ):
        run = solve(Scene(Pair(m1=1, m2=1, a2=4, b=1), State(x1=-3, v1=added, v2=added), until=64, force=force))
        assert set(run.modes) == {Mode.SLIP_PLUS, Mode.SLIP_MINUS}
        once, later = run.sol([2 * math.pi, 20 * math.pi]).T
        assert later[2] - once[2] == pytest.approx(18 * math.pi * speed, abs=1e-9)
    assert "With a damper, under a force whose second half" in "".join(
        Path(under_a_force.__file__).read_text().split('"\n        "')
    )


def test_read_literally_friction_gives_what_a_reference_asks():
    """sgn(0) = 0 with a stick that is never left: body 2 follows too-fast, and is 1 cm away after 0.1 s, not 0.28 s."""
    rest, reference = replace(load_scene("at-rest"), law="three-valued-sgn", until=2), load_reference("too-fast")
    force = Force([stuck_force(rest.pair, piece) for piece in reference])
    assert solve(replace(rest, force=force)).sol(2) == pytest.approx([0.1, 0, 0.1, 0], abs=1e-9)
    go, stop = Piece(0, (0, 0, 2)), Piece("0.05", ("0.005", "0.2", -2))
    force = Force([*(stuck_force(rest.pair, one) for one in (go, stop)), Piece("0.1", (2,))])
    assert solve(replace(rest, force=force)).sol(2) == pytest.approx([0.01, 0, 0.01, 0], abs=1e-9)
    with pytest.raises(InvalidScene, match="law"):
        track(rest, reference)
    with pytest.raises(InvalidScene, match="law"):
        fastest_transfer(rest, "0.01")


@pytest.mark.parametrize("later", [{"friction": Friction([(10, "0.1")])}, {"force": Force.step(10, 5)}])
def test_a_stick_is_not_for_ever_where_a_piece_after_the_horizon_breaks_it(later):
    scene = Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(x1="0.004"), until=20, **later)
    run = solve(scene, digits=20)
    assert run.modes[0] == Mode.STICK
    assert run.events[0].t == 10
    for how in ({}, {"digits": 20}, {"arithmetic": "ball"}):
        assert solve(replace(scene, until=5), **how).message == "reached the horizon"
    given = {"x1": 0.004, "until": [5, 10], **later}
    assert solve_many(1, 1, 200, 0.5, **given).status.tolist() == [0, 0]
    scenes = [replace(scene, until=5), Scene(scene.pair, scene.initial, until=5)]
    assert solve_scenes(scenes).status.tolist() == [0, 1]


@pytest.mark.parametrize(
    ("row", "needed"),
    [
        ("forced-no-zeno", "without end in a bounded time"),  # u = 0 is analytic, and Fig. 5 (a) has no last event
        ("merging-bands", "For three mass ratios"),  # m1 > 0.7927 m2 merges from no energy on S0 above E_cr
        ("merging-set", "If body 2 is heavy enough"),  # the same
        ("uniform-rate", "over all trajectories that never merge"),  # what the kernel's theorem is about
        ("rate-one-over-t", "over all with one $E(0)$ that never merge"),
        ("varying-interface", "without jumps, with bounded slopes, a start still has one motion"),  # b_s > b_k
        ("varying-interface", "without a force friction that stays above"),  # non-stop motions slip for ever
    ],
)
def test_a_reason_keeps_what_it_once_left_out(row, needed):
    assert needed in reason(row)
