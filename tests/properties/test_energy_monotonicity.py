"""Without a force the energy never grows: at any two times it falls by b times the slid distance and a1 int v1^2.

E' = -b |v1 - v2| - a1 v1^2, (8) of the paper with the damper that it leaves out. Each law is a function that answers
whether a run obeys it, and is seen to answer no: for another law, and under a force. The laws, and their tests:

  falls_by_friction   between any two times, of pairs of any size: test_between_any_two_times_...
  the ledger          with a damper, and with the work of a force, it closes: test_the_ledger_closes

That floats keep to them tests/every_number.py says.
"""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import driven_scenes, free_motions, magnitudes
from theory_values import energy_of, exact, start_of
from three_scenes import PAPER as SLIPS

from numerics import EventUndecided, Force, Law, Mode, OutOfRange, Pair, Scene, State, Trajectory, solve

pytestmark = pytest.mark.energy

parts = st.sets(st.integers(0, 1000), min_size=2, max_size=3).map(
    lambda some: [Fraction(n, 1000) for n in sorted(some)]
)
motions = st.one_of(free_motions(), free_motions(damped=True), free_motions(law=Law.THREE_VALUED_SGN))

DAMPED = SLIPS.replace(a1="0.4")
OVERDAMPED = Scene(Pair(1, 9000, 1, 1, 170_000), State("0.001", "0.5", 0, "0.00001"), until=900)


def in_balls(scene: Scene) -> Trajectory:
    """The run, up to its last event of so many; on a tie under a force nothing is said."""
    try:
        return solve(scene, digits=25, arithmetic="ball", max_events=40, max_digits=300)
    except EventUndecided:
        raise LeftOut from None


def times(run: Trajectory, shares: list[Fraction]) -> list[Fraction]:
    """The times at these shares of a run, exact."""
    with run.arithmetic.context():
        end = Fraction(float(run.end_time) * (1 - 2**-40))
    return [share * end for share in shares]


def falls_by_friction(
    run: Trajectory, begin: Fraction, end: Fraction, without: Mode | None = None, factor: Fraction = Fraction(1)
) -> bool:
    """Whether E falls by `factor` b times what is slid: exactly so without a damper, else by no less.

    In each mode x1 - x2 is monotone. A radius above 10^-12 of the largest energy, or of b x2, would mean little.
    """
    pair = run.scene.pair
    with run.arithmetic.context():
        events = [t for t in run.event_times if exact(begin) < t < exact(end)]
        states = [run.sol(t) for t in (begin, *events, end)]
        slid = [abs(x1 - x2 - (y1 - y2)) for (x1, _, x2, _), (y1, _, y2, _) in pairwise(states)]
        modes = [run.mode_at(begin), *map(run.mode_at, events)]
        path = sum((one for one, mode in zip(slid, modes, strict=True) if mode is not without), arb(0))
        friction, lost = exact(factor * pair.b) * path, energy_of(pair, states[0]) - energy_of(pair, states[-1])
        unit = energy_of(pair, start_of(run.scene)) + friction + exact(pair.b * abs(run.scene.initial.x2))
        sharp = bool((lost - friction).rad() <= unit * arb(10) ** -12)
        return sharp and (not lost < friction if pair.a1 else lost.overlaps(friction))


@reaching
@given(motions, parts)
@example(SLIPS, [Fraction(0), Fraction(1, 3), Fraction(1)])
def test_between_any_two_times_the_loss_is_b_times_the_slid_distance_and_what_a_damper_takes(scene, shares):
    run = in_balls(scene)
    for begin, end in pairwise(times(run, shares)):
        assert falls_by_friction(run, begin, end)


@reaching
@given(st.one_of(motions, driven_scenes()))
@example(DAMPED)
@example(OVERDAMPED)
def test_the_ledger_closes(scene):
    """E(0) + work - E is b times the slide and a1 int v1^2, by mode: none below 0, and no friction in stick."""
    run = in_balls(scene)
    try:
        ledger = run.ledger
    except OutOfRange:
        raise LeftOut from None
    with run.arithmetic.context():
        for one in run.segments:
            friction, viscous = one.losses()
            assert not friction < 0
            assert not viscous < 0
            assert friction.is_zero() == (one.mode is Mode.STICK)
        assert ledger.residual.contains(0)
        assert ledger.residual.rad() <= (ledger.initial + ledger.final + ledger.friction) * 1e-10
        assert ledger.final.overlaps(energy_of(scene.pair, run.final_state))
        if not scene.friction.steps:  # x1 - x2 is monotone from event to event
            slid = sum(map(abs, np.diff(run.y[0] - run.y[2])), arb(0))
            assert ledger.friction.overlaps(exact(scene.pair.b) * slid)


# each law is seen to fail


@given(magnitudes(-6, 0).map(lambda more: 1 + more))
def test_a_force_that_breaks_adhesion_raises_the_energy_of_a_pair_at_rest(times_held):
    """Control: what is refused without a force happens with one; its work is then what the pair has and has lost."""
    pair = SLIPS.pair
    held = pair.b * pair.mass / pair.m2
    run = in_balls(Scene(pair, State(), until=Fraction(1, 10), force=Force.step(0, held * times_held)))
    assert not falls_by_friction(run, *times(run, [Fraction(0), Fraction(1)]))
    with run.arithmetic.context():
        assert 0 < run.final_energy < run.ledger.work


@pytest.mark.parametrize(
    "wrong",
    [
        {"without": Mode.SLIP_PLUS},
        {"without": Mode.SLIP_MINUS},
        {"factor": Fraction(999_999, 10**6)},
        {"factor": Fraction(1_000_001, 10**6)},
    ],
)
def test_a_loss_without_one_mode_or_of_another_friction_is_found(wrong):
    run = in_balls(SLIPS)
    begin, end = times(run, [Fraction(1, 10**6), Fraction(1)])
    assert falls_by_friction(run, begin, end)
    assert not falls_by_friction(run, begin, end, **wrong)
