"""The derivation: each line is checked, a wrong formula turns it, and a line that does not pass turns its claims."""

import re
import runpy
from dataclasses import replace
from pathlib import Path

import pytest

from paper_checks.claims import claim_named
from paper_checks.derivation import surface
from paper_checks.derivation.chapter import LINES
from paper_checks.derivation.line import clause_named
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import derivation
from paper_checks.report.content.blocks import chapter
from paper_checks.running import runner
from paper_checks.running.planting import faults
from paper_checks.running.rows import rows
from paper_checks.running.runner import Context

DOCS = Path(__file__).resolve().parents[3] / "docs"
PLACES = range(1, len(LINES) + 1)


def passes(line):
    """Whether every check of a line passes."""
    found = line.evidence(1)
    return bool(found) and all(step.passed is True for step in found)


@pytest.mark.parametrize("place", PLACES)
def test_every_line_is_checked_and_each_fault_in_its_formulas_turns_it(place):
    line = LINES[place - 1]
    assert passes(line)
    for formula in line.made():
        wrong = [one for _, one in faults(formula)]
        assert wrong
        assert not [one.latex for one in wrong if passes(replace(line, formulas=lambda one=one: (one,)))]


@pytest.mark.parametrize("place", PLACES)
def test_a_line_carries_clauses_that_exist_and_names_theorems_of_theirs(place):
    clauses = [clause_named(key) for key in LINES[place - 1].clauses]
    assert clauses
    assert set(LINES[place - 1].kernel.split()) <= {name for one in clauses for name in one.kernel}


def row_of(name):
    return rows([claim_named(name)], Context())[0]


def shown(*rows):
    """The lines of the chapter on some rows: by number, what was done and what is remarked."""
    text = chapter("derivation", **derivation.given(rows))
    found = re.findall(r"^\*\*D(\d+)\.\*\* (.*?) \{#line-D\1\}\n\n(.*?)$", text, re.DOTALL | re.MULTILINE)
    return {int(number): (done, remark) for number, done, remark in found}


def test_a_wrong_sign_in_theory_is_said_on_the_line_and_turns_verdict_and_exit_code(monkeypatch):
    lines = [place for place in PLACES if "vector-fields" in LINES[place - 1].claims]
    sound = shown(row_of("vector-fields"))
    assert [*sound] == lines
    assert all(remark.startswith("Checked by: ") for _, remark in sound.values())
    monkeypatch.setattr(surface, "phi", lambda sign, right=surface.phi: right(-sign))
    broken = row_of("vector-fields")
    assert (broken.finding.verdict, runner.exit_code([broken])) == (Verdict.UNDECIDED, 1)
    assert all(remark.startswith("Failed: difference") for _, remark in shown(broken).values())
    with pytest.raises(ValueError, match="not checked: Failed: difference"):
        derivation.markdown("derivation-fields")


def test_the_chapter_has_all_lines_in_order_with_what_their_rows_found():
    rows = [row_of(name) for name in dict.fromkeys(name for line in LINES for name in line.claims)]
    found = shown(*rows)
    assert [*found] == [*PLACES]
    remarks = [remark for _, remark in found.values()]
    assert all(remark.startswith("Checked by: ") for remark in remarks)
    assert all(any(tool in remark for remark in remarks) for tool in derivation.TOOLS.values())
    assert all("argument in words" in found[number][1] for number in (5, 32, 36))
    assert derivation.given(rows)["whole"]
    assert not derivation.given(rows[1:])["whole"]


def test_the_page_in_the_documentation_is_what_is_generated():
    """It is not where a factor in theory is wrong: a line fails, or reads otherwise."""
    module = runpy.run_path(str(DOCS / "derivation.py"))
    assert (DOCS / "derivation.md").read_text("utf-8") == module["page"](), "python docs/derivation.py writes it"


def test_a_theorem_that_was_not_run_is_said_to_be():
    line = next(line for line in LINES if line.kernel)
    found, name = line.evidence(1), line.kernel.split()[0]
    assert f"kernel theorem `{name}` (not run)" in derivation.remark(line, found, {})
    assert f"kernel theorem `{name}`" in derivation.remark(line, found)
    assert "not run" not in derivation.remark(line, found)
    assert derivation.remark(line, [replace(found[0], passed=None)]).startswith("Failed")
