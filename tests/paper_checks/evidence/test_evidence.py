"""A finding cannot claim more than its evidence carries."""

import pytest

from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject
from paper_checks.evidence.finding import Finding, InvalidFindingError, Verdict, conclude

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
        assert Finding(verdict, "r", (FAILED, COUNTER, CORRECTION), **CORRECTED).verdict is verdict
    for verdict in (Verdict.UNDECIDED, Verdict.UNCHECKED):
        assert Finding(verdict, "r", (SAMPLE,), missing="a proof").verdict is verdict


OVERREACHING = {
    "no reason": (Verdict.HOLDS, " ", (EXACT,), {}),
    "no evidence": (Verdict.HOLDS, "r", (), {}),
    "only samples": (Verdict.HOLDS, "r", (SAMPLE,), {}),
    "a failed step": (Verdict.HOLDS, "r", (EXACT, FAILED), {}),
    "a silent step": (Verdict.HOLDS, "r", (EXACT, SILENT), {}),
    "holds with a counterexample": (Verdict.HOLDS, "r", (EXACT,), {"counterexample": "c"}),
    "decisive evidence about something else": (Verdict.HOLDS, "r", (CORRECTION,), {}),
    "refuted without counterexample": (Verdict.REFUTED, "r", (COUNTER, CORRECTION), {"corrected": "c"}),
    "refuted without correction": (Verdict.REFUTED, "r", (COUNTER, CORRECTION), {"counterexample": "c"}),
    "unchecked counterexample": (Verdict.REFUTED, "r", (CORRECTION,), CORRECTED),
    "unchecked correction": (Verdict.HOLDS_CORRECTED, "r", (COUNTER,), CORRECTED),
    "sampled correction": (Verdict.HOLDS_CORRECTED, "r", (COUNTER, SAMPLE.as_correction()), CORRECTED),
    "failed correction": (
        Verdict.HOLDS_CORRECTED,
        "r",
        (COUNTER, CORRECTION, FAILED.as_correction()),
        CORRECTED,
    ),
    "failed counterexample": (Verdict.REFUTED, "r", (COUNTER, CORRECTION, FAILED.as_counterexample()), CORRECTED),
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
