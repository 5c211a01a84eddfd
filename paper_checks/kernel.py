"""The seam to the proof kernel: theorems by name, as steps of a proof. Nothing else imports `paper_checks.proofs`."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from functools import cache
from typing import Any

from paper_checks.evidence import Evidence, EvidenceKind

PROVED, NOT_RUN, FAILED = "proved", "not run", "failed"
STATUS = {True: PROVED, None: NOT_RUN, False: FAILED}
_OUTCOMES = {status: passed for passed, status in STATUS.items()}


@dataclass(frozen=True)
class Unavailable:
    """What stands for a theorem where there is no kernel."""

    name: str
    reason: str
    statement: str = ""
    status: str = NOT_RUN
    axioms: tuple[str, ...] = ()
    uses: tuple[str, ...] = ()


@cache
def theorem(name: str) -> Any:
    """Return what the kernel says of a theorem, `File.name`; it is not run where the proofs or `coqc` are missing."""
    try:
        proofs = importlib.import_module("paper_checks.proofs")
    except ModuleNotFoundError:
        return Unavailable(name, "the proofs are not part of this installation")
    return proofs.theorem(name)


@cache
def step(name: str) -> Evidence:
    """Return the theorem as evidence, resting on those of ours that it uses.

    Passed is True where the kernel accepted it, None where it was not run, False where it was refused.
    """
    found = theorem(name)
    passed = _OUTCOMES.get(found.status)
    value = " ".join(found.statement.split()) if passed else f"kernel {found.status}: {name}: {found.reason}"
    rests_on = tuple(step(used) for used in found.uses) if passed else ()
    return Evidence(
        EvidenceKind.KERNEL,
        "Coq",
        f"the theorem {name}",
        passed,
        value=value,
        assumptions=tuple(found.axioms),
        rests_on=rests_on,
    )
