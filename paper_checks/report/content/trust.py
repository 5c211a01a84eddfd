"""How sure the verdicts are, counted: by the weakest step of each, and by relations that no check decides."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import Any

from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.report.mathematics.prose import Span, pieces
from paper_checks.running.runner import Row

_TYPED = re.compile(r"[=<>]|\\(?:leqslant|geqslant|leq?|geq?|neq?|to|in|notin|approx|sim)(?![A-Za-z])")


def given(rows: Sequence[Row]) -> dict[str, Any]:
    """Return what the chapter needs: how many verdicts have which weakest step, and the clauses with their formulas."""
    clauses = [clause for row in rows for clause in (*row.claim.clauses, *row.claim.correction)]
    return {
        "strengths": Counter((row.established_by.value, row.claim.kind.value) for row in rows if row.established_by),
        "decisive": [kind.value for kind in EvidenceKind if kind.decisive],
        "clauses": clauses,
        "decided": [formula for clause in clauses for formula in clause.formulas],
        "typed": [clause for clause in clauses if has_typed_relation(clause)],
    }


def has_typed_relation(clause: Clause) -> bool:
    """Return whether a relation stands in the text of a clause as LaTeX, beside the formulas that are decided."""
    spans = pieces(re.sub("«[^»]*»", "", clause.text))
    return any(_TYPED.search(text) for kind, text in spans if kind is not Span.PROSE)
