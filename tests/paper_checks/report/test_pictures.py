"""Figures in several processes: the same bytes as in one, and what is lost where one fails or its process ends."""

import pytest

from numerics.trade.recorded import recorded
from paper_checks.report.output import pictures

DRAWINGS = [pictures.Drawing("two-bodies", "svg"), pictures.Drawing("force-needed", "pdf")]


@pytest.fixture(scope="module")
def trade():
    return recorded(None)


def test_two_processes_draw_the_same_bytes_as_one(trade):
    assert dict(pictures.made(DRAWINGS, trade, jobs=2)) == dict(pictures.made(DRAWINGS, trade))


def test_a_figure_that_fails_or_whose_process_ends_is_said_to(figures, trade, monkeypatch):
    monkeypatch.setattr(pictures, "FIGURES", figures | {"broken": lambda: 1 / 0})
    lost = [pictures.drawn(pictures.Drawing(name, "svg"), trade) for name in ("broken", "lost")]
    broken = "the figure broken was not drawn: ZeroDivisionError: division by zero"
    assert lost == [broken, "the figure lost is not known"]
    ended = pictures.processes.Ended()
    monkeypatch.setattr(pictures.processes, "answers", lambda order, *_: ((one, ended) for one in order))
    found = [*pictures.made(DRAWINGS, trade, jobs=2)]
    assert found == [(one, f"the figure {one.name} was not drawn: its process ended") for one in DRAWINGS]
