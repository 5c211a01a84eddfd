"""The LaTeX source compiles by itself and is the PDF, which is a paper: short, with contents, nothing of a screen."""

import re
import shutil

import pytest

from paper_checks.claims import CLAIMS
from paper_checks.drawing.figures import FIGURES
from paper_checks.errors import ToolMissingError
from paper_checks.report.content import citation
from paper_checks.report.content.document import paper
from paper_checks.report.formats import latex, vector
from paper_checks.report.formats.latex import shares
from paper_checks.report.output.command_line import written
from paper_checks.running import rows as running
from paper_checks.running.runner import Context

TEX = pytest.mark.skipif(not shutil.which("pdflatex"), reason="pdflatex is not installed")
PAGES, TOO_WIDE = 26, 2.0
"""How long the paper may be, and by how much a line may stick out (points)."""
SCREEN = r"\b(explore|tab|fold|unfold|click|choose|scroll|search|filter|html|browser|page)s?\b"


def test_every_claim_is_printed_once_below_its_verdict_with_what_is_true_instead(rows):
    printed = {one.id: [block for block in one.blocks if block.kind == "entry"] for one in paper(rows).chapters}
    found = {verdict: [block.id for block in entries] for verdict, entries in printed.items() if entries}
    assert found == {row.finding.verdict.value: [row.claim.id] for row in rows}
    assert next(iter(found)) == "refuted"
    (whole,) = printed["holds"][0].inside
    assert whole.text.startswith("[III, after (8); argument] ")
    assert whole.text.endswith(" Why: An identity.")
    finding = next(row.finding for row in rows if row.claim.id == "stiction-bracket")
    told = {block.label: block.text for block in printed["holds-corrected"][0].inside[1:]}
    assert told == {"Counterexample": finding.counterexample, "What is true": finding.corrected}


def test_no_column_is_narrower_than_its_longest_word():
    """Columns of a table were printed over each other."""
    first, second = shares([("row", "what"), ("synchronisation-time", "word " * 80)])
    assert first > len("synchronisation-") / 95
    assert first + second == pytest.approx(1)
    assert shares([("row", "what"), ("x" * 90, "y" * 90)]) == [0.5, 0.5]


@TEX
def test_it_compiles_to_the_same_bytes_every_time(rows, figures):
    readable = paper([row for row in rows if row.claim.id != "hostile"])  # its mathematics is none on purpose
    drawn = {"two-bodies": vector.pdf(figures["two-bodies"]())}
    first, second = (written("pdf", readable, drawn)["report.pdf"] for _ in "12")
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
    report = paper(running.rows(CLAIMS, Context()))
    files = {name: f"figures/{name}.pdf" for name in report.pictures}
    source = latex.render(report, files)
    pdf, log = latex.typeset(source, {file: vector.pdf(FIGURES[name]()) for name, file in files.items()})
    assert int(re.search(r"Output written on report.pdf \((\d+) pages", log)[1]) <= PAGES
    assert [one for one in re.findall(r"Overfull \\[hv]box \(([\d.]+)pt", log) if float(one) > TOO_WIDE] == []
    assert "LaTeX Warning" not in log
    assert re.findall(SCREEN, source.partition(r"\begin{document}")[2], re.IGNORECASE) == []
    assert source.count(r"\tableofcontents") == 1
    assert properties(pdf) == {
        "Title": latex.TITLE,
        "Author": citation.of_package("Author"),
        "Subject": citation.of_package("Summary"),
        "Keywords": citation.of_package("Keywords").replace(",", ", "),
    }


@TEX
def test_what_tex_refuses_is_said_with_the_end_of_its_log():
    with pytest.raises(RuntimeError, match="Undefined control sequence"):
        latex.typeset(r"\documentclass{article}\begin{document}\nosuchcommand\end{document}", {})


def test_without_tex_the_remedy_is_named(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(ToolMissingError, match="pdflatex on the PATH"):
        latex.typeset("", {})
    assert latex.missing() == latex.REMEDY
