"""The engine in balls: ties decided exactly, and what is moved by a little must be noticed."""

from fractions import Fraction

import pytest
from enclosed_runs import EVEN, ONE_ANSWER, VANISHES, numbers, run, same, under
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_runs import moved
from reaching import LeftOut, reaching
from strategies import driven_scenes, scenes, weakened_scenes

from numerics import (
    EventUndecided,
    InvalidScene,
    OutOfRange,
    Pair,
    Scene,
    State,
    Weakening,
)
from numerics.arithmetic.ball import Ball
from numerics.control.orbit import Box
from numerics.linear.enclosed import EnclosedRun


@pytest.mark.long  # tests/test_signals.py asks the same of fewer scenes
@reaching
@settings(max_examples=40)
@given(driven_scenes() | scenes(damped=None) | weakened_scenes(), st.tuples(*[st.sampled_from([-1, 1])] * 3), st.data())
def test_who_starts_within_a_box_stays_in_what_is_said_of_it(scene, corner, data):
    """From its corners."""
    width, rate = float(scene.pair.half_width), float(scene.pair.a2 / scene.pair.mass) ** 0.5
    by = Fraction(width * min(1, rate)) / data.draw(st.sampled_from([10**3, 10**5, 10**8]))
    x1, v1, x2, v2 = (by * one for one in (*corner, -corner[1]))
    try:
        wide = run(scene, 40, 8, lambda digits: Box(digits, Ball.number(by)))
        if wide.rows[0].order or not any((scene.initial.x1, scene.initial.v1, scene.initial.v2)):
            raise LeftOut  # a tie, or a jump while it rests, decided on exact data: its neighbours are none
        other = moved(scene, (x1, v1, x2, v2 if wide.rows[0].mode else v1))
        assert same((scene, wide), (other, run(other, 60, 8)))
    except (EventUndecided, OutOfRange, InvalidScene):
        raise LeftOut from None


def test_a_stick_that_has_died_away_keeps_its_digits():
    scene = Scene(Pair(m1=2, m2=1, a2=12, b=1, a1=100), State(x1="0.01"), 900)
    end = run(scene).end
    assert abs(end.x1) < arb("1e-40")
    assert end.x1.rad() < abs(end.x1) * arb("1e-25")


NO_ANSWER = {
    "friction that vanishes at a place": (under(EVEN, "1.19", (0, "0.6"), VANISHES), (3 * 10**17, 0, 0, 0)),
    "friction that vanishes at a speed": (under(EVEN, "1.6", (0, "0.1"), Weakening((), -1), 1), (0, 2 * 10**17, 0, 0)),
    "a speed that nearly comes to a knot": (
        under(EVEN, 1, (0, "0.84775"), Weakening([(1, "0.5")], -1), "2.1", -2),
        (0, 2 * 10**17, 0, 0),
    ),
    "a place that nearly comes to a knot": (
        under(EVEN, 3, (0, 1), Weakening((), 0, [("1.0007", 0), (2, 9)])),
        (0, 0, -(10**17), 0),
    ),
}
"""The same, with starts that go on in another way, so that there is no answer for both."""


@pytest.fixture(params=["bounds", "balls"])
def for_both(request, monkeypatch):
    """An answer that is told how far off its start may be, by planted bounds or by balls."""

    def answer(scene, off):
        if request.param == "balls":
            return run(scene, arithmetic=lambda digits: Box(digits, Ball.number(max(map(abs, off)))))
        with monkeypatch.context() as patch:
            begin = EnclosedRun.begin

            def planted(path, knot):
                at, (x1, v1, x2, v2) = begin(path, knot), map(Ball.number, off)
                norm = path.flow(at).norm.of((x1, v1, x2, v2))
                return at._replace(norm=norm, far=abs(x1).upper(), place=abs(x1 - x2).upper())

            patch.setattr(EnclosedRun, "begin", planted)
            return run(scene)

    answer.is_sharp = request.param == "bounds"
    return answer


@pytest.mark.parametrize("name", ONE_ANSWER)
def test_one_answer_for_all_that_start_as_near_is_that_of_a_neighbour(for_both, name):
    """And not much more. @example of a found fault: an event's x2 off by less than a slower body 2 had gone."""
    scene, off = ONE_ANSWER[name]
    off = [Fraction(one, 10**20) for one in off]
    neighbour = run(moved(scene, off), 60)
    try:
        found = for_both(scene, [one * Fraction(10_001, 10_000) for one in off])
    except EventUndecided:
        assert not for_both.is_sharp  # balls of one radius reach further
        return
    assert same((scene, found), (scene, neighbour))
    ends = zip(*(numbers(scene, one.end)[1:] for one in (found, neighbour)), strict=True)
    assert not for_both.is_sharp or max(abs(b - a.mid()) / a.rad() for a, b in ends) > 0.5


@pytest.mark.parametrize("name", NO_ANSWER)
def test_no_answer_is_given_for_neighbours_that_go_on_in_another_way(for_both, name):
    scene, off = NO_ANSWER[name]
    with pytest.raises(EventUndecided):
        for_both(scene, [Fraction(one, 10**20) for one in off])
    assert for_both(scene, [Fraction(one, 10**26) for one in off]).rows
