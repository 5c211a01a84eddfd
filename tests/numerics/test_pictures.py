"""The pictures of a trajectory show what it is: titles, units, shaded sticking, and curves that are its own."""

import matplotlib as mpl
import numpy as np
import pytest

from numerics import Pair, Scene, State, solve
from numerics.trajectory.figures import sampled

mpl.use("Agg")

PAPER = Scene(Pair(1, 1, 200, "0.5"), State(v1="0.15"), until=3)
DAMPED = Scene(Pair(1, 1, 200, "0.5", a1=4), State(v1="0.45"), until=3)
STUCK = Scene(PAPER.pair, State(x1="0.001"), until=3)
HOW = [
    {},
    {"arithmetic": "double-double"},
    {"arithmetic": "mpmath"},
    {"arithmetic": "ball", "digits": 20},
    {"max_events": 3},
]


@pytest.mark.parametrize("kind", ["velocities", "positions", "phase", "excess", "energy"])
@pytest.mark.parametrize("scene", [PAPER, DAMPED, STUCK])
def test_every_picture_has_a_title_units_and_shaded_sticking(scene, kind):
    from matplotlib import pyplot as plt

    ax = solve(scene).plot(kind=kind)
    assert ax.get_title()
    assert ("(" in ax.get_xlabel() + ax.get_ylabel()) or kind == "excess"
    labels = ax.get_legend_handles_labels()[1]
    assert ("$S_0$" if kind == "phase" else "stick") in labels
    assert len(ax.collections) >= 1
    again = solve(scene).plot(kind, ax)
    assert again is ax
    plt.close("all")


def test_a_picture_of_no_kind_is_refused():
    with pytest.raises(ValueError, match="velocities, positions, phase, excess, energy"):
        solve(PAPER).plot("speed")


@pytest.mark.parametrize("how", HOW)
@pytest.mark.parametrize("scene", [PAPER, DAMPED])
def test_what_is_drawn_is_the_trajectory(scene, how):
    if scene is DAMPED and how.get("arithmetic") == "double-double":
        return
    run = solve(scene, **how)
    curve, number = sampled(run), run.arithmetic.to_float
    assert np.all(np.diff(curve.t) >= -1e-12)
    assert set(curve.segment) == set(range(len(run.segments)))
    for at in range(0, len(curve.t), 37):
        state = run.sol(min(float(curve.t[at]), number(run.end_time)))
        assert curve.y[:, at] == pytest.approx([number(one) for one in state], abs=1e-12)
    unit = float(scene.pair.critical_energy)
    total = unit * (1 + curve.w) + curve.lost.sum(axis=0)
    assert total == pytest.approx(np.full(len(total), float(scene.energy)), rel=1e-9)


def test_thousands_of_events_are_drawn_within_their_true_range():
    """Drawn through the events alone, the speeds of the stick phases between them were lost."""
    run = solve(Scene(PAPER.pair, PAPER.initial, 300))
    assert len(run.segments) > 1000
    curve, dense = sampled(run), run.sol(np.linspace(100, 200, 2000))
    drawn = curve.y[:, (curve.t > 100) & (curve.t < 200)]
    assert np.abs(drawn).max(axis=1) == pytest.approx(np.abs(dense).max(axis=1), rel=0.01)
    assert curve.resolved[0]
    assert not curve.resolved[(curve.t > 100) & (curve.t < 200)].all()
