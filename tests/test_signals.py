"""Scenes of all five signals in balls: ties, long sticks."""

import pytest
from inclusion import overlap

from numerics import Force, Pair, Piece, Scene, Sine, State, solve
from numerics.trajectory.status import Status


def run(scene, digits=30):
    return solve(scene, arithmetic="ball", digits=digits)


ON_GROUND, WITHOUT = Pair(1, "inf", 0, 1, b_static="1.5"), Pair(1, 2, 0, 0)


@pytest.mark.parametrize(
    ("pair", "v", "piece", "mode"),
    [
        *[(ON_GROUND, 0, [pulls], mode) for pulls, mode in ((["1.5"], 0), (["1.5", 1], 1), (["1.5", -1], 0), ([2], 1))],
        *[(WITHOUT, 1, [load], mode) for load, mode in (((), 0), ((0, 1), 1), ((0, -1), -1), ((0, 0, -1), -1))],
        *[
            (Pair(1, 1, 0, "0.01"), 0, [(), [Sine(1, 1, at)]], mode)
            for at, mode in (("1/3", 1), ("-1/3", -1), (-7, -1))
        ],
    ],
)
def test_a_tie_is_decided_by_the_first_derivative_of_the_load_and_a_sine_by_its_phase(pair, v, piece, mode):
    """At static friction, without friction, and from rest."""
    until = 1 if len(piece) == 1 else "0.01"
    assert run(Scene(pair, State(v1=v, v2=v), until, force=Force([Piece(0, *piece)]))).signs == [mode]


def test_long_sticks_on_a_belt_and_under_every_signal_are_gone_through_at_once():
    still = Scene(Pair(1, "inf", 30, 1, "0.1", b_static="1.6"), State("0.01", "0.1"), 10**9)
    assert run(still).status is Status.STUCK_FOR_EVER
    wall, pull = Force([Piece(0, (), [Sine("0.01", 40)])]), Force([Piece(0, (1,), [Sine("0.1", 3)])])
    shaken = Scene(Pair(1, 2, 30, 1, "0.1"), State("0.01", "0.1"), 10**6, force_2=pull, wall=wall)
    assert overlap(run(shaken, 40), run(shaken, 80))
