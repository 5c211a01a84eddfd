"""Without a force the energy never grows: at any two times it falls by b times the slid distance and a1 int v1^2.

E' = -b |v1 - v2| - a1 v1^2, (8) of the paper with the damper that it leaves out. Each law is a function that answers
whether a run obeys it, and is seen to answer no: for another law, and under a force. The laws, and their tests:

  falls_by_friction   between any two times, of pairs of any size: test_between_any_two_times_...
  has_rate            at any time, events included: test_the_rate_is_that_of_friction_and_damper
  in stick            nothing is lost without a damper: test_a_stick_without_a_damper_keeps_the_energy
  in float64          the same within the bounds that it states; and with the work of a force the ledger closes
"""

from fractions import Fraction
from functools import reduce
from itertools import pairwise

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import driven_scenes, free_motions, magnitudes
from theory_values import energy_of, exact, of_pair, start_of

from numerics import EventUndecided, Force, Law, Mode, OutOfRange, Pair, Scene, State, Trajectory, solve
from theory.energy import slip_rate, stick_rate

pytestmark = pytest.mark.energy

EVENTS = 40
TIGHT = arb(10) ** -12
"""The radius of an energy in balls, in parts of the largest energy, above which a comparison would mean little."""
parts = st.sets(st.integers(0, 1000), min_size=2, max_size=3).map(
    lambda some: [Fraction(n, 1000) for n in sorted(some)]
)
motions = st.one_of(free_motions(), free_motions(damped=True), free_motions(law=Law.THREE_VALUED_SGN))

SLIPS = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=3)
DAMPED = Scene(Pair(1, 1, 200, "0.5", "0.4"), State(v1="0.15"), until=3)
OVERDAMPED = Scene(Pair(1, 9000, 1, 1, 170_000), State("0.001", "0.5", 0, "0.00001"), until=900)
LONG = Scene(Pair(1, 1, 200, "0.05", "0.01"), State(v1="0.15"), until=7)
"""Sticks that end by the load, long before the run does."""


def in_balls(scene: Scene) -> Trajectory:
    """The run, up to its last event of so many; on a tie under a force nothing is said."""
    try:
        return solve(scene, digits=25, arithmetic="ball", max_events=EVENTS, max_digits=300)
    except EventUndecided:
        raise LeftOut from None


def times(run: Trajectory, shares: list[Fraction]) -> list[Fraction]:
    """The times at these shares of a run, exact."""
    with run.arithmetic.context():
        end = Fraction(float(run.end_time) * (1 - 2**-40))
    return [share * end for share in shares]


def path(run: Trajectory, begin: Fraction, end: Fraction, modes: tuple[Mode, ...] = tuple(Mode)) -> arb:
    """What the bodies slide on each other between two times in some modes, m; in each mode x1 - x2 is monotone."""
    events = [t for t in run.event_times if exact(begin) < t < exact(end)]
    places = [x1 - x2 for x1, _, x2, _ in map(run.sol, (begin, *events, end))]
    passed = [run.mode_at(begin), *(run.mode_at(t) for t in events)]
    slid = [abs(there - here) for (here, there), mode in zip(pairwise(places), passed, strict=True) if mode in modes]
    return sum(slid, arb(0))


def falls_by_friction(
    run: Trajectory,
    begin: Fraction,
    end: Fraction,
    modes: tuple[Mode, ...] = tuple(Mode),
    factor: Fraction = Fraction(1),
) -> bool:
    """Whether E falls by `factor` b times what is slid in some modes: exactly so without a damper, else by no less."""
    pair = run.scene.pair
    with run.arithmetic.context():
        first, last = (energy_of(pair, run.sol(t)) for t in (begin, end))
        friction = exact(factor * pair.b) * path(run, begin, end, modes)
        lost, unit = first - last, energy_of(pair, start_of(run.scene)) + friction
        sharp = bool((lost - friction).rad() <= unit * TIGHT)
        return sharp and (not lost < friction if pair.a1 else lost.overlaps(friction))


def has_rate(run: Trajectory, t: Fraction, damper: bool = True) -> bool:
    """Whether E changes about a time as theory's rates say, a slip's where the bodies move on each other.

    By the mean value theorem the mean rate over a short time is one of those in it: E is continuously differentiable,
    events included. `damper`: with the term -a1 v1^2. Within a 10^-9 of the shortest time constant a rate changes by at
    most 0.4 % of E(0) over that time constant where E(0) > 10^-6 E_cr, as it is in all starts drawn.
    """
    pair = run.scene.pair
    fastest = max(float(pair.a2 / min(pair.m1, pair.m2)) ** 0.5, float(pair.a1 / pair.m1))
    short = Fraction(1, 10**9) / Fraction(fastest)
    with run.arithmetic.context():
        later = exact(t) + exact(short)
        ends = [run.sol(one) for one in (t, t + short)]
        x1, v1, _, v2 = run.sol(exact(t) + arb(0).union(later - exact(t)))
        state = {"x1": x1, "v1": v1, "v2": v2} | ({} if damper else {"a1": 0})
        mean = (energy_of(pair, ends[1]) - energy_of(pair, ends[0])) / exact(short)
        modes = {run.mode_at(t), run.mode_at(t + short)}
        if modes == {Mode.STICK}:
            rate = of_pair(stick_rate(), pair, **state)
        else:  # v1 - v2 is next to 0 where the mode changes
            signs = {one.sign for one in modes if one is not Mode.STICK}
            rate = reduce(arb.union, [of_pair(slip_rate(one), pair, **state) for one in signs])
        unit = energy_of(pair, start_of(run.scene)) / exact(short)
        return bool((mean - rate).rad() <= unit * arb(10) ** -11) and (mean - rate).contains(0)


