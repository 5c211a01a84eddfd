"""The answers of a batch: arrays in the shape of its inputs, each made when it is looked at."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from numerics.arithmetic.compiled import compiled
from numerics.arithmetic.precision import cached_property
from numerics.linear.errors_of import errors_of_rows
from numerics.linear.ledger import TINY
from numerics.linear.record import AT, BOUNDS, How
from numerics.meter import meter
from numerics.scene.decimals import require_one_of
from numerics.scene.short_repr import html_table
from numerics.solver.inputs import SI, varying
from numerics.solver.tables import Tabled
from numerics.trajectory.columns import STATE, Array, Counts, Floats
from numerics.trajectory.digits import ROUNDING
from numerics.trajectory.rendering import MOST_DIGITS
from numerics.trajectory.status import Status

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike


class Ends(Tabled):
    """What the ends of many runs are on a line and on a surface."""

    ANSWERS: tuple[str, ...] = ("dissipated", "energy_excess", "events", "mode", "digits", "t", *STATE)
    """What can be drawn."""
    status: Counts
    events: Counts
    message: Array
    y: Floats

    def __repr__(self) -> str:
        """Return a short summary."""
        ends = ", ".join(f"{np.sum(self.status == one)} {one.name}" for one in Status if np.any(self.status == one))
        ended = f": {ends}; {int(np.sum(self.events))} events" if len(self) else ""
        failed = np.argwhere(~self.success)
        which = ", ".join(map(str, failed[:5].tolist()))
        more = f"; scene {which}{', ...' * (len(failed) > 5)}: {self.message[*failed[0]]}" if len(failed) else ""
        return f"Batch of {len(self)} scenes, shape {self.shape}{ended}{more}"

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
        found: Array = self.y[STATE.index(answer)] if answer in STATE else getattr(self, answer)
        return found

    @property
    def results(self) -> dict[str, Array]:  # type: ignore[override]  # formed when it is asked for
        """Return how each run ended, and all of `ANSWERS`, by their names."""
        ended = np.vectorize(lambda one: Status(one).name, otypes=[object])(self.status)
        return {"status": ended, "success": self.success} | {name: self.values(name) for name in self.ANSWERS}

    @meter("drawing")
    def plot(self, answer: str | None = None, along: str | ArrayLike | None = None, ax: Axes | None = None) -> Axes:
        """Draw one answer over the inputs that vary, one or the first two of them, and return the matplotlib axes.

        `answer`: one of `ANSWERS`, the first of them if left out; x1, v1, x2, v2 are those at the end. `along`: an
        input by its name, or an array of the shape, such as the amplitudes of a force. Runs that did not succeed are
        crossed out. Raises ValueError, MissingTool.
        """
        from numerics.solver.batch_picture import draw_batch

        return draw_batch(self, self.ANSWERS[0] if answer is None else answer, along, ax)


class Batch(Ends):
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

    >>> from numerics import solve_many
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
    """

    def __init__(
        self,
        numbers: Floats,
        ends: Floats,
        kept: Floats,
        shape: tuple[int, ...],
        form_ledgers: Callable[[Floats], None] | None = None,
        walls: ArrayLike = False,
        more: Callable[[], dict[str, Floats]] = dict,
    ) -> None:
        """Keep SI numbers (n, 10), and rows that the runs wrote (linear/record.py): of ends, of start and first events.

        In these the time counts from the start of the run, whatever piece of force it is in. `form_ledgers` writes to
        the ends what friction and viscosity took, where that is nan. `walls` says where a wall moves; `more` returns
        other inputs by their names.
        """
        self.numbers, self.ends, self.kept, self.shape, self.form_ledgers = numbers, ends, kept, shape, form_ledgers
        self._walls, self._more = np.asarray(walls, bool), more

    @property
    def inputs(self) -> dict[str, Floats]:  # type: ignore[override]  # formed when it is asked for
        """Return m1, m2, a2, b, x1, v1, x2, v2, until, a1 and all else that varies, SI units, each in the shape."""
        others = {name: np.broadcast_to(one, self.shape) for name, one in self._more().items() if name not in SI}
        return {name: self._given(name) for name in SI} | others

    def _given(self, name: str) -> Floats:
        return self.numbers[:, SI.index(name)].reshape(self.shape)

    def _end(self, *names: str) -> Floats:
        """Return columns of the ends, a line each."""
        found = self.ends.T[[AT[name] for name in names]].reshape(len(names), *self.shape)
        return np.where(self._how == How.OUT_OF_RANGE, np.nan, found)

    def _event(self, *names: str) -> Floats:
        """Return columns of the first events, a line each."""
        found = self.kept.T[[AT[name] for name in names], 1:].swapaxes(1, 2)
        return found.reshape(len(names), *self.shape, self.kept.shape[1] - 1)

    def _taken(self, *names: str) -> Floats:
        if self.form_ledgers is not None:
            self.form_ledgers(self.ends)
            self.form_ledgers = None
        return self._end(*names)

    @cached_property
    def _how(self) -> Counts:
        return self.ends[:, AT["how"]].astype(np.int64).reshape(self.shape)

    @cached_property
    def status(self) -> Counts:  # type: ignore[override]  # formed when it is asked for
        """Return how each run ended, a Status."""
        blank = (self._how < How.EVENT_LIMIT) & (self.digits == 0)
        ended = np.where(blank, int(Status.NO_RIGHT_DIGIT), self._how)
        return np.where(self._how == How.DOUBT, int(Status.SEQUENCE_OPEN), ended)

    @property
    def message(self) -> Array:  # type: ignore[override]  # formed when it is asked for
        """Return how each run ended, as a sentence."""
        return np.vectorize(lambda one: Status(one).sentence, otypes=[object])(self.status)

    @cached_property
    def events(self) -> Counts:  # type: ignore[override]  # formed when it is asked for
        """Number of events of each run."""
        return _whole(self._end("events")[0])

    @cached_property
    def mode(self) -> Counts:
        """Return the sign of v1 - v2 at the end."""
        return _whole(self._end("mode")[0])

    @cached_property
    def certain(self) -> Array:
        """Whether the bounds exclude any other sequence of events."""
        return np.asarray(self._how < How.OUT_OF_RANGE)

    @cached_property
    def t(self) -> Floats:
        """Return the time at the end, s."""
        return np.where(self._how < How.EVENT_LIMIT, self._given("until"), self._end("local")[0])

    @cached_property
    def y(self) -> Floats:  # type: ignore[override]  # formed when it is asked for
        """Return x1, v1, x2, v2 at the end."""
        return self._end(*STATE)

    @cached_property
    def y_error(self) -> Floats:
        """Return bounds on the errors of y."""
        return self._end(*BOUNDS[1:5])

    @cached_property
    def _judged(self) -> Floats:
        """Return bounds on the error of the excess at the end, and the worst relative errors, a line each."""
        with np.errstate(all="ignore"):
            found = compiled(errors_of_rows)(self.numbers, self.kept, self.ends, ROUNDING)
        return np.asarray(found).reshape(2, *self.shape)

    @cached_property
    def energy_excess(self) -> Floats:
        """Return E/E_cr - 1 at the end, of the pair's own b; nan without a spring or b, and where a wall moves."""
        x1, v1, _, v2 = self.y
        m1, m2, a2, b = (self._given(name) for name in SI[:4])
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            energy = a2 * x1**2 / 2 + m1 * v1**2 / 2 + np.where(np.isinf(m2), 0.0, m2 * v2**2 / 2)
            return np.where((a2 * b > 0) & ~self._walls, energy / ((b * (1 + m1 / m2)) ** 2 / (2 * a2)) - 1, np.nan)

    @cached_property
    def energy_excess_error(self) -> Floats:
        """Return a bound on its error."""
        return np.where((self._how == How.OUT_OF_RANGE) | self._walls, np.nan, self._judged[0])

    @cached_property
    def dissipated(self) -> Floats:
        """Energy dissipated by friction and viscosity, J."""
        friction, viscous = self._taken("friction", "viscous")
        return np.asarray(friction + viscous)

    @cached_property
    def dissipated_error(self) -> Floats:
        """Return a bound on its error."""
        return np.asarray(2.0 * self._taken("ledger_error")[0] + TINY)

    @cached_property
    def event_t(self) -> Floats:
        """Return the times of the first events, s."""
        return np.asarray(self._event("local")[0])

    @cached_property
    def event_y(self) -> Floats:
        """Return x1, v1, x2, v2 at the first events."""
        return self._event(*STATE)

    @cached_property
    def event_mode(self) -> Counts:
        """Return the sign of v1 - v2 after the first events."""
        return _whole(self._event("mode")[0])

    @cached_property
    def event_t_error(self) -> Floats:
        """Return bounds on the errors of event_t."""
        return np.asarray(self._event("late")[0] + 4 * ROUNDING * self.event_t)

    @cached_property
    def event_y_error(self) -> Floats:
        """Return bounds on the errors of event_y."""
        return self._event(*BOUNDS[1:5])

    @cached_property
    def digits(self) -> Counts:
        """Return the right digits of the kept events and of the end, 0 where the events are not certain."""
        with np.errstate(divide="ignore"):
            right = np.floor(-np.log10(np.maximum(self._judged[1], ROUNDING)))
        return np.where(self.certain, np.clip(right, 0, MOST_DIGITS), 0).astype(np.int64)


def _whole(numbers: Floats) -> Counts:
    return np.nan_to_num(numbers).astype(np.int64)
