"""Names that people bring from SciPy, Simulink or a textbook: an error answers them by the word that is right here."""

from __future__ import annotations

import difflib
import functools
import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, NoReturn, ParamSpec, TypeVar

_P = ParamSpec("_P")
_R = TypeVar("_R")
_PARAMETERS = """
k k1 c1 stiffness spring: a2 (N/m)
c d c2 damping damper viscosity: a1 (N s/m)
m M mass masses: m1 m2
mu_s f_s Fs static b_s: b_static (N, the friction up to which a stick is kept; b is that in slip)
mu mu_k f_k F_c Fc N normal_force mu_d b_k b_kinetic: b (N, the coefficient of friction times the normal force)
x position x0: x1 x2
v velocity v0: v1 v2
t_end t_span tspan tmax t_max tf T duration horizon end stop_time: until (s)
u F forces: force
f: force omega
state y0 initial_state ic x_0: initial
freq frequency w hz: omega (rad/s, 2 pi times the frequency in Hz)
A amp height: amplitude
phi phase_angle: phase
times time ts t_eval: t_eval times t
values forces y samples: u
precision prec dps ndigits: digits
n_jobs workers processes: jobs
fps: frames_per_second
path filename fname name: file name_or_path
params parameters names by: wrt
quantity what which y: answer kind
"""
"""Other words for parameters, and what is right: those of the function which was called are named."""
_SENTENCES = """
rtol atol tol eps tolerance: no tolerance is needed; digits=N requests N right digits
method solver integrator: no step method is chosen; arithmetic="ball" or "float64" chooses the numbers
events event event_fn: every change of mode is found, in run.events
nfev njev nlu: there are no steps to count; len(run.events) counts events
dense_output: run.sol(t) always gives the state at any time
max_step min_step first_step dt step h: there is no step size; t_eval gives the times of run.y
t_end t_span tspan tmax t_max tf T duration horizon until: the horizon is until=... (s) of the Scene
y0 initial x0 args params p: initial state and numbers are those of the Scene; scene.replace(...) changes them
k m1 m2 a1 a2 b mu c force friction belt wall force_2 b_static weakening: that is part of the Scene; \
scene.replace(...) changes it, solve_scenes takes lists of scenes
x1 v1 x2 v2: State(...) has the initial ones; run["x1"] or batch["x1"] is the row of y, run.final.x1 the end of a run
cos cosine sin: Force.sine(amplitude, omega, phase) is that; a cosine has the phase pi/2 = 1.5707963267948966
amplitude omega phase: a sine is Force.sine(amplitude, omega), in a file sines = [{ amplitude = 1, omega = 2 }]; \
its numbers are named force[0].sines[0].amplitude
speed value: a constant is Force.constant(3), in a file polynomial = [3]
fun f func rhs: the equations are those of the Scene
lambda_ function signal: a force is made of Force.sine, .step, .ramp, .samples, and their sums
times t_eval t: run.to_dataframe(times) is a table at these times, run.sol(t) the states
digits arithmetic precision: solve(scene, digits=N) chooses digits and arithmetic
save load to_csv: to_dataframe().to_csv(file) writes a table, to_xarray().to_netcdf(file) an archive
u F: scene.force(t) is the force at a time
color colour title label style: the axes that it returns take that, as ax.set_title(...)
"""
_INSTEAD = {
    "to_csv": "it returns text: Path(file).write_text(run.to_csv())",
    "to_dataframe": "only a run's table takes times: run.to_dataframe(times)",
    "solve_many": "solve_scenes takes a list of scenes",
    "Signal": "Force.constant(3), Force.samples(t, u) or Force.sine(amplitude, omega) make a force",
    "samples": 'of a file, np.loadtxt(file, delimiter=",", unpack=True) reads t and u',
}
"""What is meant where the arguments of these do not fit."""


def _spread(table: str) -> dict[str, str]:
    lines = (line.split(": ", 1) for line in table.strip().splitlines())
    return {word: right for words, right in lines for word in words.split()}


