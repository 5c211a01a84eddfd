"""A box |f_i| <= b_i in parts that neither springs nor dampers couple: each moves by itself, as if there were no other.

A part of one axis is a pair of the paper, solved by the line's engines; a larger one is a box with fewer axes. The
events of all parts make one list, a mode is a word of + 0 -. Parts with the same data, or mirrored ones, have their
events at one time, exactly, and so have those that one change of force or of friction lets go; where others may be at
one time the precision is raised.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball, exact_middle
from numerics.errors import EventUndecided, InvalidScene
from numerics.plane.answer import PlaneEvent, PlaneState, Working
from numerics.plane.linear import SIGNS
LETTERS = {sign: letter for letter, sign in SIGNS.items()}
from numerics.plane.reduced import reduced
from numerics.plane.system import System
from numerics.plane.vector import Vector, exact
from numerics.scene import Friction, Pair, Scene, State
from numerics.scene.plane import PlanePair, PlaneScene
from numerics.trajectory.status import Status

_MIRRORED = str.maketrans("+-", "-+")


def part_scene(scene: PlaneScene, axes: Sequence[int], sign: int = 1) -> Scene | PlaneScene:
    """Return the scene of axes that no other one acts on, of a pair on a line if it is one; there x2 = 0 at t = 0.

    With the sign -1 it is mirrored: all goes the other way.
    """

    def of(numbers: Sequence[Any]) -> list[Any]:
        return [numbers[i] for i in axes]

    pair = scene.pair
    a1, a2 = ([of(row) for row in of(matrix)] for matrix in (pair.a1, pair.a2))
    m1, m2, b = map(of, (pair.m1, pair.m2, pair.b))
    x1, v1, v2, force = ([sign * one for one in of(given)] for given in (scene.x1, scene.v1, scene.v2, scene.force))
    friction = [(start, of(changed)) for start, changed in scene.friction]
    if len(axes) > 1:
        small = PlanePair(m1, m2, a2, b, a1, "box")
        return PlaneScene(small, scene.until, x1, v1, 0, v2, force=force, friction=friction)
    line = Pair(m1[0], m2[0], a2[0][0], b[0], a1[0][0])
    changes = Friction((start, changed[0]) for start, changed in friction)
    return Scene(line, State(x1[0], v1[0], 0, v2[0]), scene.until, force=force[0], friction=changes)


class Parts:
    """The motions of all parts as one, at any time."""

    def __init__(self, scene: PlaneScene, alone: Callable[[Scene | PlaneScene], Any]) -> None:
        """Take what `alone` answers for each part; of parts with the same data, or mirrored ones, once."""
        self.axes, self.x2, solved = scene.pair.parts, scene.x2, dict[Any, Any]()
        self.answers, self.signs = list[Any](), list[int]()
        for axes in self.axes:
            part, mirrored = (part_scene(scene, axes, sign) for sign in (1, -1))
            known = mirrored if mirrored in solved else part
            if known not in solved:
                solved[known] = alone(known)
            self.answers.append(solved[known])
            self.signs.append(1 if known == part else -1)

    def at(self, t: Any) -> PlaneState:
        """Return the state at a time."""
        rows = np.empty((4, len(self.x2)), dtype=object)
        for axes, one, sign in zip(self.axes, self.answers, self.signs, strict=True):
            rows[:, axes] = one.sol(t).reshape(4, -1) * sign
        x1, v1, x2, v2 = map(Vector, rows)
        return PlaneState(x1, v1, x2 + exact(self.x2), v2)


Run = tuple[Working, Status, str, tuple[PlaneEvent, ...], Parts]
"""What a PlaneTrajectory is made of: how the run ended, the mode at t = 0, the events, and any time."""


def joined(scene: PlaneScene, alone: Callable[[Scene | PlaneScene], Any], most: int) -> Run:
    """Return the motions of the parts, which `alone` solves in balls, as one. Raises EventUndecided, InvalidScene."""
    motion = Parts(scene, alone)
    if not all(one.success for one in motion.answers):
        raise InvalidScene(f"a part of the box has more than {most} events; raise the cap max_events")
    arithmetic = Working(2 * max(one.arithmetic.digits for one in motion.answers))
    with arithmetic.context():
        return _joined(scene, motion, arithmetic)


def _joined(scene: PlaneScene, motion: Parts, arithmetic: Working) -> Run:
    """Return the motions of all parts with one list of events."""
    system, answers = System(reduced(scene)[-1], arithmetic.digits), motion.answers
    starts = [one.acting.start for one in system.pieces]

    def load_at(y: PlaneState, t: arb, when: Fraction) -> Vector:
        """Return the load at t, N, of the piece of u that begins last up to `when`."""
        drive = system.pieces[sum(one <= when for one in starts[1:])]
        return system.load(drive.force(t - Ball.number(drive.acting.start)), Vector(y.x1), Vector(y.v1))

    def changed(event: Any) -> list[Fraction]:
        """Return at which change an event may be, exactly; none for one that is not due to any."""
        return [one for one in starts if event.t.overlaps(Ball.number(one))] if event.cause == "jump" else []

    happened = [(event, i) for i, one in enumerate(answers) for event in one.events]
    happened.sort(key=lambda one: (float(one[0].t.mid()), one[1]))
    groups: list[list[tuple[Any, int]]] = []
    for event, i in happened:
        if not groups or not groups[-1][-1][0].t.overlaps(event.t):
            groups.append([])
        elif answers[i] is not answers[groups[-1][-1][1]]:
            before = groups[-1][-1][0]
            both, are_exact = (changed(event), changed(before)), event.t.is_exact() and before.t.is_exact()
            if not are_exact and (len(both[0]) != 1 or both[0] != both[1]):
                digits = max(one.arithmetic.digits for one in answers)
                raise EventUndecided("which axis has its event first", str(event.t.str(6)), digits)
        groups[-1].append((event, i))
    word = ["0"] * scene.pair.axes

    def put(i: int, mode: Any) -> str:
        """Return the word of all axes after one with the mode of a part."""
        letters = mode if isinstance(mode, str) else LETTERS[mode.sign]
        for axis, letter in zip(motion.axes[i], letters, strict=True):
            word[axis] = letter if motion.signs[i] > 0 else letter.translate(_MIRRORED)
        return "".join(word)

    first = mode = [put(i, one.modes[0]) for i, one in enumerate(answers)][-1]
    events = []
    for group in groups:
        t, cause = group[0][0].t, "guard"
        before = mode
        for event, i in group:
            mode = put(i, event.after)
            cause = "jump" if event.cause == "jump" else cause
        y = motion.at(t)
        signs = Vector(arb(SIGNS[one]) for one in word)
        direction = signs / (signs @ signs).max(arb(1)).sqrt()
        pieces = changed(group[0][0]) or [exact_middle(t.lower()), exact_middle(t.upper())]
        loads = [load_at(y, t, one) for one in (pieces[0], pieces[-1])]
        load = Vector(x.union(y) for x, y in zip(*loads, strict=True))
        events.append(PlaneEvent(t, before, mode, y, direction, load, cause))
    stuck = all(one.status is Status.STUCK_FOR_EVER for one in answers)
    status = Status.STUCK_FOR_EVER if stuck else Status.REACHED_HORIZON
    return arithmetic, status, first, tuple(events), motion
