"""Rows kept in the user's cache, so that nothing is decided twice: under a hash of all that they rest on.

That is every source file of the packages but those that only show rows, the versions of Python and of what is imported
or asked, the kernel and its version, and the seed. An entry carries its own hash: a damaged one is not read, and the row
is decided anew. Only rows that another run would find again are kept.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import os
import pickle
import platform
import shutil
from collections.abc import Iterator
from pathlib import Path

from paper_checks import atomic
from paper_checks.proofs import kernel
from paper_checks.running.plain import Plain

PACKAGES = ("theory", "numerics", "paper_checks")
SHOWING = ("report", "drawing", "explore", "speed")
"""Rooms of `paper_checks` that no check imports: they show rows. A test holds this."""
DEPENDENCIES = ("sympy", "mpmath", "numpy", "python-flint", "z3-solver", "cvc5", "scipy", "numba")
_GENERATIONS = 8
"""How many states of the sources are kept; the oldest goes."""


def sources() -> Iterator[Path]:
    """Yield every file that a row can depend on, in a fixed order."""
    root = Path(__file__).parents[2]
    for package in PACKAGES:
        for path in sorted((root / package).rglob("*")):
            inside = path.relative_to(root).parts
            shows = inside[0] == "paper_checks" and inside[1] in SHOWING
            if path.is_file() and "__pycache__" not in inside and not shows:
                yield path


def state(seed: int) -> str:
    """Return the hash of all that rows rest on."""
    digest = hashlib.sha256()
    for path in sources():
        content = path.read_bytes()
        digest.update(f"{path.name} {len(content)}\n".encode() + content)
    search_path = os.environ.get("PATH")
    missing = kernel.why_not(search_path)
    tools = [missing or kernel.version(search_path), platform.python_version(), platform.machine(), f"seed {seed}"]
    tools += [f"{name} {_version(name)}" for name in DEPENDENCIES]
    digest.update("\n".join(tools).encode())
    return digest.hexdigest()[:32]


def _version(name: str) -> str:
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


class Kept:
    """The rows of one state."""

    def __init__(self, seed: int, folder: Path | None = None) -> None:
        """Find the folder; `folder` instead of the one in the user's cache."""
        self._state = state(seed)
        self._folder = (folder or kernel.cache_folder().parent / "rows") / self._state

    def row(self, name: str) -> Plain | None:
        """Return the row of a claim; None where it is not kept, or not as it was written."""
        try:
            content = self._path(name).read_bytes()
        except OSError:
            return None
        seal, _, body = content.partition(b"\n")
        if seal != self._seal(name, body):
            return None
        found: Plain = pickle.loads(body)
        return found

    def keep(self, row: Plain) -> None:
        """Keep a row that another run would find again; a cache that cannot be written keeps none."""
        if not row.lasting:
            return
        body = pickle.dumps(row)
        try:
            atomic.write(self._path(row.claim), self._seal(row.claim, body) + b"\n" + body)
        except OSError:
            return

    def forget_old(self) -> None:
        """Remove the folders of states that have not been used for longest."""
        with_times = []
        try:
            self._folder.touch()
            with_times = [(one.stat().st_mtime, one) for one in self._folder.parent.iterdir() if one.is_dir()]
        except OSError:
            return
        for _, old in sorted(with_times)[:-_GENERATIONS]:
            shutil.rmtree(old, ignore_errors=True)

    def _path(self, name: str) -> Path:
        return self._folder / f"{name}.row"

    def _seal(self, name: str, body: bytes) -> bytes:
        return hashlib.sha256(f"{self._state} {name}\n".encode() + body).hexdigest().encode()
