"""Names that people bring from SciPy, Simulink or a textbook: an error answers them by the word that is right here."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from collections.abc import Callable
from typing import ParamSpec, TypeVar

_P = ParamSpec("_P")
_R = TypeVar("_R")
_PARAMETERS = {
    "k k1 c1 stiffness spring": "a2",
    "c d c2 damping damper viscosity": "a1",
    "m M mass masses": "m1 m2",
    "mu_s f_s Fs static b_s": "b_static",
    "mu mu_k f_k F_c Fc N normal_force mu_d b_k b_kinetic": "b",
    "x position x0": "x1 x2",
    "v velocity v0": "v1 v2",
    "t_end t_span tspan tmax t_max tf T duration horizon end stop_time": "until",
    "u F forces": "force",
    "f": "force omega",
    "state y0 initial_state ic x_0": "initial",
    "freq frequency w hz": "omega",
    "A amp height": "amplitude",
    "phi phase_angle": "phase",
    "times time ts": "t_eval t",
    "values forces y samples": "u",
    "precision prec dps ndigits": "digits",
    "n_jobs workers processes": "jobs",
}
"""Other words for parameters; that of the function which was called is named."""
_UNITS = {
    "a1": "N s/m",
    "a2": "N/m",
    "b": "N, the coefficient of friction times the normal force",
    "b_static": "N, the friction up to which a stick is kept; b is that in slip",
    "until": "s",
    "omega": "rad/s, 2 pi times the frequency in Hz",
}
_SENTENCES = {
    "rtol atol tol eps tolerance": "no tolerance is needed; digits=N requests N right digits",
    "method solver integrator": 'no step method is chosen; arithmetic="ball" or "float64" chooses the numbers',
    "events event event_fn": "every change of mode is found, in run.events",
    "dense_output": "run.sol(t) always gives the state at any time",
    "max_step min_step first_step dt step h": "there is no step size; t_eval gives the times of run.y",
    "t_end t_span tspan tmax t_max tf T duration horizon until": "the horizon is until=... (s) of the Scene",
    "y0 initial x0 args params p": "initial state and numbers are those of the Scene; scene.replace(...) changes them",
    "k m1 m2 b mu c force friction": "that is part of the Scene; scene.replace(...) changes it",
    "fun f func rhs": "the equations are those of the Scene",
    "lambda_ function signal": "a force is made of Force.sine, .step, .ramp, .samples, and their sums",
}


def _spread(words: dict[str, str]) -> dict[str, str]:
    return {word: found for several, found in words.items() for word in several.split()}


_OTHERS, _ANSWERS = _spread(_PARAMETERS), _spread(_SENTENCES)


def helpful(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Return a function whose error for an argument that it does not have names the right word."""

    @functools.wraps(function)
    def call(*given: _P.args, **named: _P.kwargs) -> _R:
        try:
            return function(*given, **named)
        except TypeError as error:
            is_of_the_call = error.__traceback__ is not None and error.__traceback__.tb_next is None
            if not is_of_the_call:
                raise
            raise TypeError(_said(function, str(error))) from None

    return call


def _said(function: Callable[..., object], error: str) -> str:
    """Return what a call did wrong, and the right word."""
    known = [name for name in inspect.signature(function).parameters if name not in {"self", "cls"}]
    what = function.__qualname__.removesuffix(".__init__")
    if found := re.search(r"unexpected keyword argument '(\w+)'", error):
        return f"{what} has no {found[1]!r}: {right_word(found[1], known)}"
    if "positional" in error and "missing" not in error:
        return f"{error}; the order is {', '.join(known)}; give all after the first by their names"
    return f"{error}; it takes {', '.join(known)}"


def right_word(word: str, known: list[str]) -> str:
    """Return what to write instead of a word where these are known.

    >>> right_word("k", ["m1", "m2", "a2", "b", "a1"]), right_word("rtol", ["digits"])[:22]
    ('write a2 (N/m)', 'no tolerance is needed')
    >>> right_word("m3", ["m1", "m2"]), right_word("colour", ["m1", "m2"])
    ('did you mean m2 or m1?', 'it takes m1, m2')
    """
    for words in (word, word.lower()):
        meant = [one for one in _OTHERS.get(words, "").split() if one in known]
        if meant:
            unit = _UNITS.get(meant[0])
            return f"write {' or '.join(meant)}" + (f" ({unit})" if unit else "")
        if words in _ANSWERS:
            return _ANSWERS[words]
    near = difflib.get_close_matches(word, known, n=2, cutoff=0.5)
    return f"did you mean {' or '.join(near)}?" if near else f"it takes {', '.join(known[:30])}"
