"""The answers of a batch, on a line or on a surface: arrays in the shape of its inputs, made when one is looked at."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from numerics.arithmetic.precision import cached_property
from numerics.exits import tool
from numerics.habits import Helpful
from numerics.meter import meter
from numerics.scene.decimals import require_one_of
from numerics.scene.plane import AXES
from numerics.scene.short_repr import html_table
from numerics.solver.inputs import is_of_state, varying
from numerics.trajectory.columns import STATE, Array, Counts, Floats
from numerics.trajectory.status import Status
from numerics.trajectory.units import unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike
    from pandas import DataFrame
    from xarray import Dataset


_TAKEN = "dissipated", "dissipated_error"


class Batch(Helpful):
    """Final states of many runs; arrays have the broadcast shape of the inputs, `y` and `y_error` (4, ...).

    status         a Status                       events    how many there were
    message        the same as a sentence
    mode           -1, 0, +1: sign of v1 - v2     t         s, the horizon or the last event
    y              x1, v1, x2, v2 (m, m/s)        energy_excess   E/E_cr - 1, without cancellation where no force acts
    dissipated     J, by friction and viscosity, summed over the modes; under a force given as arrays it takes a second
                   run, at the first access
    *_error        bounds on the errors of these  digits    right digits of all that is kept, by the bounds
    certain        whether the bounds exclude any other sequence of events
    event_t, event_y, event_mode   the first `keep_events` events: (..., k), (4, ..., k), (..., k); nan and 0 beyond
    event_t_error, event_y_error   bounds on their errors

    Digits of a time are relative to that time, those of positions, velocities and energies to the largest of each at
    the start, at the kept events and at the end, or of mean velocities between these (trajectory/digits.py). If they
    are 0 the status is NO_RIGHT_DIGIT.

    On a surface of n axes `y` is (4, rows, n), `event_y` (4, rows, k, n), `mode` and `event_mode` are words ("stick",
    "slip", or signs of a box; "" beyond the last event), and there is `energy`, J, instead of energy_excess, dissipated
    and certain. Where balls leave the next event open the status is SEQUENCE_OPEN, and all else is nan.

    >>> from numerics import PlanePair, PlaneScene, solve_many, solve_scenes
    >>> found = solve_many(1, 1, 200, 0.5, v1=[0.05, 0.15], until=5, keep_events=2, jobs=1)
    >>> found
    Batch of 2 scenes, shape (2,): 1 REACHED_HORIZON, 1 STUCK_FOR_EVER; 33 events
    >>> len(found), found.shape, found.success.tolist(), found.status.tolist(), found.certain.tolist()
    (2, (2,), [True, True], [1, 0], [True, True])
    >>> len(found.to_dataframe()), sorted(found.results)[:3], found.values("v1").shape, found.message[0]
    (2, ['digits', 'dissipated', 'energy_excess'], (2,), 'reached the horizon; the pair sticks permanently')
    >>> found.events.tolist(), found.mode.tolist(), found.t.tolist(), found.inputs["v1"].tolist()
    ([1, 32], [0, 0], [5.0, 5.0], [0.05, 0.15])
    >>> found.ANSWERS[:2], found.y.shape, bool((found.y_error < 1e-12).all()), bool((found.digits > 9).all())
    (('dissipated', 'energy_excess'), (4, 2), True, True)
    >>> found.dissipated.round(6).tolist(), bool((found.dissipated_error < 1e-12).all())
    ([0.000555, 0.008682], True)
    >>> found.energy_excess.round(6).tolist(), bool((found.energy_excess_error < 1e-9).all())
    ([-0.721931, 0.027012], True)
    >>> found.event_t.round(6).tolist(), found.event_mode.tolist()
    ([[0.042495, nan], [0.076879, 0.276303]], [[0, 0], [-1, 0]])
    >>> found.event_y.shape, found.event_t_error.shape, found.event_y_error.shape
    ((4, 2, 2), (2, 2), (4, 2, 2))
    >>> pair = PlanePair(1, 1, 200, "0.5")
    >>> found = solve_scenes([PlaneScene(pair, 1, x1=[x, "0.002"]) for x in ("0.006", "0.012")], keep_events=1, jobs=1)
    >>> found
    Batch of 2 scenes, shape (2,): 2 REACHED_HORIZON; 13 events
    >>> x1, v1, x2, v2 = found.y
    >>> x1.shape, found.mode.tolist(), found.event_t.round(4).tolist(), bool((found.y_error < 1e-15).all())
    ((2, 2), ['slip', 'stick'], [[0.1081], [0.1735]], True)
    >>> found.success.tolist(), found.message[0], found.digits.tolist(), found.inputs["x1_x"].tolist()
    ([True, True], 'reached the horizon', [15, 15], [0.006, 0.012])
    >>> found.ANSWERS[:5]
    ('energy', 'events', 'digits', 't', 'x1_x')
    >>> [*found.results][:6], found.energy.shape, found.energy_error.shape, found["x1_x"].round(6).tolist()
    (['status', 'success', 'energy', 'events', 'digits', 't'], (2,), (2,), [-0.003929, -0.000434])
    """

    ANSWERS: tuple[str, ...]
    """What can be drawn."""
    status: Counts
    message: Array
    events: Counts
    mode: Array
    t: Floats
    y: Floats
    y_error: Floats
    digits: Counts
    certain: Array
    energy: Floats
    energy_error: Floats
    dissipated: Floats
    dissipated_error: Floats
    energy_excess: Floats
    energy_excess_error: Floats
    event_t: Floats
    event_y: Floats
    event_mode: Array
    event_t_error: Floats
    event_y_error: Floats

    def __init__(
        self,
        shape: tuple[int, ...],
        drawn: tuple[str, ...],
        inputs: Callable[[], dict[str, Array]],
        answers: Callable[[], dict[str, Array]],
        taken: Callable[[], Floats] | None = None,
    ) -> None:
        """Keep which answers can be drawn, and what forms inputs, answers and, on a line, what was taken."""
        self.shape, self.ANSWERS, self._inputs, self._formed, self._took = shape, drawn, inputs, answers, taken

    def __len__(self) -> int:
        """Return how many scenes there were."""
        return math.prod(self.shape)

    @cached_property
    def _answers(self) -> dict[str, Array]:
        """Return all arrays by their names, formed when the first of them is looked at."""
        return self._formed()

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            """Return an array of answers; AttributeError with the right word where there is none."""
            if name in _TAKEN and self._took:
                return self._taken[_TAKEN.index(name)]
            known = {} if name.startswith("_") else self._answers
            return known[name] if name in known else super().__getattr__(name)

    def __dir__(self) -> list[str]:
        """Return the names of what this batch has: one on a surface has other answers than one on a line."""
        return sorted({*super().__dir__(), *self._answers, *_TAKEN[: 2 * bool(self._took)]})

    def __repr__(self) -> str:
        """Return a short summary."""
        ends = ", ".join(f"{np.sum(self.status == one)} {one.name}" for one in Status if np.any(self.status == one))
        ended = f": {ends}; {int(np.sum(self.events))} events" if len(self) else ""
        failed = np.argwhere(~self.success)
        failed = failed if len(failed) else np.argwhere(np.char.count(self.message.astype(str), "right digits"))
        which = ", ".join(map(str, failed[:5].tolist())) + ", ..." * (len(failed) > 5)
        first = f"; {f'scene {which}: ' * bool(self.shape)}{self.message[*failed[0]]}" if len(failed) else ""
        return f"{type(self).__name__} of {len(self)} scenes, shape {self.shape}{ended}{first}"

    @property
    def success(self) -> Array:
        """Return which runs got to their horizon, by events that are certain, with a right digit of every quantity."""
        return np.isin(self.status, (Status.REACHED_HORIZON, Status.STUCK_FOR_EVER))

    def _repr_html_(self) -> str:
        """Return the inputs that vary, and the answers, as a table of a notebook."""
        rows = {**varying(self.inputs), **{name: self.values(name) for name in self.ANSWERS}}
        spans = ((name, f"{np.nanmin(one):.6g} to {np.nanmax(one):.6g}") for name, one in rows.items() if np.size(one))
        return html_table(repr(self), spans)

    def values(self, answer: str) -> Array:
        """Return one of `ANSWERS`; x1, v1, x2, v2 are those at `t`. Raises ValueError."""
        require_one_of("answer", answer, self.ANSWERS)
        found, *less = map(self._value, answer.split(" - "))
        return np.asarray(found - less[0] if less else found)

    def _value(self, name: str) -> Array:
        """Return an array by its name; a part of the state at `t`, on a surface with its axis behind it."""
        if not is_of_state(name):
            return np.asarray(getattr(self, name))
        place, _, axis = name.partition("_")
        found = self.y[STATE.index(place)]
        return found[..., AXES.index(axis)] if axis else found

    def __getitem__(self, answer: str) -> Array:
        """Return the same: found["x1"]. Raises ValueError."""
        return self.values(answer)

    @property
    def inputs(self) -> dict[str, Floats]:
        """Return m1, m2, a2, b, x1, v1, x2, v2, until, a1 and what else all scenes have, SI units, each in the shape.

        On a surface these by axes, "m1_x", "m1_y", ..., and "a2_xy" for what couples two.
        """
        return {name: np.broadcast_to(one, self.shape) for name, one in self._inputs().items()}

    @cached_property
    def _taken(self) -> Floats:
        return self._took()  # type: ignore[misc]

    @property
    def results(self) -> dict[str, Array]:
        """Return how each run ended, and all of `ANSWERS`, by their names."""
        ended = np.vectorize(lambda one: Status(one).name, otypes=[object])(self.status)
        return {"status": ended, "success": self.success} | {name: self.values(name) for name in self.ANSWERS}

    def _columns(self) -> dict[str, Array]:
        return self.inputs | {f"{name}_at_t" if is_of_state(name) else name: one for name, one in self.results.items()}

    def to_dataframe(self) -> DataFrame:
        """Return inputs and results as a pandas DataFrame, a row for each scene, or point of it. Raises MissingTool.

        `.attrs["units"]` has the units. x1, v1, x2, v2 are those at the start, x1_at_t, ... those at `t`.
        """
        columns = self._columns()
        whole = max((one.shape for one in columns.values()), key=len)
        wide = {name: one.reshape(one.shape + (1,) * (len(whole) - one.ndim)) for name, one in columns.items()}
        found: DataFrame = tool("pandas").DataFrame(
            {name: np.broadcast_to(one, whole).ravel() for name, one in wide.items()}
        )
        found.attrs["units"] = {name: unit(name) for name in columns}
        return found

    def to_xarray(self) -> Dataset:
        """Return the same as an xarray Dataset. Raises MissingTool.

        An axis is named by the input whose values label it, if one alone varies along it and no value comes twice;
        else it is `scene`, of a grid `axis_0`, `axis_1`, ...
        """
        make, columns, axes = tool("xarray").Dataset, self._columns(), {}
        names = ["scene"] if len(self.shape) == 1 else [f"axis_{k}" for k in range(len(self.shape))]
        moving = {
            name: [k for k in range(one.ndim) if (one != one.take([0], axis=k)).any()]
            for name, one in varying(self.inputs).items()
        }
        for k in range(len(names)):
            along = [name for name, places in moving.items() if places == [k]]
            if len(along) != 1:
                continue
            values = np.moveaxis(columns[along[0]], k, 0).reshape(self.shape[k], -1)[:, 0]
            if len(np.unique(values)) == len(values):
                names[k], axes[along[0]] = along[0], values
                del columns[along[0]]
        found: Dataset = make({name: ((*names, "point")[: one.ndim], one) for name, one in columns.items()}, axes)
        for name in found.variables:
            found[name].attrs["units"] = unit(name)
        return found

    def plot(self, answer: str | None = None, along: str | ArrayLike | None = None, ax: Axes | None = None) -> Axes:
        """Draw one answer over the inputs that vary, one or the first two of them, and return the matplotlib axes.

        `answer`: one of `ANSWERS`, the first of them if left out; x1, v1, x2, v2 are those at the end. `along`: an
        input by its name, or an array of the shape, such as the amplitudes of a force. Runs that did not succeed are
        crossed out. Raises ValueError, MissingTool.
        """
        from numerics.solver.batch_picture import draw_batch

        with meter("drawing"):
            return draw_batch(self, self.ANSWERS[0] if answer is None else answer, along, ax)
