"""The engine in balls: next_event, evolve, resolve, record, from event to event; everything is proved.

What a point of the path is and what its error does in one mode is said in path_enclosed.py, how the next event is found
in next_enclosed.py.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball, proved_sign, widened
from numerics.arithmetic.precision import precision
from numerics.errors import EventUndecided
from numerics.linear.cells import VANISHES
from numerics.linear.exact_start import ExactKnot, exact_knots
from numerics.linear.flow import Motion
from numerics.linear.model import BELT, CEILING, FLOOR, V1, V2, X1, X2
from numerics.linear.next_enclosed import CLEAR, SHY, Root, next_event, short_step, slow_curves
from numerics.linear.path_enclosed import AWAY, At, EnclosedPath
from numerics.linear.pieces import polynomial_at
from numerics.linear.record import How, Knot, Record
from numerics.linear.sine_form import SineForm
from numerics.linear.system import LinearMode, dot
from numerics.linear.ties import mode_after, signal_form
from numerics.scene import Scene

Progress = Callable[[int, float], None]
_MORE_BITS = 16
"""Working bits beyond those of the arithmetic."""
_AHEAD = 20
"""So many steps a stick is followed past the horizon until it is proved to last for ever, or ends."""


def run_enclosed(scene: Scene, arithmetic: Ball, max_events: int, progress: Progress | None = None) -> Record:
    """Solve a scene in Ball(n), up to the horizon or to as many events: balls that enclose the numbers of its motion.

    Raises EventUndecided where the working digits do not settle what comes next, OutOfRange where a mode takes more
    steps than anybody waits for.
    """
    rows: list[Knot] = []
    events = 0
    with precision(arithmetic.bits + _MORE_BITS):
        run = EnclosedRun(scene, arithmetic)
        for row in run.rows():
            if events == max_events and (row is None or row.event):
                while not rows[-1].event:
                    rows.pop()
                return Record(rows, rows[-1], How.EVENT_LIMIT, events)
            if row is not None:
                rows.append(row)
                events += row.event
                if progress is not None and len(rows) % 64 == 0:
                    progress(events, float(run.pieces[row.piece].start / scene.until))
        return Record(rows[:-1], rows[-1], run.how, events)


class EnclosedRun(EnclosedPath):
    """The loop over events, and what it leaves behind."""

    how = How.REACHED
    before: Knot | None = None

    # ------------------------------------------------------------------ the loop
    def rows(self) -> Iterator[Knot | None]:
        """Follow the modes up to the horizon; yield every row, None before one that a root begins, the end last."""
        knots = exact_knots(self.scene, self.pieces)
        if not self.arithmetic.radius.is_zero():  # what is known of one start is not of all
            knots = [knots[0]._replace(quiet=knots[0].local)]
        for knot in knots:
            at = self.begin(knot)
            yield self.row(at, Ball.number(knot.local), self.exactly(knot))._replace(jump=knot.is_jump)
        is_over = knot.quiet == self.pieces[knot.piece].length
        if knot.local < knot.quiet and not is_over and not self.lasts(at):
            at = self.evolved(at, Ball.number(knot.quiet).mid())
        while True:
            at, root = (at, None) if is_over else next_event(self, at)
            is_over = False
            if root is not None:
                yield None
                at, local, state = self.resolve(at, root)
            elif at.piece + 1 < len(self.pieces):
                at = self.next_piece(at)
                local, state = at.local, self.fixed(at)
            else:
                break
            yield self.row(at, local, state)
        end = self.ended(at)
        if self.is_stuck(end):
            self.how = How.STUCK
        yield self.row(end, end.local, self.fixed(end))

    # ------------------------------------------------------------------ resolve
    def resolve(self, at: At, root: Root) -> tuple[At, arb, list[arb]]:
        """Return the point after the root of a guard, in the mode or cell that follows, and time and state there."""
        local, t, late, norm = root.local, root.tau, root.late, at.norm
        norm = norm * self.growth(at, t)
        reached = self.parted(at._replace(norm=norm), t, 2 * late)
        # about the event both motions may be in different cells
        norm = norm + 4 * self.kappa * self.pulling * reached * late
        norm = norm * (2 * self.kappa**2 * self.falling * late).exp()
        at = at._replace(norm=norm)
        state, here, bends = root.motion.state(t), widened(local, late), root.motion.bends(t + arb(0, late))
        at_knot = at.mode != 0 and (root.guard.kind != FLOOR or at.cell[0] > 0)
        event = self.around(at, t, state, bends, late, together=not at_knot)
        if at_knot:
            found, bound = self.crossed(at, root, event)
        else:
            found, bound = self.switched(at, root, event, bends, here)
        points = [one.mid() for one in state]
        if not at_knot:
            points[V1] = points[V2]
        gaps = [(state[k] - points[k]).abs_upper() for k in (V1, V2)]
        off_1, off_2 = state[X1].rad(), state[X2].rad()
        place = (self.parted(at, t, late) + off_1 + off_2).upper()
        norm = (norm + self.flow(at).norm.of((off_1, gaps[0], -off_2, gaps[1])) + self.kappa * bound).upper()
        far = self.far(at, t, off_1, norm)
        found = found._replace(local=local, state=points, norm=norm, far=far, place=place)
        return self.reweighed(found, self.weight(at)), here, event

    def switched(self, at: At, root: Root, event: list[arb], bends: list[arb], here: arb) -> tuple[At, arb]:
        """Return the mode that follows v1 = v2, and a bound on int |error of friction| dt about the event."""
        late, span, kappa = root.late, root.window, self.kappa
        there = at._replace(mode=0, local=here, state=event, place=arb(0))
        flow, z = self.here(there)
        load, b = dot(flow.load, z), self.edge(there, flow, z)
        above = self.kept * b * late  # while one sticks at more than b and the other slips
        if at.mode:
            # a slip comes back to v1 = v2 at the mirror image of where it left
            contact = None if at.contact is None else 2 * self.balance(at, at.mode) - at.contact
            if contact is None:
                mode = self.on_surface(at, load, b, arb(0))
                order = abs(mode)
            else:
                mode, order = self.exactly_after(at, contact)
            if mode == at.mode:
                raise self.undecided(at)
            after, off = late if mode == 0 else arb(0), 2 * b * span
            if mode == 0:
                off = off + above
            if self.literal:  # stick may bear more than b, and one motion sticks while the other does not
                off = off + (abs(load) + b) * late
            speed = root.value + (bends[0] + bends[1]) * span
        else:
            mode, order, after = 1 - 2 * root.guard.row, 2, arb(0)
            contact = self.balance(at, mode) if self.is_closed(at) and self.kept == 0 else None
            if self.kept > 0:
                order = 1
            else:
                bend = -Motion(flow, z).guards()[root.guard.row].polynomial[1] * kappa * kappa
                if not bend > 0:
                    raise self.undecided(at)
                # where the load is not quite b, the slip starts a little later than here
                span = span + 2 * kappa * kappa * root.value / bend
            off, speed = 2 * b * span + above, kappa**2 * b * span
        # by how much F is not B(0) + C in between
        off = off + 4 * speed * span * (self.steep + self.pulling * span)
        at = at._replace(mode=mode, late=after, contact=None, is_slow=False)
        if mode and contact is not None:
            at = self.on_circle(at, contact)
        return self.entered(at, order, event), off

    def on_surface(self, at: At, load: arb, b: arb, error: arb) -> int:
        """Return the mode that follows v1 = v2 after a point, from the load (N), which is known up to an error."""
        if self.literal or abs(load) + error < b:
            return 0
        if abs(load) - error > b:
            return 1 if load > 0 else -1
        raise self.undecided(at)

    def exactly_after(self, at: At, contact: Fraction) -> tuple[int, int]:
        """Return the mode that follows a contact so far from the bearing, and how many derivatives of its guard vanish.

        It is as if it came when the piece begins: since then only the bearing may have moved, at a constant speed.
        """
        piece = self.pieces[at.piece]
        speed = signal_form(piece, BELT, Fraction(0))
        place = polynomial_at(self.bearing(at), Fraction(0)) + contact
        state = SineForm(place), speed, SineForm(), speed
        return mode_after(LinearMode(self.pair, 0, piece), Fraction(0), state)

    def entered(self, at: At, order: int, state: Sequence[arb]) -> At:
        """Return a point at v1 = v2 in the cell in which its mode goes on."""
        at = at._replace(orders=(order, 0))
        if at.apart is not None:
            exactly = at.apart if at.mode == 0 else None
            return at._replace(cell=(0, self.cells.place_line(at.apart, at.mode or 1)), apart=exactly)
        return at._replace(cell=(0, self.interval(at, state)))

    def interval(self, at: At, state: Sequence[arb]) -> int:
        """Return the interval of places in which a mode begins: a slip does not look at what is behind it."""
        apart, places = state[X1] - state[X2] + arb(0, at.place), [Ball.number(one) for one in self.cells.places]
        if any(apart.overlaps(one) for one in places):
            raise self.undecided(at)
        return sum(apart > one for one in places)

    def crossed(self, at: At, root: Root, event: list[arb]) -> tuple[At, arb]:
        """Return a slip in the next cell, and a bound on int |error of friction| dt about the knot."""
        cells, kind = self.cells, root.guard.kind
        if kind == VANISHES:
            w, z = (float((event[n] - event[n + 2]).mid()) for n in (V1, X1))
            raise cells.vanishing(abs(w), z, f" at t = {self.time(at) + float(root.tau.mid()):.6g} s")
        cell = cells.behind(at.mode, at.cell, kind)
        # behind an end of |w| the other end of the next interval vanishes
        found = at._replace(cell=cell, orders=(int(kind == CEILING), int(kind == FLOOR)), late=arb(0))
        before, after = (cells.branch(self.pieces[at.piece], 1, one) for one in (at.cell, cell))
        bend = Ball.number(abs(after.slope - before.slope) + abs(after.pull - before.pull))
        return found, 4 * bend * root.value * root.window

    def around(self, at: At, t: arb, state: list[arb], bends: list[arb], late: arb, *, together: bool) -> list[arb]:
        """Return the state at the true event, up to `late` before or after that of the path; `together`: v1 = v2."""
        x1, v1, x2, v2 = state
        far, fast = self.far(at, t, arb(0), at.norm), [at.norm * one for one in self.speeds]
        one, two = (widened(v, off + bend * late) for v, off, bend in zip((v1, v2), fast, bends, strict=True))
        if together:
            one = two = one.intersection(two)
        runs = [late * (abs(speed) + bend * late) for speed, bend in zip((v1, v2), bends, strict=True)]
        return [widened(x1, far + runs[0]), one, widened(x2, far + self.parted(at, t, late) + runs[1]), two]

    def next_piece(self, at: At) -> At:
        """Return the start of the next piece, where signals may jump."""
        end, root_g = self.ended(at), self.weight(at)
        piece = self.pieces[at.piece + 1]
        found = end._replace(piece=at.piece + 1, local=arb(0), orders=AWAY, contact=None, is_slow=False)
        if self.is_fixed and piece.belt_jumps:
            found = self.beside(end, found)
        if found.mode == 0 and piece.is_jump:
            flow, z = self.here(found)
            mode = self.on_surface(at, dot(flow.load, z), self.edge(found, flow, z), self.margin(end))
            found = self.entered(found._replace(mode=mode), abs(mode), found.state)
        return self.reweighed(found, root_g)

    def beside(self, end: At, found: At) -> At:
        """Return the start of a piece in the mode that follows a jump of the belt's velocity."""
        before, after = self.pieces[end.piece], self.pieces[found.piece]
        jump = signal_form(after, BELT, Fraction(0)) - signal_form(before, BELT, before.length)
        if jump.sign() == 0:
            return found
        _, v1, _, v2 = self.fixed(found._replace(mode=1))
        mode = proved_sign(v1 - v2, "does the belt overtake body 1?") if end.mode else -jump.sign()
        found = self.entered(found._replace(mode=mode), 0, found.state)
        k = sum(abs(v1 - v2).mid() > Ball.number(one).mid() for one in self.cells.speeds[1:])
        return found._replace(cell=(k, found.cell[1]))

    def is_stuck(self, end: At) -> bool:
        """Return whether stick at the horizon is proved to last for ever, if u and b go on as they are."""
        if end.mode or self.literal or self.lasts(end):
            return end.mode == 0
        for _ in range(_AHEAD):
            curves = next(slow_curves(self, end, arb(0)))
            if any(one.terms > 1 for one in curves):
                return False
            if all(one.polynomial[0] > one.margin for one in curves):
                return True
            try:
                found = short_step(self, end, self.flow(end).reach)
            except EventUndecided:
                return False
            if found.hit != CLEAR:
                return False
            end = self.evolved(end, (end.local + found.since * SHY).mid())
        return False

    # ------------------------------------------------------------------ record
    def begin(self, knot: ExactKnot) -> At:
        """Return an exact knot as a point; the motion starts within its rounding, or the radius of a box."""
        state, zero, local = self.exactly(knot), arb(0), Ball.number(knot.local)
        at = At(knot.mode, knot.orders, knot.piece, local, state, zero, zero, zero, zero, knot.cell)
        x1, v1 = (knot.state[place].rational for place in (X1, V1))
        if not self.arithmetic.radius.is_zero():
            self.interval(at, state)  # the same one for all starts
        elif knot.mode == 0 and self.varies:
            at = at._replace(apart=(knot.state[X1] - knot.state[X2]).rational)
        elif knot.mode and self.is_closed(at) and x1 is not None and v1 is not None:
            at = self.on_circle(at, x1 - polynomial_at(self.bearing(at), knot.local), v1)
        start = local.lower()
        if knot.local:  # a time that is rounded, by as much before the knot
            state = Motion(*self.here(at)).state(start - local)
        return self.settled(at, state, zero)._replace(local=start)

    def exactly(self, knot: ExactKnot) -> list[arb]:
        """Return the state of an exact knot in balls, which hold all that start within the radius."""
        bits, number, radius = 4 * self.arithmetic.digits + 64, self.arithmetic.number, self.arithmetic.radius
        found = [one.enclosed(bits) if one.parts else number(one.constant) for one in knot.state]
        return found if radius.is_zero() else [widened(one, radius) for one in found]

    def fixed(self, at: At) -> list[arb]:
        """Return the state of the true motion at the time of a point."""
        fast_1, fast_2 = (at.norm * one for one in self.speeds)
        state = self.here(at)[1][:4] if self.is_fixed else at.state
        return [widened(one, off) for one, off in zip(state, (at.far, fast_1, at.far + at.place, fast_2), strict=True)]

    def row(self, at: At, local: arb, state: Sequence[arb]) -> Knot:
        """Return the row of a segment that starts at a point, after the last one."""
        before, event, jump, length = self.before, False, True, arb(0)
        if before is not None:
            event, jump = before.mode != at.mode, before.piece != at.piece
            length = (Ball.number(self.pieces[before.piece].length) if jump else local) - before.local
        self.before = Knot(at.mode, at.order, event, jump, at.piece, local, length, *state)._replace(cell=at.cell)
        return self.before
