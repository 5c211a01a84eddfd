"""A finding cannot claim more than its evidence carries, and a row is as strong as the weakest step that it needs."""

from dataclasses import replace

import pytest
import sympy as sp

from paper_checks.decide import deciders, kernel
from paper_checks.decide.deciders import equals
from paper_checks.evidence.claim import Claim, because, claim, correction, counterexample
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, argument, closure, weakest
from paper_checks.evidence.finding import Finding, InvalidFindingError, Verdict, carried, conclude
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
WAITING = Evidence(EvidenceKind.KERNEL, "Coq", "the theorem t", None)
BY_HAND = argument("by hand", cites=("Filippov",))
COUNTER, CORRECTION = EXACT.as_counterexample(), EXACT.as_correction()
CORRECTED = {"counterexample": "$a=1$", "corrected": "$a=a$"}


def test_kinds_are_ordered_strongest_first():
    names = [kind.value for kind in sorted(EvidenceKind, key=lambda kind: -kind.strength)]
    assert names == ["kernel", "smt", "exact", "enclosure", "argument", "property", "simulation"]
    assert [kind.value for kind in EvidenceKind if kind.decisive] == names[:5]


@pytest.mark.parametrize(
    ("told", "passed"),
    [
        *(({"cases": cases}, None) for cases in (0, -1)),
        *(({"value": text}, None) for text in ("nan", "[nan +/- inf]", "x = inf", "-Infinity", "[+/- inf]")),
        *(({"value": text}, True) for text in ("1.5", r"$t\to\infty$", "information", r"\inf", "finance")),
    ],
)
def test_vacuous_evidence_and_a_value_that_is_not_finite_are_no_pass(told, passed):
    assert Evidence(EvidenceKind.ENCLOSURE, "arb", "s", True, **told).passed is passed


def test_an_outcome_is_a_truth_value_or_none():
    with pytest.raises(TypeError, match="True, False or None"):
        Evidence(EvidenceKind.EXACT, "sympy", "s", 1)  # type: ignore[arg-type]


def test_a_supported_finding_of_each_verdict_can_be_built():
    assert conclude(Verdict.HOLDS, "r", EXACT) == Finding(Verdict.HOLDS, "r", (EXACT,))
    for verdict in (Verdict.REFUTED, Verdict.HOLDS_CORRECTED):
        assert Finding(verdict, "r", (EXACT, COUNTER, CORRECTION), **CORRECTED).verdict is verdict
    for verdict in (Verdict.UNDECIDED, Verdict.UNCHECKED):
        assert Finding(verdict, "r", (SAMPLE,), missing="a proof").verdict is verdict


OVERREACHING = {
    "no reason": (Verdict.HOLDS, " ", (EXACT,), {}),
    "no evidence": (Verdict.HOLDS, "r", (), {}),
    "only samples": (Verdict.HOLDS, "r", (SAMPLE,), {}),
    "a failed step": (Verdict.HOLDS, "r", (EXACT, FAILED), {}),
    "holds with a counterexample": (Verdict.HOLDS, "r", (EXACT,), {"counterexample": "c"}),
    "decisive evidence about something else": (Verdict.HOLDS, "r", (CORRECTION,), {}),
    "refuted without counterexample": (Verdict.REFUTED, "r", (COUNTER, CORRECTION), {"corrected": "c"}),
    "refuted without correction": (Verdict.REFUTED, "r", (COUNTER, CORRECTION), {"counterexample": "c"}),
    "unchecked counterexample": (Verdict.REFUTED, "r", (CORRECTION,), CORRECTED),
    "unchecked correction": (Verdict.HOLDS_CORRECTED, "r", (COUNTER,), CORRECTED),
    "sampled correction": (Verdict.HOLDS_CORRECTED, "r", (COUNTER, SAMPLE.as_correction()), CORRECTED),
    "failed correction": (Verdict.HOLDS_CORRECTED, "r", (COUNTER, CORRECTION, FAILED.as_correction()), CORRECTED),
    "a failed step beside both": (Verdict.HOLDS_CORRECTED, "r", (FAILED, COUNTER, CORRECTION), CORRECTED),
    "silent counterexample": (Verdict.REFUTED, "r", (COUNTER, CORRECTION, SILENT.as_counterexample()), CORRECTED),
    "undecided without what is missing": (Verdict.UNDECIDED, "r", (SAMPLE,), {}),
}


@pytest.mark.parametrize("case", OVERREACHING)
def test_an_overreaching_finding_cannot_be_built(case):
    verdict, reason, evidence, texts = OVERREACHING[case]
    with pytest.raises(InvalidFindingError, match=verdict.value):
        Finding(verdict, reason, evidence, **texts)


def test_only_a_step_that_passed_and_can_settle_a_claim_decides():
    assert [one.decides for one in (EXACT, FAILED, SILENT, SAMPLE, EXACT.as_support())] == [True, *[False] * 4]


