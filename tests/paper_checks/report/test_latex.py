"""The LaTeX report carries the same content, compiles by itself, and is the PDF; without TeX there is a remedy."""

import re
import shutil

import pytest

from paper_checks.errors import ToolMissingError
from paper_checks.report.content.document import document
from paper_checks.report.formats import latex
from paper_checks.report.output import pictures
from paper_checks.report.output.files import made

TEX = pytest.mark.skipif(not shutil.which("pdflatex"), reason="pdflatex is not installed")


@pytest.fixture
def source(rows):
    return latex.render(document(rows), {"sine": "sine.pdf"})


def test_environments_and_labels_match(source, rows):
    assert sorted(re.findall(r"\\begin\{(\w+)\}", source)) == sorted(re.findall(r"\\end\{(\w+)\}", source))
    labels = re.findall(r"\\label\{([^}]+)\}", source)
    assert len(labels) == len(set(labels))
    assert {row.claim.id for row in rows} <= set(labels)
    assert set(re.findall(r"\\hyperref\[([^]]+)\]", source)) <= set(labels)
    assert r"keepaspectratio]{sine.pdf}" in source
    assert r"\textless{}b\textgreater{}100\%" in source


@TEX
def test_it_compiles_to_the_same_bytes_every_time(rows, figures):
    readable = document([row for row in rows if row.claim.id != "hostile"])  # its mathematics is none on purpose
    drawn = {"sine": pictures.drawn(figures, "sine", "pdf")}
    first, second = (made("pdf", readable, drawn)["report.pdf"] for _ in "12")
    assert first == second
    assert first.startswith(b"%PDF-")
    assert not re.search(rb"CreationDate|dc:date", first)


@TEX
def test_what_tex_refuses_is_said_with_the_end_of_its_log():
    with pytest.raises(RuntimeError, match="Undefined control sequence"):
        latex.pdf(latex.PREAMBLE + r"\begin{document}\nosuchcommand\end{document}", {})


def test_without_tex_the_remedy_is_named(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(ToolMissingError, match="pdflatex on the PATH"):
        latex.pdf("", {})
    assert latex.missing() == latex.REMEDY
