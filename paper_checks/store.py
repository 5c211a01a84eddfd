"""Sealed files in the user's cache, under a hash of all that they rest on: what is damaged, or of another state, is not read.

What is kept is data (JSON, pictures), never code: whatever stands there, reading it runs nothing. It is believed all the
same, so a folder that others can change is not used (`numerics.files.cache_refused`).
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import os
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from numerics.files import cache_folder, forget_unused, make_private
from paper_checks import atomic

ROOT = Path(__file__).parents[1]
PACKAGES = ("theory", "numerics", "paper_checks")
_GENERATIONS = 8
"""How many states of the sources are kept; the oldest goes."""


def all_sources() -> Iterator[Path]:
    """Yield every file of the packages, in a fixed order."""
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                yield path


def digest(files: Iterable[Path], words: Iterable[str]) -> str:
    """Return the hash of the files' places and contents and of the words."""
    found = hashlib.sha256()
    for path in files:
        content = path.read_bytes()
        found.update(f"{os.path.relpath(path, ROOT)} {len(content)}\n".encode() + content)
    found.update("\n".join(words).encode())
    return found.hexdigest()[:32]


def version(name: str) -> str:
    """Return the installed version of a package, or that there is none."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


class Store:
    """Files of one kind and one state."""

    def __init__(self, kind: str, state: str, folder: Path | None = None) -> None:
        """Find the folder; `folder` instead of the one of this kind in the user's cache."""
        self._state = state
        self._folder = (folder or cache_folder() / kind) / state

    def is_empty(self) -> bool:
        """Return whether nothing was put there."""
        return not self._folder.is_dir()

    def get(self, name: str) -> bytes | None:
        """Return what was put under a name; None where nothing was, or the file is not as it was written."""
        try:
            content = (self._folder / name).read_bytes()
        except OSError:
            return None
        seal, _, body = content.partition(b"\n")
        return body if seal == self._seal(name, body) else None

    def put(self, name: str, body: bytes) -> None:
        """Keep bytes under a name; a cache that cannot be written keeps nothing."""
        try:
            make_private(self._folder)
            atomic.write(self._folder / name, self._seal(name, body) + b"\n" + body)
        except OSError:
            return

    def forget_old(self) -> None:
        """Remove the folders of states that have not been used for longest."""
        with suppress(OSError):  # nothing was put there
            os.utime(self._folder)
        forget_unused(self._folder.parent, _GENERATIONS, idle=0)

    def _seal(self, name: str, body: bytes) -> bytes:
        return hashlib.sha256(f"{self._state} {name}\n".encode() + body).hexdigest().encode()
