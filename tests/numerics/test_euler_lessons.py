"""Where forward Euler misleads: counted against theory, judged like a peer, extrapolated only where it may be."""

from __future__ import annotations

from importlib.util import find_spec

import numpy as np
import pytest

from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trade import euler
from numerics.trade.comparisons.forward_euler import EulerRun, forward_euler, march
from numerics.trade.euler import EulerFigure, EulerOutcome, euler_figure, stick_energies, stick_energy


@pytest.mark.parametrize("step", [1e-2, 1e-3, 1e-4])
def test_energy_in_stick_grows_as_theory_says(step):
    found = stick_energy(step)
    assert found.held == pytest.approx(found.theory, rel=1e-9)
    assert found.held > 1.05


def test_a_method_that_keeps_the_energy_is_told_from_euler(monkeypatch):
    def kept(scene, step):
        run = forward_euler(scene, step)
        return EulerRun(scene, step, run.t, np.repeat(run.y[:, :1], run.y.shape[1], axis=1))

    monkeypatch.setattr(euler, "forward_euler", kept)
    found = stick_energy(1e-3)
    assert found.held == 1
    assert found.held != pytest.approx(found.theory, rel=1e-3)


def test_chatter_takes_back_what_stick_gains_and_grows_with_finer_steps():
    found = [one for one in stick_energies() if one.chattering is not None]
    assert all(abs(one.chattering - 1) < abs(one.held - 1) for one in found)
    counts = [one.chatter for one in found]
    assert counts == sorted(counts)
    assert counts[-1] > 100_000


def test_a_figure_is_judged_against_balls():
    found = euler_figure("3 (b)", load_scene("start-with-speed"), (1e-2, 1e-3, 1e-4))
    assert found.events == len(solve(load_scene("start-with-speed"), digits=15).events)
    assert [one.right for one in found.outcomes] == [False, True, True]
    assert found.outcomes[0].difference == f"10 events, not {found.events}"
    assert found.right_from == 1e-3
    errors = [one.error for one in found.outcomes]
    assert errors == sorted(errors, reverse=True)


def planted(*outcomes: tuple[float, bool, float]) -> EulerFigure:
    return EulerFigure("0", 3, 1.0, tuple(EulerOutcome(step, right, None, error, 0) for step, right, error in outcomes))


def test_a_step_counts_only_if_all_finer_ones_do():
    lucky = planted((1e-1, True, -3.5), (1e-2, False, -0.5), (1e-3, True, -2.5), (1e-4, True, -3.5))
    assert lucky.right_from == 1e-3
    assert lucky.step_for(1e-2) == (1e-3, True)
    assert lucky.step_for(1e-3) == (1e-4, True)


def test_what_was_not_reached_is_extrapolated_with_order_one():
    step, tried = planted((1e-3, False, -1.0), (1e-4, True, -2.0)).step_for(1e-4)
    assert (step, tried) == (pytest.approx(1e-6), False)


def test_nothing_is_extrapolated_from_wrong_events():
    wrong = planted((1e-3, True, -2.0), (1e-4, False, -3.0))
    assert wrong.right_from is None
    assert wrong.step_for(1e-2) == (None, False)


@pytest.mark.slow
@pytest.mark.skipif(not find_spec("numba"), reason="numba is not installed; plain Python takes too long here")
@pytest.mark.parametrize(("name", "error"), [("velocities", 1e-2), ("relative-motion-b02", 1e-3)])
def test_the_extrapolated_step_does_what_it_says(name, error, monkeypatch):
    import numba

    scene = load_scene(name)
    step, tried = euler_figure("4", scene, (1e-4, 2e-5)).step_for(error)
    assert not tried
    loop = numba.njit(march)
    monkeypatch.setattr(euler, "forward_euler", lambda scene, step: forward_euler(scene, step, loop))
    (found,) = euler_figure("4", scene, (step,)).outcomes
    assert found.right
    assert error / 2 < 10**found.error < 2 * error
