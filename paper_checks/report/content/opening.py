"""The first screen: what the paper models, what was found, and the three findings of most consequence."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from paper_checks.drawing.captions import caption
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import notation
from paper_checks.report.content.blocks import Block, Paragraph, Picture, Section, Table
from paper_checks.report.content.highlights import HIGHLIGHTS
from paper_checks.report.content.phrases import first_sentence
from paper_checks.running.runner import Row

ID, TITLE = "found", "What was found"
MODEL = (
    "The paper models two bodies. One hangs on a spring. The other is joined to it by nothing but dry friction, as a box on a "
    "moving table is. The pair either sticks and swings as one mass, or slips. The paper says how the free pair moves in the long run."
)
LAW = (
    "All verdicts are under Coulomb's law, with the whole interval $[-b,b]$ as friction while the bodies stick (Filippov's reading). "
    "For $u=0$ that is the paper's system (3), (4); under a force (3), (4) have no motion where a stuck pair stays at the limit $b$ (`sgn-three-valued`). Section IV goes on with (11), (12), which leave the limit $b$ out: where they "
    "allow another motion, the row says so."
)
STRENGTHS = {
    "a theorem of the proof kernel": (EvidenceKind.KERNEL,),
    "checked by solvers, exact algebra or enclosures": (EvidenceKind.SMT, EvidenceKind.EXACT, EvidenceKind.ENCLOSURE),
    "an argument that a person wrote": (EvidenceKind.ARGUMENT,),
}
"""Kinds of steps, from the strongest; together they are all that can settle a row."""
_WORDS = {
    Verdict.HOLDS: ("holds as written", "hold as written"),
    Verdict.HOLDS_CORRECTED: ("holds after a correction", "hold after a correction"),
    Verdict.REFUTED: ("is refuted", "are refuted"),
    Verdict.UNDECIDED: ("is undecided", "are undecided"),
    Verdict.UNCHECKED: ("is unchecked, as a tool is missing", "are unchecked, as a tool is missing"),
}


def model() -> tuple[Block, ...]:
    """Return what the paper models: the two bodies, and six symbols."""
    title, text = caption("two-bodies")
    table = notation.table(notation.SIX, "Six symbols; the others are in the notation", anchored=False)
    return Paragraph(MODEL), Picture("two-bodies", text, title), table


def counts(rows: Sequence[Row]) -> str:
    """Return how many of the paper's claims have which verdict, and how many theorems past it are proved."""
    claims = Counter(row.finding.verdict for row in rows if row.claim.kind is Kind.CLAIM)
    theorems = Counter(row.finding.verdict for row in rows if row.claim.kind is Kind.THEOREM)
    total, proved = sum(claims.values()), theorems[Verdict.HOLDS]
    parts = [f"{claims[verdict]} {_WORDS[verdict][claims[verdict] != 1]}" for verdict in Verdict if claims[verdict]]
    of_claims = (
        f"Of the paper's {total} claims {_joined(parts)}."
        if total > 1
        else f"The claim {parts[0][2:]}."
        if total
        else ""
    )
    missing = sum(theorems.values()) - proved
    past = f"Past the paper {proved} {'theorem is' if proved == 1 else 'theorems are'} proved here." if proved else ""
    still = f"{missing} more {'is' if missing == 1 else 'are'} not settled." if missing else ""
    return " ".join(filter(None, [of_claims, past, still, open_parts(rows)]))


def open_parts(rows: Sequence[Row]) -> str:
    """Say how many of the rows leave a part open; nothing where none does."""
    some = sum(bool(row.open) for row in rows)
    return (
        f"{some} {'row leaves' if some == 1 else 'rows leave'} a part open, and {'says' if some == 1 else 'say'} which."
        if some
        else ""
    )


def strengths(rows: Sequence[Row]) -> str:
    """Return how many verdicts rest on what, each by the weakest step that it needs; nothing where none is settled."""
    counted = Counter((row.established_by, row.claim.kind) for row in rows)
    parts = []
    for name, kinds in STRENGTHS.items():
        claims, theorems = (sum(counted[one, kind] for one in kinds) for kind in (Kind.CLAIM, Kind.THEOREM))
        numbers = [f"{n} {noun}{'s' if n != 1 else ''}" for n, noun in ((claims, "claim"), (theorems, "theorem")) if n]
        if numbers:
            parts.append(f"{name}: {' and '.join(numbers)}")
    return f"The weakest step that a verdict needs is {'; '.join(parts)}." if parts else ""


def _joined(parts: Sequence[str]) -> str:
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}"


def section(rows: Sequence[Row]) -> Section:
    """Return the counts, what the verdicts rest on, and those of the three findings whose rows are there with the verdict on record."""
    shown = {row.claim.id: row for row in rows if row.as_recorded}
    results = [make() for name, make in HIGHLIGHTS.items() if name in shown]
    texts = filter(None, (counts(rows), strengths(rows)))
    return Section(ID, TITLE, (*map(Paragraph, texts), *results, Paragraph(LAW)))


def exceptions(rows: Sequence[Row]) -> Section:
    """Return one line for each of the paper's claims that does not hold as written."""
    lines = tuple(
        (f"`{row.claim.id}`\n{row.claim.where}", row.finding.verdict.value, first_sentence(row.finding.reason))
        for row in rows
        if row.claim.kind is Kind.CLAIM and row.finding.verdict is not Verdict.HOLDS
    )
    table = Table(("row, and where in the paper", "verdict", "in short"), lines, "Claims that do not hold as written")
    return Section("exceptions", "Claims that need a correction, or fail", (table,) if lines else (Paragraph("None."),))


def refuted(rows: Sequence[Row]) -> tuple[Section, ...]:
    """Return one line for each of the paper's claims that is refuted; nothing where none is."""
    lines = tuple(
        (f"`{row.claim.id}`\n{row.claim.where}", row.claim.statement, first_sentence(row.finding.reason))
        for row in rows
        if row.claim.kind is Kind.CLAIM and row.finding.verdict is Verdict.REFUTED
    )
    table = Table(
        ("row", "the paper says", "what is true"), lines, "Claims that are false as such, not only in a detail"
    )
    return (Section("refuted", "What fails", (table,)),) if lines else ()
