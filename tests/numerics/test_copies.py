"""What the public functions answer can be pickled and copied, in every arithmetic, and is the same to the last bit."""

import copy
import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
from flint import acb, arb, arb_mat, arb_poly
from hypothesis import example, given
from strategies import balls
from three_scenes import ARITHMETICS, DAMPED, PAPER

from numerics import (
    Scene,
    State,
    cheapest_transfer,
    damping,
    fastest_transfer,
    load_reference,
    load_scene,
    response,
    ring_entry,
    sensitivities,
    solve,
    solve_many,
    solve_scenes,
    thresholds,
    track,
)
from numerics.arithmetic.ball import Ball

COPIES = [lambda one: pickle.loads(pickle.dumps(one)), copy.copy, copy.deepcopy]
REST = Scene(PAPER.pair, State(), 3)


def bits(value):
    """Return what an answer holds, down to the bits of its numbers."""
    if isinstance(value, arb):
        return [part.man_exp() if part.is_finite() else str(part) for part in (value.mid(), value.rad())]
    if isinstance(value, acb):
        return bits([value.real, value.imag])
    if isinstance(value, arb_poly | arb_mat):
        return bits(value.coeffs() if isinstance(value, arb_poly) else value.entries())
    if isinstance(value, list | tuple | np.ndarray):
        return [bits(one) for one in value]
    if isinstance(value, dict):
        return {name: bits(one) for name, one in value.items()}
    return bits(vars(value)) if hasattr(value, "__dict__") and not callable(value) else repr(value)


def same_in_all_copies(answer):
    return all(bits(make(answer)) == bits(answer) and repr(make(answer)) == repr(answer) for make in COPIES)


@pytest.mark.parametrize("how", [*ARITHMETICS, {"digits": 40}])
def test_a_run_and_all_that_it_answers(how):
    run = solve(PAPER, **how)
    for one in (run.ledger, run.events, run.accuracy, run.final, run.units, run.y, run.t_events):
        assert same_in_all_copies(one)
    assert same_in_all_copies(sensitivities(solve(replace(PAPER, until="0.1"), **how)))
    assert [make(run) == run for make in COPIES] == [True] * 3
    with run.context():
        assert [bits(make(run.segments[1]).losses()) for make in COPIES] == [bits(run.segments[1].losses())] * 3


@pytest.mark.parametrize("name", ["plane-box", "plane-circle-merges"])
@pytest.mark.parametrize("how", [{}, {"digits": 20}])
def test_a_run_on_a_surface(name, how):
    run = solve(load_scene(name), **how)
    assert same_in_all_copies(run.events)
    assert same_in_all_copies([run.y, run.end_time, run.final_state])
    assert [make(run) == run for make in COPIES] == [True] * 3


@pytest.mark.parametrize(
    "ask",
    [
        lambda: thresholds(PAPER.pair, omega=7),
        lambda: response(DAMPED, amplitude=3, omega=7),
        lambda: response(DAMPED, amplitude="0.1", omega=7),
        lambda: fastest_transfer(REST, "0.01"),
        lambda: cheapest_transfer(REST, "0.001", "0.2"),
        lambda: track(REST, load_reference("s-curve")),
        lambda: ring_entry(PAPER, radius="0.001"),
        lambda: damping(REST, "0.001"),
        lambda: solve_many(1, 1, 200, 0.5, v1=[0.1, 0.2], until=1, keep_events=2).ends,
        lambda: solve_scenes([load_scene("plane-box")], jobs=1, keep_events=2),
    ],
)
def test_answers_of_control_and_batches(ask):
    assert same_in_all_copies(ask())


@pytest.mark.parametrize("make", COPIES)
def test_a_batch_answers_as_before(make):
    batch = solve_many(1, 1, 200, 0.5, v1=[0.1, 0.2], until=1, keep_events=2)
    assert bits(make(batch).dissipated) == bits(batch.dissipated)


@given(balls())
@example(arb(0))
@example(arb(1, 2.0**-2000))
@example(arb("0.1"))
@example(arb(math.inf))
@example(arb(-3, math.inf))
@example(arb("nan"))
def test_every_ball_at_whatever_precision_is_set(ball):
    wide = [ball, acb(ball, 1), arb_poly([1, ball]), arb_mat([[ball, 2]])]
    for digits in (1, 100):
        with Ball(digits).context():
            assert all(bits(make(wide)) == bits(wide) for make in COPIES)
