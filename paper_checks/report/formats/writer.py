"""What the writers of blocks have in common: texts with code and links in them, and how wide the columns of paper are."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence

from paper_checks.report.content import blocks
from paper_checks.report.content.blocks import Block, Table
from paper_checks.report.mathematics.prose import plain

LISTED = ("theorem", "definition", "step", "symbol")
"""How anchors begin that stand in a list of their kind; in a text only the rest is code."""
WIDE = 90
"""Letters of a table in one line of paper."""
_WORDS = re.compile(r"[^\s-]+-?|$")
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

    def body(self, some: Sequence[Block]) -> str:
        """Return blocks one below the other."""
        return "\n\n".join(filter(None, map(self._block, some)))

    def _block(self, block: Block) -> str:  # noqa: PLR0911  one return for each kind of block
        match block:
            case blocks.Heading(text, anchor):
                return self._heading(text, anchor)
            case blocks.Paragraph():
                return self._paragraph(block)
            case blocks.Points(items, numbered):
                return self._points([self.text(item) for item in items], numbered)
            case blocks.Table():
                return self._table(block)
            case blocks.Picture():
                return self._picture(block)
            case blocks.Cards(items):
                return self._cards([(self.text(title), self.text(text), picture) for title, text, picture in items])
            case blocks.Code(text):
                return self._lines(text)
            case blocks.Line():
                return self._numbered(block)
            case blocks.Markup(html):
                return self._markup(html)
            case blocks.Folded(title, inside, anchor):
                return self._folded(title, self.body(inside), anchor)

    @abstractmethod
    def _prose(self, text: str) -> str:
        """Return prose with mathematics between dollars."""

    @abstractmethod
    def _code(self, code: str) -> str:
        """Return a word of code, a link where it has a target."""

    @abstractmethod
    def _heading(self, text: str, anchor: str) -> str: ...

    @abstractmethod
    def _paragraph(self, block: blocks.Paragraph) -> str: ...

    @abstractmethod
    def _points(self, items: Sequence[str], numbered: bool) -> str: ...

    @abstractmethod
    def _table(self, table: Table) -> str: ...

    @abstractmethod
    def _picture(self, picture: blocks.Picture) -> str: ...

    @abstractmethod
    def _cards(self, cards: Sequence[tuple[str, str, blocks.Picture]]) -> str: ...

    @abstractmethod
    def _lines(self, text: str) -> str:
        """Return lines of fixed width."""

    @abstractmethod
    def _numbered(self, line: blocks.Line) -> str:
        """Return a line of the derivation, one whose check did not pass marked."""

    @abstractmethod
    def _markup(self, html: str) -> str: ...

    @abstractmethod
    def _folded(self, title: str, inside: str, anchor: str) -> str: ...

    def _target(self, code: str) -> str | None:
        """Return the anchor that code names: a row's id, or a theorem's, a definition's or a step's."""
        names = (code, *(f"{of}-{code}" for of in LISTED))
        return next((one for one in names if one in self._anchors), None)

    def _with_links(self, text: str) -> str:
        """Return a text in which every mention of an anchor stands between backticks."""
        if self._mention is None:
            return text
        return self._mention.sub(lambda match: f"`{match[1]}`" if match[1] else match[0], text)


def _mention_of(anchors: Iterable[str]) -> re.Pattern[str] | None:
    """Return what finds rows outside code, ids that are words joined by hyphens; None where there are none."""
    found = (name for name in anchors if "-" in name and not name.startswith(tuple(f"{of}-" for of in LISTED)))
    names = sorted(found, key=lambda name: (-len(name), name))
    return re.compile(rf"`[^`]*`|(?<![\w-])({'|'.join(map(re.escape, names))})(?![\w-])") if names else None


def shares(table: Table) -> list[float]:
    """Return the share of each column of the width (dimensionless, their sum 1).

    Each has room for its longest word; what is left goes by the length of its longest text.
    """
    columns = [
        [plain(line) for cell in column for line in cell.split("\n")]
        for column in zip(table.head, *table.rows, strict=True)
    ]
    least = [max(len(word) for line in column for word in _WORDS.findall(line)) / WIDE for column in columns]
    wishes = [max(map(len, column)) for column in columns]
    if (left := 1 - sum(least)) <= 0:
        return [one / sum(least) for one in least]
    return [one + left * wish / sum(wishes) for one, wish in zip(least, wishes, strict=True)]
