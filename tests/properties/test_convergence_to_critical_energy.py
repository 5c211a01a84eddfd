"""The free pair sticks from some time on with E <= E_cr, or its energy falls to E_cr.

All bounds are explicit: the dwell time, and the upper bound of w = E/E_cr - 1 that E(0) fixes (claim `uniform-rate`).
Laws are functions of what they claim, and are seen to answer no for an E_cr next to the true one. The laws, and their
tests:

  sticks_exactly_below   E <= E_cr: stuck from the next contact on: test_the_pair_sticks_for_good_exactly_up_to_...
  goes_to                E > E_cr: down to E_cr, or merged on the way: test_the_energy_falls_to_the_critical_one_...
"""

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import late_times, motions_of_energy, near_critical
from theory_values import energy_of, exact, excess_of, excursion_of, of_pair, reduced_time, start_of

from numerics import EventUndecided, Mode, OutOfRange, Pair, Scene, State, load_scene, solve
from numerics.arithmetic.ball import precision
from numerics.free.energy import EnergyAt, EnergyMethod, energy_at
from numerics.linear.modes import EventKind
from numerics.trajectory.status import Status
from theory.energy import critical_energy, dwell_time_bound
from theory.uniform_rate import crossings_bound, upper_bound

pytestmark = pytest.mark.critical_energy

NEXT_TO_1 = pytest.mark.parametrize("factor", [fmpq(999_999, 10**6), fmpq(1_000_001, 10**6)])
THE_CRITICAL, NEARLY = fmpq(1), 1 - fmpq(1, 10**11)
"""Above the latter part of E_cr float64 may follow a stick to the horizon without saying that it lasts."""
PAIR = Pair(1, 1, 200, "0.05")


def critical_of(pair: Pair, factor: fmpq = THE_CRITICAL) -> fmpq:
    """E_cr as theory derives it, exact; another level for another factor."""
    return factor * of_pair(critical_energy(), pair)


def until(scene: Scene, t: Fraction | arb) -> Scene:
    """The same scene with another horizon, s; of a ball its upper end."""
    at = t if isinstance(t, Fraction) else Fraction(float(t.upper()) * (1 + 2**-40))
    return Scene(scene.pair, scene.initial, at, scene.law)


# E <= E_cr: stuck from the next contact on


def sticks_exactly_below(scene: Scene, arithmetic: str, critical: fmpq) -> bool:
    """Whether the pair sticks for good where E <= `critical`, and leaves S0 within half a turn from S above it.

    Below, the next contact with S is in S0, and comes within the longest stay off S, 2 sqrt(2 E m2)/b.
    """
    pair, initial = scene.pair, scene.initial
    first = energy_of(pair, start_of(scene))
    stay = of_pair(dwell_time_bound(), pair, E0=first)
    half_turn = arb.pi() / reduced_time(pair, 1)
    run = solve(until(scene, 2 * stay + 2 * half_turn), arithmetic=arithmetic, max_events=3)
    if not run.certain:
        raise LeftOut
    within = stay if first <= critical else half_turn
    with run.arithmetic.context():
        off = run.accuracy.t[0] if run.bounded and len(run.event_times) else 0.0
        on_time = all(not arb(t) - off > within for t in run.event_times[:1])
    if first <= critical:
        is_open = run.bounded and run.final_mode is Mode.STICK and first > critical * NEARLY
        return (run.status is Status.STUCK_FOR_EVER or is_open) and len(run.event_times) <= 1 and on_time
    if initial.v1 != initial.v2:
        raise LeftOut
    return run.modes[0] is not Mode.STICK or (len(run.event_times) > 0 and on_time)


@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
@reaching
@given(scene=motions_of_energy((-25, 1), below=True))
@example(scene=Scene(PAIR, State(v1="0.005", v2="0.005"), 1))  # E_cr exactly
@example(scene=Scene(PAIR, State(v1="0.0049999999999975", v2="0.0049999999999975"), 1))  # w = -1e-12
@example(scene=Scene(PAIR, State(v1="0.005000001", v2="0.005000001"), 1))
@example(scene=Scene(PAIR, State(x1="0.0004", v1="0.002"), 1))
@example(scene=Scene(Pair(60, 1, 3701, 1), State(x1="0.0008", v2=1), 1))  # a stay above half of its bound
def test_the_pair_sticks_for_good_exactly_up_to_the_critical_energy(scene, arithmetic):
    try:
        assert sticks_exactly_below(scene, arithmetic, critical_of(scene.pair))
    except (EventUndecided, OutOfRange):  # 64 bits do not tell the sides of a tie apart
        if arithmetic == "ball":
            raise
        raise LeftOut from None


