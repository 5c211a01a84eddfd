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
    return _text([_claim(claim) | _of(claim, "recorded") for claim in claims])


def _text(value: object) -> str:
    return json.dumps(value, indent=2, ensure_ascii=False, default=lambda word: word.value) + "\n"


def _of(item: object, names: str) -> dict[str, Any]:
    """Return some fields of an item by their names."""
    return {name: getattr(item, name) for name in names.split()}


def _claim(claim: Claim) -> dict[str, Any]:
    return _of(claim, "id kind section where statement")


def _row(row: Row) -> dict[str, Any]:
    names = numbered(row.claim.id, row.proofs)
    return (
        _claim(row.claim)
        | _of(row.finding, "verdict")
        | _of(row.claim, "recorded")
        | _of(row, "established_by kernel")
        | _of(row.finding, "reason corrected counterexample missing")
        | _of(row, "open")
        | {"clauses": [_clause(proof, names) for proof in row.proofs]}
        | {"evidence": [_of(item, EVIDENCE) for item in row.finding.evidence]}
    )


EVIDENCE = "kind engine statement cases value about passed supports assumptions"
"""What is told of a step by itself."""


def _clause(proof: Proof, names: Mapping[Evidence, str]) -> dict[str, Any]:
    """Return a clause with the steps that it needs, those that stand beside them, and what binds its formulas."""
    needed = closure(proof.needed)
    beside = [step for step in closure((*proof.kernel, *proof.steps)) if step not in needed]
    theorems = zip(proof.clause.kernel, proof.kernel, strict=True)
    return {
        "id": proof.clause.id,
        "about": proof.about,
        "text": proof.clause.shown,
        "established_by": proof.established_by,
        "kernel": [{"theorem": name, "status": STATUS[step.passed]} for name, step in theorems],
        "steps": [_step(step, names) for step in needed if not step.supports],
        "support": [_step(step, names) for step in (*(one for one in needed if one.supports), *beside)],
        "formulas": [_step(step, names) for step in proof.bindings],
    }


def _step(item: Evidence, names: Mapping[Evidence, str]) -> dict[str, Any]:
    below = [names[one] for one in item.rests_on]
    return {"id": names[item]} | _of(item, "kind statement passed") | {"rests_on": below} | _of(item, "cites")
