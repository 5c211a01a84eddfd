"""What a row of the ledger is."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum

from paper_checks.errors import LedgerError
from paper_checks.evidence import Verdict

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

    `id` is permanent: it names the row, its anchor in the report and its tests. `where` is the paper's
    own label or place; `statement` says what the paper literally says there, in prose with ``$LaTeX$``;
    `recorded` is the verdict that `run` compares with; `kind` says whether the statement is the paper's. Raises LedgerError where the id is not lower-case
    words joined by hyphens.
    """

    id: str
    section: str
    where: str
    statement: str
    recorded: Verdict
    kind: Kind = Kind.CLAIM

    def __post_init__(self) -> None:
        """Refuse an id that could not be an anchor."""
        if not _ID.fullmatch(self.id):
            raise LedgerError(f"claim id {self.id!r} is not lower-case words joined by hyphens")


def in_order(*sections: Iterable[Claim]) -> tuple[Claim, ...]:
    """Join the sections' claims, in paper order; raises LedgerError where an id is taken twice."""
    claims = tuple(claim for section in sections for claim in section)
    ids = [claim.id for claim in claims]
    if twice := sorted({name for name in ids if ids.count(name) > 1}):
        raise LedgerError(f"claim ids taken twice: {', '.join(twice)}")
    return claims
