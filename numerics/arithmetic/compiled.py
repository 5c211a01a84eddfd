"""What numba compiles: the same functions as they stand. numba is optional, and imported when the first is asked for.

`@compilable` registers a function that compiled code may call, and leaves it as it is. numba keeps what `compiled`
makes in a folder of the user's cache that is named by the sources: it would not notice by itself that a function has
changed which a compiled one calls.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from functools import cache, update_wrapper
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar

import numpy as np

from numerics.files import cache_folder, forget_unused, make_private

try:
    import fcntl
except ImportError:  # not a POSIX system
    fcntl = None  # type: ignore[assignment]

_Function = TypeVar("_Function", bound=Callable[..., Any])
_OPTIONS: dict[Any, dict[str, Any]] = {}
"""numba's options for each function that is registered."""
_FOLDERS = ("arithmetic", "linear")
"""Where compilable functions are; of others numba itself notices a change."""
_STATES = 8
"""Of how many states of the sources compiled code is kept, beside those of the last day."""
_COMPILED: dict[Any, Any] = {}
"""What numba has made of functions in this process."""
_ONE_AT_A_TIME = threading.RLock()
"""Threads may ask for the same entry first, and numba's cache folder is set for the process."""
# numpy's error model divides by zero as IEEE 754 does: a number out of range must not end a whole batch.
# Without `_nrt` numba does not count the references to arrays, which takes half of the time of short functions on many
# of them; it refuses to compile a function that would have to.
# Nor is an inner function called from outside: without wrappers for that a tenth less is compiled.
_COMMON = {"nogil": True, "error_model": "numpy"}
_INNER = {"error_model": "numpy", "forceinline": True, "no_cfunc_wrapper": True, "no_cpython_wrapper": True}


def compilable(function: _Function) -> _Function:
    """Register a function that compiled code may call, and takes in whole."""
    return compilable_with()(function)


def compilable_with(*, makes_arrays: bool = False, **options: Any) -> Callable[[_Function], _Function]:
    """Register a function that compiled code may call, with options of numba: forceinline=False, fastmath=..."""

    def register(function: _Function) -> _Function:
        _OPTIONS[function] = {**options, "_nrt": makes_arrays}
        return function

    return register


def inlined(function: _Function) -> _Function:
    """Register a function that has one caller, which takes it in before types are inferred.

    It is not compiled by itself then, which halves what LLVM has to do. Were this asked for more functions than have
    it, numba would take longer than LLVM saves.
    """
    return compilable_with(inline="always")(function)


@cache
def can_compile() -> bool:
    """Return whether numba is installed and not switched off by NUMBA_DISABLE_JIT, which numba reads once, too."""
    off = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
    return not off and importlib.util.find_spec("numba") is not None


def compiles_now() -> bool:
    """Return whether compiled code is at hand: numba is installed, and has been imported already."""
    return "numba" in sys.modules and can_compile()


def compiled(function: _Function) -> _Function:
    """Return a function, compiled when it is first called, without the lock of Python; as it stands without numba.

    There numpy's scalars would warn of what the kernel itself looks for.
    """
    found = _COMPILED.get(function)
    if found is not None:
        return found
    if not can_compile():
        return np.errstate(all="ignore")(function)
    with _ONE_AT_A_TIME:
        return _kept(function)


def _kept(function: Any) -> Any:
    """Return a function compiled by numba, which keeps it; what it calls is compiled, too, once for all callers."""
    if function not in _COMPILED:
        _COMPILED[function] = _made(function)
    return _COMPILED[function]


def _made(function: Any) -> Any:
    """Return what numba makes of a function, and finds in its folder the next time."""
    import numba

    calling, before = _with_compiled(function), numba.config.CACHE_DIR  # what it calls has found its folder by then
    folder = _folder(Path(before) / "inertial-pair" if before else cache_folder())
    numba.config.CACHE_DIR = str(folder)
    # where that folder cannot be written numba would take another, by the age of the entry's source alone
    options = {**_COMMON, **_OPTIONS.get(function, {}), "cache": os.access(folder, os.W_OK)}
    made = numba.njit(calling, **options)
    numba.config.CACHE_DIR = before
    load, compile_for = made._cache.load_overload, made.compile

    def loaded(*types: Any) -> Any:
        found = load(*types)
        if found is None:
            _announce()
        return found

    def compile_alone(types: Any) -> Any:
        with _alone(folder / f"{function.__qualname__}.lock"), _optimised_once(numba.config):
            try:
                return compile_for(types)
            except OSError:  # compiled, but a full disk has not kept it: numba has it now, and finds it
                return compile_for(types)

    made._cache.load_overload, made.compile = loaded, compile_alone
    return _once_for_all_values(made)


def _with_compiled(function: Any) -> Any:
    """Return a function that calls what numba makes of registered ones."""
    known = function.__globals__
    called = [name for name in function.__code__.co_names if isinstance(known.get(name), FunctionType)]
    compiled_ones = {name: _called(known[name]) for name in called if known[name] in _OPTIONS}
    return update_wrapper(FunctionType(function.__code__, known | compiled_ones), function)


@cache
def _called(function: Any) -> Any:
    """Return an inner function for numba; one that is not taken in whole is kept, as it stands for many."""
    if not _OPTIONS[function].get("forceinline", True):
        return _kept(function)
    import numba

    return _once_for_all_values(numba.njit(_with_compiled(function), **{**_INNER, **_OPTIONS[function]}))


def _once_for_all_values(made: Any) -> Any:
    """Return a function of numba that is not compiled anew for each number or truth value that a caller writes out."""
    from numba.core.types.misc import unliteral

    template = made.get_call_template
    made.get_call_template = lambda given, named: template(tuple(map(unliteral, given)), named)
    return made


@cache
def _folder(cache: Path) -> Path:
    """Return the folder in a cache of code compiled from these sources; it is made if it can be."""
    digest, numerics = hashlib.sha256(), Path(__file__).parent.parent
    for source in sorted(one for folder in _FOLDERS for one in (numerics / folder).glob("*.py")):
        digest.update(source.read_bytes())
    folder = cache / "compiled" / digest.hexdigest()[:16]
    with suppress(OSError):
        if not folder.is_dir():
            forget_unused(folder.parent, _STATES)
        make_private(folder)  # what numba keeps there is code
        os.utime(folder)
    return folder


@cache
def _announce() -> None:
    """Say once in a process what is waited for."""
    print("numba compiles the solver, once for this version", file=sys.stderr)


@contextmanager
def _optimised_once(config: Any) -> Iterator[None]:
    """Let LLVM optimise at its first level: a quarter less to compile, and what it makes is as fast (measured)."""
    before = config.OPT
    config.OPT = type(before)(min(int(before), 1))
    try:
        yield
    finally:
        config.OPT = before


@contextmanager
def _alone(path: Path) -> Iterator[None]:
    """Let one process at a time compile a function: the second one waits, and finds it in the cache."""
    with ExitStack() as stack:
        with suppress(OSError):  # a folder that cannot be written keeps no compiled code either
            file = stack.enter_context(path.open("wb"))
            if fcntl is not None:
                fcntl.flock(file, fcntl.LOCK_EX)  # closing the file ends it
        yield
