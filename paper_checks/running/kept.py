"""Rows kept in the user's cache, so that nothing is decided twice: under a hash of all that they rest on.

That is every source file of the packages but those that only show rows, the versions of Python and of what is imported
or asked, the kernel and its version, and the seed. Only rows that another run would find again are kept.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from paper_checks.proofs import kernel
from paper_checks.store import ROOT, Store, all_sources, digest, version

if TYPE_CHECKING:
    from paper_checks.running.plain import Plain

SHOWING = ("report", "drawing", "explore", "speed", "reporting", "__main__.py")
"""Rooms of `paper_checks` that no check imports: they show rows. A test holds this."""
DEPENDENCIES = ("sympy", "mpmath", "numpy", "python-flint", "z3-solver", "cvc5", "scipy", "numba")


def sources() -> Iterator[Path]:
    """Yield every file that a row can depend on, in a fixed order."""
    for path in all_sources():
        inside = path.relative_to(ROOT).parts
        if not (inside[0] == "paper_checks" and inside[1] in SHOWING):
            yield path


def state(seed: int) -> str:
    """Return the hash of all that rows rest on."""
    return digest(sources(), [*tools(), f"seed {seed}", *(f"{name} {version(name)}" for name in DEPENDENCIES)])


def tools() -> tuple[str, ...]:
    """Return the versions of the kernel, or why it was not run, and of Python, and the machine's kind."""
    search_path = os.environ.get("PATH")
    missing = kernel.why_not(search_path) or kernel.cannot_keep(kernel.cache_folder())
    return missing or kernel.identity(search_path), platform.python_version(), platform.machine()


class Kept:
    """The rows of one state."""

    def __init__(self, seed: int, folder: Path | None = None) -> None:
        """Find the folder; `folder` instead of the one in the user's cache."""
        self._store = Store("rows", state(seed), folder)
        self.forget_old = self._store.forget_old

    def is_empty(self) -> bool:
        """Return whether no row is kept."""
        return self._store.is_empty()

    def row(self, name: str) -> Plain | None:
        """Return the row of a claim; None where it is not kept, or not as it was written."""
        from paper_checks.running import plain

        body = self._store.get(f"{name}.json")
        try:
            return plain.from_json(body.decode()) if body else None
        except ValueError:
            return None

    def keep(self, row: Plain) -> None:
        """Keep a row that another run would find again; a cache that cannot be written keeps none."""
        from paper_checks.running import plain

        if row.lasting:
            self._store.put(f"{row.claim}.json", plain.as_json(row).encode())
