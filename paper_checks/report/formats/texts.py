"""The texts of a document in one format: prose with mathematics, code, and a link at every mention of an anchor."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

LISTED = ("theorem", "definition", "step", "symbol")
"""How anchors begin that stand in a list of their kind; in a text only the rest is code."""
_CODE = re.compile(r"`([^`]+)`")


class Texts:
    """Writes texts; `prose` writes what stands outside backticks, `code` a word of code with the anchor that it links to, if any."""

    def __init__(
        self, anchors: Iterable[str], prose: Callable[[str], str], code: Callable[[str, str | None], str]
    ) -> None:
        """Take the anchors of the document, and how both are written."""
        self._anchors, self._prose, self._code = frozenset(anchors), prose, code
        mentioned = (
            one for one in self._anchors if "-" in one and not one.startswith(tuple(f"{of}-" for of in LISTED))
        )
        names = "|".join(map(re.escape, sorted(mentioned, key=lambda name: (-len(name), name))))
        self._mention = re.compile(rf"`[^`]*`|(?<![\w-])({names or '(?!)'})(?![\w-])")

    def __call__(self, text: str) -> str:
        """Return a text in this format; code stands between backticks."""
        marked = self._mention.sub(lambda found: f"`{found[1]}`" if found[1] else found[0], text)
        pieces = _CODE.split(marked)
        return "".join(self._code(one, self.target(one)) if n % 2 else self._prose(one) for n, one in enumerate(pieces))

    def target(self, code: str) -> str | None:
        """Return the anchor that code names: a claim's id, or a theorem's, a definition's, a step's or a symbol's."""
        names = (code, *(f"{of}-{code}" for of in LISTED))
        return next((one for one in names if one in self._anchors), None)


def templates(**options: Any) -> Environment:
    """Return the environment of the templates beside this file; they ask blocks for their kind."""
    folder = Path(__file__).with_name("templates")
    found = Environment(
        loader=FileSystemLoader(folder), undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True, **options
    )
    found.filters["kind"] = lambda block: type(block).__name__
    return found
