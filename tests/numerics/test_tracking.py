"""References that body 2 is to follow: the force against the independent reference, and what friction cannot do."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from control_scenes import DAMPED, FREE, referred
from flint import arb

from numerics import Force, Friction, InvalidScene, Pair, Piece, Scene, Sine, State, solve
from numerics.arithmetic.ball import Ball
from numerics.control.tracking import track
from numerics.scene.file import load_reference
from numerics.scene.largest import largest_size, over

REFERENCES = {path.stem: load_reference(path) for path in (Path(__file__).parents[1] / "references").glob("*.toml")}


@pytest.mark.parametrize("pair", [FREE, DAMPED])
@pytest.mark.parametrize("name", ["s-curve", "wave"])
def test_body_2_follows_by_the_reference(pair, name):
    reference = REFERENCES[name]
    found = track(Scene(pair, State(x1="0.002", x2="0.25"), 3), reference)
    run = referred(found.scene)
    assert not run.events
    with Ball(36).context():
        goal = over(reference[-1])(arb(3))
        assert abs(run.x2 - goal) < arb(10) ** -30


def test_one_minus_a_cosine_is_followed_though_its_phase_is_rounded():
    path = Force([Piece(0, ["0.004"], [Sine("0.004", 6, "-1.5707963267948966")])])
    found = track(Scene(FREE, State(), 2), path)
    with Ball(40).context():
        missed = abs(solve(found.scene, digits=30).final.x2 - over(path.pieces[0])(arb(2)))
        assert 0 < missed < found.force_error / float(FREE.m1 * FREE.a2) ** 0.5 < 1e-18
    with pytest.raises(InvalidScene, match="r' jumps from 0 to"):
        track(Scene(FREE, State(), 2), Force([Piece(0, ["0.004"], [Sine("0.004", 6, "-1.5707963267")])]))


def test_a_reference_of_a_sine_takes_no_longer_for_a_long_horizon():
    """It grew with the number of its periods; the largest acceleration is in the second half of each."""
    path = Force.sine("2e-7", 1000) + Force.sine("5e-8", 2000, "1.5707963267948966")
    found = track(Scene(FREE, State(v1="2e-4", x2="5e-8", v2="2e-4"), 10**6), path)
    assert float(found.share) == pytest.approx(float(FREE.m2 * Fraction("0.4") / FREE.b), rel=1e-12)


def test_what_asks_too_much_is_named_piece_by_piece_with_how_much():
    """Pieces of the reference, and of a friction that falls in time."""
    found = track(Scene(FREE, State(), 2), REFERENCES["too-fast-in-the-end"])
    assert found.scene is None
    assert [one.possible for one in found.demands] == [True, False]
    assert found.demands[1].force.overlaps(Ball.number(Fraction(6, 5)))
    falls = Scene(FREE, State(), 2, friction=Friction([(1, "0.1")]))
    demands = track(falls, (Piece(0, [0, 0, "0.1"]),)).demands
    assert [(one.start, one.possible) for one in demands] == [(0, True), (1, False)]


@pytest.mark.parametrize("digits", [1, 15, 31])
@pytest.mark.parametrize(("name", "excess"), [("a-little-too-fast", "2e-30"), ("a-swing-too-fast", "25e-8")])
def test_how_much_is_too_much_is_known_to_the_digits_asked_for_however_little_it_is(name, excess, digits):
    found = track(Scene(FREE, State(), 4), REFERENCES[name], digits=digits).demands[0]
    with Ball(100).context():
        true = Ball.number(Fraction(excess))
        assert not found.possible
        assert found.too_much.overlaps(true)
        assert abs(found.too_much - true) < true / 10**digits


LIMITS = """
swing     4 | 0.5                            | possible
swing     4 | 0.49999999999999999999         | too much
bump      1 | 4/27                           | possible
bump      1 | 0.1481481481481481481481481481 | too much
two-sines 7 | 0.6                            | possible
two-sines 7 | 0.5                            | too much
"""
"""References and how long they last (s); b; what it says."""


@pytest.mark.parametrize("row", LIMITS.strip().splitlines())
def test_the_limit_itself_can_be_followed_and_no_more(row):
    asked, b, said = row.split(" | ")
    name, until = asked.split()
    found = track(Scene(Pair(1, 1, 200, b), State(), until), REFERENCES[name], digits=25)
    assert (found.scene is not None) == (said == "possible")
    if name == "two-sines":
        assert float(found.demands[0].force) == pytest.approx(0.528, abs=1e-3)
    else:
        assert found.is_at_limit


@pytest.mark.parametrize(
    ("pair", "amplitude", "omega", "error", "sticks"),
    [
        (FREE, "0.5", 1, 0, True),
        (DAMPED, "0.4", 1, 4.8e-59, True),
        (DAMPED, "0.5", 1, 6e-59, False),
        (DAMPED, "0.1", 2, 2.4e-59, True),
    ],
)
def test_rounded_phases_of_a_damped_pair_change_the_force_and_may_let_it_slip_at_the_limit(
    pair, amplitude, omega, error, sticks
):
    """By at most a1 omega A until 10^-59, N s."""
    found = track(Scene(pair, State(), 4), (Piece(0, [0, -omega * Fraction(amplitude)], [Sine(amplitude, omega)]),))
    assert (found.force_error, found.sticks) == (pytest.approx(error, rel=1e-9, abs=0), sticks)


def test_the_largest_size_is_seen_where_a_function_is_flat_in_the_middle_of_a_part():
    """t (1 - t) (4t - 1)^3 (4t - 3)^3: f, f' and f'' are 0 at both quarters, f is 0 at both ends."""
    t = np.polynomial.Polynomial([0, 1])
    terms = (t * (1 - t) * (4 * t - 1) ** 3 * (4 * t - 3) ** 3).coef
    f = over(Piece(0, [round(c) for c in terms]))
    assert largest_size(f, arb(0), arb(1), 6)[0] >= abs(f(arb("0.05")))
