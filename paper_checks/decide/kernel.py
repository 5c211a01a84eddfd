"""The proof kernel: its cited theorems, by id, as steps of a proof."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.proofs.library import Proved, theorem

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
    if untied:
        return replace(
            _stated(found), passed=untied[0].holds, value=f"kernel {STATUS[untied[0].holds]}: {untied[0].id}"
        )
    return _stated(found)


def _stated(found: Proved) -> Evidence:
    """Return a theorem as evidence, whatever its ties."""
    name, problem = found.id, f": {found.problem}" if found.problem else ""
    value = " ".join(found.statement.split()) if found.holds else f"kernel {STATUS[found.holds]}: {name}{problem}"
    return Evidence(
        EvidenceKind.KERNEL,
        "Coq",
        f"the theorem {name}" + (f" ({found.name}): {found.sentence}" if found.name else ""),
        found.holds,
        value=value,
        assumptions=tuple(found.axioms),
        rests_on=tuple(step(used) for used in found.uses) if found.holds else (),
    )


def name_of(item: Evidence) -> str:
    """Return the id of the theorem that a step of the kernel states."""
    return item.statement.removeprefix("the theorem ").partition(" (")[0]
