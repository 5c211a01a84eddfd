"""The engine in balls, and in numbers of mpmath: next_event, evolve, resolve, record, from event to event.

What a point of the path is and what its error does in one mode is said in path_enclosed.py, how the next event is found
in next_enclosed.py. In balls everything is proved; numbers of mpmath take the same steps without bounds.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from flint import arb, ctx

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import EventUndecided
from numerics.linear.cells import CEILING, FLOOR, FORCE, LEFT, PLAIN, RIGHT
from numerics.linear.exact_start import ExactKnot, exact_knots
from numerics.linear.flow import numbers_of
from numerics.linear.modes import UNDECIDED, mode_on_surface
from numerics.linear.next_enclosed import SHY, Bracket, Root, next_event, short_step
from numerics.linear.path_enclosed import At, Path
from numerics.linear.record import How, Knot, Record
from numerics.linear.scan import splits
from numerics.scene import Scene

Progress = Callable[[int, float], None]
_AHEAD = 20
"""So many steps a stick is followed past the horizon until it is proved to last for ever, or ends."""


def run_enclosed(scene: Scene, arithmetic: Arithmetic, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene in Ball(n) or Multiprecision(n); in balls all numbers enclose those of the true motion.

    Raises EventUndecided where the working digits do not settle what comes next, OutOfRange where a mode takes more
    steps than anybody waits for.
    """
    numbers = numbers_of(arithmetic.name, arithmetic.digits)
    with ctx.workprec(numbers.bits), numbers.context():
        return _Run(scene, arithmetic, numbers).record(max_events, progress)


