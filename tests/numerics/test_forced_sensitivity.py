"""Sensitivities under a force against differences of solves in balls, other arithmetics, and what is exact."""

import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from flint import arb
from forced_differences import deviation, everything, is_first_start, parameters
from hypothesis import given, settings
from reaching import LeftOut, reaching
from strategies import driven_scenes

from numerics import Force, Friction, Law, Pair, Piece, Scene, Sine, State, sensitivities, solve
from numerics.__main__ import main
from numerics.errors import NotDifferentiable, NumericsError
from numerics.scene.file import load_scene
from numerics.trajectory import variation
from numerics.trajectory.saltation import Chain
from numerics.trajectory.variation import Variation

SCENES = Path(__file__).parents[1] / "forced" / "scenes"
PAIR = Pair(1, 1, 200, "0.05")
STEP, DIGITS = Fraction(1, 10**18), 70
CORNERS = {
    "contact-to-third-order": "without a slope",
    "force-and-friction-jump-together": "which of them comes first",
    "friction-drops-at-contact": "a slip ends where a piece begins",
    "friction-jumps-onto-the-load-slips": "onto the edge",
    "jump-at-contact-reverses": "a slip ends where a piece begins",
    "jump-at-contact-slips-on": "a slip ends where a piece begins",
    "jump-at-contact-sticks": "a slip ends where a piece begins",
    "jump-at-exit-slips": "stick ends where a piece begins",
    "jump-at-exit-to-the-other-side": "stick ends where a piece begins",
    "load-crosses-to-third-order": "without a slope",
    "marginal-stick": "the motion of a slip as well",
    "marginal-stick-then-slip": "the motion of a slip as well",
    "tie-at-a-jump-at-contact-slips-on": "a slip ends where a piece begins",
    "tie-at-a-jump-at-contact-sticks": "a slip ends where a piece begins",
    "tie-by-first-derivative-slips": "stick ends where a piece begins",
    "tie-by-second-derivative-slips": "stick ends where a piece begins",
    "tie-by-third-derivative-slips": "stick ends where a piece begins",
    "tie-on-the-lower-edge": "stick ends where a piece begins",
    "touch-in-slip": "touch in a slip",
}
QUICK = (
    *("both-resonances", "constant-force", "contact-at-a-rational-time", "damping-critical-in-slip"),
    *("damping-critical-in-stick", "damping-heavy", "damping-nearly-critical-in-stick", "exit-at-a-rational-time"),
    *("friction-by-pieces", "friction-drops-in-stick", "friction-rises-in-slip", "jump-just-before-contact"),
    *("light-body-2", "many-causes", "mass-ratio-1e6", "polynomial-of-degree-8", "pulse-of-a-microsecond"),
    *("resonance-in-slip", "resonance-in-slip-damped", "resonance-in-stick", "near-resonance-in-stick"),
    *("sine-below-threshold", "sine-stick-slip", "sine-that-starts-late", "soft-spring", "strong-friction"),
    *("tie-at-the-start-of-a-moving-pair", "trapezoid", "two-incommensurate-sines"),
)
TIES = {
    "friction-jumps-onto-the-load-sticks": 1e-40,
    "jump-at-exit-holds": 1e-40,
    "load-touches-the-edge": 1e-20,
    "sine-at-threshold": 1e-20,
    "tie-by-first-derivative-sticks": 1e-40,
    "tie-by-second-derivative-sticks": 1e-20,
    "tie-by-third-derivative-sticks": 1e-8,
}
"""Scenes whose neighbours have other events: their derivatives exist, and differences tend to them more slowly."""
SLOW = {"sine-at-threshold"}
NEAREST = {
    **dict.fromkeys(("jump-just-after-contact", "jump-just-before-contact"), Fraction(1, 10**44)),
    **dict.fromkeys(("reversal-just-before-contact", "sine-barely-below-threshold"), Fraction(1, 10**44)),
    "sine-barely-above-threshold": Fraction(1, 10**70),
}
"""Scenes so near to a tie that only nearer neighbours have the same events."""
LONG = {
    *("load-touches-to-fourth-order", "tie-at-the-start-fourth-derivative-slips"),
    *("tie-at-the-start-fourth-derivative-sticks", "touches-at-irrational-times"),
}
"""Differences tend to the derivative like the fourth root of the step, and neighbours so near to a tie take too many
steps; and a scene that no digits decide."""


