"""The graph of the proofs for readers: a section on what rests on what, and the proof of one row as nested lists."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from html import escape

from paper_checks.evidence import Evidence
from paper_checks.graph import Proof
from paper_checks.kernel import PROVED
from paper_checks.report import blocks, mathematics
from paper_checks.report.summary import kind
from paper_checks.runner import Row

FIGURE = "proof-graph"
DEPTH = 2
"""Levels of steps below a clause that a row shows; the evidence of the row has them all."""


def section(rows: Sequence[Row]) -> blocks.Section:
    """Return the section after the claims: how each row is established, clause by clause."""
    counts = Counter(row.established_by.value for row in rows if row.established_by)
    tally = ", ".join(f"{count} by {name}" for name, count in counts.most_common())
    lines = tuple((row.claim.id, row.finding.verdict.value, kind(row), _clauses(row)) for row in rows)
    return blocks.Section(
        "what-rests-on-what",
        "What rests on what",
        (
            blocks.Paragraph(
                "A row is as strong as the weakest step that it needs: a theorem that the proof kernel accepted, a statement that two "
                "solvers proved, a symbolic identity, an enclosure, or a written inference over such steps, which is the weakest. What "
                f"merely supports does not count. Of {len(rows)} rows are established: {tally or 'none'}."
            ),
            blocks.Picture(
                FIGURE,
                "What rests on what: each row of the ledger, coloured by the weakest kind of step that it needs, and the theorems "
                "of the proof kernel and the written inferences that its clauses rest on.",
            ),
            blocks.Table(("claim", "verdict", "established by", "clauses"), lines, "How each row is established"),
        ),
    )


def _clauses(row: Row) -> str:
    return "; ".join(_clause(proof) for proof in row.proofs if proof.steps or proof.kernel) or "–"


def _clause(proof: Proof) -> str:
    by = proof.established_by.value if proof.established_by else "open"
    theorems = ", ".join(proof.clause.kernel)
    status = "" if proof.kernel_status in (None, PROVED) else f", kernel {proof.kernel_status}"
    return f"{proof.clause.id}: {by}" + (f" ({theorems}{status})" if theorems else "")


def html(row: Row) -> str:
    """Return the proof of a row, clause by clause, each step above those that it rests on."""
    shown = [proof for proof in row.proofs if proof.steps or proof.kernel]
    if not shown:
        return ""
    items = "\n".join(f"<li>{_html_clause(proof)}</li>" for proof in shown)
    return f'<h4>What rests on what</h4>\n<ul class="proof">\n{items}\n</ul>'


def _html_clause(proof: Proof) -> str:
    by = proof.established_by.value if proof.established_by else "open"
    status = "" if proof.kernel_status in (None, PROVED) else f", kernel {proof.kernel_status}"
    head = f"<b>{escape(proof.clause.id)}</b> ({by}{status}): {mathematics.html(proof.clause.shown)}"
    return head + _html_steps((*proof.needed, *(step for step in proof.steps if proof.by_kernel)), DEPTH)


def _html_steps(steps: Sequence[Evidence], depth: int) -> str:
    if not (steps and depth):
        return ""
    items = "\n".join(f"<li>{_html_step(step, depth)}</li>" for step in steps)
    return f"\n<ul>\n{items}\n</ul>"


def _html_step(step: Evidence, depth: int) -> str:
    cites = f" [{escape('; '.join(step.cites))}]" if step.cites else ""
    text = f"<small>{step.kind.value}</small> {mathematics.html(step.statement)}{cites}"
    return text + _html_steps(step.rests_on, depth - 1)
