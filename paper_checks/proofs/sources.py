"""The proof files: their texts, which rests on which, and a key that changes with anything they rest on.

A file's key is a hash of its text, of the keys of the files that it requires, and of the compiler's version. What was
compiled is kept under that key, so a changed file is compiled anew with all that rest on it, and with nothing else.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "rocq"
LIBRARY = "InertialPair"

# a text in quotes holds no mark of a comment; Coq reads it as one within a comment too
_COMMENT = re.compile(r'\(\*|\*\)|"[^"]*"')
_REQUIRED = re.compile(rf"From\s+{LIBRARY}\s+Require\s+(?:Import\s+|Export\s+)?([\w\s]+)\.")
_DECLARED = re.compile(
    r"\b(?:Lemma|Theorem|Corollary|Definition|Fixpoint|Inductive|Record|Axioms?|Parameters?|Conjecture)\s+([\w']+)"
)
# what makes a statement true without a proof, or lets a proof pass that the kernel would refuse
_UNPROVED = re.compile(
    r"\b(Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|Admit Obligations|bypass_check"
    r"|Unset\s+(?:Guard|Positivity|Universe)\s+Checking)\b"
)


@dataclass(frozen=True)
class Source:
    """One proof file: its name without the ending, and its text."""

    name: str
    text: str

    @cached_property
    def requires(self) -> tuple[str, ...]:
        """The files of this library that it requires, in the order of its text."""
        return tuple(name for names in _REQUIRED.findall(without_comments(self.text)) for name in names.split())

    def declared_before(self, line: int) -> str:
        """The last statement or definition that begins in the first `line` lines: what an error there is about."""
        found = _DECLARED.findall(without_comments("\n".join(self.text.splitlines()[:line])))
        return f"{self.name}.{found[-1]}" if found else f"{self.name}.v"

    def unproved(self) -> tuple[str, ...]:
        """Each place where something is assumed instead of proved, as one line with its name."""
        text = without_comments(self.text)
        found = []
        for match in _UNPROVED.finditer(text):
            # an axiom is named after the word, an `Admitted` stands below its statement
            named = _DECLARED.match(text, match.start())
            above = _DECLARED.findall(text[: match.start()])
            name = named[1] if named else above[-1] if above else "v"
            found.append(f"{self.name}.{name}: {' '.join(match[1].split())} stands where a proof is needed")
        return tuple(found)


def without_comments(text: str) -> str:
    """The text with every comment, nested ones included, replaced by the line ends in it."""
    kept, depth, start = [], 0, 0
    for match in _COMMENT.finditer(text):
        quoted = match[0].startswith('"')
        piece = text[start : match.end() if quoted else match.start()]
        kept.append("\n" * piece.count("\n") if depth else piece)
        depth = max(0, depth + (0 if quoted else 1 if match[0] == "(*" else -1))
        start = match.end()
    kept.append(text[start:])
    return "".join(kept)


def read(folder: Path = FOLDER) -> dict[str, Source]:
    """The proof files below a folder by name, each of which is there once."""
    return {path.stem: Source(path.stem, path.read_text("utf-8")) for path in sorted(folder.rglob("*.v"))}


def in_order(sources: Mapping[str, Source]) -> tuple[str, ...]:
    """The names so that each comes after the files that it requires. Raises ValueError for a name that is missing."""
    placed: dict[str, None] = {}

    def place(name: str, above: tuple[str, ...]) -> None:
        if name in above:
            raise ValueError(f"{name}.v requires itself, by way of {', '.join(above)}")
        if name not in sources:
            raise ValueError(f"{above[-1]}.v requires {name}, and there is no {name}.v")
        for required in sources[name].requires:
            if required not in placed:
                place(required, (*above, name))
        placed.setdefault(name)

    for name in sources:
        place(name, ())
    return tuple(placed)


def all_required(name: str, sources: Mapping[str, Source]) -> frozenset[str]:
    """The files below a file, at any depth, without itself."""
    found: set[str] = set()
    waiting = [name]
    while waiting:
        further = set(sources[waiting.pop()].requires) - found
        found |= further
        waiting += further
    return frozenset(found)


def keys(sources: Mapping[str, Source], compiler: str) -> dict[str, str]:
    """The key of each file, by name."""
    found: dict[str, str] = {}
    for name in in_order(sources):
        source = sources[name]
        found[name] = digest([compiler, name, source.text, *(found[one] for one in sorted(source.requires))])
    return found


def digest(texts: Iterable[str]) -> str:
    """A short name for a sequence of texts."""
    found = hashlib.sha256()
    for text in texts:
        found.update(f"{len(text)}:{text}".encode())
    return found.hexdigest()[:20]
