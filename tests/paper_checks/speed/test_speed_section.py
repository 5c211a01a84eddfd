"""The section on speed as a whole: its headings, figures and tables in every form, its part under a force."""

from __future__ import annotations

import re

import pytest
from planted_trades import EULER_FIGURE, planted, run, with_forced

from numerics.trade.euler import StickEnergy
from paper_checks.report.content.blocks import Heading, Paragraph, Picture, Points, Section, Table
from paper_checks.report.formats.html_blocks import HtmlWriter
from paper_checks.report.formats.latex_blocks import LatexWriter
from paper_checks.report.formats.markdown import markdown
from paper_checks.speed import section
from paper_checks.speed.forced import under_a_force


def said(found) -> str:
    """Return blocks as one text."""
    return markdown(Section("x", "x", tuple(found)))


@pytest.fixture
def plain_trade(tmp_path):
    return planted(tmp_path)


class TestSection:
    @pytest.fixture
    def whole(self, tmp_path, monkeypatch):
        monkeypatch.setattr(section, "euler_figures", lambda: (EULER_FIGURE,))
        monkeypatch.setattr(section, "stick_energies", lambda: (StickEnergy(1e-2, 5.0, 2.0, 2.0, None, 5),))
        return section.section(planted(tmp_path, run("Peer", "velocities", 1e-3, -3.0)))

    def test_it_names_the_machine_and_how_to_measure_another(self, whole):
        text = markdown(whole)
        assert "Measured once: Abacus, 2 cores, Python 3.11, numpy 2" in text
        assert "python -m paper_checks report --trade F" in text

    def test_every_part_has_its_heading_and_every_figure_is_drawn(self, whole, plain_trade):
        headings = [one.text for one in whole.blocks if isinstance(one, Heading)]
        assert len(headings) == len(set(headings)) == 11
        assert set(whole.pictures) == set(section.figures(plain_trade))
        for draw in section.figures(plain_trade).values():
            assert draw().axes

    def test_all_forms_carry_every_table_and_sentence(self, whole):
        tables = [one for one in whole.blocks if isinstance(one, Table)]
        assert HtmlWriter({}).section(whole).count("<table") == len(tables)
        assert LatexWriter({}).section(whole).count(r"\begin{longtable}") == len(tables)
        assert markdown(whole).count("\n| --- |") == len(tables)
        assert HtmlWriter({}).section(whole).count("was not drawn") == len(whole.pictures)

    def test_rows_are_as_long_as_their_heads(self, whole):
        for one in whole.blocks:
            if isinstance(one, Table):
                assert {len(row) for row in one.rows} == {len(one.head)}


class TestUnderAForce:
    PEERS = (
        run("ball", "forced-touch", 2e-3, -15.0),
        run("tanh smoothing", "forced-touch", 1e-2, -2.0, right=False, difference="2 events, not 20"),
        run("heyoka, u(t)", "forced-touch", 1e-4, -12.0),
    )

    def test_its_scenes_have_a_part_of_their_own(self, tmp_path, monkeypatch):
        monkeypatch.setattr(section, "euler_figures", lambda: (EULER_FIGURE,))
        monkeypatch.setattr(section, "stick_energies", lambda: (StickEnergy(1e-2, 5.0, 2.0, 2.0, None, 5),))
        whole = section.section(planted(tmp_path, *self.PEERS, scenes=with_forced()))
        text = markdown(whole)
        before, _, after = text.partition("Under a force")
        assert "forced-touch" not in before
        assert "| tanh smoothing | wrong: 2, 5× |" in after
        assert "heyoka, u(t)" in after
        assert "Measured on Abacus" in after

    def test_a_cell_says_what_is_right_and_the_time_beside_ours(self, tmp_path):
        slow = run("slow, u(t)", "forced-touch", 4e-2, -11.0)
        fine = run("fine, u(t)", "forced-touch", 4e-2, -90.0)
        hung = run("hung, u(t)", "forced-touch", None)
        trade = planted(tmp_path, *self.PEERS, slow, fine, hung, scenes=with_forced()).part(forced=True)
        text = said(under_a_force(trade))
        assert "| ball | 1/1: 15, 2 ms |" in text
        assert "| tanh smoothing | wrong: 2, 5× |" in text
        assert "| heyoka, u(t) | 1/1: 12, 0.05× |" in text
        assert "| slow, u(t) | 1/1: 11, 20× |" in text
        assert "| fine, u(t) | 1/1: 90, – |" in text
        assert "| hung, u(t) | stopped |" in text
        assert "these beat ours at equal or better accuracy, of 1 scenes: " in text
        assert "heyoka, u(t) on 1" in text
        assert "fine, u(t) on 1" in text
        assert "slow, u(t) on" not in text

    def test_without_such_scenes_the_shipped_ones_are_told(self, plain_trade, monkeypatch):
        monkeypatch.setattr(section, "euler_figures", lambda: (EULER_FIGURE,))
        monkeypatch.setattr(section, "stick_energies", lambda: (StickEnergy(1e-2, 5.0, 2.0, 2.0, None, 5),))
        _, _, after = markdown(section.section(plain_trade)).partition("Under a force")
        assert "forced-stick-slip" in after
        assert "| Karnopp's dead zone, u(t) |" in after
        assert "| SciPy DOP853, u(t) |" in after

    @pytest.mark.parametrize(("load", "said_so"), [(0.2, False), (8.0, True), (None, False)])
    def test_a_busy_machine_is_confessed(self, tmp_path, load, said_so):
        machine = {"processor": "Abacus", "cores": 2, "load": load, "python": "3.11", "packages": {}}
        trade = planted(tmp_path, *self.PEERS, scenes=with_forced(), machine=machine).part(forced=True)
        text = said(under_a_force(trade))
        assert ("the machine did other work" in text) == said_so
        assert ("at a load of" in text) == (load is not None)


def test_the_shipped_record_is_advised_on_without_forward_euler():
    from numerics.trade.recorded import recorded

    text = said(section.advice(recorded()))
    assert "Ours have the right event sequence in all" in text
    assert not re.search(r"\bnan\b|\bNone\b", text)


def test_hostile_texts_are_escaped():
    hostile = Section("x", "<b>&", (Paragraph("<i> `a--b<` $x<y$"), Points(("%_<",)), Picture("p", "<c>")))
    page = HtmlWriter({"p": "<svg></svg>"}).section(hostile)
    assert "<b>" not in page
    assert "<i>" not in page
    assert "<code>a-<wbr>-<wbr>b&lt;</code>" in page
    source = LatexWriter({"p": "p.pdf"}).section(hostile)
    assert r"\texttt{a-\allowbreak{}{-\allowbreak{}}b\textless{}}" in source
    assert r"\%\_\textless{}" in source
