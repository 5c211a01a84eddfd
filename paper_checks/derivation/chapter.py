"""The whole derivation: its stages in order, its lines by number, and what they find for a clause of a claim."""

from __future__ import annotations

from paper_checks.derivation import energy, rate, slip, surface
from paper_checks.derivation.line import Line, Stage
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Steps

STAGES: tuple[Stage, ...] = (*surface.STAGES, *energy.STAGES, *slip.STAGES, *rate.STAGES)
LINES: tuple[Line, ...] = tuple(line for stage in STAGES for line in stage.lines)


def number(line: Line) -> int:
    """Return the number of a line, counted from 1 through the whole derivation."""
    return next(place for place, one in enumerate(LINES, start=1) if one is line)


def lines_of(claim: str) -> tuple[Line, ...]:
    """Return the lines that carry a claim, by its id, in their order."""
    return tuple(line for line in LINES if claim in line.claims)


def bindings(claim: Claim, clause: Clause) -> Steps:
    """Return what the lines that carry a clause find: a line that fails turns the claim."""
    key = f"{claim.id}/{clause.id}"
    return tuple(one for line in LINES if key in line.clauses for one in line.evidence(number(line)))
