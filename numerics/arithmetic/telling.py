"""One text, told in each arithmetic: the same code object with that arithmetic's words in its globals.

A text is a plain function under `@text`. It calls other texts, and words: `sqrt`, `sign`, `finite`, ... Its module
imports the words from float64.py, so as it stands it speaks binary64. Told in another arithmetic, every word that its
code loads as a global is that arithmetic's, and every text that it calls is told too. numba (an optional extra) then
compiles what was told, as a second, free choice: the bits are the same.
"""

from __future__ import annotations

import dis
import importlib.util
import os
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from types import FunctionType
from typing import Any, TypeVar

from numerics.arithmetic.compiling import compile_entry, compiled_by_numba

_Function = TypeVar("_Function", bound=Callable[..., Any])
_TEXTS: set[Any] = set()
_APART: set[Any] = set()
_COMPILED: dict[Any, Any] = {}
_INNER = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_ONE_AT_A_TIME = threading.RLock()
"""The threads of a batch may all ask for the same text first, and numba's cache folder is set for the process."""


def text(function: _Function) -> _Function:
    """Register a function as a text and return it unchanged."""
    _TEXTS.add(function)
    return function


def text_apart(function: _Function) -> _Function:
    """Register a function as a text that compiled code calls instead of taking it in whole."""
    _APART.add(function)
    return text(function)


def handed(template: Any, function: Any, name: str) -> Any:
    """Return the text `template` with the text `function` in the place of its global `handed_function`.

    numba keeps no compiled code of a function that is handed another one as an argument.
    """
    made = FunctionType(template.__code__, {**template.__globals__, "handed_function": function}, name)
    made.__qualname__, made.__module__, made.__doc__ = name, function.__module__, template.__doc__
    made.template, made.function = template, function  # type: ignore[attr-defined]
    return text(made)


class Telling:
    """Texts as one arithmetic tells them: `Telling(...)(function)` is the text `function`, told.

    `words` maps the names of words to what this arithmetic says for them; `spoken` are the same of binary64, which the
    texts' modules import. `instead` replaces whole texts: the loop's steps by those of another kind of motion; for a
    template it has a function that makes another of the told function that was handed.
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
        self.words, self._spoken, self._instead = words, spoken, dict(instead or {})
        self._told: dict[Any, Any] = {}

    def but(self, name: str, instead: Mapping[Any, Any]) -> Telling:
        """Return the same telling with more texts replaced."""
        return Telling(f"{self.name} {name}", self.words, self._spoken, {**self._instead, **instead}, self._prepare)

    def __call__(self, function: _Function) -> _Function:
        """Return a text as this arithmetic tells it, interpreted."""
        function = self._instead.get(function, function)
        if function not in _TEXTS:
            return function  # a plain function speaks for itself
        if function not in self._told and getattr(function, "template", None) in self._instead:
            self._told[function] = self._instead[function.template](self(function.function))  # type: ignore[attr-defined]
        if function not in self._told:
            changed = {name: self(inner) for name, inner in _called_texts(function)}
            changed |= self._words_of(function)
            same = all(function.__globals__.get(name) is value for name, value in changed.items())
            self._told[function] = function if same else _bound(function, changed, self.name)
        return self._told[function]

    def compiled(self, function: _Function) -> _Function:
        """Return a text as told, compiled, to be called from Python; interpreted without numba."""
        key = (self.name, function, "entry")
        if key not in _COMPILED:
            if not can_compile():
                return self(function)
            with _ONE_AT_A_TIME:
                if key not in _COMPILED:
                    if self._prepare is not None:
                        self._prepare()
                    _COMPILED[key] = compile_entry(self._bound_compiled(function))
        return _COMPILED[key]

    def has_compiled(self, function: Any) -> bool:
        """Return whether a text has been compiled already, to be called from Python."""
        return (self.name, function, "entry") in _COMPILED

    def _inner(self, function: Any) -> Any:
        """Return a text as told, compiled, to be called from compiled code."""
        function = self._instead.get(function, function)
        if function not in _TEXTS:
            return compiled_word(function)
        key = (self.name, function)
        if key not in _COMPILED:
            # without wrappers for Python, and put into its callers whole: a third faster, both to compile and to run
            # but for long ones that are called from many places
            options = {**_INNER, "forceinline": function not in _APART}
            _COMPILED[key] = compiled_by_numba(self._bound_compiled(function), options)
        return _COMPILED[key]

    def _bound_compiled(self, function: Any) -> Any:
        """Return a copy of a text that calls compiled texts and words."""
        changed = _compiled_helpers(function)
        changed |= {name: compiled_word(word) for name, word in self._words_of(function).items()}
        changed |= {name: self._inner(inner) for name, inner in _called_texts(function)}
        return _bound(function, changed, self.name)

    def _words_of(self, function: Any) -> dict[str, Any]:
        """Return what this arithmetic says for the words that a text loads."""
        return {
            name: self.words[name]
            for name in _loaded(function)
            if name in self.words and function.__globals__.get(name) is self._spoken[name]
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


@cache
def can_compile() -> bool:
    """Return whether numba is installed and not switched off by NUMBA_DISABLE_JIT, which numba reads once, too."""
    off = os.environ.get("NUMBA_DISABLE_JIT", "0") not in {"", "0"}
    return not off and importlib.util.find_spec("numba") is not None


def compiles_now() -> bool:
    """Return whether compiled code is at hand: numba is installed, and has been imported already."""
    return "numba" in sys.modules and can_compile()


def compiled_word(word: Any) -> Any:
    """Return a word for compiled code: a function of Python compiled, constants and C functions as they are."""
    if not isinstance(word, FunctionType):
        return word
    with _ONE_AT_A_TIME:
        if word not in _COMPILED:
            texts = {name: AS_THEY_STAND._inner(inner) for name, inner in _called_texts(word)}
            _COMPILED[word] = compiled_by_numba(_bound(word, _compiled_helpers(word) | texts, "word"), _INNER)
    return _COMPILED[word]


def _compiled_helpers(function: Any) -> dict[str, Any]:
    """Return the plain functions of floats that a function calls, compiled."""
    loaded = {name: function.__globals__.get(name) for name in _loaded(function)}
    return {
        name: compiled_word(value)
        for name, value in loaded.items()
        if isinstance(value, FunctionType) and value not in _TEXTS
    }


AS_THEY_STAND = Telling("float64", {}, {})
"""The texts in binary64, and what plain functions call."""
