"""Sensitivities against differences of solves in balls and other arithmetics; what is exact of them; as commands."""

import tomllib
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from differences import DIGITS, STEP, deviation, everything, is_first_start, moved, parameters
from every_number import derivatives
from flint import arb
from hypothesis import example, given
from reaching import LeftOut, reaching
from scene_files import scenes_in
from sixty_digits import case_of
from strategies import driven_scenes, fewer, scenes
from three_scenes import PAPER

from numerics import (
    EventUndecided,
    Force,
    Friction,
    NotDifferentiable,
    NumericsError,
    Pair,
    Piece,
    Scene,
    State,
    load_scene,
    sensitivities,
    solve,
)
from numerics.arithmetic.ball import Ball
from numerics.scene.model import WRT
from numerics.trajectory import sensitivity, variation
from numerics.trajectory.run import free_scene, run_scene

CATALOGUE = Path(__file__).parents[1] / "forced" / "scenes"
PAIR = Pair(1, 1, 200, "0.05")
FREE, WEAKENED, SIGNALS, SCENES = map(scenes_in, ("differentiated", "followed-in-balls", "signals", "derivatives"))
GIVEN = tomllib.loads((CATALOGUE.parent / "derivatives.toml").read_text("utf-8"))
FORCED, CORNERS, TIES = (GIVEN[one] for one in ("compared", "corners", "ties"))


def named(name):
    return (FREE | WEAKENED | SIGNALS).get(name) or load_scene(CATALOGUE / f"{name}.toml")


def in_balls(scene, digits=DIGITS):
    return solve(scene, arithmetic="ball", digits=digits, max_events=20)


def compared(scene):
    """All numbers of a scene moved at once; events, states and times up to the horizon, or the first twenty events."""
    base = in_balls(scene)
    return deviation(base, everything(base))


@pytest.mark.parametrize("name", [*FREE, *FORCED, *WEAKENED, *SIGNALS])
def test_differences_of_solves(name):
    found = compared(named(name))
    assert found.events_compared
    assert found.size < 1e-50, found


@pytest.mark.parametrize("name", TIES)
def test_ties_that_leave_derivatives_to_both_sides(name):
    base = in_balls(named(name))
    way = {name: one for name, one in everything(base).items() if moved(base.scene, {name: -STEP * one})}
    found = [deviation(base, way, (side,)) for side in (1, -1)]
    assert not all(one.events_compared for one in found)
    assert max(one.size for one in found) < 1e-15, found


@reaching
@fewer(3)
@example(SCENES["a-slip-of-many-turns"])
@given(driven_scenes() | scenes(damped=None, periods=(1, 1), exponents=(-1, 1)))
def test_differences_of_random_solves(scene):
    try:
        found = compared(scene)
    except NumericsError:  # the scene, or a neighbour, sits on a tie
        raise LeftOut from None
    assert found.size < (1e-20 if found.events_compared else 1e-3), found


@pytest.mark.parametrize("name", CORNERS)
@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
def test_a_corner_is_refused_in_one_line(name, arithmetic):
    try:
        trajectory = solve(named(name), arithmetic=arithmetic)
    except NumericsError:
        assert arithmetic != "ball"  # next to a tie numbers without bounds do not decide
        return
    with pytest.raises(NotDifferentiable, match=CORNERS[name]) as refused:
        sensitivities(trajectory)
    assert str(refused.value).isprintable()


MORE = ("damping-heavy", "friction-by-pieces", "resonance-in-slip", "trapezoid", "contact-at-a-rational-time")


@pytest.mark.parametrize("name", [*FREE, *MORE])
def test_derivatives_are_right_to_the_digits_of_their_arithmetic(name):
    scene, truth = named(name), in_balls(named(name), 60)
    ways = [("ball", 15), (None, None), *[("mpmath", 30)] * free_scene(scene)]
    for arithmetic, digits in ways:
        run = solve(scene, digits=digits, arithmetic=arithmetic, max_events=20)
        with truth.context():
            found = derivatives(run, truth)
            assert [one for one in found if not one.ratio <= 1] == []


def test_derivatives_have_the_digits_that_are_asked_for():
    """Of a run with fewer they are those of another one."""
    final = sensitivities(in_balls(named("damping-heavy"), 15).but(digits=60)).final.ravel()
    assert max(one.rad() for one in final) < arb("1e-58") * max(abs(one) for one in final)


def test_a_run_whose_events_many_digits_prove_has_derivatives_if_they_are_these():
    """Beside a graze, on both sides, 1e-60 m/s apart: one scene to 30 digits, but one side has two events more."""
    grazing, step = case_of("extremes", "graze-to-900-digits", "ball").scene, Fraction(1, 10**60)
    below = grazing.initial.v2 // step * step
    scenes = [grazing.replace(v2=one) for one in (below, below + step)]
    runs, proved = ([solve(one, digits=30, arithmetic=name) for one in scenes] for name in ("mpmath", "ball"))
    assert runs[0].modes == runs[1].modes
    assert proved[0].modes != proved[1].modes
    for run, truth in zip(runs, proved, strict=True):
        if run.modes == truth.modes:
            with truth.context():
                assert [one for one in derivatives(run, truth) if not one.ratio <= 1] == []
        else:
            with pytest.raises(EventUndecided, match="are the events those of the trajectory"):
                sensitivities(run)


