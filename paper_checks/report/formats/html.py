"""The report as one page of HTML, opened from disk without a network, with its figures and the page to explore beside it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from html import escape

from jinja2 import Environment
from markupsafe import Markup

from paper_checks.claims import source
from paper_checks.explore import motion, page
from paper_checks.proofs.audit import register
from paper_checks.report.content import derivation, opening, phrases, shared, story, trust
from paper_checks.report.content.blocks import Block
from paper_checks.report.content.document import Document
from paper_checks.report.formats.texts import Texts, templates
from paper_checks.report.mathematics import prose

FRONT, EXPLORE = "report.html", "explore.html"
_WORD = re.compile(r"[A-Z]\w*\.[\w']+")


def render(report: Document, figures: Mapping[str, str]) -> dict[str, str]:
    """Return every file of the report by its name, the page last. `figures` maps a figure's name to its SVG text.

    Everything but the SVG is escaped; a figure that is absent is said to be.
    """
    drawn = {name: figures[name] for name in report.pictures if name in figures}
    text = _pages(Texts(report.anchors, prose.html, _code), drawn).get_template("report.html")
    return {
        **{f"figures/{name}.svg": svg for name, svg in drawn.items()},
        EXPLORE: page.page(row.claim.id for row in report.rows),
        FRONT: text.render(
            report=report,
            motion=motion.section(),
            cited=register(),
            say=phrases,
            story=story,
            derivation=derivation,
            opening=opening,
            shared=shared,
            trust=trust,
            source=source,
        ),
    }


def fragment(blocks: Sequence[Block]) -> str:
    """Return blocks as a piece of a page."""
    macros = _pages(Texts((), prose.html, _code), {}).get_template("blocks.html").module
    return str(macros.body(blocks, 3))  # type: ignore[attr-defined]


def _pages(texts: Texts, figures: Mapping[str, str]) -> Environment:
    """Return the environment of the page's templates: how texts are written, and the sizes of the figures there are."""
    pages = templates(autoescape=True)

    def lines(text: str) -> Markup:
        """Return lines of code in which each name that is an anchor is a link."""
        return Markup(_WORD.sub(lambda word: _linked(word[0], texts.target(word[0])), escape(text, quote=False)))

    pages.filters |= {
        "text": lambda text: Markup(texts(text)),
        "unlinked": lambda text: Markup(prose.html(text.replace("`", ""))),
        "plain": lambda text: prose.plain(text).replace("`", ""),
        "lines": lines,
    }
    pages.globals["sizes"] = {name: _size(svg) for name, svg in figures.items()}
    return pages


def _code(code: str, target: str | None) -> str:
    """Return code that may be broken at its hyphens, where it is one word; a link where it has a target."""
    shown = escape(code) if " " in code else escape(code).replace("-", "-<wbr>")
    return _linked(f"<code>{shown}</code>", target)


def _linked(shown: str, target: str | None) -> str:
    return f'<a href="#{target}">{shown}</a>' if target else shown


def _size(svg: str) -> tuple[int, int]:
    """Return width and height of a figure, a point as a pixel."""
    found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)', svg)
    return (round(float(found[1])), round(float(found[2]))) if found else (0, 0)