def test_conclude_turns_undecided_and_keeps_the_evidence():
    finding = conclude(Verdict.HOLDS, "r", EXACT, FAILED, figure="f")
    assert (finding.verdict, finding.evidence) == (Verdict.UNDECIDED, (EXACT, FAILED))
    assert "a = c" in finding.reason
    assert "a = c" in (finding.missing or "")


@pytest.mark.parametrize(
    ("steps", "verdict"),
    [
        ((WAITING,), Verdict.UNCHECKED),
        ((WAITING, SILENT), Verdict.UNDECIDED),
        ((WAITING, FAILED), Verdict.UNDECIDED),
        ((replace(WAITING, passed=False),), Verdict.UNDECIDED),
        ((SILENT,), Verdict.UNDECIDED),
    ],
)
def test_only_what_waits_for_the_kernel_alone_is_unchecked(steps, verdict):
    assert conclude(Verdict.HOLDS, "r", EXACT, argument("So it is.", EXACT, *steps)).verdict is verdict


@pytest.mark.parametrize("about", ["said", "correction"])
def test_steps_of_a_corrected_claim_speak_about_what_they_carry(about):
    said, corrected = clause("said", "$a$ is $b$."), clause("correction", "$a$ is not $b$.")

    @claim("a", "II", "w", Verdict.HOLDS_CORRECTED, said, correction=(corrected,))
    def one():
        return because("r", counterexample("c", EXACT), carried(about, EXACT), correction(EXACT))

    found = one.decide()
    assert found.verdict is Verdict.HOLDS_CORRECTED
    (steps,) = (part.steps for part in found.carried)
    assert steps[0].about is (Subject.CORRECTION if about == "correction" else Subject.CLAIM)


# the graph of a proof


def said(*clauses, **more):
    return Claim("a-claim", "III", "(8)", clauses or "All is well.", Verdict.HOLDS, **more)


def of(finding, *clauses, **more):
    return row(said(*clauses, **more), finding, 0.0)


def on(*steps, kind=EvidenceKind.SMT):
    return Evidence(kind, "k", "all", True, rests_on=steps)


@pytest.mark.parametrize(
    ("steps", "kind"),
    [
        ([SMT, EXACT], EvidenceKind.EXACT),
        ([SMT, SAMPLE, BALL.as_support()], EvidenceKind.SMT),
        ([argument("so", SMT)], EvidenceKind.ARGUMENT),
        ([SAMPLE], None),
        ([on(on(argument("by hand", SMT), kind=EvidenceKind.EXACT))], EvidenceKind.ARGUMENT),
        ([on(on(BY_HAND), kind=EvidenceKind.KERNEL)], EvidenceKind.ARGUMENT),
        ([on(BALL.as_support(), kind=EvidenceKind.KERNEL)], EvidenceKind.KERNEL),
    ],
)
def test_the_weakest_step_counts_however_deep_and_what_supports_does_not(steps, kind):
    assert weakest(steps) is kind


@pytest.mark.parametrize(
    ("steps", "passed"),
    [
        ((SMT, EXACT), True),
        ((SMT, FAILED), False),
        ((SMT, SILENT), None),
        ((SILENT, FAILED), False),
        ((SMT, SAMPLE), True),
        ((BY_HAND,), True),
    ],
)
def test_an_argument_is_as_good_as_what_it_rests_on(steps, passed):
    assert argument("so", *steps).passed is passed
    with pytest.raises(ValueError, match="rests on steps, or cites"):
        argument("so")


def test_what_others_rest_on_comes_first_and_once():
    low = argument("low", SMT)
    assert closure([argument("top", low, SMT), low]) == (SMT, low, argument("top", low, SMT))


def test_a_row_is_as_strong_as_its_weakest_clause_and_one_whose_steps_are_not_named_is_an_argument():
    assert of(conclude(Verdict.HOLDS, "So it is.", EXACT)).established_by is EvidenceKind.ARGUMENT
    finding = conclude(Verdict.HOLDS, "r", carried("one", SMT), carried("two", BALL))
    assert of(finding, clause("one", "A,"), clause("two", "B.")).established_by is EvidenceKind.ENCLOSURE


@pytest.mark.parametrize("weak", [BALL, BY_HAND, SILENT])
def test_a_clause_by_reason_needs_every_step(weak):
    """Each of them, wherever it stands; what another clause is carried by is not among them."""
    for steps in ((SMT, weak), (weak, SMT), (EXACT, weak, SMT)):
        finding = Finding(Verdict.HOLDS, "So it is.", (SMT,))
        object.__setattr__(finding, "evidence", steps)  # not judged
        (proof,) = proofs(said(), finding)
        assert set(proof.steps[0].rests_on) == set(steps)
        assert proof.established_by is (None if weak is SILENT else EvidenceKind.ARGUMENT)


def formula(letter, decide=None):
    return Formula("E", "=", sp.Symbol(letter), decide or equals(lambda: sp.Symbol("m1")))


