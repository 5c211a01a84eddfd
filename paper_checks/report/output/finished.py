"""Reports kept in the user's cache, so that nothing is drawn or set twice: the bytes are those of a fresh run.

They are kept under a hash of every source file, of the versions of all that draws and sets, of the kernel's, and of the
trade that is shown, of the rows and the form.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from paper_checks import atomic
from paper_checks.running import kept, plain
from paper_checks.running.runner import Row
from paper_checks.store import Store, all_sources, digest, version

DRAWN_WITH = ("matplotlib", "math-core", "jinja2", "fonttools")
Files = Mapping[str, bytes]
"""The files of one form by name, the main one last."""


class Finished:
    """What was made before, for one trade."""

    def __init__(self, trade: Path | None = None, folder: Path | None = None) -> None:
        """Find the folder; raises OSError where the trade, a file that is shown instead of the shipped one, is not read."""
        words = [*kept.tools(), *(f"{name} {version(name)}" for name in (*kept.DEPENDENCIES, *DRAWN_WITH))]
        words.append(hashlib.sha256(trade.read_bytes()).hexdigest() if trade else "")
        self._store = Store("reports", digest(all_sources(), words), folder)
        self.forget_old = self._store.forget_old

    def files(self, name: str) -> Files | None:
        """Return the files of a form, by what `name_of` calls it."""
        names = self._store.get(name)
        found = {one: self._store.get(f"{name}.{one}") for one in json.loads(names)} if names else {}
        whole = {one: content for one, content in found.items() if content is not None}
        return whole if names and len(whole) == len(found) else None

    def keep(self, name: str, files: Files) -> None:
        """Keep the files of a form, and last their names."""
        for one, content in files.items():
            self._store.put(f"{name}.{one}", content)
        self._store.put(name, json.dumps(list(files)).encode())


def name_of(rows: Sequence[Row], form: str) -> str:
    """Return a name for a form of the report on these rows: a hash of what they say, and not of how long they took."""
    said = hashlib.sha256(form.encode())
    for row in rows:
        said.update(plain.as_json(replace(plain.plain(row), seconds=0.0)).encode() + b"\n")
    return f"{said.hexdigest()[:32]}.{form}"


def placed(folder: Path, files: Files) -> Path:
    """Write files into a folder; return the last one, which is the main one. Raises OSError."""
    for name, content in files.items():
        atomic.write(folder / name, content)
    return folder / name