_OTHERS, _ANSWERS = _spread(_PARAMETERS), _spread(_SENTENCES)


def helpful(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Return a function whose error for arguments that do not fit it names the right word."""

    @functools.wraps(function)
    def call(*given: _P.args, **named: _P.kwargs) -> _R:
        try:
            return function(*given, **named)
        except TypeError:
            if wrong := _wrong_call(function, given, named):
                raise TypeError(wrong) from None
            raise

    return call


def _wrong_call(function: Callable[..., object], given: tuple[object, ...], named: dict[str, object]) -> str:
    """Return what a call does wrong, and the right word; "" where its arguments fit."""
    signature = inspect.signature(function)
    known = [name for name in signature.parameters if name not in {"self", "cls"}]
    what = function.__qualname__.removesuffix(".__init__").rpartition(".")[2]
    try:
        signature.bind(*given, **named)
    except TypeError as error:
        if unknown := [name for name in named if name not in known]:
            return f"{what} has no {unknown[0]!r}: {right_word(unknown[0], known)}"
        remedy = _INSTEAD.get(what, "give all after the first by their names" if "many" in str(error) else "give it")
        return f"{what}: {error}; it takes {', '.join(known) or 'none'}, in this order; {remedy}"
    return ""


class _Answering(type):
    """The type of a class that answers a name which it, or an object of it, does not have by the right word."""

    if not TYPE_CHECKING:

        def __getattr__(cls, name: str) -> NoReturn:
            """Raise AttributeError with the right word."""
            cls._refuse(cls, name)


class Helpful(metaclass=_Answering):
    """A class whose methods, and names that it does not have, are answered by the right word."""

    __slots__ = ()

    def __init_subclass__(cls) -> None:
        """Make the public methods helpful, once: a dataclass with slots is made anew of its own parts."""
        super().__init_subclass__()
        for name, one in vars(cls).copy().items():
            function = one.__func__ if (is_of_class := isinstance(one, classmethod)) else one
            is_public = name == "__init__" or not name.startswith("_")
            if is_public and inspect.isfunction(function) and function.__globals__ is not globals():
                setattr(cls, name, classmethod(helpful(function)) if is_of_class else helpful(function))

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> NoReturn:
            """Raise AttributeError with the right word."""
            self._refuse(self, name)

    @classmethod
    def _refuse(cls, of: object, name: str) -> NoReturn:
        if name.startswith("_"):  # which Python and NumPy ask for
            raise AttributeError(f"{cls.__name__} has no {name}")
        public = [one for one in dir(of) if not one.startswith("_")]
        raise AttributeError(
            f"{cls.__name__} has no {name!r}: {right_word(name, public, 'dir(...) lists what it has')}"
        )


def right_word(word: str, known: list[str], otherwise: str = "") -> str:
    """Return what to write instead of a word where these are known; else the list of them, or something else.

    >>> right_word("k", ["m1", "m2", "a2", "b", "a1"]), right_word("rtol", ["digits"])[:22]
    ('write a2 (N/m)', 'no tolerance is needed')
    >>> right_word("m3", ["m1", "m2"]), right_word("red", ["m1", "m2"]), right_word("dps", ["--digits"])
    ('did you mean m2 or m1?', 'it takes m1, m2', 'write --digits')
    """
    if word.lower() in known:
        return f"did you mean {word.lower()}?"
    for one in (word, word.lower()):
        names, bracket, unit = _OTHERS.get(one, "").partition(" (")
        if meant := [name for other in names.split() for name in known if name.lstrip("-") == other]:
            return f"write {' or '.join(meant)}{bracket}{unit}"
        if one in _ANSWERS:
            return _ANSWERS[one]
    close = {1: 1.0, 2: 0.5, 3: 0.5}.get(len(word), 0.6)  # to one letter none is near
    near = difflib.get_close_matches(word, known, n=2, cutoff=close)
    return f"did you mean {' or '.join(near)}?" if near else otherwise or f"it takes {', '.join(known[:30])}"