def test_pieces_of_one_length_share_their_exponentials(monkeypatch):
    """A record at equal steps but for one: derivatives by all its numbers are right, and few matrices are formed."""
    force = Force.samples([*(Fraction(k, 20) for k in range(40)), "1.99"], [(7 * k * k) % 11 - 5 for k in range(41)])
    scene, formed = Scene(Pair(1, 1, 200, "0.5", 3), State(), 2, force=force), []
    assert compared(scene).size < 1e-50
    honest = variation._exponential
    monkeypatch.setattr(variation, "_exponential", lambda *given: formed.append(given) or honest(*given))
    run = in_balls(scene)
    sensitivities(run, wrt=["b", "m1"])
    assert len(run.events) < len(formed) < 3 * len(run.events) + 6 < 41


def test_there_are_no_derivatives_by_the_samples_of_a_table():
    table = Force.samples(range(150), [k * k % 17 for k in range(150)])
    assert sensitivities(solve(Scene(PAIR, State(), 3, force=table))).wrt == (*WRT, "until")


@pytest.mark.parametrize("name", ["force[0].from", "friction[0].from"])
@pytest.mark.parametrize("way", ["up", "down"])
def test_a_force_from_the_start_on_breaks_a_stick_towards_either_side(way, name):
    base = in_balls(SCENES[f"a-push-{way}"])
    assert deviation(base, {name: Fraction(1)}, (1,)).size < 1e-50


FROM_THE_START = scenes_in("from-the-start")


@pytest.mark.parametrize("scene", FROM_THE_START.values(), ids=FROM_THE_START)
def test_what_begins_at_the_start_may_begin_later(scene):
    """One by one, from v1 = v2 too: it was wrong on the ground or a belt, and where a short slip follows."""
    base = in_balls(scene)
    for name in parameters(scene):
        if is_first_start(scene, name):
            assert deviation(base, {name: Fraction(1)}, (1,)).size < 1e-30  # of second order, where friction holds


def test_a_body_that_sticks_to_a_belt_goes_with_it_by_every_number():
    assert compared(FROM_THE_START["it-goes-with-the-belt"]).size < 1e-50


def test_what_friction_read_literally_would_not_bring_back_has_no_derivative():
    """A belt that begins late leaves the stick behind, which no friction b could hold."""
    with pytest.raises(NotDifferentiable, match=r"where belt\[0\] begins a little later"):
        sensitivities(solve(SCENES["a-belt-read-literally"]))


@pytest.mark.parametrize("short", ["1e-50", "-1e-50"])
def test_a_slip_that_ends_next_to_the_edge_has_derivatives(short):
    """On the ground at rest; and a stick under the law read literally has them with any load."""
    x1 = Fraction("0.0075") + Fraction(short)
    assert compared(Scene(Pair(2, "inf", 200, "0.5"), State(x1), 1)).size < 1e-15
    kept = Scene(Pair(2, "inf", 200, 1, 0, "1.5"), State(x1 + Fraction("0.01")), "0.5")
    assert compared(kept).size < 1e-15
    few = sensitivities(run_scene(kept, Ball(20))).final[0, 0]  # in 20 digits the load is what friction holds
    assert few.overlaps(sensitivities(in_balls(kept)).final[0, 0])
    literal = Scene(Pair(2, 3, 100, 1, 0, "1.5"), State("0.025"), 1, "three-valued-sgn")
    assert compared(literal).size < 1e-20


def test_static_friction_that_falls_to_0_where_no_load_is_leaves_derivatives():
    scene = SCENES["static-friction-that-touches-0"]
    for one in (scene, scene.replace(friction=Friction([Piece("0.1", (0, 1))]))):
        assert compared(one).size < 1e-50


# at any time

FOLLOWED = scenes_in("followed")


@pytest.mark.parametrize("scene", FOLLOWED.values(), ids=FOLLOWED)
def test_derivatives_at_the_ends_are_those_of_start_and_end_and_at_an_event_those_of_its_side(scene):
    run, balls = solve(scene), in_balls(scene, 20)
    first, last, found = (sensitivities(run, t) for t in (0, scene.until, None))
    if run.modes[0].sign:
        assert (first[:, :4] == np.eye(4)).all()
    for index, name in enumerate(found.wrt):
        assert (last[:, index] == (0 if name == "until" else found.final[:, index])).all()
    event = next(one for one in balls.events if not one.t.is_exact())
    about = event.t + arb(0, 1e-60)  # another ball of times, which may be before or after it
    for side, near in (("left", event.t.lower() - 1e-9), ("right", event.t.upper() + 1e-9)):
        beside = sensitivities(balls, near)
        at = sensitivities(balls, event.t, side)
        assert all(one.rad() < 1e-6 for one in at.flat)
        for found_there in (at, sensitivities(balls, about)):
            assert all(abs(one).lower() < 1e-6 for one in (found_there - beside).flat)


