"""The rows as JSON, for programs."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from paper_checks.decide.kernel import STATUS
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.evidence import Evidence, closure
from paper_checks.running.graph import Proof, numbered
from paper_checks.running.runner import Row


def render(rows: Iterable[Row]) -> str:
    """Return the rows as a JSON list, without times: the same evidence gives the same text."""
    return _text([_row(row) for row in rows])


def render_claims(claims: Iterable[Claim]) -> str:
    """Return the claims with the verdicts on record."""
    return _text([_claim(claim) | {"recorded": claim.recorded.value} for claim in claims])


def _established_by(row: Row | None) -> str | None:
    return row.established_by.value if row and row.established_by else None


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
    finding, names = row.finding, numbered(row.claim.id, row.proofs)
    return _claim(row.claim) | {
        "verdict": finding.verdict.value,
        "recorded": row.claim.recorded.value,
        "established_by": _established_by(row),
        "kernel": row.kernel,
        "reason": finding.reason,
        "corrected": finding.corrected,
        "counterexample": finding.counterexample,
        "missing": finding.missing,
        "open": list(row.open),
        "clauses": [_clause(proof, names) for proof in row.proofs],
        "evidence": [_evidence(item) for item in finding.evidence],
    }


def _clause(proof: Proof, names: Mapping[Evidence, str]) -> dict[str, Any]:
    """Return a clause with the steps that it needs, those that stand beside them, and what binds its formulas."""
    needed = closure(proof.needed)
    beside = [step for step in closure((*proof.kernel, *proof.steps)) if step not in needed]
    return {
        "id": proof.clause.id,
        "about": proof.about.value,
        "text": proof.clause.shown,
        "established_by": proof.established_by.value if proof.established_by else None,
        "kernel": [
            {"theorem": name, "status": STATUS[step.passed]}
            for name, step in zip(proof.clause.kernel, proof.kernel, strict=True)
        ],
        "steps": [_step(step, names) for step in needed if not step.supports],
        "support": [_step(step, names) for step in (*(one for one in needed if one.supports), *beside)],
        "formulas": [_step(step, names) for step in proof.bindings],
    }


def _step(item: Evidence, names: Mapping[Evidence, str]) -> dict[str, Any]:
    return {
        "id": names[item],
        "kind": item.kind.value,
        "statement": item.statement,
        "passed": item.passed,
        "rests_on": [names[below] for below in item.rests_on],
        "cites": list(item.cites),
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
        "supports": item.supports,
        "assumptions": list(item.assumptions),
    }
