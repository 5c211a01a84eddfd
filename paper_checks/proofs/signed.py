"""Pairs that a person has read together and signed: a sentence that is shown, and the pinned statement behind it.

`signed.json` has a hash of each pair: of the sentence of a cited theorem and what the kernel prints of it, definitions
included; of the words of a clause and the statements of the theorems that carry it. Where either is changed alone, or both
are and nobody has signed again, the theorem does not count as proved, and the clause is not carried:
`python -m paper_checks sign` shows both sides. All that a row says, formulas and what it leaves open included, is signed
beside that: it turns no row, but a test.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path

from paper_checks import atomic
from paper_checks.proofs.pins import pinned
from paper_checks.proofs.sources import digest

FILE = Path(__file__).with_name("signed.json")
Texts = Sequence[str]
"""What was read together: the sentence first, then each statement and definition with its name."""


@cache
def signatures() -> Mapping[str, str]:
    """The hash of each pair by its key: a theorem's id, or a claim's and its clause's with a slash between."""
    found: dict[str, str] = json.loads(FILE.read_text("utf-8"))
    return found


def of_theorem(sentence: str, statement: str, definitions: Mapping[str, str]) -> Texts:
    """What is read together of a cited theorem."""
    return (sentence, statement, *(f"{name} := {text}" for name, text in sorted(definitions.items())))


def of_clause(words: str, theorems: Iterable[str]) -> Texts:
    """What is read together of a clause: its words, and the pinned statements of the theorems that prove it, by id."""
    pins = pinned().theorems
    return (words, *(f"{one}: {pins[one].statement if one in pins else 'not pinned'}" for one in theorems))


def is_signed(key: str, texts: Texts) -> bool:
    """Whether these very texts were signed together."""
    return signatures().get(key) == digest(texts)


def sign(pairs: Mapping[str, Texts], keys: Iterable[str]) -> None:
    """Sign pairs by their keys; signatures of what is no pair any more go."""
    kept = {key: value for key, value in signatures().items() if key in pairs} if FILE.exists() else {}
    found = kept | {key: digest(pairs[key]) for key in keys}
    atomic.write(FILE, json.dumps(dict(sorted(found.items())), indent=0) + "\n")
    signatures.cache_clear()