class _Run(Path):
    """The loop over events, and what it leaves behind."""

    # ------------------------------------------------------------------ the loop
    def record(self, max_events: int, progress: Progress | None) -> Record:
        """Follow the modes up to the horizon, or to as many events."""
        numbers, knots = self.numbers, exact_knots(self.scene, self.pieces)
        rows: list[Knot] = []
        events = 0
        for knot in knots:
            if knot.is_event and events == max_events:
                return self._limited(rows, events)
            events += knot.is_event
            rows.append(self.known(knot, rows))
        at, last = self.begin(knots[-1]), knots[-1]
        is_over = last.quiet == self.pieces[last.piece].length
        if last.local < last.quiet and not is_over:
            at = self.evolved(at, numbers.middle(numbers.number(last.quiet)))
        while True:
            at, root = (at, None) if is_over else next_event(self, at)
            is_over = False
            if root is None and at.piece + 1 == len(self.pieces):
                end = self.ended(at)
                how = How.STUCK if self.is_stuck(end) else How.REACHED
                return Record(rows, self.row(end, rows, end.local, self.fixed(end), event=False), how, events)
            if root is not None and events == max_events:
                return self._limited(rows, events)
            at, row = self.next_piece(at, rows) if root is None else self.resolve(at, root, rows)
            if row.event and events == max_events:
                return self._limited(rows, events)
            rows.append(row)
            events += row.event
            if progress is not None and len(rows) % 64 == 0:
                progress(events, float(self.pieces[at.piece].start / self.scene.until))

    def _limited(self, rows: list[Knot], events: int) -> Record:
        while len(rows) > 1 and not rows[-1].event:
            rows.pop()
        return Record(rows, rows[-1], How.EVENT_LIMIT, events)

    # ------------------------------------------------------------------ resolve
    def resolve(self, at: At, root: Root, rows: list[Knot]) -> tuple[At, Knot]:
        """Return the point after the root of a guard, in the mode or cell that follows, and its row."""
        numbers, local = self.numbers, self.numbers.middle(at.local + root.tau)
        t = local - at.local
        moved = (arb(t) - arb(root.tau)).abs_upper()
        late, norm = root.late + moved, at.norm
        if self.cells:
            norm = norm * self.growth(at, arb(t))
            reached = at.place + self.kappa * norm * (4 * late + (arb(t) if at.mode else 0))
            # about the event both motions may be in different cells
            norm = (2 * self.kappa**2 * self.falling * late).exp() * (
                norm + 4 * self.kappa * self.pulling * reached * late
            )
            at = at._replace(norm=norm)
        state, here = root.motion.state(t), numbers.within(local, late)
        bends = root.motion.bends(t + arb(0, late)) if self.is_ball else [arb(0), arb(0)]
        at_knot = at.mode != 0 and (root.guard.kind != FLOOR or at.cell[0] > 0)
        event = self.around(at, t, state, bends, late, together=not at_knot) if self.is_ball else state
        if at_knot:
            after, bound = self.crossed(at, root, state, bends, moved, event)
            shared, x = state, state[0]
        else:
            after, bound = self.switched(at, root, event, bends, here, moved)
            shared, x = [state[0], numbers.middle(state[3]), state[2], numbers.middle(state[3])], state[0]
        gaps = [
            (arb(one) - arb(numbers.middle(v))).abs_upper() for one, v in zip(state[1::2], shared[1::2], strict=True)
        ]
        radii = numbers.radius(x), numbers.radius(state[2])
        apart = self.kappa * norm * (2 * late + (arb(t) if at.mode else 0))
        norm = norm + self.root_a2 * radii[0] + self.root_m1 * gaps[0] + self.root_m2 * gaps[1] + self.kappa * bound
        if self.cells:
            norm = norm + self.weight(at) * (radii[0] + radii[1])
        norm, place = norm.upper(), (at.place + apart + radii[0] + radii[1]).upper()
        x1, v1, x2, v2 = map(numbers.middle, shared)
        far = self.far(at, arb(t), radii[0], norm)
        found = after._replace(local=local, state=(x1, v1, x2, v2), norm=norm, far=far, place=place)
        found = self.reweighed(found, self.weight(at))
        return found, self.row(found, rows, here, event, event=at.mode != found.mode)

    def switched(self, at: At, root: Root, event: list[Any], bends: list[arb], here: Any, moved: arb) -> tuple[At, arb]:
        """Return the mode that follows v1 = v2, and a bound on int |error of friction| dt about the event."""
        late, window = root.late + moved, root.window + moved
        load, rate = self.flow(0, at.piece).load(self.vector(0, at.piece, here, event))
        b = self.held(at, arb(event[0]) - arb(event[2])) if self.cells and at.mode else self.edge(at)
        if at.mode:
            mode = mode_on_surface(load, b, arb(0), literal=self.literal)
            if mode in {UNDECIDED, at.mode}:
                raise self.undecided(at)
            after, order, off = late if mode == 0 else arb(0), abs(mode), 2 * b * window
            if self.literal:  # stick may bear more than b, and one motion sticks while the other does not
                off = off + (abs(load) + b) * late
        else:
            mode, order, after = 1 if root.guard.sign < 0 else -1, 2, arb(0)
            bend = mode * rate * self.kappa * self.kappa
            if not bend > 0:
                raise self.undecided(at)
            # where the load is not quite b, the slip starts a little later than here
            span = window + 2 * self.kappa * self.kappa * (root.value + abs(rate) * moved) / bend
            off = 2 * b * span
        found = at._replace(mode=mode, order=order, late=after)
        if self.cells is None:
            return found, off
        if at.mode:  # by how much F is not B(0) + C in between
            speed = root.value + (bends[0] + bends[1]) * window
            off = off + 4 * speed * window * (self.cell_slopes(at) + self.pulling * window)
        else:
            off = off + 4 * self.kappa**2 * b * span**2 * (self.cell_slopes(found) + self.pulling * span)
        return self.entered(found, event), off

    def cell_slopes(self, at: At) -> arb:
        """Return the greatest |B'| next to rest, N s/m, for the mode before and the one after."""
        if self.cells is None:
            return arb(0)
        return Ball.number(abs(self.cells.by_speed[0][1]) * self.cells.scale(self.pieces[at.piece]))

    def entered(self, at: At, state: Sequence[Any]) -> At:
        """Return a point at v1 = v2 in the cell in which its mode goes on."""
        cells, z = self.cells, at.apart
        if cells is None or at.mode == 0:
            return at._replace(cell=PLAIN, orders=())
        at_knot = z is not None and z in cells.places
        if z is None:
            apart = arb(state[0]) - arb(state[2])
            j = sum(apart.mid() > Ball.number(one).mid() for one in cells.places)
        else:
            j = cells.place_line(z, at.mode)
        ties = (0, 0, (at.order + 1) * (at.mode > 0), (at.order + 1) * (at.mode < 0)) if at_knot else ()
        return at._replace(cell=(0, j), orders=ties, apart=None)

    def crossed(
        self, at: At, root: Root, state: list[Any], bends: list[arb], moved: arb, event: list[Any]
    ) -> tuple[At, arb]:
        """Return a slip in the next cell, and a bound on int |error of friction| dt about the knot."""
        cells, (k, j), kind = self.cells, at.cell, root.guard.kind
        assert cells is not None
        if kind == FORCE:
            w, z = (float(arb(event[n] - event[n + 2]).mid()) for n in (1, 0))
            raise cells.vanishing(abs(w), z, f" at t = {self.time(at) + float(arb(root.tau).mid()):.6g} s")
        # behind an end of |w| the other end of the next interval vanishes, and so for z
        cell, behind = {
            FLOOR: ((k - 1, j), CEILING),
            CEILING: ((k + 1, j), FLOOR),
            LEFT: ((k, j - 1), RIGHT),
            RIGHT: ((k, j + 1), LEFT),
        }[kind]
        found = at._replace(cell=cell, order=0, orders=tuple(int(n == behind) for n in range(4)), late=arb(0))
        of_speed, window = kind in {FLOOR, CEILING}, root.window + moved
        rate = bends[0] + bends[1] if of_speed else abs(arb(state[1]) - arb(state[3]))
        lines = cells.by_speed if of_speed else cells.by_place
        before, after = (lines[one[0 if of_speed else 1]][1] for one in (at.cell, cell))
        bend = Ball.number(abs(after - before) * cells.scale(self.pieces[at.piece]))
        return found, 4 * bend * (root.value + rate * moved) * window

    def around(self, at: At, t: Any, state: list[Any], bends: list[arb], late: arb, *, together: bool) -> list[Any]:
        """Return the state at the true event, up to `late` before or after that of the path; `together`: v1 = v2."""
        within = self.numbers.within
        x1, v1, x2, v2 = state
        far, fast = self.far(at, arb(t), arb(0), at.norm), [at.norm / self.root_m1, at.norm / self.root_m2]
        one, two = (within(v, off + bend * late) for v, off, bend in zip((v1, v2), fast, bends, strict=True))
        if together:
            one = two = one.intersection(two)
        runs = [late * (abs(speed) + bend * late) for speed, bend in zip((v1, v2), bends, strict=True)]
        place = at.place + 2 * self.kappa * at.norm * late
        if at.mode:
            place = place + self.kappa * at.norm * arb(t)
        return [within(x1, (far + runs[0]).upper()), one, within(x2, (far + place + runs[1]).upper()), two]

    def next_piece(self, at: At, rows: list[Knot]) -> tuple[At, Knot]:
        """Return the start of the next piece, where u or b may jump, and its row."""
        end, index = self.ended(at), at.piece + 1
        piece, local, mode = self.pieces[index], self.numbers.number(0), at.mode
        if mode == 0 and piece.is_jump:
            load, _ = self.flow(0, index).load(self.vector(0, index, local, end.state))
            b = self.edge(end._replace(piece=index))
            mode = mode_on_surface(load, b, self.load_norm * end.norm, literal=self.literal)
            if mode == UNDECIDED:
                raise self.undecided(at)
        found = end._replace(mode=mode, order=abs(mode - at.mode), piece=index, local=local)
        if at.mode == 0:
            found = self.entered(found, found.state)
        found = self.reweighed(found, self.weight(at))
        return found, self.row(found, rows, local, self.fixed(found), event=mode != at.mode)

    def is_stuck(self, end: At) -> bool:
        """Return whether stick at the horizon is proved to last for ever, if u and b go on as they are."""
        piece, flow = self.pieces[end.piece], self.flow(0, end.piece)
        if end.mode or self.literal or len(piece.polynomial) > 3:
            return end.mode == 0 and self.literal
        for _ in range(_AHEAD):
            z = self.vector(0, end.piece, end.local, end.state)
            split = next(splits(flow, piece, 0, end.local, z), None)
            if split is None:
                return False
            if abs(split.polynomial[0]) + split.amplitude + self.margin(end) < self.edge(end):
                return True
            try:
                found = short_step(self, end, flow, z, flow.reach, flow.reach)
            except EventUndecided:
                return False
            if isinstance(found, Bracket):
                return False
            end = self.evolved(end, self.numbers.middle(end.local + self.numbers.point(found[0] * SHY)))
        return False

    # ------------------------------------------------------------------ record
    def begin(self, knot: ExactKnot) -> At:
        """Return an exact knot as a point; the motion starts within its rounding."""
        state, zero, local = self.exactly(knot), arb(0), self.numbers.number(knot.local)
        at = At(knot.mode, knot.order, knot.piece, local, (0, 0, 0, 0), zero, zero, zero, zero)
        if self.cells and knot.mode == 0:
            at = at._replace(apart=(knot.x1 - knot.x2).rational)
        elif self.cells:
            exact = (knot.x1, knot.v1, knot.x2, knot.v2)
            begun = self.cells.start(self.pieces[knot.piece], knot.mode, knot.local, exact, knot.order)
            at = at._replace(cell=begun.cell, orders=begun.orders)
        start = self.numbers.point(arb(local).lower())
        if knot.local:  # a time that is rounded, by as much before the knot
            z = self.vector(at.mode, at.piece, local, state, at.cell)
            state = self.flow(at.mode, at.piece, at.cell).expansion(z).state(start - local)
        return self.settled(at, state, zero)._replace(local=start)

    def exactly(self, knot: ExactKnot) -> list[Any]:
        """Return the state of an exact knot in numbers."""
        return [one.number(self.arithmetic) for one in (knot.x1, knot.v1, knot.x2, knot.v2)]

    def known(self, knot: ExactKnot, rows: list[Knot]) -> Knot:
        """Return the row of an exact knot."""
        local, state = self.numbers.number(knot.local), self.exactly(knot)
        return self.row(self.begin(knot), rows, local, state, event=knot.is_event)._replace(jump=knot.is_jump)

    def fixed(self, at: At) -> list[Any]:
        """Return the state of the true motion at the time of a point."""
        bounds = at.far, at.norm / self.root_m1, at.far + at.place, at.norm / self.root_m2
        return [self.numbers.within(one, off.upper()) for one, off in zip(at.state, bounds, strict=True)]

    def row(self, at: At, rows: list[Knot], local: Any, state: Sequence[Any], *, event: bool) -> Knot:
        """Return the row of a segment that starts at a point."""
        before = rows[-1] if rows else None
        length, jump = self.numbers.number(0), True
        if before is not None:
            jump = before.piece != at.piece
            length = (self.numbers.number(self.pieces[before.piece].length) if jump else local) - before.local
        return Knot(at.mode, at.order, event, jump, at.piece, local, length, *state)._replace(cell=at.cell)
