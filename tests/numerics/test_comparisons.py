"""The paper's forward Euler: its chatter, its order, and steps that it refuses."""

import numpy as np
import pytest

from numerics.linear.modes import Mode
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trade.comparisons.forward_euler import forward_euler

FREE = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=1)


def test_euler_chatters_where_the_pair_sticks():
    exact, run = solve(FREE), forward_euler(FREE, 1e-4)
    stuck = sum(one.length for one in exact.segments if one.mode is Mode.STICK)
    assert run.exact_contacts == 0
    assert run.chatter > 0.3 * stuck / 1e-4
    assert run.t.shape == (len(run.energy),)
    assert run.y.shape == (4, len(run.t))


@pytest.mark.parametrize("state", [State(v1="0.15"), State(x1="0.05", v2="0.3")])
@pytest.mark.parametrize("a1", [0, 2])
def test_euler_converges_with_order_one(state, a1):
    scene = Scene(Pair(1, 2, 200, "0.5", a1=a1), state, until="0.4")
    exact = solve(scene).y[:, -1]
    coarse, fine = (np.abs(forward_euler(scene, 0.4 / n).y[:, -1] - exact).max() for n in (2000, 64000))
    assert 8 < coarse / fine < 128  # 32, but chatter makes the error uneven


@pytest.mark.parametrize("step", [0, -1e-3, 2.5])
def test_euler_refuses_a_step_beyond_the_horizon(step):
    with pytest.raises(ValueError, match="step"):
        forward_euler(FREE, step)
