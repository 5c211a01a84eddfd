"""A box |f_i| <= b_i without couplings: on every axis a pair of the paper by itself, solved by the line's engines.

The events of all axes make one list, a mode is a word of + 0 -. Two axes with the same data have their events at one
time, exactly; where others may be at one time the precision is raised.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from flint import arb, arb_poly

from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided, InvalidScene
from numerics.linear.modes import Mode
from numerics.plane.answer import PlaneEvent, PlaneSolution, PlaneState, Working
from numerics.plane.vector import Matrix, Vector, exact
from numerics.scene import Friction, Pair, Scene, State
from numerics.scene.plane import PlaneScene
from numerics.trajectory.status import Status

LETTERS = {Mode.SLIP_PLUS: "+", Mode.STICK: "0", Mode.SLIP_MINUS: "-"}
_SPARE = 4


def axis_scene(scene: PlaneScene, i: int) -> Scene:
    """Return the scene of one axis of a box without couplings."""
    pair = scene.pair
    return Scene(
        Pair(pair.m1[i], pair.m2[i], pair.a2[i][i], pair.b[i], pair.a1[i][i]),
        State(scene.x1[i], scene.v1[i], scene.x2[i], scene.v2[i]),
        scene.until,
        force=scene.force[i],
        friction=Friction((start, b[i]) for start, b in scene.friction),
    )


def independent(
    scene: PlaneScene, line: Callable[..., Any], working: int, name: str, limits: dict[str, Any]
) -> PlaneSolution:
    """Return the axes' motions as one. Raises EventUndecided."""
    asked = {"digits": working - _SPARE, "arithmetic": "ball", **limits}
    solved: dict[Any, Any] = {}
    answers = []
    for part in (axis_scene(scene, i) for i in range(scene.pair.axes)):
        key = part.pair, part.initial.x1, part.initial.v1, part.initial.v2, part.force
        if key not in solved:  # axes that share these have their events at the same times
            solved[key] = line(part, **asked)
        answers.append(solved[key])
    if not all(one.success for one in answers):
        raise InvalidScene(f"an axis of the box has more than {limits['max_events']} events; raise the cap max_events")
    arithmetic = Working(2 * max(one.arithmetic.digits for one in answers), name)
    with arithmetic.context():
        return _joined(scene, answers, arithmetic)


class Axes:
    """The motions of all axes as one, at any time."""

    def __init__(self, scene: PlaneScene, answers: list[Any]) -> None:
        """Take the answer of each axis, which may be that of another one with the same motion and other places."""
        self.answers, starts = answers, [one.scene.initial for one in answers]
        self.places = exact(x - y - (at.x1 - at.x2) for x, y, at in zip(scene.x1, scene.x2, starts, strict=True))

    def at(self, t: Any) -> PlaneState:
        """Return the state at a time."""
        x1, v1, x2, v2 = map(Vector, zip(*(one.sol(t) for one in self.answers), strict=True))
        return PlaneState(x1, v1, x2 - self.places, v2)


def _joined(scene: PlaneScene, answers: list[Any], arithmetic: Working) -> PlaneSolution:
    """Return the motions of all axes with one list of events."""
    motion = Axes(scene, answers)
    happened = [(event, i) for i, one in enumerate(answers) for event in one.events]
    happened.sort(key=lambda one: (float(one[0].t.mid()), one[1]))
    groups: list[list[tuple[Any, int]]] = []
    for event, i in happened:
        if groups and groups[-1][-1][0].t.overlaps(event.t):
            before, k = groups[-1][-1]
            if answers[k] is not answers[i] and not (event.t.is_exact() and before.t.is_exact()):
                raise EventUndecided(
                    "which axis has its event first", str(event.t.str(6)), answers[i].arithmetic.digits
                )
            groups[-1].append((event, i))
        else:
            groups.append([(event, i)])
    word = [LETTERS[one.modes[0]] for one in answers]
    modes, events = ["".join(word)], []
    for group in groups:
        t = group[0][0].t
        for event, i in group:
            word[i] = LETTERS[event.after]
        y = motion.at(t)
        signs = Vector(arb({"+": 1, "0": 0, "-": -1}[one]) for one in word)
        direction = signs / (signs @ signs).max(arb(1)).sqrt()
        load = _load(scene, y, t)
        modes.append("".join(word))
        cause = "jump" if any(event.cause == "jump" for event, _ in group) else "guard"
        events.append(PlaneEvent(t, modes[-2], modes[-1], y, direction, load, cause))
    stuck = all(one.status is Status.STUCK_FOR_EVER for one in answers)
    status = Status.STUCK_FOR_EVER if stuck else Status.REACHED_HORIZON
    end = Ball.number(scene.until), motion.at(scene.until)
    return PlaneSolution(scene, arithmetic, status, events, modes, end, motion)


def _load(scene: PlaneScene, y: PlaneState, t: arb) -> Vector:
    """Return m2/(m1 + m2) (u - a2 x1 - a1 v1), N."""
    pair, number, u = scene.pair, Ball.number, []
    for force in scene.force:
        piece = force.piece_at(Fraction(float(t.mid())))
        u.append(arb_poly([number(c) for c in piece.polynomial])(t - number(piece.start)))
        for sine in piece.sines:
            u[-1] += number(sine.amplitude) * (number(sine.omega) * t + number(sine.phase)).sin()
    m1, m2 = exact(pair.m1), exact(pair.m2)
    found: Vector = (Vector(u) - Matrix.of(pair.a2) @ y.x1 - Matrix.of(pair.a1) @ y.v1) * m2 / (m1 + m2)
    return found
