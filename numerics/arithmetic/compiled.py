"""What numba compiles: the same functions as they stand. numba is optional, and imported when the first is asked for.

`@compilable` registers a function that compiled code may call, `@by_type` one that asks for the type of its first
argument: compiled code takes that of floats instead. Neither changes the function. What `compiled` makes of an entry is
kept in a folder of the user's cache that is named by the sources: numba would not notice that a function has changed
which a compiled one calls.
"""

# ruff: noqa: PLW0108 - numba wants a function of Python, with names of its own for the arguments

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar

from numerics.files import cache_folder, forget_unused, make_private

try:
    import fcntl
except ImportError:  # not a POSIX system
    fcntl = None  # type: ignore[assignment]

_Function = TypeVar("_Function", bound=Callable[..., Any])
_WAITING: list[tuple[Any, Any, dict[str, Any]]] = []
"""Functions that numba has not heard of yet, what stands for them among floats, and numba's options."""
_OPTIONS: dict[Any, dict[str, Any]] = {}
_ROOMS = ("arithmetic", "linear", "free", "plane")
"""Where compilable functions are."""
_STATES = 8
"""Of how many states of the sources compiled code is kept, beside those of the last day."""
_SOON = 2.0
"""After so many seconds of compiling a person at a terminal is told why nothing happens."""
_ONE_AT_A_TIME = threading.RLock()
"""The threads of a batch may all ask for the same entry first, and numba's cache folder is set for the process."""
# numpy's error model divides by zero as IEEE 754 does: a number out of range must not end a whole batch.
# Without `_nrt` numba does not count the references to arrays, which takes half of the time of short functions on many
# of them; it refuses to compile a function that would have to.
_INNER = {"error_model": "numpy", "forceinline": True, "_nrt": False}


def compilable(function: _Function) -> _Function:
    """Register a function that compiled code may call, and takes in whole."""
    return compilable_with()(function)


def compilable_with(*, makes_arrays: bool = False, **options: Any) -> Callable[[_Function], _Function]:
    """Register a function that compiled code may call, with options of numba: forceinline=False, fastmath=..."""
    options["_nrt"] = makes_arrays

    def register(function: _Function) -> _Function:
        _OPTIONS[function] = options
        _WAITING.append((function, function, {**_INNER, **options}))
        return function

    return register


def by_type(floats: Any) -> Callable[[_Function], _Function]:
    """Register what compiled code calls for a function that asks for the type of its first argument."""

    def register(function: _Function) -> _Function:
        _WAITING.append((function, floats, _INNER))
        return function

    return register


@cache
def can_compile() -> bool:
    """Return whether numba is installed and not switched off by NUMBA_DISABLE_JIT, which numba reads once, too."""
    off = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
    return not off and importlib.util.find_spec("numba") is not None


def compiles_now() -> bool:
    """Return whether compiled code is at hand: numba is installed, and has been imported already."""
    return "numba" in sys.modules and can_compile()


def compiled(function: _Function) -> _Function:
    """Return a function, compiled when it is first called, without the lock of Python; as it stands without numba."""
    if not can_compile():
        return function
    with _ONE_AT_A_TIME:
        return _kept(function)


@cache
def _kept(function: Any) -> Any:
    import numba

    _declare()
    options = {"nogil": True, "error_model": "numpy", **_OPTIONS.get(function, {})}
    with _folder_of_these_sources(numba.config):
        try:
            made = numba.njit(function, cache=True, **options)
        except RuntimeError:  # no folder can be written: compile each time
            return numba.njit(function, **options)
        lock = Path(numba.config.CACHE_DIR) / f"{function.__qualname__}.lock"
    made.compile = _one_process_at_a_time(made.compile, lock)
    return made


def _one_process_at_a_time(compile_for: Callable[..., Any], path: Path) -> Callable[..., Any]:
    """Return numba's compilation for some types, so that a second process waits and finds the first one's in the cache.

    It takes half a minute, and processes that are started together would all do it.
    """

    def locked(types: Any) -> Any:
        with ExitStack() as stack:
            stack.enter_context(_told())
            with suppress(OSError):  # a folder that cannot be written keeps no compiled code either
                if not path.parent.is_dir():  # of these sources, the first
                    forget_unused(path.parent.parent, _STATES)
                make_private(path.parent)  # what numba keeps there is code
                os.utime(path.parent)
                file = stack.enter_context(path.open("wb"))
                if fcntl is not None:
                    fcntl.flock(file, fcntl.LOCK_EX)  # closing the file ends it
            try:
                return compile_for(types)
            except OSError:  # compiled, but a full disk has not kept it: numba has it now, and finds it
                return compile_for(types)

    return locked


@contextmanager
def _told() -> Iterator[None]:
    """Tell a person at a terminal what is waited for, if it takes long: what is found in the cache does not."""
    sentence = "numba compiles the solver; that takes about a minute, once for this version"
    teller = threading.Timer(_SOON, lambda: print(sentence, file=sys.stderr))
    teller.daemon = True
    if sys.stderr.isatty():
        teller.start()
    try:
        yield
    finally:
        teller.cancel()


@contextmanager
def _folder_of_these_sources(config: Any) -> Iterator[None]:
    before = config.CACHE_DIR
    folder = Path(before) / "inertial-pair" if before else cache_folder()
    config.CACHE_DIR = str(folder / "compiled" / _digest_of_sources())
    try:
        yield
    finally:
        config.CACHE_DIR = before


@cache
def _digest_of_sources() -> str:
    digest = hashlib.sha256()
    numerics = Path(__file__).parent.parent
    for room in _ROOMS:
        for source in sorted((numerics / room).glob("*.py")):
            digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def _declare() -> None:
    """Tell numba of every function that was registered since the last time."""
    from numba.extending import overload, register_jitable

    while _WAITING:
        function, floats, options = _WAITING.pop()
        if floats is function:
            register_jitable(**options)(function)
        else:
            overload(function, strict=False, jit_options=options)(_chosen(floats))


def _chosen(floats: Any) -> Any:
    """Return what tells numba which function to compile: a function of C within one of Python."""
    if isinstance(floats, FunctionType):
        return lambda *_: floats
    one, two = (lambda x: floats(x)), (lambda x, y: floats(x, y))
    return lambda *types: two if len(types) == 2 else one
