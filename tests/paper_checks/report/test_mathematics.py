"""LaTeX in prose becomes MathML, Unicode and LaTeX; nothing hostile gets through."""

import tomllib
from pathlib import Path
from xml.etree import ElementTree

import pytest

from paper_checks.claims import CLAIMS
from paper_checks.report.mathematics.mathml import UnreadableMathematicsError, mathml
from paper_checks.report.mathematics.prose import Span, html, latex, pieces, plain

MADE = tomllib.loads(Path(__file__).with_name("mathematics.toml").read_text("utf-8"))


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.id)
def test_every_statement_can_be_read_in_every_form(claim):
    """An index is no product either, as sympy would make of a name that it splits at its underscore."""
    for text in (claim.statement, claim.corrected or "", claim.where):
        assert "<code>" not in html(text)
        assert not {"\\", "$"} & set(plain(text))
        assert "U+" not in latex(text)
        for content in (content for kind, content in pieces(text) if kind is not Span.PROSE):
            tree = ElementTree.fromstring(mathml(content).replace("&ApplyFunction;", ""))
            assert not any("⋅" in "".join(node[1].itertext()) for node in tree.iter("msub"))


@pytest.mark.parametrize(("source", "element"), MADE["set"])
def test_a_browser_sets_it_as_tex_does(source, element):
    assert element in mathml(source)


@pytest.mark.parametrize("latex_source", [r"\foo{x}", r"\frac{a}", "{"])
def test_unknown_mathematics_is_refused_and_shown_as_code(latex_source):
    with pytest.raises(UnreadableMathematicsError):
        mathml(latex_source)
    assert html(f"${latex_source}$").startswith("<code>")


def test_prose_is_escaped():
    assert html('<script>"&') == "&lt;script&gt;&quot;&amp;"
    assert "<script" not in html(r"$\text{<script>}$")
    assert "<script" not in html(r"$\text{<script></script>}$")
    assert latex("100% & #_^~{}\\") == (r"100\% \& \#\_\textasciicircum{}\textasciitilde{}\{\}\textbackslash{}")
    assert latex("0." + "1" * 24) == r"0.11111111\allowbreak{}11111111\allowbreak{}11111111"
    assert latex("x ≤ y ẋ") == "x ≤ y [U+1E8B]"


def test_a_ball_is_shown_as_midpoint_and_radius():
    assert html("at t = [-0.25 +/- 4.18e-14] s") == "at t = −0.25 ± 4.18e-14 s"
    assert latex("[+/- 1e-9], [1.5e+22 +/- 3]") == "0 ± 1e-9, 1.5e+22 ± 3"


@pytest.mark.parametrize(("source", "text"), MADE["plain"])
def test_plain_text(source, text):
    assert plain(f"${source}$") == text