@NEXT_TO_1
@given(shift=st.sampled_from([-1, 1]), scene=motions_of_energy((-40, -40), on_surface=True))
def test_a_critical_energy_next_to_the_true_one_is_found(factor, shift, scene):
    """At half the way between both levels one says that the pair sticks, the other that it leaves."""
    at = scene.initial
    between = 1 + (Fraction(int(factor.p), int(factor.q)) - 1) / 4  # of the state: half of it of the energy
    moved = Scene(scene.pair, State(*(between * one * shift for one in start_of(scene))), 1)
    assert at.v1 == at.v2
    assert sticks_exactly_below(moved, "ball", critical_of(scene.pair))
    assert not sticks_exactly_below(moved, "ball", critical_of(scene.pair, factor))


# E > E_cr: down to E_cr, or merged on the way


def at_late_time(scene: Scene, t: Fraction, digits: int = 20) -> EnergyAt:
    """The energy at a late time; too many events before a jump leave a scene out."""
    try:
        return energy_at(scene, t, digits=digits, max_steps=5000)
    except (OutOfRange, EventUndecided):
        raise LeftOut from None


def goes_to(scene: Scene, t: Fraction, factor: fmpq = THE_CRITICAL) -> bool:
    """Whether at a time the pair is stuck for good with E <= E_cr, or E is above it by no more than theory's bound.

    E and w are told apart: E_cr (1 + w) with theory's E_cr is the energy in J, also where w is 1e-100.
    """
    found, pair = at_late_time(scene, t), scene.pair
    w, critical = found.energy_excess, critical_of(pair, factor)
    if not found.energy.overlaps(critical * (1 + w)):
        return False
    if w <= 0:
        stay = of_pair(dwell_time_bound(), pair, E0=critical)
        later = at_late_time(scene, t + Fraction(float(stay)) * 2)
        return later.mode is Mode.STICK and later.road is EnergyMethod.NO_MORE_SLIP and not later.energy > found.energy
    return not w > largest_excess(scene, t)  # both are E(0) as long as there was no excursion


def largest_excess(scene: Scene, t: Fraction) -> arb:
    """The bound of w at a time that E(0) alone fixes."""
    pair = scene.pair
    letters = excursion_of(arb(excess_of(scene) / exact(pair.share)))
    letters["N"] = of_pair(crossings_bound(), pair, **letters)
    return of_pair(upper_bound(), pair, tau=reduced_time(pair, t), **letters)


@reaching
@given(motions_of_energy((-30, 1), ratios=(-2, 2)), late_times())
@example(Scene(PAIR, State(v1="0.15"), 1), Fraction(10) ** 100)
@example(load_scene("itinerary-that-merges"), Fraction(1000))
@example(load_scene("itinerary-that-creeps"), Fraction(1000))
@example(Scene(Pair(1, 1, "1e-7", 1), State("-14832396.97", "-3316.6248", 0, "-3316.6248"), 1), Fraction(1000))
def test_the_energy_falls_to_the_critical_one_or_the_pair_sticks_below_it(scene, t):
    with precision(200):
        assert goes_to(scene, t)


@NEXT_TO_1
@pytest.mark.parametrize("scene", [Scene(PAIR, State(v1="0.15"), 1), load_scene("itinerary-that-creeps")])
def test_an_energy_that_falls_to_another_level_is_found(factor, scene):
    with precision(200):
        assert not goes_to(scene, Fraction(10) ** 30, factor)


@reaching
@given(near_critical((1, 4), ratios=(-2, 2)), st.integers(1, 20) | st.integers(301, 330))
@example(load_scene("start-with-speed"), 320)
@example(load_scene("start-with-speed-literal"), 320)
@example(load_scene("itinerary-that-merges"), 320)
def test_a_jump_gives_what_stepping_gives(scene, half_turns):
    t = half_turns * Fraction(float(arb.pi() / reduced_time(scene.pair, 1)))
    jumped = at_late_time(scene, t, digits=15)
    stepped = solve(until(scene, t), digits=15, arithmetic="ball", max_events=2000)
    with stepped.arithmetic.context():
        (x1, v1, _, v2), there = jumped.si_state, stepped.final_state  # x2 counts from an unknown origin after a jump
        ours = [jumped.energy_excess, jumped.energy, x1, v1, v2]
        theirs = [stepped.reduced.final.w, energy_of(scene.pair, there), there[0], there[1], there[3]]
        assert all(map(arb.overlaps, ours, theirs))
    assert jumped.excursions == stepped.event_kinds.count(EventKind.EXIT)
    assert jumped.mode is stepped.final_mode
