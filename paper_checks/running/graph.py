"""What rests on what: the steps that carry each clause, and how strong the weakest one that it needs is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from paper_checks.decide import kernel
from paper_checks.derivation import chapter
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps, Subject, argument, closure, weakest
from paper_checks.evidence.finding import Finding, Verdict

SETTLED = (Verdict.HOLDS, Verdict.HOLDS_CORRECTED, Verdict.REFUTED)


@dataclass(frozen=True)
class Proof:
    """A clause, the steps that carry it, the theorems of the kernel that prove it, and what binds its formulas: their checks, and lines of the derivation."""

    clause: Clause
    about: Subject
    steps: Steps
    kernel: Steps
    bindings: Steps
    quoted: bool = False
    """Whether it is what the paper says where a counterexample stands against it: then nothing has to carry it."""

    @property
    def counts(self) -> bool:
        """Whether the verdict stands on it: all but what is merely quoted, and even that where steps carry it."""
        return bool(self.steps or self.kernel) or not self.quoted

    @property
    def by_kernel(self) -> bool:
        """Whether the kernel accepted a proof of the whole clause: then it needs no other step."""
        return bool(self.kernel) and all(step.passed for step in self.kernel)

    @property
    def needed(self) -> Steps:
        """The steps that the clause needs, without what these rest on."""
        return self.kernel if self.by_kernel else self.steps

    @property
    def established_by(self) -> EvidenceKind | None:
        """The weakest kind of step that the clause needs, its formulas' among them; None where it is not established."""
        steps = closure(self.needed)
        failed = any(step.passed is not True for step in (*steps, *self.bindings) if not step.supports)
        carries = any(not step.supports for step in steps)
        return None if failed or not carries else weakest(steps if self.by_kernel else (*steps, *self.bindings))

    @property
    def kernel_status(self) -> str | None:
        """The kernel's part: proved, not run, failed; None where no theorem is named."""
        if not self.kernel:
            return None
        outcomes = {step.passed for step in self.kernel}
        return kernel.FAILED if False in outcomes else kernel.NOT_RUN if None in outcomes else kernel.PROVED


def proofs(claim: Claim, finding: Finding) -> tuple[Proof, ...]:
    """Return the proof of each clause that the verdict stands on; a quoted clause that it does not is not among them.

    A clause whose steps the check does not name is carried by the finding's reason, an inference over its evidence.
    Nothing is carried where the claim is not judged: what was checked beside it proves no part of it.
    """
    if finding.verdict is Verdict.NOT_JUDGED:
        return ()
    named = {one.clause: one.steps for one in finding.carried}
    used = {step for steps in named.values() for step in closure(steps)}
    found = []
    for clause, about in clauses(claim, finding):
        steps = named.get(clause.id) or _by_reason(finding, about, used)
        theorems = tuple(kernel.step(name) for name in clause.kernel)
        formulas = (one.evidence() for one in clause.formulas.values())
        bindings = (*formulas, *chapter.bindings(claim, clause))
        quoted = about is Subject.CLAIM and finding.counterexample is not None
        found.append(Proof(clause, about, steps, theorems, tuple(_about(one, about) for one in bindings), quoted))
    return tuple(found)


def _about(item: Evidence, about: Subject) -> Evidence:
    return replace(item, about=about)


def clauses(claim: Claim, finding: Finding) -> Iterator[tuple[Clause, Subject]]:
    """Yield the clauses that the verdict stands on, and about what each speaks."""
    if not finding.counterexample:
        yield from ((clause, Subject.CLAIM) for clause in claim.clauses)
        return
    named = {one.clause for one in finding.carried}
    for clause in claim.clauses:
        if clause.id in named or clause.formulas:
            yield clause, Subject.CLAIM
    yield Clause("counterexample", finding.counterexample), Subject.COUNTEREXAMPLE
    correction = claim.correction or (Clause("corrected", finding.corrected or ""),)
    yield from ((clause, Subject.CORRECTION) for clause in correction)


def _by_reason(finding: Finding, about: Subject, used: set[Evidence]) -> Steps:
    below = {step for item in finding.evidence for step in item.rests_on}
    steps = [item for item in finding.evidence if item.about is about and item not in below and item not in used]
    if about is Subject.COUNTEREXAMPLE:
        return tuple(steps)
    return (replace(argument(finding.reason, *steps), about=about),) if steps else ()


def judged(finding: Finding, found: Sequence[Proof]) -> Finding:
    """Return the finding, turned where a formula of a clause is not what was checked, the kernel refused a theorem, or
    a clause is carried by nothing: unchecked where the kernel was to carry it and was not run, else undecided.
    """
    bindings = tuple(one for proof in found for one in proof.bindings)
    refused = tuple(step for proof in found for step in closure(proof.kernel) if step.passed is False)
    evidence = closure((*bindings, *finding.evidence)) if bindings else finding.evidence
    failed = next((item for item in (*bindings, *refused) if item.passed is not True), None)
    if failed is None or finding.verdict is Verdict.UNDECIDED:
        whole = replace(finding, evidence=evidence) if bindings else finding
        return _where_open(whole, found) if finding.verdict in SETTLED else whole
    text = f"{failed.statement}: {failed.value}" if failed.kind is EvidenceKind.KERNEL else failed.statement
    reason = f"Not carried by its evidence: it did not pass: {text}"
    return replace(finding, verdict=Verdict.UNDECIDED, evidence=evidence, reason=reason, missing=text)


def open_clauses(found: Sequence[Proof]) -> tuple[Proof, ...]:
    """Return the clauses that the verdict stands on and that nothing establishes."""
    return tuple(proof for proof in found if proof.counts and proof.established_by is None)


def _where_open(finding: Finding, found: Sequence[Proof]) -> Finding:
    left = open_clauses(found)
    if not left:
        return finding
    names = ", ".join(proof.clause.id for proof in left)
    waiting = all(proof.kernel_status == kernel.NOT_RUN for proof in left)
    verdict = Verdict.UNCHECKED if waiting else Verdict.UNDECIDED
    missing = f"the proof kernel, which alone proves {names}" if waiting else f"steps that carry {names}"
    parts, need = (f"its part {names}", "needs") if len(left) == 1 else (f"its parts {names}", "need")
    why = f"{parts} {need} the proof kernel, which was not run" if waiting else f"nothing carries {parts}"
    reason = f"Not settled: {why}. {finding.reason}"
    return replace(finding, verdict=verdict, reason=reason, missing=missing)


def established_by(found: Sequence[Proof]) -> EvidenceKind | None:
    """Return the weakest kind of step that a row needs: a chain of clauses is as strong as its weakest one."""
    kinds = [proof.established_by for proof in found if proof.counts]
    if not kinds or None in kinds:
        return None
    return min((kind for kind in kinds if kind), key=lambda kind: kind.strength)


def kernel_status(found: Sequence[Proof]) -> str | None:
    """Return the kernel's part in a row: failed if one theorem is, else not run if one was not; None without any."""
    states = {proof.kernel_status for proof in found}
    return next((state for state in (kernel.FAILED, kernel.NOT_RUN, kernel.PROVED) if state in states), None)


def numbered(row_id: str, found: Sequence[Proof]) -> dict[Evidence, str]:
    """Return an id for each step of a row: its theorem's name, or the row's id and a number."""
    steps = closure(step for proof in found for step in (*proof.kernel, *proof.steps, *proof.bindings))
    names: dict[Evidence, str] = {}
    for step in steps:
        theorem = kernel.name_of(step) if step.kind is EvidenceKind.KERNEL else ""
        names[step] = theorem or f"{row_id}/{len(names) + 1}"
    return names
