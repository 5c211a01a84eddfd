"""The derivation: each line is checked, a wrong formula turns it, and a line that does not pass turns its claims."""

import importlib.util
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from paper_checks.claims import claim_named
from paper_checks.derivation import energy, rate, slip, surface
from paper_checks.derivation.chapter import LINES, STAGES
from paper_checks.derivation.line import clause_named
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import blocks, derivation
from paper_checks.report.formats import markdown
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
    for formula in line.formulas():
        wrong = [one for _, one in faults(formula)]
        assert wrong
        assert not [one.latex for one in wrong if passes(replace(line, formulas=lambda one=one: (one,)))]


@pytest.mark.parametrize("place", PLACES)
def test_a_line_carries_clauses_that_exist_and_names_theorems_of_theirs(place):
    clauses = [clause_named(key) for key in LINES[place - 1].clauses]
    assert clauses
    assert set(LINES[place - 1].kernel.split()) <= {name for one in clauses for name in one.kernel}


def twice(value):
    """What theory finds, wrong by a factor."""
    return type(value)(*(2 * part for part in value)) if isinstance(value, tuple) else 2 * value


BROKEN = {
    surface: "phi transversality half_width sliding_weight weight_margin sliding_field",
    energy: "slip_rate on_surface level_semi_axis critical_energy edge_speed_squared",
    slip: "stick_frequency reduced_slip reduced_energy reduced_guard h_slope",
    rate: "inverse_step reduced_rate_constant rate_constant",
}
"""Functions of theory, by the module that prints what they return."""


@pytest.mark.parametrize(("module", "name"), [(one, name) for one in BROKEN for name in BROKEN[one].split()])
def test_a_factor_in_theory_turns_a_line(monkeypatch, module, name):
    right = getattr(module, name)
    monkeypatch.setattr(module, name, lambda *values: twice(right(*values)))
    assert not all(passes(line) for stage in module.STAGES for line in stage.lines)


def row_of(name):
    return rows([claim_named(name)], Context())[0]


def shown(row):
    """The lines on the page of a row."""
    return [block for block in derivation.story(row) if isinstance(block, blocks.Line)]


def test_a_wrong_sign_in_theory_is_said_on_the_line_and_turns_verdict_and_exit_code(monkeypatch):
    sound = row_of("vector-fields")
    assert [line.passed for line in shown(sound)] == [True] * 3
    monkeypatch.setattr(surface, "phi", lambda sign, right=surface.phi: right(-sign))
    broken = row_of("vector-fields")
    assert (broken.finding.verdict, runner.exit_code([broken])) == (Verdict.UNDECIDED, 1)
    assert not any(line.passed for line in shown(broken))
    assert all("Failed: difference" in line.remark for line in shown(broken))


def test_a_line_without_a_solver_or_without_its_row_is_unchecked(monkeypatch):
    monkeypatch.setitem(sys.modules, "z3", None)
    row = row_of("transversality-strip")
    assert (row.finding.verdict, runner.exit_code([row])) == (Verdict.UNCHECKED, 3)
    assert {line.passed for line in shown(row)} == {False}
    assert all(line.remark.startswith("Unchecked") for line in shown(row))


def test_a_formula_that_cannot_be_derived_costs_itself_only(monkeypatch):
    monkeypatch.setattr(surface, "phi", lambda sign: 1 / 0)
    row = row_of("vector-fields")
    assert row.finding.verdict is Verdict.UNDECIDED
    assert "no formula: ZeroDivisionError" in shown(row)[0].text


def test_a_claim_has_its_lines_in_order_and_the_chapter_has_all_of_them():
    for name in ("critical-energy", "sharp-rate-constant", "transversality-outside", "sliding-region"):
        numbers = [line.number for line in shown(row_of(name))]
        assert numbers == sorted(numbers)
        assert numbers == [place for place in PLACES if name in LINES[place - 1].claims]
    assert [one.number for one in derivation.checked_anew() if isinstance(one, blocks.Line)] == list(PLACES)


def test_the_chapter_needs_all_its_claims_and_then_takes_what_their_rows_found():
    names = dict.fromkeys(name for line in LINES for name in line.claims)
    assert not derivation.section([row_of("critical-energy")]).blocks
    rows = [row_of(name) for name in names]
    found = [block for block in derivation.section(rows).blocks if isinstance(block, blocks.Line)]
    assert [line.passed for line in found] == [True] * len(LINES)
    kinds = {step.kind for row in rows for steps in derivation.of_row(row).values() for step in steps}
    assert kinds == {EvidenceKind.EXACT, EvidenceKind.SMT, EvidenceKind.ENCLOSURE, EvidenceKind.ARGUMENT}
    assert all("argument in words" in line.remark for line in found if line.number in (5, 32, 36))


def test_the_order_is_that_of_the_paper_and_each_stage_says_what_it_assumes():
    text = " ".join(one.done + one.latex() for one in LINES)
    constant = r"\frac{4 \pi E_{cr} m_{1}}{9 m_{2}}"
    marks = (r"\Phi_+=", r"\Phi_-=", "(9)", "(10)", "$$L=", r"\alpha=", "(8)", "E_{cr}=", r"\frac1{w'}", constant)
    places = [text.index(mark) for mark in marks]
    assert places == sorted(places)
    assert all("b>0" in stage.assumed for stage in STAGES)
    assert all("a_1=0" in stage.assumed for stage in STAGES[1:])


def test_the_page_in_the_documentation_is_what_is_generated():
    spec = importlib.util.spec_from_file_location("docs_derivation", DOCS / "derivation.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert (DOCS / "derivation.md").read_text("utf-8") == module.page(), "python docs/derivation.py writes it"
    with pytest.raises(ValueError, match="no block"):
        markdown.written([blocks.Line(1, "x", "y", passed=False)])


def test_a_theorem_is_not_run_in_the_chapter_and_not_named_on_the_page_of_a_claim_that_does_not_need_it():
    line = next(line for line in LINES if line.kernel)
    found = line.evidence(1)
    assert "kernel theorem" in derivation.shown(line, found, {}).remark
    assert "(not run)" in derivation.shown(line, found, {}).remark
    assert "kernel theorem" not in derivation.shown(line, found, {}, own=line.claims[0]).remark
