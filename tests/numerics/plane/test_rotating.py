"""A rotating force, in closed form, against runs; permanent stick; what the commands print about a surface."""

import pytest
from flint import acb, arb

from numerics import Force, response, solve, thresholds
from numerics.arithmetic.ball import Ball
from numerics.control.rotating import rotating_response
from numerics.scene.plane import PlanePair, PlaneScene

PAIR = PlanePair(1, 1, 200, "0.2", 20)


def turning(amplitude, sense=1):
    with Ball(70).context():
        quarter = (arb.pi() / 2).str(60, radius=False)
    return [Force.sine(amplitude, 10, quarter), Force.sine(sense * amplitude, 10)]


@pytest.mark.parametrize("sense", [1, -1])
def test_a_slip_goes_round_at_the_constant_speed_of_the_formula_to_forty_digits(sense):
    """A run of a second that starts on the circle; clockwise it was that of the other sense."""
    found = response(PlaneScene(PAIR, 1, force=turning(2, sense)), digits=51)
    assert found.clockwise == (sense < 0)
    x, y = found.plot().axes[0].lines[0].get_data()
    assert sense * (x[0] * y[1] - x[1] * y[0]) > 0
    vectors = {"x1": found.q1, "v1": found.v1, "v2": found.v2}
    with Ball(61).context():
        start = {
            name: [part.mid().str(46, radius=False) for part in (one.real, one.imag)] for name, one in vectors.items()
        }
    run = solve(PlaneScene(PAIR, 1, force=turning(2, sense), **start), digits=41)
    assert not run.events
    with run.context():
        for name, one in vectors.items():
            assert abs(acb(*getattr(run.final_state, name)) - one * acb(0, sense * 10).exp()) < arb(10) ** -40


def test_from_rest_it_comes_nearer_at_the_rate_of_the_least_exponent():
    found, gaps = rotating_response(PAIR, 2, 10, 20), []
    for until in (2, 4):
        run = solve(PlaneScene(PAIR, until, force=turning(2)), digits=15)
        with run.context():
            gaps.append(float(abs(acb(*run.final_state.v2) - found.v2 * acb(0, 10 * until).exp())))
    assert gaps[1] / gaps[0] == pytest.approx(float((2 * found.exponents[0].real).exp()), rel=0.5)


def test_there_is_one_threshold_and_below_it_the_pair_sticks():
    found = thresholds(PAIR, 10)
    assert found.entrainment.overlaps(found.non_stop)
    assert float(found.entrainment) == pytest.approx(0.4)
    for amplitude, after in (("0.399", True), ("0.401", False)):
        answer = rotating_response(PAIR, amplitude, 10)
        assert (bool(answer.speed.is_zero()), answer.attracts) == (after, True)
        with Ball(15).context():
            assert (abs(answer.friction) < arb("0.2")) == after


def test_a_pair_without_a_damper_is_attracted_but_at_two_frequencies():
    pair = PlanePair(1, 1, 100, "0.2")
    assert rotating_response(pair, 9, 4).attracts
    assert not rotating_response(pair, 9, 5).attracts
    assert not rotating_response(pair, "0.2", 4).attracts  # stuck, it keeps a free oscillation


def test_the_commands_know_a_surface(output, record, tmp_path):
    (event,) = record("solve", "plane-circle-merges", "--digits", 12)["events"]
    assert (event["from"], event["to"]) == ("slip", "stick")
    assert [len(event[name]) for name in ("x1", "x1_radius", "load")] == [2, 2, 2]
    assert "0.0800000000000000" in output("response", "plane-rotating-force", "--plot", tmp_path / "a.svg")
    assert (tmp_path / "a.svg").stat().st_size > 10_000
