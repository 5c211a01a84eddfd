"""The texts of a document in one format: prose with mathematics, and code, a link where it names an anchor."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

LISTED = ("theorem", "definition", "symbol", "line")
"""How anchors begin that stand in a list of their kind; in a text only the rest is code."""


def target(code: str, anchors: Collection[str]) -> str | None:
    """Return the anchor that code names: a claim's id, or a theorem's, a definition's, a symbol's or a line's."""
    return next((one for one in (code, *(f"{of}-{code}" for of in LISTED)) if one in anchors), None)


def templates(prose: Callable[[str], str], code: Callable[[str], str], **options: Any) -> Environment:
    """Return the environment of the templates beside this file: `text` writes prose so, and what stands between backticks so."""
    found = Environment(
        loader=FileSystemLoader(Path(__file__).with_name("templates")),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        **options,
    )

    def text(source: str) -> str:
        pieces = re.split(r"`([^`]+)`", source)
        return "".join(code(one) if place % 2 else prose(one) for place, one in enumerate(pieces))

    found.filters["text"] = text
    return found