@pytest.mark.parametrize("arithmetic", ["float64", "mpmath", "ball"])
def test_at_no_times_there_are_no_derivatives(arithmetic):
    assert sensitivities(solve(load_scene("velocities"), arithmetic=arithmetic), []).shape == (4, 9, 0)


@pytest.mark.parametrize(("solved", "jump"), [(solve, "1"), (in_balls, "1.7")])
def test_a_jump_of_the_force_has_two_sides(solved, jump):
    """Of a time that no float holds one ball held both of them."""
    run = solved(SCENES[f"a-push-at-{jump}-s"])
    before, after = (sensitivities(run, jump, side, ["force[0].from"]) for side in ("left", "right"))
    assert (before == 0).all()
    off = after[:, 0] - [0, arb("-0.1"), 0, arb("-0.1")]  # both bodies go on, and later
    assert all(abs(one) < 1e-14 for one in off)


def test_an_event_is_that_event_also_where_derivatives_need_more_digits_than_the_run_has(monkeypatch):
    run, tried = solve(load_scene("belt"), digits=15, arithmetic="ball"), []
    honest = sensitivity.run_scene
    monkeypatch.setattr(sensitivity, "run_scene", lambda *given: tried.append(given) or honest(*given))
    for side in ("left", "right"):
        assert all(one.rad() < 1e-12 for one in sensitivities(run, run.events[-1].t, side).flat)
    assert tried


@pytest.mark.parametrize(("wall", "has_one"), [("that-jumps", False), ("that-runs", True), ("elsewhere", True)])
def test_by_the_damper_there_is_no_derivative_where_the_wall_jumps(wall, has_one):
    """A jump would be a blow through it: such a scene is refused, and what was returned left the blow out."""
    assert ("a1" in sensitivities(solve(SCENES[f"a-wall-{wall}"])).wrt) is has_one


@pytest.mark.parametrize("name", ["no-friction", "no-friction-on-the-ground"])
def test_by_a_b_that_is_0_there_is_no_derivative(name):
    """It was 0, where friction of any b > 0 slows the motion down."""
    run = solve(SCENES[name])
    assert "b" not in sensitivities(run).wrt
    with pytest.raises(ValueError, match="'b', which is 0: by that there is no derivative"):
        sensitivities(run, wrt=["b"])


# as the command line tells them: digits that are right, an archive, a table


@pytest.mark.parametrize("arithmetic", ["ball", "mpmath", "float64"])
def test_json_carries_them(arithmetic, scene_file, record):
    found = record("solve", scene_file, "--sensitivity", "--arithmetic", arithmetic)
    truth = sensitivities(solve(PAPER.replace(until=2), digits=60, arithmetic="ball"))
    for event, t, y in zip(found["events"], truth.t, truth.y, strict=True):
        assert set(event["sensitivity"]) == {"t", "x1", "v1", "x2", "v2"}
        for row, true in zip(event["sensitivity"].values(), (t, *y), strict=True):
            check_row(row, true, arithmetic)
    for row, true in zip(found["final"]["sensitivity"].values(), (*truth.final, truth.energy), strict=True):
        check_row(row, true, arithmetic)


def check_row(row, true, arithmetic):
    with Ball(70).context():
        for name, value in zip(WRT, true, strict=True):
            exact, exponent = row[name] in {"0", "1"}, Decimal(row[name]).as_tuple().exponent
            place = row[f"{name}_radius"] if arithmetic == "ball" else "0" if exact else f"1e{exponent}"
            assert arb(row[name], arb(place)).overlaps(value), (name, row[name])
            assert arb(place) <= arb("1e-10") * (1 + abs(value))


def test_the_archive_and_the_table_carry_them(scene_file, tmp_path, output):
    path = tmp_path / "out.npz"
    output("solve", scene_file, "--npz", path, "--sensitivity", "--digits", 20)
    found = sensitivities(solve(PAPER.replace(until=2)))
    with np.load(path) as archive:
        assert tuple(archive["sensitivity_wrt"]) == WRT
        for name in ("t", "y", "final", "energy"):
            assert np.allclose(archive[f"sensitivity_{name}"], getattr(found, name), rtol=1e-9, atol=1e-12)
    lines = output("solve", scene_file, "--sensitivity").splitlines()
    last = next(line for line in lines if line.startswith("by b ")).split()
    assert float(last[2]) == pytest.approx(found.t[-1, WRT.index("b")], rel=1e-5)
