"""What numba compiles, and where it is kept: a folder of the user's cache, named by the sources of all texts.

numba itself would not notice that a text has changed which a compiled one calls.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any

from numerics.files import cache_folder

try:
    import fcntl
except ImportError:  # not a POSIX system
    fcntl = None  # type: ignore[assignment]

_ROOMS = ("arithmetic", "flows", "contact", "motion", "bounds", "trajectory", "run", "batch")
"""Where texts and words are, from whose sources the name of the cache folder is made."""


def compiled_by_numba(function: Any, options: Mapping[str, Any]) -> Any:
    """Compile a function that compiled code calls."""
    import numba

    # numpy's error model divides by zero as IEEE 754 does: a number out of range must not end a whole batch
    return numba.njit(function, nogil=True, error_model="numpy", **options)


def compile_entry(function: Any) -> Any:
    """Compile a function that Python calls; it is kept in the cache folder with all that it calls."""
    import numba

    with _cache_folder(numba.config):
        try:
            made = compiled_by_numba(function, {"cache": True})
        except RuntimeError:  # no folder can be written: compile each time
            return compiled_by_numba(function, {})
        made.compile = _one_process_at_a_time(
            made.compile, Path(numba.config.CACHE_DIR) / f"{function.__qualname__}.lock"
        )
    return made


def _one_process_at_a_time(compile_for: Callable[..., Any], path: Path) -> Callable[..., Any]:
    """Return numba's compilation for some types, so that a second process waits and finds the first one's in the cache.

    It takes half a minute, and processes that are started together would all do it.
    """

    def compiled(types: Any) -> Any:
        with ExitStack() as stack:
            with suppress(OSError):  # a folder that cannot be written keeps no compiled code either
                path.parent.mkdir(parents=True, exist_ok=True)
                file = stack.enter_context(path.open("wb"))
                if fcntl is not None:
                    fcntl.flock(file, fcntl.LOCK_EX)  # closing the file ends it
            try:
                return compile_for(types)
            except OSError:  # compiled, but a full disk has not kept it: numba has it now, and finds it
                return compile_for(types)

    return compiled


@contextmanager
def _cache_folder(config: Any) -> Iterator[None]:
    before = config.CACHE_DIR
    folder = Path(before) / "inertial-pair" if before else cache_folder()
    config.CACHE_DIR = str(folder / _digest_of_sources())
    try:
        yield
    finally:
        config.CACHE_DIR = before


@cache
def _digest_of_sources() -> str:
    """Return a name for the sources of every room that has texts or words in it."""
    digest = hashlib.sha256()
    numerics = Path(__file__).parent.parent
    for room in _ROOMS:
        for source in sorted((numerics / room).glob("*.py")):
            digest.update(source.read_bytes())
    return digest.hexdigest()[:16]
