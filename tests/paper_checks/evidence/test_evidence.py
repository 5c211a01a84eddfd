"""A finding cannot claim more than its evidence carries, and a row is as strong as the weakest step that it needs."""

from dataclasses import replace

import pytest
import sympy as sp

from paper_checks.decide import kernel
from paper_checks.decide.deciders import equals
from paper_checks.evidence.claim import Claim, because, claim, correction, counterexample
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Subject, argument, closure, reading, weakest
from paper_checks.evidence.finding import Finding, InvalidFindingError, Verdict, carried, conclude
from paper_checks.proofs.library import Proved
from paper_checks.running.graph import Proof, proofs
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
STEPS = {
    "exact": EXACT,
    "sample": SAMPLE,
    "failed": FAILED,
    "silent": SILENT,
    "support": EXACT.as_support(),
    "counter": COUNTER,
    "silent-counter": SILENT.as_counterexample(),
    "correction": CORRECTION,
    "sampled-correction": SAMPLE.as_correction(),
    "failed-correction": FAILED.as_correction(),
}


def test_kinds_are_ordered_strongest_first():
    names = [kind.value for kind in sorted(EvidenceKind, key=lambda kind: -kind.strength)]
    assert names == ["kernel", "smt", "exact", "enclosure", "argument", "property", "simulation", "reading"]
    assert [kind.value for kind in EvidenceKind if kind.decisive] == names[:5]


INFERENCES = """so hence thus therefore then because since implies imply follow follows consequently whence
prove proves show shows"""


@pytest.mark.parametrize(
    ("words", "meaning", "missing"),
    [
        *(("they stick", f"$v_1=v_2$, {word} $E$ is constant", "infers nothing") for word in INFERENCES.split()),
        ("they stick", "$v_1=v_2$. The energy is constant", "one sentence"),
        ("they stick", "equality of the velocities", "names the formula"),
    ],
)
def test_a_reading_infers_nothing_is_one_sentence_and_names_the_formula(words, meaning, missing):
    with pytest.raises(ValueError, match=missing):
        reading(words, meaning)


def test_a_clause_that_no_step_names_is_not_carried_by_a_reading_alone():
    @claim("a", "II", "w", HOLDS, clause("named", "text"), clause("left", "text"))
    def found():
        return because("Why.", carried("named", EXACT), reading("they stick", "$v_1=v_2$"))

    named, left = proofs(found, found.decide())
    assert weakest((EXACT, reading("they stick", "$v_1=v_2$"))) is EvidenceKind.EXACT
    assert named.established_by is EvidenceKind.EXACT
    assert left.established_by is None


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


HOLDS, AMENDED, REFUTED = Verdict.HOLDS, Verdict.HOLDS_CORRECTED, Verdict.REFUTED
UNDECIDED, UNCHECKED, NOT_JUDGED = Verdict.UNDECIDED, Verdict.UNCHECKED, Verdict.NOT_JUDGED
OVERREACHING = """
holds           |                                      |
holds           | sample                               |
holds           | support                              |
holds           | exact failed                         |
holds           | exact silent                         |
holds           | exact                                | counterexample
holds           | correction                           |                          about something else
refuted         | counter correction                   | corrected
refuted         | counter correction                   | counterexample
refuted         | correction                           | counterexample corrected
holds-corrected | counter                              | counterexample corrected
holds-corrected | counter sampled-correction           | counterexample corrected
holds-corrected | counter correction failed-correction | counterexample corrected
holds-corrected | failed counter correction            | counterexample corrected
refuted         | counter correction silent-counter    | counterexample corrected
not-judged      | failed                               |                          what was checked beside it
not-judged      | counter correction                   | counterexample corrected
"""
"""A verdict, its steps, and which of its texts are given."""


@pytest.mark.parametrize("row", OVERREACHING.strip().splitlines())
def test_an_overreaching_finding_cannot_be_built_and_is_concluded_undecided(row):
    (name,), steps, given = map(str.split, row.split("|"))
    verdict, steps = Verdict(name), tuple(STEPS[one] for one in steps)
    more = {one: text for one, text in CORRECTED.items() if one in given}
    with pytest.raises(InvalidFindingError, match=verdict.value):
        Finding(verdict, "r", steps, **more)
    found = conclude(verdict, "r", *steps, **more)
    assert (found.verdict, found.evidence) == (UNDECIDED, steps)
    for said in (found.reason, found.missing):
        assert all(one.statement in said for one in steps if one is FAILED)


