"""The LaTeX source compiles by itself and is the PDF, which is a paper: short, with contents, nothing of a screen."""

import re
import shutil
from dataclasses import replace

import pytest

from paper_checks.claims import CLAIMS, claim_named
from paper_checks.drawing.figures import FIGURES
from paper_checks.errors import ToolMissingError
from paper_checks.evidence.claim import FREE, UNDER_A_FORCE
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.report.content import citation, paper
from paper_checks.report.content.blocks import Folded, Paragraph, Picture, Section, Table
from paper_checks.report.content.document import document
from paper_checks.report.formats import latex
from paper_checks.report.formats.latex import shares
from paper_checks.report.output import pictures
from paper_checks.report.output.files import made, shown_in
from paper_checks.running import rows as running
from paper_checks.running.runner import Context, Row

TEX = pytest.mark.skipif(not shutil.which("pdflatex"), reason="pdflatex is not installed")
PAGES, TOO_WIDE = 26, 2.0
"""How long the paper may be, and by how much a line may stick out (points)."""
SCREEN = r"\b(explore|tab|fold|unfold|click|choose|scroll|search|filter|html|browser|page)s?\b"


@pytest.fixture
def source(rows):
    return latex.render(document(rows), {"two-bodies": "figures/two-bodies.pdf"})


def test_environments_and_labels_match(source, rows):
    assert sorted(re.findall(r"\\begin\{(\w+)\}", source)) == sorted(re.findall(r"\\end\{(\w+)\}", source))
    labels = re.findall(r"\\label\{([^}]+)\}", source)
    assert len(labels) == len(set(labels))
    assert {row.claim.id for row in rows} <= set(labels)
    assert {*re.findall(r"\\(?:hyperref\[|ref\{)([^]}]+)[]}]", source)} <= set(labels)
    assert r"keepaspectratio]{figures/two-bodies.pdf}" in source
    assert r"\textless{}script\textgreater{}" in source


def test_a_claim_is_printed_with_what_is_wrong_and_what_is_true_instead(rows):
    printed = {row.claim.id: paper.entry(row).blocks for row in rows}
    for row in rows:
        text = " ".join(one.text for one in printed[row.claim.id])
        found = row.finding
        for said in filter(None, (row.claim.statement, found.counterexample, found.corrected, found.missing)):
            assert said in text
    (whole,) = (one.text for one in printed["energy-rate"])
    assert whole.startswith("[III, after (8); argument] ")
    assert whole.endswith(" Why: An identity.")
    assert [one.label for one in printed["stiction-bracket"]] == ["", "Counterexample", "What is true"]


def test_a_theorem_is_printed_with_what_it_assumes_where_that_is_its_own():
    driven, free = (
        paper.entry(Row(claim_named(name), Finding(Verdict.UNDECIDED, "r", missing="m"))).blocks[0].text
        for name in ("forced-no-zeno", "sharp-rate-constant")
    )
    assert UNDER_A_FORCE in driven
    assert FREE not in free


def test_every_claim_is_printed_once_and_below_its_verdict(rows):
    sections = [one for one in paper.sections(document(rows)) if any(isinstance(block, Folded) for block in one.blocks)]
    printed = {one.id: [block.id for block in one.blocks if isinstance(block, Folded)] for one in sections}
    verdicts = [row.finding.verdict.value for row in rows]
    assert printed == {verdict: [row.claim.id] for verdict, row in zip(verdicts, rows, strict=True)}
    assert sections[0].title == "Claims that are refuted"


SHOWN = Picture("lost", "", "Lost"), Paragraph("See `trust`, energy-rate.")


def test_a_section_is_a_number_and_a_picture_that_is_absent_is_said_to_be(rows):
    source = latex.render(replace(document(rows), front=(Section("model", "", SHOWN),)), {})
    assert "The figure lost was not drawn." in source
    assert source.count(r"See Section~\ref{trust}, \hyperref[energy-rate]{\texttt{energy") == 1


def test_no_column_is_narrower_than_its_longest_word():
    """Columns of a table were printed over each other."""
    table = Table(("row", "what"), (("synchronisation-time", "word " * 80),), "")
    first, second = shares(table)
    assert first > len("synchronisation-") / 95
    assert first + second == pytest.approx(1)
    assert shares(replace(table, rows=(("x" * 90, "y" * 90),))) == [0.5, 0.5]


@TEX
def test_it_compiles_to_the_same_bytes_every_time(rows, figures):
    readable = document([row for row in rows if row.claim.id != "hostile"])  # its mathematics is none on purpose
    drawn = {"two-bodies": pictures.drawn(figures, "two-bodies", "pdf")}
    first, second = (made("pdf", readable, drawn)["report.pdf"] for _ in "12")
    assert first == second
    assert first.startswith(b"%PDF-")
    assert not re.search(rb"CreationDate|dc:date", first)


def properties(pdf):
    """What a PDF says of itself: each text in UTF-16, its bytes as octal numbers."""
    found = re.findall(rb"/(Title|Author|Subject|Keywords)\(([^)]*)\)", pdf)
    plain = {name: re.sub(rb"\\(\d{3})", lambda byte: bytes([int(byte[1], 8)]), text) for name, text in found}
    return {name.decode(): text.decode("utf-16") for name, text in plain.items()}


@TEX
@pytest.mark.slow
def test_the_whole_report_is_a_paper():
    report = document(running.rows(CLAIMS, Context()))
    files = {name: f"figures/{name}.pdf" for name in shown_in("pdf", report)}
    source = latex.render(report, files)
    pdf, log = latex.typeset(source, {file: pictures.drawn(FIGURES, name, "pdf") for name, file in files.items()})
    assert int(re.search(r"Output written on report.pdf \((\d+) pages", log)[1]) <= PAGES
    assert [one for one in re.findall(r"Overfull \\[hv]box \(([\d.]+)pt", log) if float(one) > TOO_WIDE] == []
    assert "LaTeX Warning" not in log
    assert re.findall(SCREEN, source.partition(r"\begin{document}")[2], re.IGNORECASE) == []
    assert source.count(r"\tableofcontents") == 1
    assert properties(pdf) == {
        "Title": report.title,
        "Author": citation.of_package("Author"),
        "Subject": citation.of_package("Summary"),
        "Keywords": citation.of_package("Keywords").replace(",", ", "),
    }


@TEX
def test_what_tex_refuses_is_said_with_the_end_of_its_log():
    with pytest.raises(RuntimeError, match="Undefined control sequence"):
        latex.pdf(r"\documentclass{article}\begin{document}\nosuchcommand\end{document}", {})


def test_without_tex_the_remedy_is_named(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(ToolMissingError, match="pdflatex on the PATH"):
        latex.pdf("", {})
    assert latex.missing() == latex.REMEDY
