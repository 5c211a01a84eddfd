"""The free pair sticks from some time on with E <= E_cr, or its energy falls to E_cr; with a damper it falls to 0.

All bounds are explicit: the dwell time, the upper bound of w = E/E_cr - 1 that E(0) fixes (claim `uniform-rate`), what
is left to slide, at most (E - lim E)/b, and the speed that this slide allows. Laws are functions of what they claim,
and are seen to answer no for an E_cr next to the true one. The laws, and their tests:

  sticks_exactly_below   E <= E_cr: stuck from the next contact on: test_the_pair_sticks_for_good_exactly_up_to_...
  goes_to                E > E_cr: down to E_cr, or merged on the way: test_the_energy_falls_to_the_critical_one_...
  comes_together         x1 - x2 has a limit, v1 - v2 tends to 0: test_the_relative_position_has_a_limit_...
  dies_out               with a damper everything tends to 0: test_with_a_damper_everything_dies_out
"""

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import excesses, free_motions, late_times, magnitudes, motions_of_energy, starts_on_a_ray
from theory_values import energy_of, exact, excess_of, excursion_of, of_pair, reduced_time, start_of

from numerics import EventUndecided, Mode, OutOfRange, Pair, Scene, State, load_scene, solve
from numerics.arithmetic.ball import precision
from numerics.free.abel import creeping_place
from numerics.free.energy import EnergyAt, EnergyMethod, energy_at
from numerics.linear.modes import EventKind
from numerics.trajectory.status import Status
from theory.energy import critical_energy, dwell_time_bound
from theory.filippov import half_width
from theory.uniform_rate import crossings_bound, upper_bound

pytestmark = pytest.mark.critical_energy

ARITHMETICS = pytest.mark.parametrize("arithmetic", ["float64", "ball"])
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


@given(motions_of_energy(excesses(-25, 1)))
def test_the_solver_has_the_critical_energy_that_theory_derives(scene):
    assert exact(scene.pair.critical_energy) == critical_of(scene.pair)
    assert exact(scene.pair.half_width) == of_pair(half_width(), scene.pair)
    assert exact(scene.energy) == energy_of(scene.pair, start_of(scene))
    assert exact(scene.energy_excess) == excess_of(scene)


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


@ARITHMETICS
@reaching
@given(scene=motions_of_energy(excesses(-25, 1)))
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
@given(shift=st.sampled_from([-1, 1]), scene=motions_of_energy(st.just(Fraction(0)), on_surface=True))
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
@given(motions_of_energy(magnitudes(-30, 1), ratios=(-2, 2)), late_times())
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
@given(starts_on_a_ray((-4, -1), exponents=(-3, 3), ratios=(-2, 2)), st.integers(1, 20) | st.integers(301, 330))
@example(load_scene("start-with-speed"), 320)
@example(load_scene("start-with-speed-literal"), 320)
@example(load_scene("itinerary-that-merges"), 320)
def test_a_jump_gives_what_stepping_gives(scene, half_turns):
    t = half_turns * Fraction(float(arb.pi() / reduced_time(scene.pair, 1)))
    jumped = at_late_time(scene, t, digits=15)
    stepped = solve(until(scene, t), digits=15, arithmetic="ball", max_events=2000)
    with stepped.arithmetic.context():
        assert jumped.energy_excess.overlaps(stepped.reduced.final.w)
        assert jumped.energy.overlaps(energy_of(scene.pair, stepped.final_state))
        for k in (0, 1, 3):  # x2 counts from an unknown origin after a jump
            assert jumped.si_state[k].overlaps(stepped.final_state[k])
    assert jumped.excursions == stepped.event_kinds.count(EventKind.EXIT)
    assert jumped.mode is stepped.final_mode


# z = x1 - x2 has a limit, and z' tends to 0


def comes_together(scene: Scene, margin: fmpq = THE_CRITICAL) -> bool:
    """Whether what z still moves, and z'^2, stay below what the energy above its limit allows, at all times looked at.

    b |z(t) - lim z| <= E(t) - lim E, and z'^2 <= (2 K/b) (E(t) - lim E) with |z''| <= K below the energy E(t): a speed
    of z has to slide some way before it is gone. `margin`: times the right side.
    """
    pair, run = scene.pair, solve(scene, digits=60, arithmetic="ball", max_events=30)
    last = at_late_time(scene, Fraction(10) ** 60)
    limit = critical_of(pair) if last.energy_excess > 0 else last.energy
    with run.arithmetic.context():
        settled = creeping_place(run, pair, float(pair.half_width), Fraction(0)) if last.energy_excess > 0 else None
        x1, _, x2, _ = run.y[:, -1]
        at_last = settled.limit if settled else x1 - x2
        states = [*run.y.T, *(one.state(one.length / 2) for one in run.segments)]
        return all(_within(pair, state, at_last, limit, margin) for state in states)


