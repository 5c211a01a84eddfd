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
from numerics.linear.exact_start import ExactKnot, exact_knots
from numerics.linear.flow import Expansion, numbers_of
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
        """Return the point after the root of a guard, in the mode that follows, and its row."""
        numbers, local = self.numbers, self.numbers.middle(at.local + root.tau)
        t = local - at.local
        moved = (arb(t) - arb(root.tau)).abs_upper()
        late, window, norm = root.late + moved, root.window + moved, at.norm
        state, here = root.motion.state(t), numbers.within(local, late)
        event = self.around(at, t, state, root.motion.bends(t + arb(0, late)), late) if self.is_ball else state
        load, rate = self.flow(0, at.piece).load(self.vector(0, at.piece, here, event))
        b, x, v = Ball.number(self.pieces[at.piece].b), state[0], numbers.middle(state[3])
        if at.mode:
            mode = mode_on_surface(load, b, arb(0), literal=self.literal)
            if mode in {UNDECIDED, at.mode}:
                raise self.undecided(at)
            after, order, off = late if mode == 0 else arb(0), abs(mode), 2 * b * window
            if self.literal:  # stick may bear more than b, and one motion sticks while the other does not
                off = off + (abs(load) + b) * late
        else:
            mode, order, after = 1 if root.guard == 0 else -1, 2, arb(0)
            bend = mode * rate * self.kappa * self.kappa
            if not bend > 0:
                raise self.undecided(at)
            # where the load is not quite b, the slip starts a little later than here
            off = 2 * b * (window + 2 * self.kappa * self.kappa * (root.value + abs(rate) * moved) / bend)
        gaps = [(arb(one) - arb(v)).abs_upper() for one in (state[1], state[3])]
        radii = numbers.radius(x), numbers.radius(state[2])
        apart = self.kappa * norm * (2 * late + (arb(t) if at.mode else 0))
        norm = norm + self.root_a2 * radii[0] + self.root_m1 * gaps[0] + self.root_m2 * gaps[1] + self.kappa * off
        points = numbers.middle(x), v, numbers.middle(state[2]), v
        place = at.place + apart + radii[0] + radii[1]
        norm = norm.upper()
        found = At(
            mode, order, at.piece, local, points, norm, self.far(at, arb(t), radii[0], norm), place.upper(), after
        )
        return found, self.row(found, rows, here, event, event=True)

    def around(self, at: At, t: Any, state: list[Any], bends: list[arb], late: arb) -> list[Any]:
        """Return the state at the true event, which is up to `late` before or after that of the path."""
        within = self.numbers.within
        x1, v1, x2, v2 = state
        far, fast = self.far(at, arb(t), arb(0), at.norm), [at.norm / self.root_m1, at.norm / self.root_m2]
        one, two = (within(v, off + bend * late) for v, off, bend in zip((v1, v2), fast, bends, strict=True))
        v = one.intersection(two)
        runs = [late * (abs(speed) + bend * late) for speed, bend in zip((v1, v2), bends, strict=True)]
        place = at.place + 2 * self.kappa * at.norm * late
        return [within(x1, (far + runs[0]).upper()), v, within(x2, (far + place + runs[1]).upper()), v]

    def next_piece(self, at: At, rows: list[Knot]) -> tuple[At, Knot]:
        """Return the start of the next piece, where u or b may jump, and its row."""
        end, index = self.ended(at), at.piece + 1
        piece, local, mode = self.pieces[index], self.numbers.number(0), at.mode
        if mode == 0 and piece.is_jump:
            load, _ = self.flow(0, index).load(self.vector(0, index, local, end.state))
            mode = mode_on_surface(load, Ball.number(piece.b), self.load_norm * end.norm, literal=self.literal)
            if mode == UNDECIDED:
                raise self.undecided(at)
        found = end._replace(mode=mode, order=abs(mode - at.mode), piece=index, local=local)
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
            if abs(split.polynomial[0]) + split.amplitude + self.margin(end) < Ball.number(piece.b):
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
        start = self.numbers.point(arb(local).lower())
        if knot.local:  # a time that is rounded, by as much before the knot
            z = self.vector(at.mode, at.piece, local, state)
            state = Expansion(self.flow(at.mode, at.piece), z).state(start - local)
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
        return Knot(at.mode, at.order, event, jump, at.piece, local, length, *state)
