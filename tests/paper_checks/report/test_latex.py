"""The LaTeX report carries the same content and compiles by itself."""

import re
import shutil
import subprocess

import pytest

from paper_checks.report.content.document import document
from paper_checks.report.formats import latex
from paper_checks.report.output.files import write


@pytest.fixture
def source(rows):
    return latex.render(document(rows), {"sine": "sine.pdf"})


def test_environments_and_labels_match(source, rows):
    assert sorted(re.findall(r"\\begin\{(\w+)\}", source)) == sorted(re.findall(r"\\end\{(\w+)\}", source))
    labels = re.findall(r"\\label\{([^}]+)\}", source)
    assert len(labels) == len(set(labels))
    assert {row.claim.id for row in rows} <= set(labels)
    assert set(re.findall(r"\\hyperref\[([^]]+)\]", source)) <= set(labels)


def test_the_content_is_that_of_the_rows(source):
    for text in ("Counterexample.", "What is true.", "Missing for a proof.", r"$x_1(0)=0.006$", "500 cases"):
        assert text in source
    assert r"keepaspectratio]{sine.pdf}" in source
    assert r"\textless{}b\textgreater{}100\%" in source


@pytest.mark.skipif(not shutil.which("pdflatex"), reason="pdflatex is not installed")
def test_it_compiles(rows, figures, tmp_path):
    readable = [row for row in rows if row.claim.id != "hostile"]  # its mathematics is none on purpose
    (path,) = write(tmp_path, ("latex",), document(readable), figures, lambda complaint: None)
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", path.name]
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False, timeout=120)
    assert result.returncode == 0, result.stdout[-2000:]
