"""What the writers of blocks have in common: texts with code and links in them, and how wide the columns of paper are."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping

from paper_checks.report.content.blocks import Table

_CODE = re.compile(r"`([^`]+)`")


class Writer(ABC):
    """Writes blocks in one form. `figures` maps the names of figures to what the form shows of them."""

    def __init__(self, figures: Mapping[str, str], anchors: Iterable[str] = ()) -> None:
        """Take the figures, and the anchors of the document: code in a text that names one links to it."""
        self._figures = figures
        self._anchors = frozenset(anchors)
        self._mention = _mention_of(self._anchors)

    def text(self, text: str) -> str:
        """Return a text in this form; code stands between backticks, and every mention of an anchor is a link."""
        pieces = _CODE.split(self._with_links(text))
        return "".join(self._code(piece) if index % 2 else self._prose(piece) for index, piece in enumerate(pieces))

    @abstractmethod
    def _prose(self, text: str) -> str:
        """Return prose with mathematics between dollars."""

    @abstractmethod
    def _code(self, code: str) -> str:
        """Return a word of code, a link where it has a target."""

    def _target(self, code: str) -> str | None:
        """Return the anchor that code names: a row's id, or a theorem's."""
        return next((one for one in (code, f"theorem-{code}") if one in self._anchors), None)

    def _with_links(self, text: str) -> str:
        """Return a text in which every mention of an anchor stands between backticks."""
        if self._mention is None:
            return text
        return self._mention.sub(lambda match: f"`{match[1]}`" if match[1] else match[0], text)


def _mention_of(anchors: Iterable[str]) -> re.Pattern[str] | None:
    """Return what finds anchors outside code, those that are words joined by hyphens; None where there are none."""
    names = sorted((name for name in anchors if "-" in name), key=lambda name: (-len(name), name))
    return re.compile(rf"`[^`]*`|(?<![\w-])({'|'.join(map(re.escape, names))})(?![\w-])") if names else None


def shares(table: Table) -> list[float]:
    """Return the share of each column of the width (dimensionless, their sum 1): the root of its longest text's length."""
    columns = [
        [len(line) for cell in column for line in cell.split("\n")]
        for column in zip(table.head, *table.rows, strict=True)
    ]
    wishes = [max(*lengths, 6) ** 0.5 for lengths in columns]
    return [wish / sum(wishes) for wish in wishes]
