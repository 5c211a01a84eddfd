"""What a reader meets first: the pair, what fails, what is new, how sure it is; and what is often asked."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction

from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from paper_checks.drawing.relative_velocity import PRINTED
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content import derivation
from paper_checks.report.content.blocks import Block, Cards, Heading, Paragraph, Picture, Points, Section, Table
from paper_checks.report.content.phrases import formula, headline, in_short, kind, picture
from paper_checks.running.runner import Row

MODEL = (
    "The paper models two bodies. One is held by a spring. The other is coupled to it by dry friction alone, like a box on a "
    "moving table. The pair either sticks and oscillates as one mass, or slips. The paper states how the free pair moves in the long run; "
    "its claims, and more, are checked here."
)
STRENGTHS = {
    "a theorem of the proof kernel": (EvidenceKind.KERNEL,),
    "solvers, exact algebra or enclosures": (EvidenceKind.SMT, EvidenceKind.EXACT, EvidenceKind.ENCLOSURE),
    "an argument that a person wrote, over such steps": (EvidenceKind.ARGUMENT,),
}
"""Kinds of steps, from the strongest; together they are all that can settle a claim."""
DERIVED = "How the paper's results follow from the equations of motion, line by line, and which check accepted each line: `derivation`."
NEW: dict[str, tuple[str, str, str]] = {
    "sharp-rate-constant": (
        "rate-bounds",
        "One 1/t law",
        "Without damper and force, a pair that never merges has $«limit/limit»$, from every initial state",
    ),
    "critical-mass-ratio": (
        "merging-window",
        "Heavy driving bodies merge at first contact or never",
        "If $m_1/m_2>\\mu^*$, no slip from $S$ above $E_{cr}$ ends below it; $«root/digits»$",
    ),
    "merging-share": (
        "merging-share",
        "Just above critical, merging is the common case",
        "Up to $r^*$ nearly all states just above $E_{cr}$ merge, though none on $S_0$ does; their share is an integral, and falls like $1/E$",
    ),
    "entrainment-threshold": (
        "thresholds-over-frequency",
        "Three regimes under a sine",
        "Up to $U_*$ some motion sticks permanently, and with a damper every motion tends to it; below $U_{**}$ none of the force's "
        "period slips permanently with two reversals. Both have closed forms; between them not every amplitude has a motion with two stops",
    ),
    "uniform-rate": (
        "uniform-rate",
        "What the initial energy determines",
        "$E(0)$ alone fixes an upper bound $c_2/t$ of $E/E_{cr}-1$, for all trajectories that never merge, and no lower one",
    ),
}
"""Results beyond the paper that the first page shows, by their claims: figure, title, and a sentence with the claim's formulas."""
_SLOT = re.compile("«([a-z]+)/([a-z]+)»")


def front(rows: Sequence[Row]) -> tuple[Section, ...]:
    """Return the sections of the first page, those that have something to say."""
    shown = {row.claim.id: row for row in rows}
    past = tuple(
        (title, f"{_filled(name, text)} (`{name}`; weakest step: {kind(shown[name])}).", picture(figure))
        for name, (figure, title, text) in NEW.items()
        if name in shown and shown[name].as_recorded
    )
    sections = (
        Section(
            "model",
            "The pair",
            (
                Paragraph(MODEL),
                Paragraph(headline(rows)),
                *(Paragraph(one) for one in (DERIVED,) if derivation.is_whole(rows)),
            ),
        ),
        Section("refuted", "What fails", tuple(_refuted(rows))),
        Section(
            "results",
            "What is new",
            (Cards(past), Paragraph("All theorems beyond the paper: `new`.")) if past else (),
        ),
        Section("sure", "How sure it is", tuple(_sure(rows))),
    )
    return tuple(one for one in sections if one.blocks)


def _filled(row: str, text: str) -> str:
    """Return a sentence with the formulas of a row in their places."""
    return _SLOT.sub(lambda place: formula(row, place[1], place[2]), text)


def _refuted(rows: Sequence[Row]) -> Iterator[Block]:
    """Yield a line for each of the paper's claims that is refuted, and the pictures of two."""
    failed = [row for row in rows if row.claim.kind is Kind.CLAIM and row.finding.verdict is Verdict.REFUTED]
    lines = ((f"`{one.claim.id}`\n{one.claim.where}", one.claim.statement, in_short(one), kind(one)) for one in failed)
    if failed:
        yield Table(
            ("claim", "the paper says", "what is true", "weakest step"),
            tuple(lines),
            "Refuted claims",
        )
    known = {row.claim.id for row in rows if row.as_recorded}
    cards = (
        make()
        for name, make in (("synchronisation-time", _synchronisation), ("start-at-6mm-sticks", _start_at_6mm))
        if name in known
    )
    if found := tuple(cards):
        yield Cards(found)


def _synchronisation() -> tuple[str, str, Picture]:
    run = solve(load_scene("velocities"), digits=12, arithmetic="ball")
    _, v1, _, v2 = run.sol(PRINTED)
    slip = 1000 * abs(float(v1 - v2))
    return (
        f"At {PRINTED} s the bodies slip",
        f"The relative velocity is {slip:.2f} mm/s at the time of the paper's synchronisation.",
        picture("relative-velocity"),
    )


def _start_at_6mm() -> tuple[str, str, Picture]:
    scene = load_scene("start-at-6mm")
    pair, start = scene.pair, Fraction(scene.initial.x1)
    needed = float(pair.m2 * pair.a2 / pair.mass * start)
    text = f"Sticking needs {needed:g} N; friction gives at most {float(pair.b):g} N."
    return f"From {float(start):g} m the bodies slip at once under (3), (4)", text, picture("force-needed")


def strengths(rows: Sequence[Row]) -> tuple[tuple[str, ...], ...]:
    """Return how many verdicts rest on what, each by the weakest step that it needs."""
    counted = Counter((row.established_by, row.claim.kind) for row in rows)
    lines = ((name, *(str(sum(counted[one, of] for one in kinds)) for of in Kind)) for name, kinds in STRENGTHS.items())
    return tuple(lines)


def _sure(rows: Sequence[Row]) -> Iterator[Block]:
    yield Table(("weakest step that the verdict needs", "claims", "theorems"), strengths(rows), "")
    left = "Open parts: `open`." if any(row.open for row in rows) else "No claim leaves a part open."
    yield Paragraph(
        f"What each kind of step guarantees, what has to be trusted, and which friction law is used: `trust`. {left}"
    )


def still_open(rows: Sequence[Row]) -> Section:
    """Return all that rows leave open, sentence by sentence, and what is not settled at all."""
    kinds = {
        "Open parts of decided claims, which no verdict needs": tuple(
            f"{text} (`{row.claim.id}`)" for row in rows for text in row.open
        ),
        "Not settled here": tuple(f"`{row.claim.id}`: {row.finding.missing}" for row in rows if row.finding.missing),
    }
    parts = (block for title, items in kinds.items() if items for block in (Heading(title), Points(items)))
    return Section("open", "Open", tuple(parts))
