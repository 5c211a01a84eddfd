"""Runs the checks in the ledger's order; one that fails takes nothing with it."""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

from paper_checks.checks.registry import Check, Context, Registry
from paper_checks.errors import ToolMissingError
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.ledger import Claim
from paper_checks.running.graph import SETTLED, Proof, established_by, judged, kernel_status, open_clauses, proofs


@dataclass(frozen=True)
class Row:
    """A claim, what was found about it, and how long that took (seconds, wall clock)."""

    claim: Claim
    finding: Finding
    seconds: float = 0.0
    proofs: tuple[Proof, ...] = field(default=(), repr=False)

    @property
    def established_by(self) -> EvidenceKind | None:
        """The weakest kind of step that the verdict needs; None where nothing is settled."""
        settled = self.finding.verdict in SETTLED
        return established_by(self.proofs) if settled else None

    @property
    def kernel(self) -> str | None:
        """The proof kernel's part: proved, not run, failed; None where no theorem of it is named."""
        return kernel_status(self.proofs)

    @property
    def open(self) -> tuple[str, ...]:
        """What the row leaves open, sentence by sentence: what the ledger names, and clauses that nothing establishes."""
        left = (f"The clause `{proof.clause.id}` is not established." for proof in open_clauses(self.proofs))
        return (*self.claim.open, *left)

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the one on record."""
        return self.finding.verdict is self.claim.recorded


def run(
    claims: Iterable[Claim],
    registry: Registry,
    context: Context,
    progress: Callable[[Claim], None] | None = None,
) -> list[Row]:
    """Decide each claim; `progress` is told of each before it is run."""
    rows = []
    for claim in claims:
        if progress:
            progress(claim)
        begin = time.perf_counter()
        rows.append(row(claim, decide(registry.of(claim.id), context), begin))
    return rows


def row(claim: Claim, finding: Finding, begun: float) -> Row:
    """Join a claim with what was found about it: its formulas and the kernel's theorems may turn the finding."""
    try:
        found = proofs(claim, finding)
        finding = judged(finding, found)
    except Exception as error:  # noqa: BLE001  a formula's failure is that row's verdict
        found, finding = (), failed(error)
    return Row(claim, finding, time.perf_counter() - begun, found)


def decide(checks: Sequence[Check], context: Context) -> Finding:
    """Run a claim's checks and join what they find."""
    if not checks:
        return Finding(Verdict.UNCHECKED, "No check decides this claim.", missing="a check")
    findings = [_isolated(check, context) for check in checks]
    return findings[0] if len(findings) == 1 else joined(findings)


def _isolated(check: Check, context: Context) -> Finding:
    try:
        finding = check(context)
        if not isinstance(finding, Finding):
            raise TypeError(f"{check.__name__} returned {type(finding).__name__}, not a Finding")
    except Exception as error:  # noqa: BLE001  a check's failure, whatever it is, is that row's verdict
        if context.debug:
            traceback.print_exception(error)
        return failed(error)
    return finding


def failed(error: Exception) -> Finding:
    """Return what is found where a check did not run to its end: never a pass."""
    if isinstance(error, ToolMissingError):
        return Finding(Verdict.UNCHECKED, f"A tool is missing: {_literal(error)}.", missing=_literal(error))
    text = f"{type(error).__name__}: {_literal(error)}"
    return Finding(Verdict.UNDECIDED, f"The check failed. {text}", missing="a check that runs to its end")


def _literal(error: Exception) -> str:
    """Return the error's text so that none of it reads as mathematics."""
    return " ".join(str(error).split()).replace("$", r"\$")


def joined(findings: Sequence[Finding]) -> Finding:
    """Join the findings about one claim. Where the verdicts differ, nothing is decided."""
    verdicts = {finding.verdict for finding in findings}
    reason = " ".join(dict.fromkeys(finding.reason for finding in findings))
    missing = _together(finding.missing for finding in findings)
    if Verdict.UNCHECKED in verdicts:
        verdict = Verdict.UNCHECKED
    elif len(verdicts) == 1:
        verdict = verdicts.pop()
    else:
        verdict = Verdict.UNDECIDED
        found = ", ".join(finding.verdict.value for finding in findings)
        reason = f"The checks do not agree ({found}). {reason}"
        missing = missing or "agreement between the checks"
    return Finding(
        verdict,
        reason,
        tuple(item for finding in findings for item in finding.evidence),
        _together(finding.corrected for finding in findings),
        _together(finding.counterexample for finding in findings),
        tuple(step for finding in findings for step in finding.derivation),
        next((finding.figure for finding in findings if finding.figure), None),
        missing,
        tuple(one for finding in findings for one in finding.carried),
    )


def _together(texts: Iterable[str | None]) -> str | None:
    return " ".join(dict.fromkeys(text for text in texts if text)) or None


def exit_code(rows: Iterable[Row]) -> int:
    """Return 1 where a verdict differs from the record, 3 where something is unchecked, else 0."""
    different = [row.finding.verdict for row in rows if not row.as_recorded]
    if any(verdict is not Verdict.UNCHECKED for verdict in different):
        return 1
    return 3 if different else 0
