"""Other integrators: the paper's forward Euler with its chatter, and SciPy's driven from event to event."""

import numpy as np
import pytest
from hypothesis import given
from scipy.integrate import solve_ivp
from strategies import scenes

from numerics.motion.modes import Mode
from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene, shipped_scenes
from numerics.solver.solve import solve
from numerics.trade.comparisons.forward_euler import forward_euler

FREE = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=1)


def test_euler_chatters_where_the_pair_sticks():
    exact, run = solve(FREE), forward_euler(FREE, 1e-4)
    stuck = sum(one.length for one in exact.segments if one.mode is Mode.STICK) / exact.frame.rate
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


def scipy_segment(pair, sign, start, t0, t1):
    """One mode by DOP853 at its tightest tolerance; the events of its end."""
    m1, m2, a1, a2, b = (float(one) for one in (pair.m1, pair.m2, pair.a1, pair.a2, pair.b))
    mass = m1 if sign else m1 + m2

    def field(_t, y):
        acceleration = -(a2 * y[0] + a1 * y[1] + b * sign) / mass
        return [y[1], acceleration, y[3], b * sign / m2 if sign else acceleration]

    def leaves(_t, y):
        return sign * (y[1] - y[3]) if sign else b * (m1 + m2) / m2 - abs(a2 * y[0] + a1 * y[1])

    leaves.direction, leaves.terminal = -1, True
    rate = np.sqrt(a2 / m1) + a1 / m1
    scale = np.array([1.0, rate, 1.0, rate]) * max(1e-3, np.abs(start).max() / rate)
    return solve_ivp(
        field, (t0, t1), start, "DOP853", events=leaves, rtol=3e-14, atol=1e-14 * scale, max_step=0.3 / rate
    )


UNFORCED = [name for name in shipped_scenes() if not load_scene(name).is_forced]


@pytest.mark.parametrize("name", [name for name in UNFORCED if "literal" not in name and "3a" not in name])
def test_scipy_finds_the_same_ends_of_the_same_modes(name):
    """Each mode is started where the exact one starts: a comparison of event times, not of accumulated errors."""
    scene = load_scene(name)
    run = solve(scene)
    for index, segment in enumerate(run.segments[:-1][:12]):
        t0, t1 = run.t[index], run.t[index + 1]
        found = scipy_segment(
            scene.pair, segment.mode.sign, run.sol(t0 + 0.2 * (t1 - t0)), t0 + 0.2 * (t1 - t0), t1 + 1
        )
        assert found.t_events[0][0] == pytest.approx(t1, abs=1e-9)
        assert found.y_events[0][0] == pytest.approx(run.y[:, index + 1], abs=1e-9 * np.abs(run.y).max())


@given(scenes((-1, 1), None, size=(-1, 0), periods=(1, 2)))
def test_scipy_agrees_inside_segments(scene):
    run = solve(scene, max_events=4)
    for index, segment in enumerate(run.segments):
        t0, t1 = run.t[index], run.t[index + 1]
        if (t1 - t0) * np.sqrt(float(scene.pair.a2 / scene.pair.m1)) > 60 or scene.pair.a1 > 30 * scene.pair.m1:
            continue  # many steps; nothing new in them
        near, far = t0 + 0.01 * (t1 - t0), t0 + 0.99 * (t1 - t0)
        found = scipy_segment(scene.pair, segment.mode.sign, run.sol(near), near, far)
        scale = np.abs(run.y).max(axis=1) + float(scene.pair.half_width) * np.array([1, 1, 1, 1])
        assert np.all(np.abs(found.y[:, -1] - run.sol(found.t[-1])) <= 1e-8 * scale.max())
        assert found.t[-1] == pytest.approx(far) or segment.mode is Mode.STICK
