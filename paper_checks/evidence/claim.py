"""A claim in one place: what is said, the verdict on record, and the function that says why and by which steps."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from itertools import chain
from typing import Any

from paper_checks.errors import LedgerError
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Evidence, Named, Steps, Subject, one_line, steps
from paper_checks.evidence.finding import Carried, Finding, Verdict, carried, conclude

HOLDS, CORRECTED, REFUTED, NOT_JUDGED = Verdict.HOLDS, Verdict.HOLDS_CORRECTED, Verdict.REFUTED, Verdict.NOT_JUDGED
POSITIVE = "$m_1,m_2,a_2,b>0$."
FREE = f"{POSITIVE} No damper and no force: $a_1=0$, $u=0$, $b$ constant."
"""What a theorem assumes that says nothing else."""
UNDER_A_FORCE = f"{POSITIVE} A force $u(t)$ on body 1, under Coulomb's law; $a_1\\geqslant 0$ unless stated otherwise."
_ID = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


class Kind(Enum):
    """Whose statement a row is; the value is the word that the reader sees."""

    CLAIM = "claim"
    """The paper's: it is judged as the paper puts it."""
    THEOREM = "theorem"
    """Ours, beyond the paper: it is proved, or it is not there."""


@dataclass(frozen=True)
class About:
    """Steps that speak about the counterexample, or about the correction, and what is said of it in words."""

    subject: Subject
    text: str
    steps: Steps


def counterexample(text: str, *named: Named) -> About:
    """Return the counterexample, and the steps that show that it is real and violates what the paper says."""
    return About(Subject.COUNTEREXAMPLE, one_line(text), steps(*named))


def correction(*named: Named) -> About:
    """Return steps of the corrected statement that carry no clause by name."""
    return About(Subject.CORRECTION, "", steps(*named))


@dataclass(frozen=True)
class Case:
    """Why a claim's verdict is what it is; texts are prose with LaTeX between dollars."""

    reason: str
    parts: tuple[Evidence | Carried | About, ...]
    figure: str | None


def because(reason: str, *parts: Named | Carried | About, figure: str | None = None) -> Case:
    """Return the case for a claim: the reason, and the steps; `carried` says which of them carry which clause."""
    made = ((one,) if isinstance(one, Carried | About) else steps(one) for one in parts)
    return Case(one_line(reason), tuple(chain.from_iterable(made)), figure)


@dataclass(frozen=True)
class Claim:
    """One statement of the paper, or past it.

    `id` is permanent: it names the row, its anchor in the report and its tests. `where` is the place in the paper as
    printed; `said` is what the paper literally says there, clause by clause, or one clause of prose with ``$LaTeX$``;
    `recorded` is the verdict that `run` compares with; `kind` says whether the statement is the paper's; `correction` is
    the nearest true statement of a claim that does not hold; `open` says, sentence by sentence, what the row leaves
    undecided beside its clauses; `case` makes the case for the verdict; `assuming` is what a theorem assumes besides what it says. Raises LedgerError where the id is not
    lower-case words joined by hyphens, an id of a clause is taken twice, or a sentence that is not judged has a formula.
    """

    id: str
    section: str
    where: str
    said: str | tuple[Clause, ...]
    recorded: Verdict
    kind: Kind = Kind.CLAIM
    correction: tuple[Clause, ...] = ()
    open: tuple[str, ...] = ()
    case: Callable[..., Case] | None = None
    assuming: str = FREE

    def __post_init__(self) -> None:
        """Refuse an id that could not be an anchor, and clauses of one id."""
        object.__setattr__(self, "open", tuple(map(one_line, self.open)))
        if not _ID.fullmatch(self.id):
            raise LedgerError(f"claim id {self.id!r} is not lower-case words joined by hyphens")
        ids = [clause.id for clause in (*self.clauses, *self.correction)]
        if len(set(ids)) != len(ids):
            raise LedgerError(f"{self.id}: two clauses of one id among {', '.join(ids)}")
        if self.recorded is NOT_JUDGED and any(one.formulas or one.kernel for one in self.clauses):
            raise LedgerError(
                f"{self.id} is not judged: nothing would check its formulas; quote them, or judge the claim"
            )

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
        """The nearest true statement; None where no clause says it."""
        return " ".join(clause.shown for clause in self.correction) or None

    def decide(self, seed: int = 0, **others: Any) -> Finding:
        """Return what is found: the verdict on record where the case carries it, and an undecided one elsewhere.

        The seed goes to a case that draws at random; others are what a test asks of the case instead of its defaults.
        """
        if self.case is None:
            return Finding(Verdict.UNCHECKED, "Nothing decides this claim.", missing="a case")
        drawn = {"seed": seed} if "seed" in inspect.signature(self.case).parameters else {}
        case = self.case(**drawn, **others)
        texts = [part.text for part in case.parts if isinstance(part, About) and part.text]
        return conclude(
            self.recorded,
            case.reason,
            *(step for part in case.parts for step in self._about(part)),
            corrected=self.corrected,
            counterexample=texts[0] if texts else None,
            figure=case.figure,
        )

    def _about(self, part: Evidence | Carried | About) -> tuple[Evidence | Carried, ...]:
        """Return a part of the case with its subject said to its steps."""
        if isinstance(part, About):
            return tuple(step.about_(part.subject) for step in part.steps)
        if isinstance(part, Carried) and not part.steps:
            clause = next(one for one in (*self.clauses, *self.correction) if one.id == part.clause)
            part = carried(part.clause, *(one.evidence() for one in clause.formulas.values()))
        if isinstance(part, Carried) and part.clause in {clause.id for clause in self.correction}:
            return (carried(part.clause, *(step.as_correction() for step in part.steps)),)
        return (part,)


def claim(
    id: str,
    section: str,
    where: str,
    recorded: Verdict,
    *said: Clause | str,
    correction: tuple[Clause, ...] = (),
    open: tuple[str, ...] = (),
) -> Callable[[Callable[..., Case]], Claim]:
    """Make a claim of the paper of the function that makes the case for it."""
    clauses = tuple(one if isinstance(one, Clause) else Clause("statement", one) for one in said)
    return lambda case: Claim(id, section, where, clauses, recorded, Kind.CLAIM, correction, open, case)


def theorem(
    id: str, *said: Clause, open: tuple[str, ...] = (), assuming: str = FREE
) -> Callable[[Callable[..., Case]], Claim]:
    """Make a theorem beyond the paper of the function that makes the case for it: it is proved, or it is not there."""
    return lambda case: Claim(id, "Theorems", "beyond the paper", said, HOLDS, Kind.THEOREM, (), open, case, assuming)
