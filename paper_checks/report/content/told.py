"""What is told of one claim, in the terminal and on the page."""

from __future__ import annotations

from paper_checks.derivation.chapter import lines_of, number
from paper_checks.report.content import story
from paper_checks.report.content.blocks import Block, chapter, read
from paper_checks.running.runner import Row


def told(row: Row, *, page: bool = False) -> list[Block]:
    """Return what is told of a claim, by itself or on the page."""
    return read(chapter("claim", page=page, row=row, story=story, number=number, carried=lines_of(row.claim.id)))
