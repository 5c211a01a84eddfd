"""What a row of the ledger is."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum

from paper_checks.errors import LedgerError
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.finding import Verdict

_ID = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


class Kind(Enum):
    """Whose statement a row is; the value is the word that the reader sees."""

    CLAIM = "claim"
    """The paper's: it is judged as the paper puts it."""
    THEOREM = "theorem"
    """Ours, past the paper: it is proved, or it is not there."""


@dataclass(frozen=True)
class Claim:
    """One statement of the paper, or past it.

    `id` is permanent: it names the row, its anchor in the report and its tests. `where` is the place in the paper as
    printed; `said` is what the paper literally says there, clause by clause, or one clause of prose with ``$LaTeX$``;
    `recorded` is the verdict that `run` compares with; `kind` says whether the statement is the paper's; `correction` is
    the nearest true statement of a claim that does not hold; `open` says, sentence by sentence, what the row leaves
    undecided beside its clauses. Raises LedgerError where the id is not lower-case words
    joined by hyphens, or an id of a clause is taken twice.
    """

    id: str
    section: str
    where: str
    said: str | tuple[Clause, ...]
    recorded: Verdict
    kind: Kind = Kind.CLAIM
    correction: tuple[Clause, ...] = ()
    open: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Refuse an id that could not be an anchor, and clauses of one id."""
        if not _ID.fullmatch(self.id):
            raise LedgerError(f"claim id {self.id!r} is not lower-case words joined by hyphens")
        ids = [clause.id for clause in (*self.clauses, *self.correction)]
        if len(set(ids)) != len(ids):
            raise LedgerError(f"{self.id}: two clauses of one id among {', '.join(ids)}")

    @property
    def clauses(self) -> tuple[Clause, ...]:
        """What is claimed, clause by clause."""
        return (Clause("statement", self.said),) if isinstance(self.said, str) else self.said

    @property
    def statement(self) -> str:
        """What is claimed, in prose with LaTeX between dollars."""
        return " ".join(clause.shown for clause in self.clauses)

    @property
    def corrected(self) -> str | None:
        """The nearest true statement; None where it does not stand in the ledger."""
        return " ".join(clause.shown for clause in self.correction) or None


def in_order(*sections: Iterable[Claim]) -> tuple[Claim, ...]:
    """Join the sections' claims, in paper order; raises LedgerError where an id is taken twice."""
    claims = tuple(claim for section in sections for claim in section)
    ids = [claim.id for claim in claims]
    if twice := sorted({name for name in ids if ids.count(name) > 1}):
        raise LedgerError(f"claim ids taken twice: {', '.join(twice)}")
    return claims
