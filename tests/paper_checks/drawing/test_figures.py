"""The report's figures: axes with units, legends, captions, and bytes that depend on nothing else."""

import re

import matplotlib as mpl
import pytest

from paper_checks.drawing.captions import caption
from paper_checks.drawing.figures import FIGURES
from paper_checks.report.formats import vector

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
    assert caption(name)[1]


QUICK = "force-needed"
"""Drawn twice by the default run, as it takes little; the `long` tests draw all of them twice."""


@pytest.mark.parametrize(
    "name", [name if name == QUICK else pytest.param(name, marks=pytest.mark.long) for name in FIGURES]
)
def test_bytes_depend_on_the_figure_alone(name, monkeypatch):
    first = vector.svg(FIGURES[name]()), vector.pdf(FIGURES[name]())
    monkeypatch.setitem(mpl.rcParams, "axes.facecolor", "pink")  # a reader's own taste
    monkeypatch.setitem(mpl.rcParams, "lines.linewidth", 7)
    assert (vector.svg(FIGURES[name]()), vector.pdf(FIGURES[name]())) == first
    assert b"CreationDate" not in first[1]
    assert b"<dc:date>" not in first[0]