def named(name):
    return load_scene(SCENES / f"{name}.toml")


def in_balls(scene, digits=DIGITS, most=40):
    return solve(scene, arithmetic="ball", digits=digits, max_events=most)


@pytest.mark.parametrize("name", QUICK)
def test_differences_of_solves(name):
    """All numbers of a scene moved at once; events, states and times up to the horizon, or the first forty events."""
    base = in_balls(named(name))
    found = deviation(base, everything(base), DIGITS, STEP)
    assert found.events_compared
    assert found.size < 1e-37, found


@pytest.mark.parametrize(
    "name", [*sorted(set(TIES) - SLOW), *(pytest.param(one, marks=pytest.mark.long) for one in SLOW)]
)
def test_ties_that_leave_derivatives(name):
    base = in_balls(named(name))
    found = deviation(base, everything(base), DIGITS, STEP)
    assert not found.events_compared
    assert found.size < TIES[name], found


@pytest.mark.long
@pytest.mark.parametrize("name", sorted({one.stem for one in SCENES.glob("*.toml")} - {*CORNERS, *TIES, *LONG}))
def test_differences_by_each_number(name):
    step = NEAREST.get(name, STEP)
    digits = DIGITS if step == STEP else 230
    base = in_balls(named(name), digits, 6)
    names = list(parameters(base.scene))
    for one in names[:: 1 + len(names) // 12]:
        found = deviation(base, {one: Fraction(1)}, digits, step)
        # from v1 = v2 differences on both sides have different second derivatives; a start has one side, or a tie
        slow = one in {"v1", "v2"} or is_first_start(base.scene, one) or not found.events_compared
        assert found.size < (1e-7 if slow else 1e-20), (one, found)


@pytest.mark.parametrize("name", CORNERS)
@pytest.mark.parametrize("arithmetic", ["float64", "mpmath", "ball"])
def test_a_corner_is_refused_in_one_line(name, arithmetic):
    try:
        trajectory = solve(named(name), arithmetic=arithmetic)
    except NumericsError:
        assert arithmetic != "ball"  # next to a tie numbers without bounds do not decide
        return
    with pytest.raises(NotDifferentiable, match=CORNERS[name]) as refused:
        sensitivities(trajectory)
    assert str(refused.value).isprintable()


def test_a_run_that_ends_before_a_corner_has_derivatives():
    scene = named("touch-in-slip")
    assert sensitivities(solve(Scene(scene.pair, scene.initial, "0.5", force=scene.force))).final.shape == (4, 15)


def test_a_contact_on_the_horizon_is_a_corner():
    scene = Scene(Pair(1, 1, 1, 1), State(0, 2, 0, 0), 1, force=Force([Piece(0, (0, 2, "-0.5"))]))
    assert solve(scene, arithmetic="ball").events == ()
    with pytest.raises(NotDifferentiable, match="on the horizon"):
        sensitivities(solve(scene, arithmetic="ball"))


@reaching
@given(driven_scenes())
@settings(max_examples=8)
def test_differences_of_random_solves(scene):
    try:
        base = in_balls(scene)
        found = deviation(base, everything(base), DIGITS, STEP)
    except NumericsError:  # the scene, or a neighbour, sits on a tie
        raise LeftOut from None
    assert found.size < (1e-25 if found.events_compared else 1e-3), found


@reaching
@given(driven_scenes())
@settings(max_examples=10)
def test_neighbours_never_move_apart(scene):
    """In N of (x1, v1, v2) the flow contracts, whatever the force does."""
    try:
        final = sensitivities(in_balls(scene, 15, 60)).final
    except NumericsError:
        raise LeftOut from None
    weights = np.sqrt([float(scene.pair.a2), float(scene.pair.m1), float(scene.pair.m2)])
    jacobian = np.array([[float(final[i, j].mid()) for j in (0, 1, 3)] for i in (0, 1, 3)])
    assert np.linalg.norm(weights[:, None] * jacobian / weights, 2) <= 1 + 1e-9


def every(found):
    return np.concatenate([np.ravel(array) for array in (found.t, found.y, found.final, found.energy)])


@pytest.mark.parametrize("name", ["damping-heavy", "friction-by-pieces", "resonance-in-slip", "trapezoid"])
def test_balls_contain_the_derivatives_and_points_are_close(name):
    low, high = (in_balls(named(name), digits) for digits in (15, 60))
    points, floats = (
        solve(named(name), arithmetic="mpmath", digits=30, max_events=40),
        solve(named(name), max_events=40),
    )
    wide, narrow, middle, floats = (every(sensitivities(one)) for one in (low, high, points, floats))
    with high.arithmetic.context():
        assert all(one.overlaps(two) for one, two in zip(wide, narrow, strict=True))
        assert max(one.rad() for one in wide) < arb("1e-13") * max(abs(one) for one in narrow)
        true = np.array([float(one.mid()) for one in narrow]).reshape(-1, len(parameters(named(name))))
        largest = np.abs(true).max(axis=0) + 1e-30
        for ours, digits in ((middle, 1e-15), (floats, 4e-16)):
            assert (np.abs(ours.astype(float).reshape(true.shape) - true) <= digits * largest).all()


def test_a_bound_without_growth():
    """A hundred events: the bounds grow like sums, not like products."""
    found = sensitivities(in_balls(named("four-thousand-events"), 20, 100))
    assert max(one.rad() for one in found.final.ravel()) < arb("1e-18") * max(abs(one) for one in found.final.ravel())


def test_names_and_shapes():
    force = Force([Piece(0, (1, 2), [Sine(1, 3)]), Piece(2, (), [Sine("0.1", 3), Sine("0.2", 4, 1)])])
    scene = Scene(PAIR, State(), 3, force=force, friction=Friction([(1, "0.08")]))
    found = sensitivities(solve(scene))
    sines = [f"force[1].sines[{k}].{one}" for k in range(2) for one in ("amplitude", "omega", "phase")]
    assert found.wrt == (
        *("x1", "v1", "x2", "v2", "m1", "m2", "a2", "b", "a1", "until"),
        *("force[0].from", "force[0].polynomial[0]", "force[0].polynomial[1]"),
        *("force[0].sines[0].amplitude", "force[0].sines[0].omega", "force[0].sines[0].phase"),
        *("force[1].from", *sines, "friction[0].from", "friction[0].b"),
    )
    assert found.final.shape == (4, len(found.wrt))
    assert found.energy.shape == (len(found.wrt),)
    assert found.y.shape == (len(solve(scene).events), 4, len(found.wrt))


def test_what_is_not_yet_there_and_what_does_nothing_are_exactly_0():
    scene = Scene(PAIR, State(), 1, force=Force.trapezoid(0, "0.2", "0.2", "0.2", "0.3") + Force.step(5, 1))
    found = sensitivities(in_balls(scene))
    zero = {name for k, name in enumerate(found.wrt) if all(one.is_zero() for one in found.final[:, k])}
    assert {"force[1].from", "force[4].from", "force[4].polynomial[0]"} <= zero
    assert "force[0].from" not in zero  # its slope begins there
    event = found.t[0]
    assert event[found.wrt.index("until")].is_zero()


def test_an_event_by_a_jump_moves_with_it():
    found = sensitivities(solve(Scene(PAIR, State(), 3, force=Force.step(1, "0.2"))))
    assert found.t[0].tolist() == [float(name == "force[0].from") for name in found.wrt]


def test_a_jump_kept_in_stick_and_the_literal_law():
    """Under the literal law a pair with v1 = v2 sticks: its motion is that of one body, by hand."""
    pair, x = Pair(1, 3, 4, "0.05"), np.cos(0.5)
    scene = Scene(pair, State(), 1, Law.THREE_VALUED_SGN, force=Force.step("0.5", 8))
    found = sensitivities(solve(scene))
    height, start = (found.wrt.index(name) for name in ("force[0].polynomial[0]", "force[0].from"))
    assert found.final[0, height] == pytest.approx((1 - x) / 4)
    assert found.final[0, start] == pytest.approx(-8 * np.sin(0.5) / 4)
    assert found.final[1, start] == pytest.approx(-8 * x / 4)


def test_resonance_has_its_derivative_by_the_frequency():
    """M x'' + a2 x = U sin(Omega t) in stick, differentiated by omega at omega = Omega by hand."""
    scene = Scene(Pair(1, 3, 4, 1000), State(), 2, force=Force.sine(1, 1))
    found = sensitivities(solve(scene))
    # x = (sin t - t cos t)/8; by omega: the answer from rest to t cos t, which is (t sin t - t^2 cos t ... )/16
    t, s, c = 2.0, np.sin(2.0), np.cos(2.0)
    by_omega = (t * t * s + t * c - s) / 16
    assert found.final[0, found.wrt.index("force[0].sines[0].omega")] == pytest.approx(by_omega, rel=1e-13)


def test_wrong_derivatives_are_found_out(monkeypatch):
    base = in_balls(named("resonance-in-stick"))
    omega = {"force[0].sines[0].omega": Fraction(1)}
    assert deviation(base, omega, DIGITS, STEP).size < 1e-35
    with monkeypatch.context() as patch:
        honest = variation._sine
        patch.setattr(variation, "_sine", lambda *given: honest(*given)._replace(by={}))
        assert deviation(base, omega, DIGITS, STEP).size > 1e-3
    base = in_balls(named("friction-by-pieces"))
    with monkeypatch.context() as patch:
        patch.setattr(Chain, "_jumps", lambda *_: {})
        assert deviation(base, everything(base), DIGITS, STEP).size > 1e-3
    with monkeypatch.context() as patch:
        guard = Variation.guard
        patch.setattr(Variation, "guard", lambda *given: (*guard(*given)[:2], 2 * guard(*given)[2]))
        assert deviation(base, everything(base), DIGITS, STEP).size > 1e-3


def test_the_command_line_says_them(tmp_path, capsys):
    path = str(SCENES / "trapezoid.toml")
    for arithmetic in ("ball", "float64"):
        assert main(["solve", path, "--sensitivity", "--json", "--arithmetic", arithmetic]) == 0
        record = json.loads(capsys.readouterr().out)
        truth = sensitivities(in_balls(load_scene(path)))
        by = truth.wrt.index("force[2].from")
        ours = record["final"]["sensitivity"]["x1"]["force[2].from"]
        assert float(ours) == pytest.approx(float(truth.final[0, by].mid()), rel=1e-10)
        assert set(record["events"][0]["sensitivity"]) == {"t", "x1", "v1", "x2", "v2"}
    assert main(["solve", path, "--sensitivity"]) == 0
    assert "by force[0].polynomial[1]" in capsys.readouterr().out
    assert main(["solve", path, "--sensitivity", "--npz", str(tmp_path / "found.npz")]) == 0
    assert "force[0].from" in np.load(tmp_path / "found.npz")["sensitivity_wrt"]
    capsys.readouterr()
    assert main(["solve", str(SCENES / "touch-in-slip.toml"), "--sensitivity"]) == 1
    assert capsys.readouterr().err.count("\n") == 1
