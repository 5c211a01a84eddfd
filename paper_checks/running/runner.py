"""Decides a claim; one that fails takes nothing with it."""

from __future__ import annotations

import time
import traceback
from collections.abc import Iterable
from dataclasses import dataclass, field
from textwrap import shorten

from paper_checks.errors import ToolMissingError
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict
from paper_checks.running.graph import SETTLED, Proof, established_by, judged, kernel_status, open_clauses, proofs

SAID = 240
"""Characters up to which an error is quoted."""


@dataclass(frozen=True)
class Context:
    """What claims are decided with: the seed of whatever is drawn at random."""

    seed: int = 0
    debug: bool = False
    """Whether a case that fails prints its traceback on stderr."""


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
        """What the row leaves open, sentence by sentence: what the ledger names, and clauses that wait for a tool."""
        waiting = open_clauses(self.proofs) if self.finding.verdict is Verdict.UNCHECKED else ()
        return (*self.claim.open, *(f"The clause `{proof.clause.id}` is not established." for proof in waiting))

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the one on record."""
        return self.finding.verdict is self.claim.recorded


def row(claim: Claim, finding: Finding, seconds: float) -> Row:
    """Join a claim with what was found about it: its formulas and the kernel's theorems may turn the finding."""
    begin = time.perf_counter() - seconds
    try:
        found = proofs(claim, finding)
        finding = judged(finding, found)
    except Exception as error:  # noqa: BLE001  a formula's failure is that row's verdict
        found, finding = (), failed(error)
    return Row(claim, finding, time.perf_counter() - begin, found)


def decide(claim: Claim, context: Context) -> Finding:
    """Return what is found about a claim; what is raised on the way is what is found."""
    try:
        return claim.decide(context.seed)
    except Exception as error:  # noqa: BLE001  a case's failure, whatever it is, is that row's verdict
        if context.debug:
            traceback.print_exception(error)
        return failed(error)


def failed(error: Exception) -> Finding:
    """Return what is found where a check did not run to its end: never a pass."""
    if isinstance(error, ToolMissingError):
        return Finding(Verdict.UNCHECKED, f"A tool is missing: {_literal(error)}.", missing=_literal(error))
    text = f"{_place(error)} raised {type(error).__name__}: {_literal(error)}"
    return Finding(Verdict.UNDECIDED, f"A check did not run to its end: {text}", missing=text)


def _place(error: Exception) -> str:
    """Return the innermost function of `theory` or of a claim in which an error was raised."""
    frames = [frame for frame, _ in traceback.walk_tb(error.__traceback__)]
    names = [(str(frame.f_globals.get("__name__")), frame.f_code.co_name) for frame in frames]
    ours = [f"{module}.{name}" for module, name in names if module.startswith(("theory.", "paper_checks.claims."))]
    return ours[-1] if ours else "the check"


def _literal(error: Exception) -> str:
    """Return the error's text, its beginning where it is long, so that none of it reads as mathematics."""
    return shorten(str(error), SAID, placeholder=" ...").replace("$", r"\$")


def exit_code(rows: Iterable[Row]) -> int:
    """Return 1 where a verdict differs from the record, 3 where something is unchecked, else 0."""
    different = [row.finding.verdict for row in rows if not row.as_recorded]
    if any(verdict is not Verdict.UNCHECKED for verdict in different):
        return 1
    return 3 if different else 0
