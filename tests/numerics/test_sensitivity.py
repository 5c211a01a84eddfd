"""Sensitivities against differences of solves in balls, against other arithmetics, and what is exact of them."""

import tomllib
from fractions import Fraction
from pathlib import Path

import pytest
from differences import DIGITS, STEP, deviation, everything, is_first_start, moved, parameters
from every_number import derivatives
from flint import arb
from hypothesis import example, given
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import driven_scenes, fewer, scenes

from numerics import (
    EventUndecided,
    Force,
    Friction,
    NotDifferentiable,
    NumericsError,
    Pair,
    Piece,
    Scene,
    Sine,
    State,
    load_scene,
    sensitivities,
    solve,
)
from numerics.trajectory import variation
from numerics.trajectory.run import free_scene
from numerics.trajectory.saltation import Chain
from numerics.trajectory.trajectory import Trajectory
from numerics.trajectory.variation import Variation

CATALOGUE = Path(__file__).parents[1] / "forced" / "scenes"
PAPER, PAIR = Pair(1, 1, 200, "0.5"), Pair(1, 1, 200, "0.05")
FREE, WEAKENED, SIGNALS = map(scenes_in, ("differentiated", "followed-in-balls", "signals"))
GIVEN = tomllib.loads((CATALOGUE.parent / "derivatives.toml").read_text("utf-8"))
FORCED, CORNERS, TIES, LEFT_OUT = (GIVEN[one] for one in ("compared", "corners", "ties", "left_out"))


def named(name):
    return (FREE | WEAKENED | SIGNALS).get(name) or load_scene(CATALOGUE / f"{name}.toml")


def in_balls(scene, digits=DIGITS, most=40):
    return solve(scene, arithmetic="ball", digits=digits, max_events=most)


def compared(scene):
    """All numbers of a scene moved at once; events, states and times up to the horizon, or the first forty events."""
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


