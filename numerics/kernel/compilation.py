"""One source, two ways to run it: kernels are plain functions, and numba (an optional extra) compiles them on demand.

A kernel calls only `math`, other kernels and constants of its module; it returns numbers or tuples of them, or writes
into arrays that it is given. numba is
imported when something is compiled, not before: it takes a second. What it compiles is kept in the user's cache folder,
under a name made from the sources of all kernels, since numba itself would not notice that a called kernel has changed.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])
_KERNELS: set[Any] = set()
_COMPILED: dict[Any, Any] = {}
_ONE_AT_A_TIME = threading.RLock()
"""The threads of a batch may all ask for the same kernel first, and numba's cache folder is set for the process."""


def kernel(function: _Function) -> _Function:
    """Register a function as a kernel and return it unchanged."""
    _KERNELS.add(function)
    return function


def can_compile() -> bool:
    """Return whether numba is installed and not switched off by NUMBA_DISABLE_JIT."""
    off = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
    return not off and importlib.util.find_spec("numba") is not None


def compiled(function: _Function) -> _Function:
    """Return the kernel compiled, or the kernel itself without numba. The results have the same bits."""
    if not can_compile():
        return function
    if function not in _COMPILED:
        with _ONE_AT_A_TIME:
            if function not in _COMPILED:
                _COMPILED[function] = _compile(_bound(function))
    return _COMPILED[function]


def _bound(function: Any) -> Any:
    """Return a copy of a kernel that calls compiled kernels."""
    names = {name: compiled(inner) for name, inner in _called_kernels(function)}
    bound = FunctionType(function.__code__, {**function.__globals__, **names}, function.__name__)
    bound.__qualname__, bound.__module__ = function.__qualname__, function.__module__
    bound.__doc__, bound.__defaults__ = function.__doc__, function.__defaults__
    return bound


def _called_kernels(function: Any) -> Iterator[tuple[str, Any]]:
    for name in function.__code__.co_names:
        inner = function.__globals__.get(name)
        if isinstance(inner, FunctionType) and inner in _KERNELS:
            yield name, inner


def _compile(function: Any) -> Any:
    import numba

    # numpy's error model divides by zero as IEEE 754 does: a number out of range must not end a whole batch
    options = {"nogil": True, "error_model": "numpy"}
    with _cache_folder(numba.config):
        try:
            return numba.njit(function, cache=True, **options)
        except RuntimeError:  # no folder can be written: compile each time
            return numba.njit(function, **options)


@contextmanager
def _cache_folder(config: Any) -> Iterator[None]:
    before = config.CACHE_DIR
    base = Path(before or os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    config.CACHE_DIR = str(base / "inertial-pair" / _digest_of_sources())
    try:
        yield
    finally:
        config.CACHE_DIR = before


@cache
def _digest_of_sources() -> str:
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]
