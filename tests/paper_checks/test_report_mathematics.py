"""LaTeX in prose becomes MathML, Unicode and LaTeX; nothing hostile gets through."""

import pytest

from paper_checks.ledger import CLAIMS
from paper_checks.report.mathematics import (
    Piece,
    UnreadableMathematicsError,
    html,
    latex,
    mathml,
    pieces,
    plain,
)


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.id)
def test_every_statement_can_be_read_in_every_form(claim):
    for text in (claim.statement, claim.where):
        assert "<code>" not in html(text)
        assert "\\" not in plain(text)
        assert "$" not in plain(text)
        assert "U+" not in latex(text)


def test_pieces():
    text = r"a $x$ b $$y$$ \$5 c"
    assert list(pieces(text)) == [
        (Piece.PROSE, "a "),
        (Piece.INLINE, "x"),
        (Piece.PROSE, " b "),
        (Piece.DISPLAY, "y"),
        (Piece.PROSE, " $5 c"),
    ]
    assert list(pieces("100 $ alone")) == [(Piece.PROSE, "100 $ alone")]


def test_mathematics_becomes_mathml():
    assert "<msub>" in html("$x_1$")
    assert 'display="block"' in html("$$x$$")
    assert "<mo>&#x02A7D;</mo>" in mathml(r"a\leqslant b")
    assert '<mo form="prefix">&#x02212;</mo>' in mathml("a=-b")
    assert '<mo form="prefix">&#x02212;</mo>' in mathml(r"0,\,-1")
    assert mathml(r"\bigl(a\bigr)").count('lspace="0"') == 2
    assert "\\" not in mathml(r"\Bigl\{a\Bigr\}")
    assert '<mo form="prefix">' not in mathml("(a)-b")
    assert '<mo form="prefix">' not in mathml("|a|-b")


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
    assert latex("x ≤ y ẋ") == r"x $\leq$ y [U+1E8B]"


@pytest.mark.parametrize(
    ("source", "text"),
    [
        (r"\ddot{x}_1 \leqslant \tfrac{b}{m_2}", "ẍ₁ ≤b/m₂"),
        (r"\frac{a+b}{2a}x", "(a+b)/(2a) x"),
        (r"x_1\to\mathrm{const}", "x₁→const"),
        (r"t_{k+1}-\tau_k\to 0", "t_(k+1)-τ_k→0"),
        (r"\left\{E=E_0\right\}\cap S_0", "{E=E₀}∩S₀"),
    ],
)
def test_plain_text(source, text):
    assert plain(f"${source}$") == text
