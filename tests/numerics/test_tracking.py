"""References that body 2 is to follow: the force against the independent reference, and what friction cannot do."""

from fractions import Fraction

import pytest
from control_scenes import DAMPED, FREE, referred
from flint import arb

from numerics import Friction, Pair, Piece, Scene, Sine, State
from numerics.arithmetic.ball import Ball
from numerics.control.tracking import track
from numerics.scene.largest import over

S_CURVE = (Piece(0, ["0.25", 0, "0.1"]), Piece(1, ["0.35", "0.2", 0, "-0.01"]), Piece(2, ["0.54", "0.17", "-0.03"]))


WAVE = (Piece(0, ["0.25", "-0.03"], [Sine("0.01", 3)]),)


@pytest.mark.parametrize(("pair", "reference"), [(FREE, S_CURVE), (DAMPED, S_CURVE), (FREE, WAVE), (DAMPED, WAVE)])
def test_body_2_follows_by_the_reference(pair, reference):
    found = track(Scene(pair, State(x1="0.002", x2="0.25"), 3), reference)
    run = referred(found.scene)
    assert not run.events
    with Ball(36).context():
        goal = over(reference[-1])(arb(3))
        assert abs(run.x2 - goal) < arb(10) ** -30


def test_what_asks_too_much_is_named_piece_by_piece_with_how_much():
    """Pieces of the reference, and of a friction that falls in time."""
    found = track(Scene(FREE, State(), 2), (Piece(0, [0, 0, "0.2"]), Piece(1, ["0.2", "0.4", 0, "-0.2"])))
    assert found.scene is None
    assert [one.possible for one in found.demands] == [True, False]
    assert found.demands[1].force.overlaps(Ball.number(Fraction(6, 5)))
    falls = Scene(FREE, State(), 2, friction=Friction([(1, "0.1")]))
    demands = track(falls, (Piece(0, [0, 0, "0.1"]),)).demands
    assert [(one.start, one.possible) for one in demands] == [(0, True), (1, False)]


@pytest.mark.parametrize("digits", [1, 15, 31])
@pytest.mark.parametrize(
    ("reference", "excess"),
    [
        ((Piece(0, [0, 0, "0.250000000000000000000000000001"]),), Fraction(2, 10**30)),
        ((Piece(0, [0, "-0.50000025"], [Sine("0.50000025", 1)]),), Fraction(25, 10**8)),
    ],
)
def test_how_much_is_too_much_is_known_to_the_digits_asked_for_however_little_it_is(reference, excess, digits):
    found = track(Scene(FREE, State(), 4), reference, digits=digits).demands[0]
    with Ball(100).context():
        true = Ball.number(excess)
        assert not found.possible
        assert found.too_much.overlaps(true)
        assert abs(found.too_much - true) < true / 10**digits


BUMP = (Piece(0, [0, 0, 0, "1/6", "-1/6", "1/20"]),)
"""r'' = t (1 - t)^2 is largest, 4/27, at t = 1/3, where it turns back."""
TWO_SINES = (Piece(0, [0, "-0.45"], [Sine("0.3", 1), Sine("0.075", 2)]),)
"""r'' = -0.3 sin t - 0.3 sin 2t gets to 0.528: each sine alone, and the parabola beside them, is within b."""


@pytest.mark.parametrize(
    ("reference", "until", "b", "possible"),
    [
        ((Piece(0, [0, "-0.5"], [Sine("0.5", 1)]),), 4, "0.5", True),
        ((Piece(0, [0, "-0.5"], [Sine("0.5", 1)]),), 4, "0.49999999999999999999", False),
        (BUMP, 1, "4/27", True),
        (BUMP, 1, "0.1481481481481481481481481481", False),
        (TWO_SINES, 7, "0.5", False),
        (TWO_SINES, 7, "0.6", True),
    ],
)
def test_the_limit_itself_can_be_followed_and_no_more(reference, until, b, possible):
    found = track(Scene(Pair(1, 1, 200, b), State(), until), reference, digits=25)
    assert (found.scene is not None) == possible
    if reference is TWO_SINES:
        assert float(found.demands[0].force) == pytest.approx(0.528, abs=1e-3)
    else:
        assert found.is_at_limit


@pytest.mark.parametrize(
    ("pair", "amplitude", "error", "sticks"),
    [(FREE, "0.5", 0, True), (DAMPED, "0.4", 4.8e-59, True), (DAMPED, "0.5", 6e-59, False)],
)
def test_rounded_phases_of_a_damped_pair_change_the_force_and_may_let_it_slip_at_the_limit(
    pair, amplitude, error, sticks
):
    """By at most a1 omega A until 10^-59, N s."""
    found = track(Scene(pair, State(), 4), (Piece(0, [0, f"-{amplitude}"], [Sine(amplitude, 1)]),))
    assert (found.force_error, found.sticks) == (pytest.approx(error, rel=1e-9, abs=0), sticks)
