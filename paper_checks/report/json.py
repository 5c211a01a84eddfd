"""The rows as JSON, for programs."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from paper_checks.evidence import Evidence
from paper_checks.ledger import Claim
from paper_checks.runner import Row


def render(rows: Iterable[Row]) -> str:
    """Return the rows as a JSON list, without times: the same evidence gives the same text."""
    return _text([_row(row) for row in rows])


def render_claims(claims: Iterable[Claim]) -> str:
    """Return the claims alone, with the verdicts on record."""
    return _text([_claim(claim) | {"recorded": claim.recorded.value} for claim in claims])


def _text(value: object) -> str:
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"


def _claim(claim: Claim) -> dict[str, Any]:
    return {
        "id": claim.id,
        "kind": claim.kind.value,
        "section": claim.section,
        "where": claim.where,
        "statement": claim.statement,
    }


def _row(row: Row) -> dict[str, Any]:
    finding = row.finding
    return _claim(row.claim) | {
        "verdict": finding.verdict.value,
        "recorded": row.claim.recorded.value,
        "reason": finding.reason,
        "corrected": finding.corrected,
        "counterexample": finding.counterexample,
        "missing": finding.missing,
        "evidence": [_evidence(item) for item in finding.evidence],
    }


def _evidence(item: Evidence) -> dict[str, Any]:
    return {
        "kind": item.kind.value,
        "engine": item.engine,
        "statement": item.statement,
        "cases": item.cases,
        "value": item.value,
        "about": item.about.value,
        "passed": item.passed,
        "assumptions": list(item.assumptions),
    }
