"""The pictures of a trajectory show what it is: units, sticking, and curves that are its own."""

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt
from scene_files import scenes_in
from three_scenes import ARITHMETICS, DAMPED, PAPER, STUCK

from numerics import Mode, solve
from numerics.trajectory.curve import sampled

mpl.use("Agg")


@pytest.mark.parametrize(
    "kind", ["velocities", "positions", "load", "force", "phase", "relative", "excess", "energy", "friction"]
)
@pytest.mark.parametrize("scene", [PAPER, DAMPED, STUCK])
def test_every_picture_has_units_and_shows_sticking(scene, kind):
    ax = solve(scene).plot(kind=kind)
    assert ("(" in ax.get_xlabel() + ax.get_ylabel()) or kind == "excess"
    assert "stick" in ax.get_legend_handles_labels()[1]
    assert solve(scene).plot(kind, ax) is ax
    plt.close("all")


def test_events_are_marked_where_they_are():
    run = solve(DAMPED)
    for kind, rows in (("velocities", (0, 2)), ("phase", (1, 2))):
        marked = [line.get_xydata() for line in run.plot(kind).lines if line.get_marker() in set("o^x")]
        events = [np.column_stack([t, y])[:, rows] for t, y in zip(run.t_events, run.y_events, strict=True) if len(t)]
        assert [one.tolist() for one in marked] == [one.tolist() for one in events]
    plt.close("all")


FORCED = scenes_in("drawn")["every-cause"]


@pytest.mark.parametrize("a1", [4, 900])
@pytest.mark.parametrize("how", [{}, *ARITHMETICS[2:], {"max_events": 3}])
def test_what_is_drawn_under_a_force_is_the_trajectory(how, a1):
    run = solve(FORCED.replace(a1=a1), **how)
    curve, number = sampled(run), run.arithmetic.to_float
    assert len(set(curve.segment)) == len(run.segments) >= 3
    inside = (curve.segment[2:] == curve.segment[:-2]) & (np.diff(curve.t)[1:] > 1e-9)
    for at in 1 + np.flatnonzero(inside)[::29]:
        t = min(float(curve.t[at]), number(run.end_time))
        assert curve.y[:, at] == pytest.approx([number(one) for one in run.sol(t)], abs=1e-13)
        assert curve.stick[at] == (run.mode_at(t, "left") is Mode.STICK)
    assert (np.abs(np.diff(curve.u)).max() == pytest.approx(9, rel=0.05)) == run.reached  # the trapezoid falls at once
    if run.reached:
        ends = [number(one) for one in (run.ledger.friction, run.ledger.viscous)]
        assert curve.lost[:, -1] == pytest.approx(ends, rel=1e-3)


@pytest.mark.parametrize("how", ARITHMETICS)
def test_an_excess_far_below_rounding_is_drawn(how):
    run = solve(PAPER.replace(x1="0.005", v1="1e-12", v2="1e-12", until=2), **how)
    assert sampled(run).w * 1e22 == pytest.approx(4)


def test_an_excess_below_its_error_is_not_drawn():
    at_rest = PAPER.replace(x1=PAPER.pair.half_width, v1=0)
    assert not solve(at_rest).plot("excess").lines


def test_thousands_of_events_are_drawn_within_their_true_range():
    """Drawn through the events alone, the speeds of the stick phases between them were lost."""
    run = solve(PAPER.replace(until=300))
    assert len(run.segments) > 1000
    curve, dense = sampled(run), run.sol(np.linspace(100, 200, 2000))
    drawn = curve.y[:, (curve.t > 100) & (curve.t < 200)]
    assert np.abs(drawn).max(axis=1) == pytest.approx(np.abs(dense).max(axis=1), rel=0.01)
    assert curve.resolved[0]
    assert not curve.resolved[(curve.t > 100) & (curve.t < 200)].all()
