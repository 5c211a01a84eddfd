"""A finding cannot claim more than its evidence carries."""

from dataclasses import replace

import pytest

from paper_checks.evidence.claim import because, claim, correction, counterexample
from paper_checks.evidence.clause import clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, argument
from paper_checks.evidence.finding import Finding, InvalidFindingError, Verdict, carried, conclude

EXACT = Evidence(EvidenceKind.EXACT, "sympy", "a = a", True)
SAMPLE = Evidence(EvidenceKind.PROPERTY, "hypothesis", "a = a", True, cases=100)
FAILED = Evidence(EvidenceKind.EXACT, "sympy", "a = b", False)
SILENT = Evidence(EvidenceKind.SMT, "z3", "a = c", None)
COUNTER = EXACT.as_counterexample()
CORRECTION = EXACT.as_correction()
CORRECTED = {"counterexample": "$a=1$", "corrected": "$a=a$"}


def test_kinds_are_ordered_strongest_first():
    names = [kind.value for kind in sorted(EvidenceKind, key=lambda kind: -kind.strength)]
    assert names == ["kernel", "smt", "exact", "enclosure", "argument", "property", "simulation"]
    assert [kind.value for kind in EvidenceKind if kind.decisive] == names[:5]


@pytest.mark.parametrize("cases", [0, -1])
def test_vacuous_evidence_is_no_pass(cases):
    assert Evidence(EvidenceKind.ENCLOSURE, "arb", "s", True, cases=cases).passed is None


@pytest.mark.parametrize("value", ["nan", "[nan +/- inf]", "x = inf", "-Infinity", "[+/- inf]"])
def test_a_value_that_is_not_finite_is_no_pass(value):
    assert Evidence(EvidenceKind.ENCLOSURE, "arb", "s", True, value=value).passed is None


@pytest.mark.parametrize("value", ["1.5", r"$t\to\infty$", "information", r"\inf", "finance"])
def test_words_that_only_look_non_finite_pass(value):
    assert Evidence(EvidenceKind.ENCLOSURE, "arb", "s", True, value=value).passed is True


def test_an_outcome_is_a_truth_value_or_none():
    with pytest.raises(TypeError, match="True, False or None"):
        Evidence(EvidenceKind.EXACT, "sympy", "s", 1)  # type: ignore[arg-type]


def test_a_supported_finding_of_each_verdict_can_be_built():
    assert Finding(Verdict.HOLDS, "r", (EXACT, SAMPLE)).verdict is Verdict.HOLDS
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


@pytest.mark.parametrize(("step", "decides"), [(EXACT, True), (FAILED, False), (SILENT, False), (SAMPLE, False)])
def test_only_a_step_that_passed_and_can_settle_a_claim_decides(step, decides):
    assert step.decides is decides
    assert not step.as_support().decides


def test_conclude_keeps_a_supported_verdict():
    assert conclude(Verdict.HOLDS, "r", EXACT) == Finding(Verdict.HOLDS, "r", (EXACT,))


def test_conclude_turns_undecided_and_keeps_the_evidence():
    finding = conclude(Verdict.HOLDS, "r", EXACT, FAILED, figure="f")
    assert finding.verdict is Verdict.UNDECIDED
    assert finding.evidence == (EXACT, FAILED)
    assert "a = b" in finding.reason
    assert "a = b" in (finding.missing or "")


def test_the_subject_can_be_named():
    assert (COUNTER.about, CORRECTION.about) == (Subject.COUNTEREXAMPLE, Subject.CORRECTION)


WAITING = Evidence(EvidenceKind.KERNEL, "Coq", "the theorem t", None)
SILENT = Evidence(EvidenceKind.SMT, "z3 and cvc5", "a < b", None)


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


def test_words_may_stand_over_several_lines():
    assert clause("a", "one\n    two  three").text == "one two three"
    assert argument("one\n    two", EXACT).statement == "one two"
    assert because("one\n  two", EXACT).reason == "one two"
