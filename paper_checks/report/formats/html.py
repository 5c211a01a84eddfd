"""The report as one page of HTML, opened from disk without a network, with its figures and the page to explore beside it."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from html import escape

from jinja2 import Environment
from markupsafe import Markup

from paper_checks.drawing.captions import caption
from paper_checks.explore import motion, page
from paper_checks.report.content import phrases, story
from paper_checks.report.content.blocks import Section
from paper_checks.report.content.document import TITLE, Document
from paper_checks.report.formats.texts import target, templates
from paper_checks.report.mathematics import prose

FRONT, EXPLORE = "report.html", "explore.html"
_WORD = re.compile(r"[A-Z]\w*\.[\w']+")


def render(report: Document, figures: Mapping[str, str]) -> dict[str, str]:
    """Return every file of the report by its name, the page last. `figures` maps a figure's name to its SVG text.

    Everything but the SVG is escaped; a figure that is absent is said to be.
    """
    drawn = {name: figures[name] for name in report.pictures if name in figures}
    text = _pages(report.anchors, drawn).get_template("report.html")
    return {
        **{f"figures/{name}.svg": svg for name, svg in drawn.items()},
        EXPLORE: page.page(row.claim.id for row in report.rows),
        FRONT: text.render(report=report, title=TITLE, motion=motion.section(), say=phrases, story=story),
    }


def fragment(section: Section) -> str:
    """Return the blocks of a section, without its figures, as a piece of a page."""
    macros = _pages((), {}).get_template("blocks.html").module
    return str(macros.body([one for one in section.blocks if one.kind != "picture"]))  # type: ignore[attr-defined]


def _pages(anchors: Collection[str], figures: Mapping[str, str]) -> Environment:
    """Return the environment of the page's templates: how texts are written, and the sizes of the figures there are."""

    def linked(word: str, shown: str) -> Markup:
        place = target(word, anchors)
        return Markup(f'<a href="#{place}">{shown}</a>' if place else shown)

    def code(word: str) -> Markup:
        """Return code that may be broken at its hyphens, where it is one word."""
        return linked(word, f"<code>{escape(word) if ' ' in word else escape(word).replace('-', '-<wbr>')}</code>")

    def lines(text: str) -> Markup:
        """Return lines of code in which each name that is an anchor is a link."""
        return Markup(_WORD.sub(lambda word: linked(word[0], word[0]), escape(text, quote=False)))

    pages = templates(lambda text: Markup(prose.html(text)), code, autoescape=True)
    text = pages.filters["text"]
    pages.filters |= {
        "text": lambda source: Markup(text(source)),
        "unlinked": lambda source: Markup(prose.html(source.replace("`", ""))),
        "plain": lambda source: prose.plain(source).replace("`", ""),
        "lines": lines,
    }
    pages.globals |= {"sizes": {name: _size(svg) for name, svg in figures.items()}, "caption": caption}
    return pages


def _size(svg: str) -> tuple[int, int]:
    """Return width and height of a figure, a point as a pixel."""
    found = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)', svg)
    return (round(float(found[1])), round(float(found[2]))) if found else (0, 0)
