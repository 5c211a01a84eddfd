"""A row is as strong as the weakest step that it needs; a theorem of the kernel carries a clause, or turns its row."""

from dataclasses import replace

import pytest
import sympy as sp

from paper_checks.decide import deciders, kernel
from paper_checks.decide.deciders import equals
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, argument, closure, weakest
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.proofs import signed
from paper_checks.proofs.library import Proved
from paper_checks.running.graph import Proof, established_by, proofs
from paper_checks.running.runner import exit_code, row

SMT = Evidence(EvidenceKind.SMT, "z3", "a < b", True)
EXACT = Evidence(EvidenceKind.EXACT, "sympy", "a = a", True)
BALL = Evidence(EvidenceKind.ENCLOSURE, "arb", "a < 1", True)
SAMPLE = Evidence(EvidenceKind.PROPERTY, "numerics", "a < 1", True, cases=9)
FAILED = Evidence(EvidenceKind.EXACT, "sympy", "a = c", False)
SILENT = Evidence(EvidenceKind.SMT, "z3", "a = d", None)


def claim(*clauses, **more):
    return Claim("a-claim", "III", "(8)", clauses or "All is well.", Verdict.HOLDS, **more)


def of(finding, *clauses):
    return row(claim(*clauses), finding, 0.0)


def test_the_weakest_step_counts_and_what_supports_does_not():
    assert weakest([SMT, EXACT]) is EvidenceKind.EXACT
    assert weakest([SMT, SAMPLE, BALL.as_support()]) is EvidenceKind.SMT
    assert weakest([argument("so", SMT)]) is EvidenceKind.ARGUMENT
    assert weakest([SAMPLE]) is None


@pytest.mark.parametrize("kind", [EvidenceKind.KERNEL, EvidenceKind.SMT])
def test_a_step_is_no_stronger_than_what_it_rests_on_however_deep(kind):
    below = Evidence(EvidenceKind.EXACT, "sympy", "so", True, rests_on=(argument("by hand", SMT),))
    assert weakest([Evidence(kind, "k", "all", True, rests_on=(below,))]) is EvidenceKind.ARGUMENT
    assert weakest([Evidence(kind, "k", "all", True, rests_on=(BALL.as_support(),))]) is kind


def test_an_argument_is_as_good_as_what_it_rests_on():
    assert argument("so", SMT, EXACT).passed is True
    assert argument("so", SMT, FAILED).passed is False
    assert argument("so", SMT, SILENT).passed is None
    assert argument("so", SILENT, FAILED).passed is False
    assert argument("so", SMT, SAMPLE).passed is True
    assert argument("so", cites=("Filippov",)).passed is True
    with pytest.raises(ValueError, match="rests on steps, or cites"):
        argument("so")


def test_what_others_rest_on_comes_first_and_once():
    low = argument("low", SMT)
    assert closure([argument("top", low, SMT), low]) == (SMT, low, argument("top", low, SMT))


def test_a_clause_whose_steps_are_not_named_is_an_argument():
    assert of(conclude(Verdict.HOLDS, "So it is.", EXACT)).established_by is EvidenceKind.ARGUMENT
    assert of(conclude(Verdict.HOLDS, "r", carried("statement", EXACT))).established_by is EvidenceKind.EXACT


@pytest.mark.parametrize("weak", [BALL, argument("by hand", cites=("Filippov",)), SILENT])
def test_a_clause_by_reason_needs_every_step(weak):
    """Each of them, wherever it stands; what another clause is carried by is not among them."""
    for steps in ((SMT, weak), (weak, SMT), (EXACT, weak, SMT)):
        finding = Finding(Verdict.HOLDS, "So it is.", tuple(step for step in steps if step.passed))
        (proof,) = proofs(claim(), replace_evidence(finding, steps))
        assert set(proof.steps[0].rests_on) == set(steps)
        assert proof.established_by is (None if weak is SILENT else EvidenceKind.ARGUMENT)


def replace_evidence(finding, steps):
    """The finding with other evidence, not judged."""
    object.__setattr__(finding, "evidence", steps)
    return finding


