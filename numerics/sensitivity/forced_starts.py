"""How a state moves with the start of a piece: by (y'(t-) - y'(t+)) for each second that the start comes later."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from numerics.arithmetic.protocol import Number
from numerics.errors import NotDifferentiable
from numerics.motion.forced_rules import force_form
from numerics.motion.sine_form import SineForm
from numerics.scene import Law
from numerics.sensitivity.forced_segments import Segments


class Starts:
    """The pieces that begin at the rows of a trajectory."""

    def __init__(self, segments: Segments) -> None:
        """Read its segments."""
        scene = segments.of.scene
        self._segments, self._scene = segments, scene
        self._force = {start: f"force[{k}].from" for k, start in enumerate(scene.force.starts)}
        self._friction = {start: f"friction[{k}].from" for k, start in enumerate(scene.friction.starts)}

    def columns(self, row: int) -> dict[str, tuple[Any, Any]]:
        """Return y' before and after each start at the beginning of a row that begins a piece, by its name.

        Where u and b jump together, each does so after the other. What does not jump, or does nothing in stick, is left
        out. Raises NotDifferentiable if the order of two jumps counts.
        """
        of = self._segments
        piece, state, mode = of.pieces[row], of.of.enclosed(row), of.modes[row]
        of_force, of_friction = self._jumping(piece)
        if of_force is None and of_friction is None:
            return {}
        u, b = of.force(piece, of.zero), of.friction(piece)
        u_before, b_before, before = self._before(row)
        if row > 0 and of_force is not None and of_friction is not None:
            self._require_any_order(row, state, ((u_before, b), (u, b_before)))
        after, found = of.field(state, u, b, mode), {}
        if of_force is not None:
            found[of_force] = of.field(state, u_before, b, before), after
        if of_friction is not None and (before, mode) != (0, 0):
            found[of_friction] = of.field(state, u, b_before, before), after
        return found

    def _jumping(self, piece: int) -> tuple[str | None, str | None]:
        """Return the names of the starts at which u and b jump where a piece begins; exact."""
        pieces, here = self._segments.of.pieces, self._segments.of.pieces[piece]
        u, b = SineForm(), self._scene.pair.b
        if piece:
            u, b = force_form(pieces[piece - 1], pieces[piece - 1].length), pieces[piece - 1].b
        of_force, of_friction = self._force.get(here.start), self._friction.get(here.start)
        u_jumps = of_force is not None and u != force_form(here, Fraction(0))
        return of_force if u_jumps else None, of_friction if b != here.b else None

    def _before(self, row: int) -> tuple[Number, Number, int | None]:
        """Return u, b and the mode right before a row; before the run there is no force, and the pair's own b."""
        of = self._segments
        if row > 0:
            piece = of.pieces[row - 1]
            return of.force(piece, of.whole(piece)), of.friction(piece), of.modes[row - 1]
        at, literal = self._scene.initial, self._scene.law is Law.THREE_VALUED_SGN
        mode = of.modes[0] if at.v1 != at.v2 or literal else None
        return of.zero, of.arithmetic.base.number(self._scene.pair.b), mode

    def _require_any_order(self, row: int, state: Any, between: Any) -> None:
        """Raise unless a slip goes on, or the pair sticks, whichever of two jumps comes first."""
        of, literal = self._segments, self._scene.law is Law.THREE_VALUED_SGN
        if not of.events[row]:
            pushes = ((abs(of.pair.m2 * of.field(state, u, b, 0)[1]), b) for u, b in between)
            if of.modes[row] or literal or all(push < b for push, b in pushes):
                return
        at = float(of.of.pieces[of.pieces[row]].start)
        raise NotDifferentiable(
            f"this scene has no derivatives: at t = {at:.6g} s force and friction both jump, and which of them comes "
            "first counts; move one by a little"
        )