def _within(pair: Pair, state, at_last: arb, limit: arb | fmpq, margin: fmpq) -> bool:
    x1, v1, x2, v2 = state
    energy = energy_of(pair, state)
    left = margin * (energy - limit)
    m1, m2, a1, a2, b = map(exact, (pair.m1, pair.m2, pair.a1, pair.a2, pair.b))
    steepest = ((2 * energy * a2).sqrt() + a1 * (2 * energy / m1).sqrt()) / m1 + b / m1 + b / m2
    moved, speed = x1 - x2 - at_last, v1 - v2
    return not b * abs(moved) > left and not b * speed**2 > 2 * steepest * left


@reaching
@given(st.one_of(free_motions(ratios=(-2, 2)), motions_of_energy(excesses(-9, 0), ratios=(-2, 2))))
@example(Scene(PAIR, State(v1="0.15"), 5))
def test_the_relative_position_has_a_limit_and_its_speed_tends_to_0(scene):
    assert comes_together(scene)


@pytest.mark.parametrize("start", [State(v1="0.15"), State(v2="0.3")])
def test_less_room_to_slide_is_found(start):
    """In one slip the whole loss is b times what is slid: with a margin below 1 the rest of it is too little."""
    scene = Scene(Pair(1, 1, 200, 3), start, 5)
    assert solve(scene).status is Status.STUCK_FOR_EVER
    assert comes_together(scene)
    assert not comes_together(scene, fmpq(999_999, 10**6))


# with a damper everything tends to 0


def decay_rate(pair: Pair, energy: arb | fmpq) -> arb:
    """A rate k, 1/s, with E(t) <= 3 E(0) exp(-2 k t/3) for a1 > 0.

    V = E + k x1 p, p = m1 v1 + m2 v2, p' = -a2 x1 - a1 v1 whatever friction is. With k <= Omega/4, |k x1 p| <= E/2.
    V' <= -b |z'| - a1 v1^2 + k (M v1^2 + m2 |v1 z'| - a2 x1^2 + a1 |x1 v1|), and where k is at most a1/(4 M),
    a2/(2 a1) and b/(2 m2 c), c = sqrt(2 E(0) (1/m1 + 1/m2)) a bound of |z'| and |v1|, that is at most
    -b |z'|/2 - a1 v1^2/2 - k a2 x1^2/2 <= -k E, as m2 v2^2 <= 2 m2 (v1^2 + z'^2).
    """
    m2, mass, a1, a2, b = (exact(one) for one in (pair.m2, pair.mass, pair.a1, pair.a2, pair.b))
    fastest = (2 * energy * (1 / exact(pair.m1) + 1 / m2) + arb(0)).sqrt()
    rates = [arb(a1 / (4 * mass)), arb(a2 / (2 * a1)), b / (2 * m2 * fastest), arb(a2 / mass).sqrt() / 4]
    return rates[0].min(rates[1]).min(rates[2]).min(rates[3])


def dies_out(scene: Scene, pair: Pair, share: Fraction) -> bool:
    """Whether E is below the bound of a pair's damper at all events, at the end, and at a share of the run."""
    run = solve(scene, digits=20, arithmetic="ball", max_events=60)
    with run.arithmetic.context():
        first = energy_of(pair, start_of(scene))
        rate = decay_rate(pair, first)
        between = Fraction(float(run.end_time)) * share
        states = [*zip(run.t, run.y.T, strict=True), (exact(between), run.sol(between))]
        return all(energy_of(pair, state) <= 3 * first * (-2 * rate * t / 3).exp() for t, state in states)


@reaching
@given(free_motions(damped=True), st.integers(0, 999), magnitudes(-1, 2))
def test_with_a_damper_everything_dies_out(scene, thousandths, times):
    try:
        first = energy_of(scene.pair, start_of(scene))
        if first == 0:
            raise LeftOut
        long = Fraction(float(1 / decay_rate(scene.pair, first))) * times
        assert dies_out(until(scene, long), scene.pair, Fraction(thousandths, 1000))
    except EventUndecided:
        raise LeftOut from None


def test_a_pair_without_a_damper_does_not_die_out():
    """Stuck on a small ellipse it keeps its energy: the bound of the same pair with a damper is found wrong."""
    damped = Pair(1, 1, 200, "0.5", 5)
    start, long = State(x1="0.001"), Fraction(30)
    assert dies_out(Scene(damped, start, long), damped, Fraction(1, 2))
    free = Pair(1, 1, 200, "0.5")
    assert not dies_out(Scene(free, start, long), damped, Fraction(1, 2))
