"""The report as data: its sections, read from the chapters, and what is told of each claim. A page has all, paper a selection."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from numerics.trade.recorded import Trade
from paper_checks.claims import source
from paper_checks.evidence.claim import FREE, Kind
from paper_checks.evidence.finding import Verdict
from paper_checks.proofs.audit import register
from paper_checks.report.content import citation, derivation, force, kernel, phrases, speed, story, trust
from paper_checks.report.content.blocks import Section, chapter, section
from paper_checks.report.content.told import told
from paper_checks.running.runner import Row

TITLE = f"{source.TITLE}: its claims, checked"
ROWS = "rows"
"""The anchor of the list of claims."""
FRONT = ("pair", "fails", "results", "trust")
CHAPTERS = ("derivation", "new", "not-judged", "questions", "open")
OF_ALL_CLAIMS: dict[str, Callable[[Trade], dict[str, Any]]] = {
    "under-a-force": lambda _: force.given(),
    "speed-and-accuracy": speed.given,
}
"""Chapters of a page on all claims, and what they need."""
BEHIND = ("kernel", "notation", "provenance")


@dataclass(frozen=True)
class Document:
    """A report: what a reader meets first, what is told of each claim, by its id, and chapters."""

    front: tuple[Section, ...]
    rows: tuple[Row, ...]
    claims: Mapping[str, Section]
    chapters: tuple[Section, ...]

    @property
    def sections(self) -> tuple[Section, ...]:
        """All its sections, those of the claims among them."""
        return (*self.front, *self.claims.values(), *self.chapters)

    @property
    def anchors(self) -> frozenset[str]:
        """All that a link can point to."""
        return frozenset((ROWS, *(anchor for one in self.sections for anchor in one.anchors)))

    @property
    def pictures(self) -> tuple[str, ...]:
        """The names of its figures, each once."""
        return tuple(dict.fromkeys(name for one in self.sections for name in one.pictures))


def document(rows: Sequence[Row], trade: Trade | None = None) -> Document:
    """Return the page on these rows; with a trade, on all claims, it has the chapters on forces and on speed."""
    given = _given(rows) | {"answers": [*speed.answers(trade)] if trade else []}
    more = {name: of(trade) for name, of in OF_ALL_CLAIMS.items()} if trade else {}
    names = (*CHAPTERS, *more, *BEHIND)
    chapters = [section(chapter(name, **given | more.get(name, {}))) for name in names]
    front = tuple(filter(None, (section(chapter(name, **given)) for name in FRONT)))
    claims = {row.claim.id: Section(row.claim.id, "", tuple(told(row, page=True))) for row in rows}
    return Document(front, tuple(rows), claims, tuple(filter(None, chapters)))


def paper(rows: Sequence[Row]) -> Document:
    """Return what is printed: what stands before the contents, then the numbered sections; each claim once, by its verdict."""
    given = _given(rows, paper=True)
    texts = [chapter(name, **given) for name in ("fails", "results", "derivation")]
    texts += [
        chapter("verdict", **given, verdict=one.value, words=phrases.COUNTED[one])
        for one in Verdict
        if one is not Verdict.REFUTED
    ]
    texts += [chapter(name, **given) for name in ("new", "kernel", "open", "trust", "notation", "provenance")]
    before = section(chapter("pair", **given))
    return Document(tuple(filter(None, [before])), tuple(rows), {}, tuple(filter(None, map(section, texts))))


def _given(rows: Sequence[Row], *, paper: bool = False) -> dict[str, Any]:
    """Return what the chapters know."""
    return {
        "paper": paper,
        "rows": rows,
        "claims": {row.claim.id: row for row in rows},
        "recorded": {row.claim.id: row for row in rows if row.as_recorded},
        "theorems": [row for row in rows if row.claim.kind is Kind.THEOREM],
        "free": FREE,
        "say": phrases,
        "story": story,
        "source": source,
        "citation": citation,
        "cited": register(),
        **derivation.given(rows),
        **kernel.given(rows),
        **trust.given(rows),
    }
