"""The chain rule along a trajectory of balls: derivatives from leg to leg, across events and jumps of signals.

Along a motion of one mode derivatives at a fixed time follow the linearised equation (variation.py). Between two
motions, with f- and f+ the field y' on either side, they jump:

    guard   dtau = -(dg)/g',   dy+ = dy- + (f- - f+) dtau   (dg at a fixed time; g a row of z, as in model.py)
    piece   its start is a number of the scene: dtau = 1 by that number, else 0

At an event, which moves, the state has the derivatives dy- + f- dtau. An exit by a guard leaves f as it is, but for
friction that is larger at rest.

At a fixed time two solutions of the linearised equations never part in the norm of model.py across all events. So what
is carried on are points, with bounds that are sums of local radii; of x1, where there is no spring, and of x1 - x2,
which N does not know, the bound grows by that of a velocity. Where friction depends on the state N grows at the rate of
each cell (cells.py), and a crossing of a knot, where the field is continuous, is no jump. A belt says its velocity.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

import flint
import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball, undecided, widened
from numerics.errors import NotDifferentiable
from numerics.linear.cells import mode_in
from numerics.linear.exact_start import exact_knots
from numerics.linear.model import BELT, CONSTANT, FIRST, FRICTION, V1, V2, WALL, X1, Bodies
from numerics.linear.pieces import ExactPiece
from numerics.linear.system import value
from numerics.linear.ties import MARGINAL, derivatives, signal_form
from numerics.scene import Law, Piece, Scene
from numerics.trajectory.columns import STATE, Array
from numerics.trajectory.variation import SIGNALS, Leg, Variation, driven, rates_in

_radius = np.frompyfunc(lambda x: x.rad(), 1, 1)
_middle = np.frompyfunc(lambda x: x.mid(), 1, 1)
_widened = np.frompyfunc(widened, 2, 1)


class CarriedDerivatives(NamedTuple):
    """Derivatives of the state at a fixed time, (4, p), with bounds (p,) on their errors: in N, of x1, of x1 - x2."""

    y: Array
    norm: Array
    far: Array
    place: Array


class Shift(NamedTuple):
    """How what ends a leg moves in time: by numbers of the carried point, (p,), with bounds on their errors.

    `before` and `behind` are the fields y' on both sides; None where they are the same.
    """

    t: Array
    before: Array
    behind: Array | None
    off: Array | arb = arb(0)


class Chain:
    """Derivatives along the legs of one trajectory; to be used in the balls' context.

    `events`: of the times (p,), of the states (4, p) and of the energies (p,) of all events, which move; `starts`: what
    is carried into every leg.
    """

    def __init__(
        self, scene: Scene, legs: Sequence[Leg], names: Sequence[str], progress: Callable[..., None] | None = None
    ) -> None:
        """Follow all legs; `names` are those of the numbers, the last axis of every array."""
        self.scene, self.legs = scene, legs
        self.column = {name: index for index, name in enumerate(names)}
        self.bodies, self.is_fixed = Bodies.of(scene.pair), scene.pair.is_fixed
        self.alike = dict[object, Variation]()
        """One for all pieces whose matrices are the same."""
        self.norm = self._of(legs[0]).norm
        self.events: list[tuple[Array, Array, Array]] = []
        y = self._zeros(4)
        for place, name in enumerate(STATE):
            if name in self.column:
                y[place, self.column[name]] = arb(1)
        if legs[0].side == 0:  # stuck neighbours share their momentum at once
            y[1] = y[3] = Ball.number(self.bodies.share_1) * y[1] + Ball.number(self.bodies.share_2) * y[3]
        zeros = self._zeros()
        self.starts = [self._across(0, CarriedDerivatives(y, zeros, zeros, zeros), self._by_jumps(0))]
        for index in range(len(legs) - 1):
            self.starts.append(self._crossed(index))
            if progress is not None and index % 64 == 0:
                progress(index, len(legs))

    def at(self, index: int, tau: arb) -> Array:
        """Return the derivatives of the state at a fixed time, tau (s) after the start of a leg, enclosed, (4, p)."""
        return self._enclosed(self._ahead(index, tau))

    def final(self, state: Sequence[arb]) -> tuple[Array, Array, Array]:
        """Return the derivatives of the end as those of an event; the last state is given."""
        last, t = self.legs[-1], self._zeros()
        if last.start is last.end:
            return self.events[-1]
        if "until" in self.column:
            t[self.column["until"]] += 1
        y = self.at(len(self.legs) - 1, last.length)
        return self._moved(last, (last.end, state), t, y + np.outer(rates_in(last.mode, last.end, state), t))

    def _moved(self, leg: Leg, at: tuple[arb, Sequence[arb]], t: Array, y: Array) -> tuple[Array, Array, Array]:
        """Return the derivatives of a time (s) in a leg, of the state there, and of the energy, J, from the first two.

        What the signals say of the state is taken from them.
        """
        (now, state), own, pair = at, self._of(leg), self.scene.pair
        (z, moved), energy, signal = own.begun(state, now, y), self._zeros(), leg.mode.signal(WALL)
        rates = own.A @ z
        rates[:FIRST] = arb(0)  # the state has moved
        moved[:FIRST] += np.outer(driven(leg.mode, rates)[:FIRST], t)
        wall, by_wall, wall_rate = (value(signal, one) for one in (z, moved, rates))
        stretched = z[X1] - wall, moved[X1] - (by_wall + wall_rate * t)
        parts = {"a2": stretched, "m1": (z[V1], moved[V1]), "m2": (z[V2], moved[V2])}
        for name in ("a2", "m1") if self.is_fixed else parts:
            one, by = parts[name]
            energy = energy + by * (Ball.number(getattr(pair, name)) * one)
            if name in self.column:
                energy[self.column[name]] += one * one / 2
        return t, moved[:FIRST], energy

    def _zeros(self, *rows: int) -> Array:
        return np.full((*rows, len(self.column)), arb(0))

    def _of(self, leg: Leg) -> Variation:
        mode = leg.mode  # its own hash takes long
        same = id(mode) if any(mode.layout.omegas) or mode.cell is not CONSTANT else (mode.layout, mode.side)
        if same not in self.alike:
            self.alike[same] = Variation(self.scene, self.column, mode, leg.cell)
        return self.alike[same].under(self.scene, mode)

    def _ahead(self, index: int, tau: arb) -> CarriedDerivatives:
        """Return the derivatives tau (s) after the start of a leg: of the point that is carried, and the bounds."""
        leg, (y, norm, far, place) = self.legs[index], self.starts[index]
        variation = self._of(leg)
        ahead, own = variation.over(leg.state, leg.start, tau, y), variation.norm
        norm = norm * own.growth(tau.abs_upper())
        place = place + norm * own.kappa * abs(tau) * abs(leg.side)
        return CarriedDerivatives(ahead, norm, far + norm / own.root_m1 * abs(tau), place)

    def _pointed(self, found: CarriedDerivatives) -> CarriedDerivatives:
        """Return the middles of balls, their radii added to the bounds."""
        (x1, v1, x2, v2), own = _radius(found.y), self.norm
        off = found.norm + x1 * own.root_a2 + v1 * own.root_m1 + v2 * own.root_m2 + (x1 + x2) * own.root_g
        return CarriedDerivatives(_middle(found.y), off, found.far + x1, found.place + x1 + x2)

    def _enclosed(self, found: CarriedDerivatives) -> Array:
        """Return balls that hold the true derivatives."""
        own = self.norm
        x1 = found.norm / own.root_a2 if own.root_a2 > 0 else found.far
        v2 = 0 * found.norm if self.is_fixed else found.norm / own.root_m2
        return _widened(found.y, np.array([x1, found.norm / own.root_m1, found.place + x1, v2]))

    def _crossed(self, index: int) -> CarriedDerivatives:
        """Return the derivatives at the start of the next leg; those of an event are kept."""
        leg, after = self.legs[index], self.legs[index + 1]
        found = self._ahead(index, leg.length)
        if after.begins_piece:
            shifts = self._by_jumps(index + 1)
        else:
            shifts = iter([self._by_guard(leg, after, found)] if after.is_event else [])
        return self._across(index + 1, found, shifts)

    def _across(self, index: int, found: CarriedDerivatives, shifts: Iterable[Shift]) -> CarriedDerivatives:
        """Return the derivatives at the start of a leg behind what moves in time; those of an event are kept."""
        enclosed, leg = self._enclosed(found), self.legs[index]
        t, moving, y = self._zeros(), +enclosed, +found.y
        for one in shifts:
            late = _widened(one.t, one.off)
            t, moving = t + late, moving + np.outer(one.before, late)
            if one.behind is not None:
                y += np.outer(one.before - one.behind, one.t)
                if not leg.begins_piece and self.legs[index - 1].side:  # a slip ends where both velocities are one
                    moving[1], y[1] = moving[3], found.y[3] + (one.before[3] - one.behind[1]) * one.t
        if leg.is_event:
            self.events.append(self._moved(leg, (leg.start, leg.state), t, moving))
        return self._pointed(found._replace(y=y))

    def _by_guard(self, leg: Leg, after: Leg, ended: CarriedDerivatives) -> Shift:
        """Return how an event by a guard moves."""
        own = self._of(leg)
        if leg.side:
            self._require_clear(after)
        by_state, moved, rate = own.guard(after.side, after.state, after.start, ended.y)
        off = ended.norm * own.norm.most(by_state.tolist()) + ended.place * abs(by_state[2])
        off = off + (ended.far * abs(by_state[0] + by_state[2]) if not own.norm.root_a2 > 0 else 0)
        behind = after.rates if leg.side or self.bodies.static != 1 else None
        return Shift(-moved / rate, rates_in(leg.mode, after.start, after.state), behind, off / abs(rate))

    def _require_clear(self, leg: Leg) -> None:
        """Raise NotDifferentiable where a slip has ended with a load on an edge that it keeps to, or that keeps sticks.

        Raise EventUndecided where digits leave it open.
        """
        keeps, when = self.bodies.static != 1, f"at t = {float(leg.start):.6g} s"
        if leg.order == MARGINAL or (keeps and leg.side == 0 and leg.order > 0):
            ends = f"{when} a slip ends with exactly the load that friction holds"
            raise NotDifferentiable(f"this scene has no derivatives: {ends}; change it slightly")
        if keeps and leg.side:
            mode = mode_in(self.scene, leg.mode.piece, 0, (0, leg.cell[1]))
            for row in mode.guards:
                if (held := value(row, mode.begin(leg.state, leg.start))).contains(0):
                    raise undecided(f"does friction hold the load where a slip ends, {when}?", held)

    def _by_jumps(self, index: int) -> Iterator[Shift]:
        """Yield how each start at the beginning of a leg that begins a piece moves it.

        Where signals jump together, each does so after the others. What does not jump, or does nothing in stick, is
        left out. Raises NotDifferentiable if the order of two jumps counts.
        """
        leg, last, scene = self.legs[index], self.legs[max(index - 1, 0)], self.scene
        here, literal = leg.mode.piece, scene.law is Law.THREE_VALUED_SGN
        before = last.mode.piece if index else _in_front(here, scene)
        names = [f"{name}.from" for name, _ in self._of(leg).signals]
        alone = {}
        for k, name in enumerate(names):
            if name in self.column and _jumps_at(before, here, k):
                signals = [*here.signals[:k], before.signals[k].moved(here.start), *here.signals[k + 1 :]]
                alone[k] = replace(here, signals=tuple(signals))
        if index and len(alone) > 1 and (leg.is_event or not (leg.side or literal or self._hold(alone, leg))):
            both = " and ".join(SIGNALS[k] for k in alone)
            when = f"at t = {float(leg.start):.6g} s {both} both jump, and which of them comes first"
            raise NotDifferentiable(f"this scene has no derivatives: {when} counts; change one of them slightly")
        for k, one in alone.items():
            if index and k == FRICTION and not (leg.side or last.side):
                continue
            t = self._zeros()
            t[self.column[names[k]]] += 1
            if index:
                yield Shift(t, self._rates(leg, one, last.side, last.cell), leg.rates)
            else:
                yield from self._begun_later(one, k, t)

    def _begun_later(self, piece: ExactPiece, k: int, late: Array) -> Iterator[Shift]:
        """Yield how the start moves where signal k begins late, up to when another piece acts.

        From v1 = v2 the bodies may part in that time, to the wrong side or from a stick: a slip back follows.
        """
        leg, t = self.legs[0], Fraction(0)
        here = leg.mode.piece
        before, begun = (exact_knots(self.scene, (one,))[0] for one in (piece, here))
        _, rates, *_ = derivatives(mode_in(self.scene, piece, before.mode, before.cell), t, before.state)
        moved = rates[V1] - rates[V2]
        if k == BELT:  # its polynomial begins late as well, its sines do not
            waves = replace(here.signals[BELT], polynomial=())
            moved = rates[V1] - signal_form(replace(here, signals=(*here.signals[:BELT], waves)), BELT, t, 1)
        side, in_front = moved.sign(), self._rates(leg, piece, before.mode, before.cell)
        if begun.gap != 0 or side in (0, leg.side):
            yield Shift(late, in_front, leg.rates)
            return
        back = self._rates(leg, here, side, (0, leg.cell[1]))
        rate = back[1] - back[3]
        if not rate * side < 0:
            begins = f"{SIGNALS[k]}[0] begins a little later"
            raise NotDifferentiable(
                f"this scene has no derivatives: where {begins} the bodies part; change it slightly"
            )
        yield Shift(late, in_front, back)
        yield Shift(late * (1 - moved.enclosed(flint.ctx.prec) / rate), back, leg.rates)

    def _rates(self, leg: Leg, piece: ExactPiece, side: int, cell: tuple[int, int]) -> Array:
        """Return (x1, v1, x2, v2)' where a leg starts, but in a mode under another piece."""
        mode = mode_in(self.scene, piece, side, cell)
        return rates_in(mode, leg.start, driven(mode, mode.begin(leg.state, leg.start))[:FIRST])

    def _hold(self, pieces: dict[int, ExactPiece], leg: Leg) -> bool:
        """Return whether the load stays below the edge for sure under each of some pieces, where a leg starts."""
        modes = [mode_in(self.scene, one, 0, (0, leg.cell[1])) for one in pieces.values()]
        return all(value(row, mode.begin(leg.state, leg.start)) > 0 for mode in modes for row in mode.guards)


def _in_front(here: ExactPiece, scene: Scene) -> ExactPiece:
    """Return what is before the run: no signals, and the pair's own b."""
    nothing = Piece(0)
    return replace(here, signals=(nothing, nothing, nothing, nothing, Piece(0, (scene.pair.b,))))


def _jumps_at(before: ExactPiece, here: ExactPiece, k: int) -> bool:
    """Return whether a signal jumps where a piece begins; of belt and wall its derivative counts, too."""
    orders, end = 2 if k in {BELT, WALL} else 1, here.start - before.start
    return any(signal_form(before, k, end, n) != signal_form(here, k, Fraction(0), n) for n in range(orders))
