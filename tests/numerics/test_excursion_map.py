"""The return map against the solver that steps through time, and against its expansion."""

import math
from itertools import islice

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from strategies import decimals

from numerics.arithmetic.float64 import Float64
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve


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
