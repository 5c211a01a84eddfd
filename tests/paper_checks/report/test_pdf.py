"""The PDF carries the same rows; its mathematics is that of the page; without typst there is a remedy."""

import builtins
import re

import pytest

from paper_checks.claims import CLAIMS
from paper_checks.errors import ToolMissingError
from paper_checks.report.content.blocks import pictures
from paper_checks.report.content.document import document, summary
from paper_checks.report.formats import pdf, vector
from paper_checks.report.formats.typst_blocks import escaped
from paper_checks.report.mathematics.typst import typst


@pytest.mark.parametrize(
    ("source", "markup"),
    [
        (r"\frac{b}{m_2}", "$frac(b, attach(m, b: 2))$"),
        (r"\mathrm{sgn}(v)", r'$upright("sgn") \( v \)$'),
        (r"\sin^3\theta", '$attach(op("sin"), t: 3)  space.thin  θ$'),
        (r"\ddot{x}_1", "$attach(accent(x, dot.double), b: 1)$"),
        (r"\sqrt{M/a}", r"$sqrt(M \/ a)$"),
        (r"\begin{pmatrix}1\\ 2\end{pmatrix}", r"$\( mat(delim: #none, 1; 2) \)$"),
    ],
)
def test_mathematics_goes_by_the_same_tree_as_the_page(source, markup):
    assert typst(source) == markup


def test_prose_is_escaped():
    assert escaped("#a $b$ *c* _d_ `e` @f") == r"\#a \$b\$ \*c\* \_d\_ \`e\` \@f"


def test_every_row_and_link_is_in_the_source(rows):
    source = pdf.source(document(rows), {})
    labels = re.findall(r"<([a-zA-Z0-9-]+)>", re.sub(r"#link\(<[^>]+>\)", "", source))
    assert {row.claim.id for row in rows} <= set(labels)
    assert set(re.findall(r"#link\(<([^>]+)>\)", source)) <= set(labels)


def test_on_paper_steps_are_left_out_with_a_word_on_where_they_are(rows):
    whole, paper = document(rows), document(rows).on_paper()
    assert pdf.source(paper, {}).count("Steps, each above those it rests on") == 0
    assert pdf.source(whole, {}).count("Steps, each above those it rests on") == len(rows) - 1
    assert "HTML form" in pdf.source(paper, {})
    assert set(paper.anchors) <= {*whole.anchors, "steps"}


def test_on_paper_a_picture_of_several_rows_stands_at_the_first_and_the_others_lead_to_it(rows):
    whole, paper = document(rows), document(rows).on_paper()
    first, second = [row.claim.id for row in rows if row.finding.figure == "sine"][:2]
    assert [[one.name for one in pictures(whole.stories[row])] for row in (first, second)] == [["sine"], ["sine"]]
    assert [[one.name for one in pictures(paper.stories[row])] for row in (first, second)] == [["sine"], []]
    assert f"drawn under `{first}`" in str(paper.stories[second])
    assert paper.pictures == whole.pictures


def test_it_compiles_with_every_statement_of_the_ledger(rows, figures):
    pytest.importorskip("typst")
    pictures = {name: vector.svg(draw()) for name, draw in figures.items()}
    assert pdf.render(document(rows), pictures).startswith(b"%PDF-")
    assert pdf.render(summary(rows), pictures).startswith(b"%PDF-")


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.id)
def test_no_mathematics_of_the_ledger_is_lost(claim):
    from paper_checks.report.formats.typst_blocks import TypstWriter

    written = TypstWriter({}).text(f"{claim.statement} {claim.where}")
    assert "#raw" not in written


def test_without_typst_the_remedy_is_named(rows, monkeypatch):
    real = builtins.__import__

    def no_typst(name, *rest, **more):
        if name == "typst":
            raise ModuleNotFoundError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", no_typst)
    with pytest.raises(ToolMissingError, match=r"pip install 'inertial-pair\[pdf\]'"):
        pdf.render(document(rows), {})
    assert pdf.missing() == pdf.REMEDY
