"""Where forward Euler misleads: counted against theory and judged like a peer."""

from dataclasses import replace

import numpy as np
import pytest

from numerics import load_scene
from numerics.trade import euler
from numerics.trade.comparisons.forward_euler import forward_euler
from numerics.trade.euler import euler_figure, stick_energy


@pytest.mark.parametrize("step", [1e-2, 1e-3, 1e-4])
def test_energy_in_stick_grows_as_theory_says(step, monkeypatch):
    found, theory = stick_energy(step)
    assert found == pytest.approx(theory, rel=1e-9)
    assert found > 1.05

    def kept(scene, step):
        run = forward_euler(scene, step)
        return replace(run, y=np.repeat(run.y[:, :1], run.y.shape[1], axis=1))

    monkeypatch.setattr(euler, "forward_euler", kept)  # a method that keeps the energy is told from it
    assert stick_energy(step)[0] == 1


def test_a_figure_is_judged_against_balls_and_chatters_more_with_finer_steps():
    found = euler_figure(load_scene("start-with-speed"), (1e-2, 1e-3, 1e-4))
    assert found.events == 32
    assert [one.right for one in found.outcomes] == [False, True, True]
    assert found.right_from() == 1e-3
    for some in ([one.digits for one in found.outcomes], [one.chatter for one in found.outcomes]):
        assert some == sorted(some)