def test_a_finding_has_a_reason_or_says_what_is_missing_and_an_outcome_is_a_truth_value_or_none():
    for verdict, reason in ((HOLDS, " "), (UNDECIDED, "r")):
        with pytest.raises(InvalidFindingError):
            Finding(verdict, reason, (EXACT,))
    with pytest.raises(TypeError, match="True, False or None"):
        Evidence(EvidenceKind.EXACT, "sympy", "s", 1)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("steps", "verdict"),
    [
        ((WAITING,), UNCHECKED),
        ((WAITING, SILENT), UNDECIDED),
        ((WAITING, FAILED), UNDECIDED),
        ((replace(WAITING, passed=False),), UNDECIDED),
    ],
)
def test_only_what_waits_for_the_kernel_alone_is_unchecked(steps, verdict):
    assert conclude(HOLDS, "r", EXACT, argument("So it is.", EXACT, *steps)).verdict is verdict


@pytest.mark.parametrize("about", ["said", "correction"])
def test_steps_of_a_corrected_claim_speak_about_what_they_carry(about):
    said, corrected = clause("said", "$a$ is $b$."), clause("correction", "$a$ is not $b$.")

    @claim("a", "II", "w", AMENDED, said, correction=(corrected,))
    def one():
        return because("r", counterexample("c", EXACT), carried(about, argument("so", EXACT)), correction(EXACT))

    found = one.decide()
    assert found.verdict is AMENDED
    (steps,) = (part.steps for part in found.carried)
    assert {one.about for one in closure(steps)} == {Subject.CORRECTION if about == "correction" else Subject.CLAIM}


def test_what_is_not_judged_is_established_by_nothing_and_nothing_carries_it():
    quoted = Claim("a", "V", "w", "It is interesting.", NOT_JUDGED, case=lambda: because("An opinion.", EXACT))
    found = row(quoted, quoted.decide(), 0.0)
    assert (found.finding.verdict, found.established_by, found.proofs, found.as_recorded) == (
        NOT_JUDGED,
        None,
        (),
        True,
    )
    assert exit_code([found]) == 0
    with pytest.raises(InvalidFindingError, match="not judged"):
        Finding(NOT_JUDGED, "An opinion.", (EXACT,), carried=(carried("statement", EXACT),))


# the graph of a proof


def said(*clauses, **more):
    return Claim("a-claim", "III", "(8)", clauses or "All is well.", HOLDS, **more)


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
        ((SMT, FAILED.as_support()), True),
        ((BY_HAND,), True),
    ],
)
def test_an_argument_and_a_clause_by_reason_are_as_good_as_all_they_rest_on(steps, passed):
    finding = Finding(HOLDS, "So it is.", (SMT,))
    for some in (steps, steps[::-1]):
        one = argument("so", *some)
        assert one.passed is passed
        assert set(closure([one, SMT])) == {one, *some, SMT}
        assert closure([one, SMT])[: len(some)] == some
        object.__setattr__(finding, "evidence", some)  # not judged
        (proof,) = proofs(said(), finding)
        assert proof.steps[0].rests_on == some
        assert proof.established_by is (EvidenceKind.ARGUMENT if passed else None)
    with pytest.raises(ValueError, match="rests on steps, or cites"):
        argument("so")


def test_a_row_is_as_strong_as_its_weakest_clause_and_one_whose_steps_are_not_named_is_an_argument():
    assert of(conclude(HOLDS, "So it is.", EXACT)).established_by is EvidenceKind.ARGUMENT
    finding = conclude(HOLDS, "r", carried("one", SMT), carried("two", BALL))
    assert of(finding, clause("one", "A,"), clause("two", "B.")).established_by is EvidenceKind.ENCLOSURE
    bound, finding = clause("one", "«e».", e=formula("m1", lambda _: BALL)), conclude(HOLDS, "r", carried("one", SMT))
    assert of(finding, bound).established_by is EvidenceKind.ENCLOSURE


def formula(letter, decide=None):
    return Formula("E", "=", sp.Symbol(letter), decide or equals(lambda: sp.Symbol("m1")))


