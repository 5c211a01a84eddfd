"""What numba compiles: the same functions as they stand. numba is optional, and imported when the first is asked for.

`@compilable` registers a function that compiled code may call, `@by_type` one that asks for the type of its first
argument: compiled code takes one of two instead. Neither changes the function. What `compiled` makes of an entry is
kept in a folder of the user's cache that is named by the sources: numba would not notice that a function has changed
which a compiled one calls.
"""

# ruff: noqa: PLW0108 - numba wants a function of Python, with names of its own for the arguments

from __future__ import annotations

import hashlib
import importlib.util
import operator
import os
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar

from numerics.arithmetic import pair
from numerics.files import cache_folder, forget_unused, make_private

try:
    import fcntl
except ImportError:  # not a POSIX system
    fcntl = None  # type: ignore[assignment]

_Function = TypeVar("_Function", bound=Callable[..., Any])
_WAITING: list[tuple[Any, Any, Any, dict[str, Any]]] = []
"""Functions that numba has not heard of yet, what stands for them among floats and among pairs, and numba's options."""
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
        _WAITING.append((function, function, function, {**_INNER, **options}))
        return function

    return register


def by_type(floats: Any, pairs: Any) -> Callable[[_Function], _Function]:
    """Register what compiled code calls for a function, by the type of its first argument."""

    def register(function: _Function) -> _Function:
        _WAITING.append((function, floats, pairs, _INNER))
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
    """Tell numba of every function that was registered since the last time, and first of the operators of pairs."""
    from numba.extending import overload, register_jitable

    _declare_operators()
    while _WAITING:
        function, floats, pairs, options = _WAITING.pop()
        if floats is pairs is function:
            register_jitable(**options)(function)
        else:
            overload(function, strict=False, jit_options=options)(_chosen(floats, pairs))


def _chosen(floats: Any, pairs: Any) -> Any:
    """Return what tells numba, by the types of some arguments, which function to compile."""
    return lambda *types: _as_function(pairs if _is_pair(types[0]) else floats)


@cache
def _as_function(implementation: Any) -> Any:
    """Return a function of C within one of Python, which numba asks for."""
    if isinstance(implementation, FunctionType):
        return implementation
    one, two = (lambda x: implementation(x)), (lambda x, y: implementation(x, y))
    return two if implementation.__name__ == "atan2" else one


def _is_pair(kind: Any) -> bool:
    return getattr(kind, "instance_class", None) is pair.TwoFloats


@cache
def _declare_operators() -> None:
    """Tell numba what the operators of pairs are, with numbers too: its own leave named tuples alone, or join them."""
    from numba import types
    from numba.extending import intrinsic, overload, register_jitable

    TwoFloats, as_pair = pair.TwoFloats, pair.as_pair
    others: set[Any] = {as_pair, pair.nearest, pair.two_product}
    for one in vars(pair).values():
        if isinstance(one, FunctionType) and one.__module__ == pair.__name__ and one not in others:
            register_jitable(**_INNER)(one)

    @intrinsic
    def fused(_, a, b, c):  # type: ignore[no-untyped-def]  # noqa: ARG001 - a b + c, rounded once
        return types.float64(*[types.float64] * 3), lambda _, builder, __, given: builder.fma(*given)

    @overload(pair.two_product, jit_options=_INNER)  # the same numbers, by two operations instead of seventeen
    def _two_product(a, b):  # type: ignore[no-untyped-def]  # noqa: ARG001
        def by_one_rounding(a, b):  # type: ignore[no-untyped-def]
            product = a * b
            return TwoFloats(product, fused(a, b, -product))

        return by_one_rounding

    @overload(as_pair, jit_options=_INNER)
    def _as_pair(x):  # type: ignore[no-untyped-def]
        return (lambda x: x) if _is_pair(x) else lambda x: TwoFloats(float(x), 0.0)

    def of_two(function: Any, method: Any) -> None:
        of_pairs = register_jitable(**_INNER)(method)

        @overload(function, jit_options=_INNER)
        def _operator(a, b):  # type: ignore[no-untyped-def]
            are_numbers = all(_is_pair(one) or isinstance(one, types.Number) for one in (a, b))
            is_ours = are_numbers and (_is_pair(a) or _is_pair(b))
            return (lambda a, b: of_pairs(as_pair(a), as_pair(b))) if is_ours else None

    def of_one(function: Any, method: Any) -> None:
        of_pair = register_jitable(**_INNER)(method)
        overload(function, jit_options=_INNER)(lambda a: (lambda a: of_pair(a)) if _is_pair(a) else None)

    of_two(operator.add, TwoFloats.__add__)
    of_two(operator.sub, TwoFloats.__sub__)
    of_two(operator.mul, TwoFloats.__mul__)
    of_two(operator.truediv, TwoFloats.__truediv__)
    of_one(operator.neg, TwoFloats.__neg__)
    of_one(abs, TwoFloats.__abs__)