def test_a_row_is_as_strong_as_its_weakest_clause():
    finding = conclude(Verdict.HOLDS, "r", carried("one", SMT), carried("two", BALL))
    assert of(finding, clause("one", "A,"), clause("two", "B.")).established_by is EvidenceKind.ENCLOSURE


CORRECTED = (BALL.as_counterexample(), SMT.as_correction()), {"corrected": "B.", "counterexample": "x = 1"}


@pytest.mark.parametrize(
    ("verdict", "steps", "more"), [(Verdict.HOLDS, (EXACT,), {}), (Verdict.HOLDS_CORRECTED, *CORRECTED)]
)
def test_a_wrong_formula_turns_the_row(verdict, steps, more):
    """One that is quoted beside its counterexample too."""
    right = Formula("E", "=", sp.Symbol("m1"), equals(lambda: sp.Symbol("m1")))
    wrong = Formula("E", "=", sp.Symbol("m2"), equals(lambda: sp.Symbol("m1")))
    finding = conclude(verdict, "r", *steps, **more)
    assert of(finding, clause("c", "«e».", e=right)).finding.verdict is verdict
    turned = of(finding, clause("c", "«e».", e=wrong))
    assert (turned.finding.verdict, turned.established_by) == (Verdict.UNDECIDED, None)
    assert "$E=m_{2}$" in (turned.finding.missing or "")


@pytest.mark.parametrize("relation", ["!=", "<", "<=", ">", ">="])
def test_what_derives_an_equality_passes_no_other_relation(relation):
    m1 = sp.Symbol("m1", positive=True)
    assert Formula("E", relation, m1, equals(lambda: m1)).evidence().passed is not True


HOLDS = {name: passed for passed, name in kernel.STATUS.items()}


@pytest.fixture
def theorems(monkeypatch):
    """Plant how the theorem of a row stands, and those that it is tied to or uses."""
    monkeypatch.setattr(signed, "is_signed", lambda *_: True)

    def plant(status, ties=(), uses=(), others=kernel.PROVED):
        other = Proved("", "Law.sharp_law", "It is so.", "forall x, x = x", {}, (), (), (), HOLDS[others])
        top = replace(other, uses=uses, ties=ties, holds=HOLDS[status])
        monkeypatch.setattr(kernel, "theorem", lambda name: replace(top if name == "sharp-law" else other, id=name))
        kernel.step.cache_clear()

    yield plant
    kernel.step.cache_clear()


@pytest.mark.parametrize(
    ("status", "verdict", "kind"),
    [
        (kernel.PROVED, Verdict.HOLDS, EvidenceKind.KERNEL),
        (kernel.NOT_RUN, Verdict.HOLDS, EvidenceKind.ARGUMENT),
        (kernel.FAILED, Verdict.UNDECIDED, None),
    ],
)
def test_the_kernel_carries_a_clause_or_leaves_it_to_the_other_steps(theorems, status, verdict, kind):
    theorems(status)
    finding = conclude(Verdict.HOLDS, "r", carried("c", argument("so", EXACT)))
    found = of(finding, clause("c", "All.", kernel="sharp-law"))
    assert (found.finding.verdict, found.established_by, found.kernel) == (verdict, kind, status)
    if status == kernel.FAILED:
        assert "sharp-law" in found.finding.reason


@pytest.mark.parametrize("status", [kernel.PROVED, kernel.NOT_RUN, kernel.FAILED])
def test_a_theorem_about_something_else_than_the_theory_proves_nothing(theorems, status):
    theorems(kernel.PROVED, ties=("tie-ray",), others=status)
    found = kernel.step("sharp-law")
    assert found.passed is HOLDS[status]
    assert ("tie-ray" in found.value) == (status != kernel.PROVED)


def test_a_theorem_of_the_kernel_rests_on_those_that_it_uses(theorems):
    theorems(kernel.PROVED, uses=("rate", "limit"))
    found = kernel.step("sharp-law")
    assert [kernel.name_of(one) for one in found.rests_on] == ["rate", "limit"]
    assert [kernel.name_of(one) for one in closure([found])] == ["rate", "limit", "sharp-law"]


