"""The proof kernel: its cited theorems, by id, as steps of a proof."""

from __future__ import annotations

from functools import cache

from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.proofs.library import theorem

PROVED, NOT_RUN, FAILED = "proved", "not run", "failed"
STATUS = {True: PROVED, None: NOT_RUN, False: FAILED}
"""What the kernel's answer is called."""


@cache
def step(name: str) -> Evidence:
    """Return the theorem as evidence, resting on those of ours that it uses.

    Passed is True where the kernel accepted it and the ties of its definitions to `theory/`, None where it was not run,
    False where it, or a tie, was refused. Raises KeyError for an id that the proofs do not cite.
    """
    found = theorem(name)
    untied = [tie for tie in map(theorem, found.ties) if not tie.holds] if found.holds else []
    answer = untied[0] if untied else found
    problem = f": {answer.problem}" if answer.problem else ""
    return Evidence(
        EvidenceKind.KERNEL,
        "Coq",
        f"the theorem {name}" + (f" ({found.name}): {found.sentence}" if found.name else ""),
        answer.holds,
        value=" ".join(found.statement.split())
        if answer.holds
        else f"kernel {STATUS[answer.holds]}: {answer.id}{problem}",
        assumptions=tuple(found.axioms),
        rests_on=tuple(step(used) for used in found.uses) if found.holds else (),
    )


def name_of(item: Evidence) -> str:
    """Return the id of the theorem that a step of the kernel states."""
    return item.statement.removeprefix("the theorem ").partition(" (")[0]