@pytest.mark.parametrize(
    ("verdict", "steps", "more"),
    [
        (HOLDS, (EXACT,), {}),
        (AMENDED, (COUNTER, SMT.as_correction()), CORRECTED),  # quoted beside its counterexample
        (UNCHECKED, (), {"missing": "the proof kernel"}),
    ],
)
def test_a_formula_that_is_wrong_or_not_decided_turns_the_row(verdict, steps, more):
    finding = conclude(verdict, "r", *steps, **more)
    assert of(finding, clause("c", "«e».", e=formula("m1"))).finding.verdict is verdict
    for wrong, missing in ((formula("m2"), "$E=m_{2}$, as derived"), (formula("m1", lambda _: SILENT), "a = d")):
        turned = of(finding, clause("c", "«e».", e=wrong))
        assert (turned.finding.verdict, turned.established_by) == (UNDECIDED, None)
        assert turned.finding.missing == missing


@pytest.mark.parametrize("relation", ["!=", "<", "<=", ">", ">="])
def test_what_derives_an_equality_passes_no_other_relation(relation):
    m1 = sp.Symbol("m1", positive=True)
    assert Formula("E", relation, m1, equals(lambda: m1)).evidence().passed is not True


def test_what_is_quoted_beside_its_counterexample_needs_no_step_and_its_correction_does():
    parts = (BALL.as_counterexample(), carried("right", SMT.as_correction()))
    finding = conclude(AMENDED, "r", *parts, corrected="B.", counterexample="x = 1")
    quoted, right, more = clause("said", "A."), clause("right", "B,"), clause("more", "C.")
    assert of(finding, quoted, correction=(right,)).established_by is EvidenceKind.ENCLOSURE
    for corrected in ((right, more), ()):  # without a clause, B. has no step left
        assert of(finding, quoted, correction=corrected).finding.verdict is UNDECIDED


# theorems of the kernel

PASSED = {name: passed for passed, name in kernel.STATUS.items()}


@pytest.fixture
def theorems(monkeypatch):
    """Plant how the theorem of a row stands, and those that it is tied to or uses."""

    def plant(status, ties=(), uses=(), others=kernel.PROVED):
        other = Proved("", "SharpLaw.sharp_law", "It is so.", "forall x, x = x", (), (), (), PASSED[others])
        top = replace(other, uses=uses, ties=ties, holds=PASSED[status])
        monkeypatch.setattr(kernel, "theorem", lambda name: replace(top if name == "sharp-law" else other, id=name))
        kernel.step.cache_clear()

    yield plant
    kernel.step.cache_clear()


@pytest.mark.parametrize(
    ("status", "verdict", "kind"),
    [
        (kernel.PROVED, HOLDS, EvidenceKind.KERNEL),
        (kernel.NOT_RUN, HOLDS, EvidenceKind.ARGUMENT),
        (kernel.FAILED, UNDECIDED, None),
    ],
)
def test_the_kernel_carries_a_clause_or_leaves_it_to_the_other_steps(theorems, status, verdict, kind):
    theorems(status)
    finding = conclude(HOLDS, "r", carried("c", argument("so", EXACT)))
    found = of(finding, clause("c", "All.", kernel="sharp-law"))
    assert (found.finding.verdict, found.established_by, found.kernel) == (verdict, kind, status)
    assert status != kernel.FAILED or "sharp-law" in found.finding.reason
    theorems(kernel.PROVED, ties=("tie-ray",), others=status)  # one about something else than the theory
    assert kernel.step("sharp-law").passed is PASSED[status]
    assert ("tie-ray" in kernel.step("sharp-law").value) == (status != kernel.PROVED)


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
    finding = conclude(HOLDS, "r", carried("one", EXACT))
    clauses = clause("one", "A,"), clause("two", "B.", kernel="sharp-law")
    theorems(kernel.NOT_RUN)
    waiting = of(finding, *clauses)
    assert (waiting.finding.verdict, waiting.established_by) == (UNCHECKED, None)
    assert "two" in waiting.finding.missing
    assert waiting.open == ("The clause `two` is not established.",)
    assert exit_code([waiting]) == 3
    bare = of(finding, *clauses, clause("three", "C."))
    assert (bare.finding.verdict, exit_code([bare])) == (UNDECIDED, 1)
    theorems(kernel.PROVED)
    assert of(finding, *clauses).finding.verdict is HOLDS
