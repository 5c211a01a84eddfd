"""What the page is made of: its font, its colours in the dark, its graph, its notation, its provenance."""

import re
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp
from fontTools.ttLib import TTFont

from numerics.scene.file import load_scene
from paper_checks.claims import CLAIMS, source
from paper_checks.drawing.sharp_rate import limit_of
from paper_checks.report.content import highlights, notation, opening, trust
from paper_checks.report.content.blocks import Graph, Table
from paper_checks.report.content.document import document
from paper_checks.report.content.highlights import HIGHLIGHTS
from paper_checks.report.formats import colours, html
from paper_checks.report.formats.html_graph import graph
from paper_checks.report.mathematics import font
from paper_checks.report.mathematics.mathml import tree
from paper_checks.report.mathematics.prose import Piece, pieces
from theory.near_critical import rate_constant
from theory.symbols import a2, b, m1, m2


@pytest.fixture(scope="module")
def glyphs():
    with TTFont(font.FILE) as found:
        assert "MATH" in found
        return set(found.getBestCmap())


def test_the_font_has_every_character_that_it_promises(glyphs):
    assert set(map(ord, font.CHARACTERS)) <= glyphs


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.id)
def test_the_font_has_every_character_of_a_statement(claim, glyphs):
    for kind, content in pieces(f"{claim.statement} {claim.corrected or ''}"):
        if kind is not Piece.PROSE:
            assert set("".join(tree(content).itertext())) <= set(map(chr, glyphs))


def test_the_font_is_embedded_under_a_name_of_its_own():
    assert font.face().startswith('@font-face { font-family: "Report Math"; src: url(data:font/woff;base64,')
    with TTFont(font.FILE) as found:
        names = {str(record) for record in found["name"].names if record.nameID != 0}
    assert names == {"Report Math", "ReportMath"}


def lightness(colour):
    return sum(int(colour[i : i + 2], 16) for i in (1, 3, 5))


def test_what_is_dark_on_white_is_light_in_the_dark():
    svg = '<svg><path style="fill: #1b4f8f; stroke: #F2F2F2"/></svg>'
    assert colours.themed(svg) == '<svg><path style="fill: var(--c-1b4f8f); stroke: var(--c-f2f2f2)"/></svg>'
    light, dark = colours.rules([svg]).split("@media")
    assert "--c-1b4f8f: #1b4f8f;" in light
    (ink,) = re.findall(r"--c-1b4f8f: (#\w{6});", dark)
    (panel,) = re.findall(r"--c-f2f2f2: (#\w{6});", dark)
    assert lightness(ink) > 300 > lightness(panel)


def test_a_graph_links_what_the_page_has_and_draws_what_rests_on_it(rows):
    (drawn,) = [block for block in trust.graph(rows).blocks if isinstance(block, Graph)]
    text = graph(drawn, {"energy-rate"}, str)
    assert '<a href="#energy-rate">' in text
    assert '<a href="#hostile">' not in text
    assert ">hostile</text>" in text


def test_every_symbol_has_an_anchor_and_is_found_where_it_is_used():
    (table,) = [block for block in notation.section().blocks if isinstance(block, Table)]
    assert len(table.ids) == len(set(table.ids)) == len(table.rows)
    for name, symbol in notation.SYMBOLS.items():
        if name not in ("d",):  # its first letter stands for derivatives too
            assert name in notation.used([f"${symbol.latex}$"]), name
    assert notation.used(["the word b, no formula"]) == ()
    assert "force" not in notation.used([r"$\mu+\tau u'$"])


def test_the_counts_are_those_of_the_rows(rows):
    assert opening.counts(rows[:1]) == "The claim holds as written."
    assert opening.counts(rows[:2]) == "Of the paper's 2 claims 1 holds as written and 1 is refuted."


def test_results_are_shown_only_with_the_verdict_on_record(rows):
    assert opening.section(rows).pictures == []  # none of the three rows is among these


@pytest.mark.parametrize("name", HIGHLIGHTS)
def test_the_numbers_of_the_first_screen_are_computed(name):
    result = HIGHLIGHTS[name]()
    expected = {
        "start-at-6mm-sticks": ("0.6 N", "at most 0.5 N"),
        "synchronisation-time": ("2.31 mm/s", "1.5 % of the initial speed"),
        "sharp-rate-constant": ("0.3491 mJ s", "$10^{100}$ s"),
    }[name]
    assert result.number == expected[0]
    assert expected[1] in result.what
    assert result.row == name


def test_the_provenance_says_how_to_install_as_the_readme_does(rows):
    readme = (Path(__file__).parents[3] / "README.md").read_text(encoding="utf-8")
    assert readme.partition("```sh\n")[2].partition("\n```")[0] == trust.INSTALL
    text = html.render(document(rows), {})
    assert f"{trust.SOFTWARE}, version " in text
    assert 'installed as <a href="#provenance">' in text


def test_a_file_is_the_source_or_it_is_not(tmp_path):
    other = tmp_path / "other.tex"
    other.write_text("\\title{Another paper}")
    assert not source.is_the_source(other)
    assert re.fullmatch("[0-9a-f]{64}", source.SHA256)
    citation = Path(__file__).parents[3] / "CITATION.cff"
    assert all(text in citation.read_text(encoding="utf-8") for text in (source.SHA256, source.TITLE))


def test_the_limit_of_the_first_screen_is_that_of_its_row():
    assert highlights._rate_in_words() == (
        r"\frac{4 \pi}{9}\,\frac{m_{1}}{m_{2}}\,\sqrt{\frac{m_1+m_2}{a_{2}}}\,E_{cr}"
    )
    pair = load_scene("start-with-speed").pair
    value = rate_constant().subs({m1: 1, m2: 1, a2: 200, b: sp.Rational(1, 2)})
    assert (pair.m1, pair.m2, pair.a2, pair.b) == (1, 1, 200, Fraction(1, 2))
    assert sp.simplify(limit_of(pair) - value) == 0
