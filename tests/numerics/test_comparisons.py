"""Other integrators: the paper's forward Euler with its chatter, and SciPy's driven from event to event."""

import numpy as np
import pytest

from numerics.linear.modes import Mode
from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene, shipped_scenes
from numerics.solver.solve import solve
from numerics.trade.comparisons.forward_euler import forward_euler
from numerics.trade.contenders import contender
from numerics.trade.judge import judge, proved

FREE = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=1)


def test_euler_chatters_where_the_pair_sticks():
    exact, run = solve(FREE), forward_euler(FREE, 1e-4)
    stuck = sum(one.length for one in exact.segments if one.mode is Mode.STICK)
    assert run.exact_contacts == 0
    assert run.chatter > 0.3 * stuck / 1e-4
    assert run.t.shape == (len(run.energy),)
    assert run.y.shape == (4, len(run.t))


def test_euler_gains_energy_in_stick():
    """Stuck for ever on the set-valued reading: the exact energy is constant, Euler's grows by 1 + (step Omega)^2."""
    scene = Scene(Pair(1, 1, 200, "0.5"), State(x1="0.001"), until=1)
    run = forward_euler(scene, 1e-3)
    assert run.exact_contacts == len(run.t)
    assert run.energy[-1] / run.energy[0] == pytest.approx((1 + (1e-3 * 10) ** 2) ** 1000, rel=1e-9)
    assert np.all(np.diff(run.energy) > 0)
    assert solve(scene).energy[-1] == pytest.approx(solve(scene).energy[0], rel=1e-14)


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


def test_euler_knows_both_readings():
    outside = State(x1="0.006")
    literal = forward_euler(Scene(FREE.pair, outside, 1, Law.THREE_VALUED_SGN), 1e-3)
    filippov = forward_euler(Scene(FREE.pair, outside, 1), 1e-3)
    assert literal.exact_contacts == len(literal.t)
    assert filippov.exact_contacts < 10


UNFORCED = [name for name in shipped_scenes() if not load_scene(name).is_forced]


@pytest.mark.parametrize("name", [name for name in UNFORCED if "literal" not in name])
def test_scipy_finds_the_same_events(name):
    scene = load_scene(name)
    run = contender("SciPy DOP853").prepare(scene, 1e-12)()
    found = judge(run, proved(scene), scene)
    assert found.difference is None
    assert found.digits > 6
