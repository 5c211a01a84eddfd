"""One text, told in each arithmetic: the same code object with that arithmetic's words in its globals.

A text is a plain function under `@text`. It calls other texts, and words: `sqrt`, `sign`, `contact`, ... A text's module
imports its words from float64.py, so as it stands it speaks binary64. Told in another arithmetic, every word that its
code loads as a global is that arithmetic's, and every text that it calls is told too. numba (an optional extra) then
compiles what was told, as a second, free choice: the bits are the same.

What numba compiles is kept in the user's cache folder, under a name made from the sources of all texts, since numba
itself would not notice that a called text has changed.
"""

from __future__ import annotations

import dis
import hashlib
import importlib.util
import os
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])
_TEXTS: set[Any] = set()
_COMPILED: dict[Any, Any] = {}
_ONE_AT_A_TIME = threading.RLock()
"""The threads of a batch may all ask for the same text first, and numba's cache folder is set for the process."""


def text(function: _Function) -> _Function:
    """Register a function as a text and return it unchanged."""
    _TEXTS.add(function)
    return function


class Telling:
    """Texts as one arithmetic tells them: `Telling(...)(function)` is the text `function`, told.

    `words` maps the names of words to what this arithmetic says for them; `spoken` are the same of binary64, which the
    texts' modules import. `instead` replaces whole texts by others: the loop's steps by those of another kind of motion.
    """

    def __init__(
        self,
        name: str,
        words: Mapping[str, Any],
        spoken: Mapping[str, Any],
        instead: Mapping[Any, Any] | None = None,
        prepare: Callable[[], None] | None = None,
    ) -> None:
        """Keep the vocabulary; `prepare` is called once before anything is compiled."""
        self.name, self._prepare = name, prepare
        self._words, self._spoken, self._instead = words, spoken, dict(instead or {})
        self._told: dict[Any, Any] = {}

    def but(self, name: str, instead: Mapping[Any, Any]) -> Telling:
        """Return the same telling with more texts replaced."""
        return Telling(f"{self.name} {name}", self._words, self._spoken, {**self._instead, **instead}, self._prepare)

    def __call__(self, function: _Function) -> _Function:
        """Return a text as this arithmetic tells it, interpreted."""
        function = self._instead.get(function, function)
        if function not in self._told:
            changed = {name: self(inner) for name, inner in _called_texts(function)}
            changed |= self._words_of(function)
            same = all(function.__globals__.get(name) is value for name, value in changed.items())
            self._told[function] = function if same else _bound(function, changed, self.name)
        return self._told[function]

    def compiled(self, function: _Function) -> _Function:
        """Return a text as told, compiled; interpreted without numba. The results have the same bits."""
        if not can_compile():
            return self(function)
        function = self._instead.get(function, function)
        key = (self.name, function)
        if key not in _COMPILED:
            with _ONE_AT_A_TIME:
                if key not in _COMPILED:
                    if self._prepare is not None:
                        self._prepare()
                    changed = _compiled_helpers(function)
                    changed |= {name: _word_compiled(word) for name, word in self._words_of(function).items()}
                    changed |= {name: self.compiled(inner) for name, inner in _called_texts(function)}
                    _COMPILED[key] = _compile(_bound(function, changed, self.name))
        return _COMPILED[key]

    def _words_of(self, function: Any) -> dict[str, Any]:
        """Return what this arithmetic says for the words that a text loads."""
        return {
            name: self._words[name]
            for name in _loaded(function)
            if name in self._words and function.__globals__.get(name) is self._spoken[name]
        }


def _bound(function: Any, changed: Mapping[str, Any], name: str) -> Any:
    """Return a copy of a function with other globals, under a name of its own: numba's cache goes by names."""
    copy = FunctionType(function.__code__, {**function.__globals__, **changed}, function.__name__)
    copy.__qualname__, copy.__module__ = f"{function.__name__}_in_{name.replace(' ', '_')}", function.__module__
    copy.__doc__, copy.__defaults__ = function.__doc__, function.__defaults__
    copy.text = function  # type: ignore[attr-defined]
    return copy


def text_of(function: Any) -> Any:
    """Return the text that was told."""
    return getattr(function, "text", function)


@cache
def _loaded(function: Any) -> tuple[str, ...]:
    """Return the names that a function's code loads as globals; attributes of the same name do not count."""
    found = {one.argval for one in dis.get_instructions(function) if one.opname == "LOAD_GLOBAL"}
    return tuple(sorted(found))


def _called_texts(function: Any) -> Iterator[tuple[str, Any]]:
    for name in _loaded(function):
        inner = function.__globals__.get(name)
        if isinstance(inner, FunctionType) and inner in _TEXTS:
            yield name, inner


def can_compile() -> bool:
    """Return whether numba is installed and not switched off by NUMBA_DISABLE_JIT."""
    off = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
    return not off and importlib.util.find_spec("numba") is not None


def _word_compiled(word: Any) -> Any:
    """Return a word for compiled code: a function of Python compiled, constants and C functions as they are."""
    if not isinstance(word, FunctionType):
        return word
    if word not in _COMPILED:
        texts = {name: AS_THEY_STAND.compiled(inner) for name, inner in _called_texts(word)}
        _COMPILED[word] = _compile(_bound(word, _compiled_helpers(word) | texts, "word"))
    return _COMPILED[word]


def _compiled_helpers(function: Any) -> dict[str, Any]:
    """Return the plain functions of floats that a function calls, compiled."""
    loaded = {name: function.__globals__.get(name) for name in _loaded(function)}
    return {
        name: _word_compiled(value)
        for name, value in loaded.items()
        if isinstance(value, FunctionType) and value not in _TEXTS
    }


def compiled_word(word: _Function) -> _Function:
    """Return a plain function of numbers compiled, for declarations to numba."""
    with _ONE_AT_A_TIME:
        return _word_compiled(word)  # type: ignore[no-any-return]


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
    """Return a name for the sources of every room that has texts or words in it."""
    digest = hashlib.sha256()
    numerics = Path(__file__).parent.parent
    for room in ("arithmetic", "flows", "contact", "motion", "bounds", "run"):
        for source in sorted((numerics / room).glob("*.py")):
            digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


AS_THEY_STAND = Telling("float64", {}, {})
"""The texts in binary64, and what plain functions call."""