@pytest.mark.parametrize(
    ("verdict", "steps", "more"),
    [
        (Verdict.HOLDS, (EXACT,), {}),
        (Verdict.HOLDS_CORRECTED, (COUNTER, SMT.as_correction()), CORRECTED),  # quoted beside its counterexample
    ],
)
def test_a_wrong_formula_turns_the_row(verdict, steps, more):
    finding = conclude(verdict, "r", *steps, **more)
    assert of(finding, clause("c", "«e».", e=formula("m1"))).finding.verdict is verdict
    turned = of(finding, clause("c", "«e».", e=formula("m2")))
    assert (turned.finding.verdict, turned.established_by) == (Verdict.UNDECIDED, None)
    assert "$E=m_{2}$" in (turned.finding.missing or "")


def test_a_formula_that_is_not_decided_turns_the_row_too():
    """One that waits for the kernel, too."""
    silent = clause("c", "«e».", e=formula("m2", lambda _: SILENT))
    for finding in (conclude(Verdict.HOLDS, "r", EXACT), Finding(Verdict.UNCHECKED, "r", missing="the proof kernel")):
        turned = of(finding, silent).finding
        assert (turned.verdict, turned.missing) == (Verdict.UNDECIDED, SILENT.statement)


@pytest.mark.parametrize("relation", ["!=", "<", "<=", ">", ">="])
def test_what_derives_an_equality_passes_no_other_relation(relation):
    m1 = sp.Symbol("m1", positive=True)
    assert Formula("E", relation, m1, equals(lambda: m1)).evidence().passed is not True


def test_what_is_not_settled_at_a_point_does_not_fail_there(monkeypatch):
    monkeypatch.setattr(deciders, "holds_at", lambda *_: lambda _: SILENT)
    assert Formula("E", "=", 1, deciders.fails_at({}), false=True).evidence().passed is None


def test_a_clause_whose_formula_does_not_pass_is_not_established():
    proof = Proof(clause("c", "All."), Subject.CLAIM, (SMT,), (), ())
    assert established_by([proof]) is EvidenceKind.SMT
    assert established_by([replace(proof, bindings=(BALL,))]) is EvidenceKind.ENCLOSURE
    assert established_by([replace(proof, steps=(), bindings=(BALL,))]) is None
    for binding in (FAILED, SILENT):
        assert established_by([replace(proof, bindings=(binding,)), proof]) is None


def test_what_is_quoted_beside_its_counterexample_needs_no_step_and_its_correction_does():
    parts = (BALL.as_counterexample(), carried("right", SMT.as_correction()))
    finding = conclude(Verdict.HOLDS_CORRECTED, "r", *parts, corrected="B.", counterexample="x = 1")
    quoted, right, more = clause("said", "A."), clause("right", "B,"), clause("more", "C.")
    assert of(finding, quoted, correction=(right,)).established_by is EvidenceKind.ENCLOSURE
    for corrected in ((right, more), ()):  # without a clause, B. has no step left
        assert of(finding, quoted, correction=corrected).finding.verdict is Verdict.UNDECIDED


# theorems of the kernel

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
    assert status != kernel.FAILED or "sharp-law" in found.finding.reason
    theorems(kernel.PROVED, ties=("tie-ray",), others=status)  # one about something else than the theory
    assert kernel.step("sharp-law").passed is HOLDS[status]
    assert ("tie-ray" in kernel.step("sharp-law").value) == (status != kernel.PROVED)


def test_a_theorem_of_the_kernel_rests_on_those_that_it_uses(theorems):
    theorems(kernel.PROVED, uses=("rate", "limit"))
    assert [kernel.name_of(one) for one in closure([kernel.step("sharp-law")])] == ["rate", "limit", "sharp-law"]


def test_one_theorem_of_two_does_not_carry_a_clause():
    """What is proved without the other is not the whole: the clause's other steps carry it."""
    one = replace(WAITING, passed=True)
    whole = Proof(clause("c", "All."), Subject.CLAIM, (SMT,), (one, WAITING), ())
    assert not whole.by_kernel
    assert (whole.established_by, whole.kernel_status) == (EvidenceKind.SMT, kernel.NOT_RUN)
    assert replace(whole, kernel=(one, one)).established_by is EvidenceKind.KERNEL
    assert replace(whole, steps=(FAILED,)).established_by is None


def test_a_clause_that_nothing_carries_is_not_settled(theorems):
    """Carried by the kernel alone, and the kernel was not run: unchecked; one of both by nothing at all: undecided."""
    finding = conclude(Verdict.HOLDS, "r", carried("one", EXACT))
    clauses = clause("one", "A,"), clause("two", "B.", kernel="sharp-law")
    theorems(kernel.NOT_RUN)
    waiting = of(finding, *clauses)
    assert (waiting.finding.verdict, waiting.established_by) == (Verdict.UNCHECKED, None)
    assert "two" in waiting.finding.missing
    assert waiting.open == ("The clause `two` is not established.",)
    assert exit_code([waiting]) == 3
    bare = of(finding, *clauses, clause("three", "C."))
    assert (bare.finding.verdict, exit_code([bare])) == (Verdict.UNDECIDED, 1)
    theorems(kernel.PROVED)
    assert of(finding, *clauses).finding.verdict is Verdict.HOLDS
