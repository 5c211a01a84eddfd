"""What the proof kernel was asked: theorems with the claims that need them, their axioms, and the definitions they use."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import Any

from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.proofs.audit import recorded
from paper_checks.report.content import story
from paper_checks.running.runner import Row

SAME = "filippov-iff"
"""The theorem that the notion of solution is Filippov's."""
_WITHOUT_DAMPER = re.compile(
    r"\b(Pair.solution|Forced.forced|Filippov.filippov|Nonstop.nonstop|Switching.switch\w+) \S+ \S+ 0\b"
)
"""A motion of a pair whose third letter, the damper, is 0."""


def given(rows: Sequence[Row]) -> dict[str, Any]:
    """Return what the chapter needs: the theorems on record that the rows rest on, with the claims that need each."""
    users: dict[str, list[str]] = {}
    steps: list[Evidence] = []
    for row in rows:
        for step, name in story.steps(row).items():
            if step.kind is EvidenceKind.KERNEL and name in recorded().theorems:
                users.setdefault(name, []).append(row.claim.id)
                steps.append(step)
    shown = (SAME, *users) if users else ()
    definitions = {name: text for one in shown for name, text in recorded().definitions_of[one].items()}
    return {
        "proved": dict(sorted(users.items())),
        "axioms": Counter(axiom for step in dict.fromkeys(steps) for axiom in step.assumptions),
        "definitions": dict(sorted(definitions.items())),
        "record": recorded(),
        "undamped": undamped,
    }


def undamped(statement: str) -> bool:
    """Return whether a statement is about motions without a damper.

    >>> undamped("Pair.solution m1 m2 0 a2 b x v1 v2 s -> True"), undamped("Pair.solution m1 m2 a1 a2 b x v1 v2 s")
    (True, False)
    """
    return bool(_WITHOUT_DAMPER.search(statement))
