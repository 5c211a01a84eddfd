"""The report's figures: axes with units, legends, event markers, and bytes that depend on nothing else."""

import re

import matplotlib as mpl
import pytest

from numerics import load_scene, solve
from numerics.linear.modes import EventKind
from paper_checks.drawing.figures import FIGURES
from paper_checks.drawing.style import MARKERS
from paper_checks.report.formats import vector

PAPER = (
    "start-at-6mm",
    "start-with-speed",
    "velocities",
    "itinerary-that-merges",
    "itinerary-that-creeps",
)
UNIT = re.compile(r"\((m|mm|m/s|mm/s|rad/s|s|J|N|dimensionless)\)$")
WORDLESS = ("two-bodies", "fastest-transfer")
"""A drawing without axes, and those of `numerics` whose panels share one."""
DIRECT = ("force-needed",)
"""Their curves are named where they are."""


def texts(figure):
    """All texts of all legends."""
    legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes)]
    return {text.get_text() for legend in legends if legend for text in legend.get_texts()}


@pytest.mark.parametrize("name", [name for name in FIGURES if name not in WORDLESS])
def test_axes_have_labels_with_units_and_a_legend(name):
    figure = FIGURES[name]()
    for axes in figure.axes:
        assert UNIT.search(axes.get_xlabel()), axes.get_xlabel()
        assert UNIT.search(axes.get_ylabel()), axes.get_ylabel()
    assert texts(figure) or name in DIRECT


QUICK = ("force-needed", "merging-window")
"""Drawn twice by the default run, as they take little; the `long` tests draw all of them twice."""


@pytest.mark.parametrize(
    "name", [name if name in QUICK else pytest.param(name, marks=pytest.mark.long) for name in FIGURES]
)
def test_bytes_depend_on_the_figure_alone(name, monkeypatch):
    first = vector.svg(FIGURES[name]()), vector.pdf(FIGURES[name]())
    monkeypatch.setitem(mpl.rcParams, "axes.facecolor", "pink")  # a reader's own taste
    monkeypatch.setitem(mpl.rcParams, "lines.linewidth", 7)
    assert (vector.svg(FIGURES[name]()), vector.pdf(FIGURES[name]())) == first
    assert b"CreationDate" not in first[1]
    assert b"<dc:date>" not in first[0]


@pytest.mark.parametrize("name", PAPER)
def test_the_events_that_happen_are_in_the_legend_and_differ_by_shape(name):
    happened = {kind.value for kind in solve(load_scene(name)).event_kinds}
    assert happened <= texts(FIGURES[name]())
    assert len(set(MARKERS.values())) == len(EventKind)


def test_the_named_points_stand_on_the_projected_trajectory():
    """C1 and D1 on the rays, A1 in S+, B1 in S-, A2, B2, A3 inside S0; coordinates (x1, (v1 + v2)/2) in mm and mm/s."""
    texts = FIGURES["itinerary-that-creeps"]().axes[0].texts
    at = {text.get_text().strip("$"): text.xy for text in texts if text.get_text() and hasattr(text, "xy")}
    half = 5.0
    assert at["O_1"] == pytest.approx((0, 105))
    assert at["A_1"][0] > half > -half > at["B_1"][0]
    assert (at["C_1"][0], at["D_1"][0]) == pytest.approx((half, -half))
    assert at["C_1"][1] > 0 > at["D_1"][1]
    assert all(abs(at[name][0]) < half for name in ("A_2", "B_2", "A_3", "O_2"))
