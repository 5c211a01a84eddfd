"""The 1/t law over a hundred thousand excursions, and the map against the solver that steps through time."""

import math
from itertools import islice, pairwise

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from strategies import decimals

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.float64 import Float64
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve


def limit(frame) -> float:
    """What reduced time times w tends to: 4 pi q/(9 r)."""
    return 4 * math.pi * frame.q / (9 * frame.r)


def history(pair: Pair, w: float, count: int) -> list[tuple[float, float]]:
    """(reduced time, w) at every exit."""
    tau, points = 0.0, []
    for one in islice(excursions(Frame(Float64(), pair), w), count):
        points.append((tau, one.w))
        tau += one.slip + one.stick
    return points


@pytest.mark.slow
@pytest.mark.parametrize(("m1", "m2", "count"), [(1, 1, 100_001), (9, 1, 30_001), (1, 4, 30_001)])
def test_time_times_excess_tends_to_one_limit_for_every_initial_energy(m1, m2, count):
    pair = Pair(m1, m2, a2=1, b=1)
    expected, limits = limit(Frame(Float64(), pair)), []
    for w in (0.02, 0.2):
        points = history(pair, w, count)
        assert len(points) == count
        assert all(later < earlier for (_, earlier), (_, later) in pairwise(points))
        # two-sided bounds from some time on
        assert all(0.5 * expected < tau * w < 2 * expected for tau, w in points[1000:])
        # 1/w grows by tau/limit, up to a logarithm that the second half hardly feels
        (tau1, w1), (tau2, w2) = points[count // 2], points[-1]
        limits.append((tau2 - tau1) / (1 / w2 - 1 / w1))
        assert tau2 * w2 == pytest.approx(expected, rel=0.01)
    assert limits[0] == pytest.approx(expected, rel=2e-4)
    assert limits[1] == pytest.approx(limits[0], rel=2e-4)


@pytest.mark.parametrize("ratio", [1, 1000])
def test_the_bounds_hold_in_balls(ratio):
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(ratio, 1, a2=1, b=1))
        run = list(islice(excursions(frame, arithmetic.number(1) / 100), 300))
        assert all(one.w_after > 0 and one.w_after < one.w for one in run)
        assert all(two.w.overlaps(one.w_after) and two.side == -one.side for one, two in pairwise(run))
        assert run[-1].w.rel_accuracy_bits() > 100


@given(decimals(-6, -2), st.sampled_from([(1, 1), (3, 1), (1, 2)]))
def test_the_map_is_the_solver_from_ray_to_ray(eps, masses):
    pair = Pair(*masses, a2=sum(masses), b=1)  # Omega = 1
    width = pair.half_width
    scene = Scene(pair, State(x1=width, v1=eps * width, v2=eps * width), until=20)
    run = solve(scene, digits=30, arithmetic="ball")
    with run.arithmetic.context():
        mapped = list(islice(excursions(run.frame, run.arithmetic.number(scene.energy_excess)), 6))
        exits = [event for event in run.events if event.kind is EventKind.EXIT]
        tau = arb(0)
        for one, event in zip(mapped, exits, strict=False):
            tau += one.slip + one.stick
            assert event.reduced.w.overlaps(one.w_after)
            assert (event.t * run.frame.rate).overlaps(tau)


@given(st.floats(1e-90, 1e-3))
def test_the_expansion_of_one_excursion(w):
    """Slip time 3 eps, stick time pi - O(eps), drop (9 r/(4 q)) w^2."""
    frame = Frame(Float64(), Pair(1, 1, a2=1, b=1))
    one = next(excursions(frame, w))
    assert one.slip == pytest.approx(3 * math.sqrt(w), rel=1e-2 + 3 * w)
    assert one.stick == pytest.approx(math.pi, abs=4 * math.sqrt(w))
    if w > 1e-12:
        assert (w - one.w_after) / w**2 == pytest.approx(9 / 4, rel=1e-2 + 10 * w + 1e-15 / w)
    else:
        assert one.w_after <= w
