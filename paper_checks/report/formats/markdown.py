"""Blocks as Markdown, for a notebook that draws its figures itself."""

from __future__ import annotations

from collections.abc import Sequence

from paper_checks.report.content.blocks import (
    Block,
    Command,
    Folded,
    Heading,
    Labelled,
    Numbered,
    Paragraph,
    Points,
    Section,
    Table,
)


def markdown(section: Section) -> str:
    """Return the section as Markdown, without its figures."""
    return "\n\n".join([f"## {section.title}", *filter(None, map(_markdown, section.blocks))])


def _markdown(block: Block) -> str:  # noqa: PLR0911  one return for each kind of block
    match block:
        case Heading(text):
            return f"### {text}"
        case Paragraph(text):
            return text
        case Labelled(label, text):
            return f"**{label}.** {text}"
        case Points(items):
            return "\n".join(f"- {item}" for item in items)
        case Numbered(items):
            return "\n".join(f"1. {item}" for item in items)
        case Table(head, rows, caption):
            return f"*{caption}*\n\n{_table(head, rows)}"
        case Command(text):
            return f"    {text}"
        case Folded(title, blocks):
            return "\n\n".join([f"#### {title}", *filter(None, map(_markdown, blocks))])
        case _:
            return ""


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    cells = (" | ".join(cell.replace("|", r"\|").replace("\n", "<br>") for cell in line) for line in lines)
    return "\n".join(f"| {line} |" for line in cells)
