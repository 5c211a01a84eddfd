"""What a trajectory consists of: segments in one mode, the events between them, and where the energy went.

E' = u v1 - a1 v1^2 - b |v1 - v2| is integrated anew between the rows of a record, each time from the state of a row
over the length that the run says: an engine that put an event, or the state at it, in a wrong place leaves a residual.
Quadratic forms of z' = A z are integrated by Van Loan's block exponential, what is slid is the flow itself.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from numerics.arithmetic.protocol import Number
from numerics.free.frame import ReducedState
from numerics.linear.modes import EventKind, Mode
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.rows import Rows


@dataclass(frozen=True, slots=True, repr=False)
class Event(ShortRepr):
    """A change of mode at the time t (s), from `before` to `after`, at y = (x1, v1, x2, v2) in SI units.

    `kind`: crossing, entry of a stick or exit; `cause`: "guard", a velocity or a load got there; or "jump", of the
    force or of b; `reduced`: the state in the engine's own units.

    >>> from numerics import load_scene, solve
    >>> event = solve(load_scene("velocities")).events[20]
    >>> round(event.t, 6), event.kind.name, event.before.value, event.after.value, event.cause
    (4.549769, 'ENTRY', 'slip+', 'stick', 'guard')
    >>> [round(float(one), 5) for one in event.y]
    [0.00035, 0.00555, -0.0002, 0.00555]
    """

    t: Number
    kind: EventKind
    before: Mode
    after: Mode
    y: tuple[Number, Number, Number, Number]
    reduced: ReducedState = field(repr=False)
    cause: str = "guard"


@dataclass(frozen=True, slots=True, repr=False)
class Segment(ShortRepr):
    """One mode of motion from `start` to `end` (s); u and b may jump in it.

    `length` (s) is kept apart: next to a late start the difference of both would round a short slip away.

    >>> from numerics import load_scene, solve
    >>> run = solve(load_scene("velocities"))
    >>> stuck, slip = run.segments[21:23]
    >>> stuck.mode.value, round(stuck.start, 6), float(round(stuck.length, 6)), slip.start == stuck.end
    ('stick', 4.549769, 0.029769, True)
    >>> with run.arithmetic.context():
    ...     [round(float(one), 6) for one in (*slip.state(0.1), slip.losses()[0])]
    [0.000587, -0.002827, 0.000129, -0.000732, 1.3e-05]
    """

    mode: Mode
    start: Number
    end: Number
    length: Number
    rows: range = field(repr=False)
    run: Rows = field(repr=False, compare=False)

    def state(self, since: Number) -> tuple[Number, Number, Number, Number]:
        """Return (x1, v1, x2, v2) at `since` (s) after the start, m and m/s; in the arithmetic's context."""
        row = self.rows[0]
        for later in self.rows[1:]:  # pieces of force begin within
            before = self.run.row_lengths[row]
            if self.run.arithmetic.to_float(since - before) <= 0:
                break
            row, since = later, since - before
        x1, v1, x2, v2 = self.run.row_flow(np.array([row]), np.array([since]))[:, 0].tolist()
        return x1, v1, x2, v2

    def losses(self) -> tuple[Number, Number]:
        """Return what friction and viscosity take in it, b int |v1 - v2| and a1 int v1^2, J."""
        rows = np.array(self.rows)
        friction, viscous, _ = self.run.row_losses(rows, self.run.row_lengths[rows]).sum(axis=1)
        return friction, viscous


@dataclass(frozen=True, slots=True, repr=False)
class EnergyLedger(ShortRepr):
    """Where the energy went, J: initial - final against b int |v1 - v2| dt + a1 int v1^2 dt.

    `work` is what a force has put in, int u v1 dt. `residual` = initial + work - final - friction - viscous: rounding
    only, and an enclosure of 0 for balls. The integrals start anew from the state at each event, so that an
    event at the wrong place shows.

    >>> from numerics import load_scene, solve
    >>> books = solve(load_scene("velocities")).ledger
    >>> [round(float(one), 6) for one in (books.initial, books.final, books.friction, books.viscous, books.work)]
    [0.01125, 2.9e-05, 0.011221, 0.0, 0.0]
    >>> abs(books.residual) < 1e-15
    True
    """

    initial: Number
    final: Number
    friction: Number
    viscous: Number
    residual: Number
    work: Number = 0


def ledger_of(run: Rows) -> EnergyLedger:
    """Return the ledger of the whole run; in the arithmetic's context."""
    lengths, zero = run.row_lengths, run.arithmetic.number(0)
    friction, viscous, work = (sum(part.tolist(), zero) for part in run.row_losses(np.arange(len(lengths)), lengths))
    initial, final = run.arithmetic.number(run.scene.energy), run.final_energy
    return EnergyLedger(initial, final, friction, viscous, initial + work - final - friction - viscous, work)
