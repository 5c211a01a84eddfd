"""The proof files: their texts, which requires which, and a key that changes with anything they rest on.

A file's key is a hash of its text, of the keys of the files that it requires, and of the compiler's version. What was
compiled is kept under that key, so a changed file is compiled anew with all that rest on it, and with nothing else.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from graphlib import TopologicalSorter
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "rocq"
LIBRARY = "InertialPair"
AUDIT = "Audit"
"""The file that prints what the others prove: it is none of them."""

_REQUIRED = re.compile(rf"From\s+{LIBRARY}\s+Require\s+(?:Import\s+|Export\s+)?([\w\s]+)\.")
_DECLARED = re.compile(r"^\s*(?:Lemma|Theorem|Corollary|Definition|Fixpoint|Inductive|Record) ([\w']+)", re.MULTILINE)


@dataclass(frozen=True)
class Source:
    """One proof file: its name without the ending, and its text."""

    name: str
    text: str

    @cached_property
    def requires(self) -> tuple[str, ...]:
        """The files of this library that it requires, in the order of its text."""
        return tuple(name for names in _REQUIRED.findall(self.text) for name in names.split())

    def declared_before(self, line: int) -> str:
        """The last statement or definition that begins in the first `line` lines: what an error there is about."""
        declared = _DECLARED.findall("\n".join(self.text.splitlines()[:line]))
        return f"{self.name}.{declared[-1]}" if declared else f"{self.name}.v"


def read(folder: Path = FOLDER) -> dict[str, Source]:
    """The proof files below a folder by name, each of which is there once."""
    paths = (path for path in sorted(folder.rglob("*.v")) if path.stem != AUDIT)
    return {path.stem: Source(path.stem, path.read_text("utf-8")) for path in paths}


def needed(wanted: Iterable[str], sources: Mapping[str, Source]) -> tuple[str, ...]:
    """Files and all that they rest on, each after those that it requires.

    Raises ValueError for a name that is missing, CycleError where a file requires itself.
    """
    graph: dict[str, tuple[str, ...]] = {}
    waiting = list(wanted)
    while waiting:
        name = waiting.pop()
        if name not in sources:
            raise ValueError(f"{name} is required, and there is no {name}.v")
        if name not in graph:
            graph[name] = sources[name].requires
            waiting += graph[name]
    return tuple(TopologicalSorter(graph).static_order())


def keys(sources: Mapping[str, Source], compiler: str) -> dict[str, str]:
    """The key of each file, by name."""
    known: dict[str, str] = {}
    for name in needed(sources, sources):
        source = sources[name]
        known[name] = digest([compiler, name, source.text, *(known[one] for one in sorted(source.requires))])
    return known


def digest(texts: Iterable[str]) -> str:
    """A short name for a sequence of texts."""
    total = hashlib.sha256()
    for text in texts:
        total.update(f"{len(text)}:{text}".encode())
    return total.hexdigest()[:20]
