"""Figures in several processes: the same bytes as in one, and what is lost where one fails or its process ends."""

import pytest
from dying_process import dies_of_two_bodies

from numerics.trade.recorded import recorded
from paper_checks.report.output import pictures

DRAWINGS = [pictures.Drawing(*one) for one in (("two-bodies", "svg"), ("force-needed", "pdf"), ("start-at-6mm", "svg"))]


@pytest.fixture(scope="module")
def trade():
    return recorded(None)


@pytest.fixture(scope="module")
def alone(trade):
    return dict(pictures.made(DRAWINGS, trade))


def test_a_process_that_ends_costs_its_own_figure_only(trade, alone, monkeypatch):
    monkeypatch.setattr(pictures, "drawn", dies_of_two_bodies)
    found = dict(pictures.made(DRAWINGS, trade, jobs=2))
    assert found == alone | {DRAWINGS[0]: "the figure two-bodies was not drawn: its process ended"}


def test_a_figure_that_fails_is_said_to(figures, trade, monkeypatch):
    monkeypatch.setattr(pictures, "FIGURES", figures | {"broken": lambda: 1 / 0})
    lost = [pictures.drawn(pictures.Drawing(name, "svg"), trade) for name in ("broken", "lost")]
    broken = "the figure broken was not drawn: ZeroDivisionError: division by zero"
    assert lost == [broken, "the figure lost is not known"]