@reaching
@given(motions, parts)
@example(SLIPS, [Fraction(0), Fraction(1, 3), Fraction(1)])
def test_between_any_two_times_the_loss_is_b_times_the_slid_distance_and_what_a_damper_takes(scene, shares):
    run = in_balls(scene)
    for begin, end in pairwise(times(run, shares)):
        assert falls_by_friction(run, begin, end)


@reaching
@given(motions, st.integers(0, 999).map(lambda n: Fraction(n, 1000)))
@example(DAMPED, Fraction(1, 7))
@example(OVERDAMPED, Fraction(0))  # m1/a1 = 6e-6 s beside sqrt(m1/a2) = 1 s
def test_the_rate_is_that_of_friction_and_damper(scene, share):
    run = in_balls(scene)
    assert has_rate(run, *times(run, [share]))


@reaching
@given(free_motions())
def test_a_stick_without_a_damper_keeps_the_energy(scene):
    run = in_balls(scene)
    sticks = [one for one in run.segments if one.mode is Mode.STICK]
    if not sticks:
        raise LeftOut
    with run.arithmetic.context():
        unit = energy_of(scene.pair, start_of(scene)) * TIGHT
        for one in sticks:
            first, *later = (energy_of(scene.pair, one.state(one.length * k / 4)) for k in range(5))
            assert all(two.overlaps(first) and (two - first).rad() <= unit for two in later)
            assert all(loss.is_zero() for loss in one.losses())


@reaching
@given(motions, parts)
@example(LONG, [Fraction(1)])
def test_in_float64_energies_and_losses_are_within_their_bounds(scene, shares):
    """Runs that end at drawn times: E + what was taken is E(0), and E does not grow; each up to the bounds given."""
    until, last = Fraction(float(scene.until)), (scene.energy, Fraction(0))
    for t in (share * until for share in shares if share):
        ended = Scene(scene.pair, scene.initial, t, scene.law)
        try:
            run = solve(ended, arithmetic="float64", max_events=EVENTS)
        except (EventUndecided, OutOfRange):  # a damper or a mass ratio that 64 bits do not hold
            raise LeftOut from None
        if not (run.certain and run.reached and run.accuracy.bounded):
            raise LeftOut
        energy, taken = Fraction(run.final_energy), Fraction(run.dissipated)
        off, more = Fraction(run.accuracy.energy), Fraction(run.accuracy.dissipated)
        assert abs(scene.energy - energy - taken) <= off + more
        assert energy - last[0] <= off + last[1]
        last = energy, off
        true = in_balls(ended)
        with true.arithmetic.context():
            assert abs(energy_of(scene.pair, true.final_state) - exact(energy)) <= exact(off)
            assert abs(true.dissipated - exact(taken)) <= exact(more)


@reaching
@given(st.one_of(motions, driven_scenes()))
def test_the_ledger_closes(scene):
    """With the work of a force; friction is 0 in sticks and only there, and no loss is below 0."""
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
        unit = ledger.initial + ledger.final + ledger.friction
        assert ledger.residual.contains(0)
        assert ledger.residual.rad() <= unit * 1e-10
        assert (ledger.initial + ledger.work - ledger.final).overlaps(ledger.friction + ledger.viscous)
        assert ledger.final.overlaps(energy_of(scene.pair, run.final_state))
        assert run.dissipated.overlaps(ledger.friction + ledger.viscous)
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
    assert not has_rate(run, *times(run, [Fraction(1, 3)]))
    with run.arithmetic.context():
        assert run.final_energy > 0
        assert run.ledger.work > run.final_energy


@pytest.mark.parametrize("left_out", list(Mode))
def test_a_loss_without_one_mode_is_found(left_out):
    run = in_balls(SLIPS)
    kept = tuple(mode for mode in Mode if mode is not left_out)
    begin, end = times(run, [Fraction(1, 10**6), Fraction(1)])
    assert {Mode.SLIP_PLUS, Mode.SLIP_MINUS, Mode.STICK} <= set(run.modes)
    assert falls_by_friction(run, begin, end, kept) is (left_out is Mode.STICK)


def test_a_rate_without_the_damper_is_found():
    run = in_balls(DAMPED)
    for t in times(run, [Fraction(1, 100), Fraction(1, 7), Fraction(5, 6)]):
        assert has_rate(run, t)
        assert not has_rate(run, t, damper=False)


@pytest.mark.parametrize("factor", [Fraction(999_999, 10**6), Fraction(1_000_001, 10**6)])
def test_a_loss_of_another_friction_is_found(factor):
    run = in_balls(SLIPS)
    begin, end = times(run, [Fraction(0), Fraction(1)])
    assert falls_by_friction(run, begin, end)
    assert not falls_by_friction(run, begin, end, factor=factor)