def test_what_is_not_settled_at_a_point_does_not_fail_there(monkeypatch):
    monkeypatch.setattr(deciders, "holds_at", lambda *_: lambda _: SILENT)
    assert Formula("E", "=", 1, deciders.fails_at({}), false=True).evidence().passed is None


def test_one_theorem_of_two_does_not_carry_a_clause():
    """What is proved without the other is not the whole: the clause's other steps carry it."""
    one, other = (Evidence(EvidenceKind.KERNEL, "Coq", name, passed) for name, passed in (("a", True), ("b", None)))
    whole = Proof(clause("c", "All."), Subject.CLAIM, (SMT,), (one, other), ())
    assert not whole.by_kernel
    assert (whole.established_by, whole.kernel_status) == (EvidenceKind.SMT, kernel.NOT_RUN)
    assert replace(whole, kernel=(one, one)).established_by is EvidenceKind.KERNEL
    assert replace(whole, kernel=(one, other), steps=(FAILED,)).established_by is None


@pytest.mark.parametrize("binding", [FAILED, SILENT])
def test_a_clause_whose_formula_does_not_pass_is_not_established(binding):
    open_clause = Proof(clause("c", "All."), Subject.CLAIM, (SMT,), (), (binding,))
    assert open_clause.established_by is None
    assert established_by([open_clause, replace(open_clause, bindings=())]) is None
    assert established_by([replace(open_clause, bindings=())]) is EvidenceKind.SMT
    assert established_by([replace(open_clause, bindings=(BALL,))]) is EvidenceKind.ENCLOSURE
    assert established_by([replace(open_clause, steps=(), bindings=(BALL,))]) is None


def test_a_formula_that_is_not_decided_turns_the_row_too():
    """One that waits for the kernel, too."""
    silent = Formula("E", "=", sp.Symbol("m2"), lambda _: SILENT)
    for finding in (conclude(Verdict.HOLDS, "r", EXACT), Finding(Verdict.UNCHECKED, "r", missing="the proof kernel")):
        turned = of(finding, clause("c", "«e».", e=silent))
        assert (turned.finding.verdict, turned.finding.missing) == (Verdict.UNDECIDED, SILENT.statement)


def test_a_clause_that_nothing_carries_is_not_settled(theorems):
    """Carried by the kernel alone, and the kernel was not run: unchecked; one of both by nothing at all: undecided."""
    finding = conclude(Verdict.HOLDS, "r", carried("one", EXACT))
    alone = clause("two", "B.", kernel="sharp-law")
    theorems(kernel.NOT_RUN)
    waiting = of(finding, clause("one", "A,"), alone)
    assert (waiting.finding.verdict, waiting.established_by) == (Verdict.UNCHECKED, None)
    assert "two" in waiting.finding.missing
    assert waiting.open == ("The clause `two` is not established.",)
    assert exit_code([waiting]) == 3
    bare = of(finding, clause("one", "A,"), alone, clause("three", "C."))
    assert (bare.finding.verdict, exit_code([bare])) == (Verdict.UNDECIDED, 1)
    theorems(kernel.PROVED)
    assert of(finding, clause("one", "A,"), alone).finding.verdict is Verdict.HOLDS


def test_what_is_quoted_beside_its_counterexample_needs_no_step_and_its_correction_does():
    parts = (BALL.as_counterexample(), carried("right", SMT.as_correction()))
    finding = conclude(Verdict.HOLDS_CORRECTED, "r", *parts, corrected="B.", counterexample="x = 1")
    said, right, more = clause("said", "A."), clause("right", "B,"), clause("more", "C.")
    assert row(claim(said, correction=(right,)), finding, 0.0).established_by is EvidenceKind.ENCLOSURE
    assert row(claim(said, correction=(right, more)), finding, 0.0).finding.verdict is Verdict.UNDECIDED
    assert row(claim(said), finding, 0.0).finding.verdict is Verdict.UNDECIDED, "B. has no clause, and no step left"