@pytest.mark.long
@pytest.mark.parametrize(
    "name", [*FREE, *sorted({one.stem for one in CATALOGUE.glob("*.toml")} - {*CORNERS, *TIES, *LEFT_OUT})]
)
def test_differences_by_each_number(name):
    base = in_balls(named(name), most=6)
    names = list(parameters(base.scene))
    for one in names[:: 1 + len(names) // 12]:
        found = deviation(base, {one: Fraction(1)})
        # from v1 = v2 differences on both sides have different second derivatives; a start has one side, or a tie
        slow = one in {"v1", "v2"} or is_first_start(base.scene, one) or not found.events_compared
        assert found.size < (1e-7 if slow else 1e-20), (one, found)


@reaching
@fewer(3)
@example(Scene(Pair(1, 10, 1, 1, "2e-9"), State("-1.1"), "20.7289"))
@given(driven_scenes() | scenes(damped=None, periods=(1, 1), exponents=(-1, 1)))
def test_differences_of_random_solves(scene):
    try:
        found = compared(scene)
    except NumericsError:  # the scene, or a neighbour, sits on a tie
        raise LeftOut from None
    assert found.size < (1e-20 if found.events_compared else 1e-3), found


def test_a_trajectory_that_has_lost_its_last_events_has_no_derivatives():
    run = solve(Scene(PAIR, State(v1="0.15"), 1))
    cut = solve(Scene(PAIR, State(v1="0.15"), Fraction((run.events[1].t + run.events[2].t) / 2)))
    with pytest.raises(EventUndecided, match="events"):
        sensitivities(Trajectory(run.scene, run.arithmetic, cut.record))


@pytest.mark.parametrize("mass", [1, 3])
@pytest.mark.parametrize("state", [State("0.003", "0.04", 0, "0.04"), State("0.005", 0, 0, 0)], ids=["moving", "rest"])
def test_the_critical_orbit_is_differentiable(state, mass):
    """Neighbours on one side slip for ever, on the other never: both agree with the stuck pair to first order."""
    scene = Scene(Pair(2 - Fraction(mass, 2), Fraction(mass, 2), 200, Fraction(mass, 4)), state, 3)
    assert scene.energy_excess == 0
    base = in_balls(scene)
    for name in set(parameters(scene)) - {"a1", "until"}:
        assert deviation(base, {name: Fraction(1)}).size < 1e-4


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


def test_jumps_together_of_which_the_first_alone_breaks_a_stick_are_a_corner():
    """Together they are no event: the force comes with more friction."""
    scene = Scene(PAIR, State(), 2, force=Force.step(1, "0.2"), friction=Friction([(1, "0.5")]))
    assert solve(scene).events == ()
    with pytest.raises(NotDifferentiable, match="which of them comes first"):
        sensitivities(solve(scene))


def test_a_run_that_ends_before_a_corner_has_derivatives():
    scene = named("touch-in-slip")
    assert sensitivities(solve(Scene(scene.pair, scene.initial, "0.5", force=scene.force))).final.shape == (4, 15)


def test_a_contact_on_the_horizon_is_a_corner():
    scene = Scene(Pair(1, 1, 1, 1), State(0, 2, 0, 0), 1, force=Force([Piece(0, (0, 2, "-0.5"))]))
    assert solve(scene, arithmetic="ball").events == ()
    with pytest.raises(NotDifferentiable, match="on the horizon"):
        sensitivities(solve(scene, arithmetic="ball"))


def test_an_event_next_to_the_horizon_is_before_it_or_after_it():
    """In float64 it falls on the horizon; the truth is on one side, and if it is not that of float64, it is said."""
    pair = Pair("0.5", "0.5", 4, "0.5")  # Omega = 2: times are halved exactly
    first = solve(Scene(pair, State(v1="1.5"), 5)).events[0].t
    scene = Scene(pair, State(v1="1.5"), Fraction(*first.as_integer_ratio()))
    trajectory, true = solve(scene), solve(scene, arithmetic="ball")
    if true.modes == trajectory.modes:
        assert sensitivities(trajectory).t.shape[0] == len(true.events)
    else:
        with pytest.raises(EventUndecided, match="those of the trajectory"):
            sensitivities(trajectory)


MORE = ("damping-heavy", "friction-by-pieces", "resonance-in-slip", "trapezoid", "contact-at-a-rational-time")


@pytest.mark.parametrize("name", [*FREE, *MORE])
def test_derivatives_are_right_to_the_digits_of_their_arithmetic(name):
    scene, truth = named(name), in_balls(named(name), 60)
    ways = [("ball", 15), (None, None), *[("mpmath", 30)] * free_scene(scene)]
    for arithmetic, digits in ways:
        run = solve(scene, digits=digits, arithmetic=arithmetic, max_events=40)
        with truth.context():
            found = derivatives(run, truth)
            assert [one for one in found if not one.ratio <= 1] == []


def test_a_bound_without_growth():
    """A hundred events: the bounds grow like sums, not like products."""
    found = sensitivities(in_balls(named("four-thousand-events"), 20, 100))
    assert max(one.rad() for one in found.final.ravel()) < arb("1e-18") * max(abs(one) for one in found.final.ravel())


def test_derivatives_have_the_digits_that_are_asked_for():
    """Of a run with fewer they are those of another one."""
    final = sensitivities(in_balls(named("damping-heavy"), 15).but(digits=60)).final.ravel()
    assert max(one.rad() for one in final) < arb("1e-58") * max(abs(one) for one in final)


def test_names_and_shapes():
    force = Force([Piece(0, (1, 2), [Sine(1, 3)]), Piece(2, (), [Sine("0.1", 3)])])
    found = sensitivities(solve(Scene(PAIR, State(), 3, force=force, friction=Friction([(1, "0.08")]))))
    sines = [f"force[{k}].sines[0].{one}" for k in range(2) for one in ("amplitude", "omega", "phase")]
    assert found.wrt == (
        *("x1", "v1", "x2", "v2", "m1", "m2", "a2", "b", "a1", "until"),
        *("force[0].from", "force[0].polynomial[0]", "force[0].polynomial[1]", *sines[:3]),
        *("force[1].from", *sines[3:], "friction[0].from", "friction[0].b"),
    )
    assert found.y.shape[1:] == found.final.shape == (4, len(found.wrt))
    none = sensitivities(solve(FREE["stuck-for-ever"], digits=20, arithmetic="ball"))
    assert (none.t.shape, none.y.shape, none.t.dtype) == ((0, 9), (0, 4, 9), object)


def test_what_is_not_yet_there_and_what_does_nothing_are_exactly_0():
    scene = Scene(PAIR, State(), 1, force=Force.trapezoid(0, "0.2", "0.2", "0.2", "0.3") + Force.step(5, 1))
    found = sensitivities(in_balls(scene))
    zero = {name for k, name in enumerate(found.wrt) if all(one.is_zero() for one in found.final[:, k])}
    assert {"force[1].from", "force[4].from", "force[4].polynomial[0]"} <= zero
    assert "force[0].from" not in zero  # its slope begins there
    assert found.t[0][found.wrt.index("until")].is_zero()


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


def test_an_event_by_a_jump_moves_with_it():
    found = sensitivities(solve(Scene(PAIR, State(), 3, force=Force.step(1, "0.2"))))
    assert found.t[0].tolist() == [float(name == "force[0].from") for name in found.wrt]


@pytest.mark.parametrize("name", ["force[0].from", "friction[0].from"])
@pytest.mark.parametrize("height", ["0.2", "-0.2"])
def test_a_force_from_the_start_on_breaks_a_stick_towards_either_side(height, name):
    base = in_balls(Scene(PAIR, State(), 1, force=Force.step(0, height), friction=Friction([(0, "0.08")])))
    assert deviation(base, {name: Fraction(1)}, (1,)).size < 1e-50


def forgetful_guard(self, *given):
    by_state, _, rate = HONEST_GUARD(self, *given)
    return by_state, by_state @ given[-1], rate


def forgetful_numbers(word):
    """A motion that does not move with the numbers in whose names there is a word."""

    def over(self, *given):
        column, flow = self.column, self.flow
        self.column = {name: place for name, place in column.items() if word not in name}

        def forgetful(*parts):
            found, by_numbers = flow(*parts)
            return found, [(own, [k for k in at if k in self.column.values()]) for own, at in by_numbers]

        try:
            self.flow = forgetful
            return HONEST_OVER(self, *given)
        finally:
            self.column, self.flow = column, flow

    return over


HONEST_GUARD, HONEST_OVER = Variation.guard, Variation.over


@pytest.mark.parametrize(
    ("name", "owner", "part", "wrong"),
    [
        ("resonance-in-stick", Variation, "over", forgetful_numbers("sines")),
        ("friction-by-pieces", Chain, "_by_jumps", lambda *_: ()),
        ("stick", Variation, "guard", forgetful_guard),
        ("critical-slip", Variation, "over", forgetful_numbers("")),
    ],
)
def test_wrong_derivatives_are_found_out(monkeypatch, name, owner, part, wrong):
    """A sine that does not move with its frequency, a jump, an exit, and a motion that moves with its start alone."""
    assert compared(named(name)).size < 1e-50
    monkeypatch.setattr(owner, part, wrong)
    assert compared(named(name)).size > 1e-3
