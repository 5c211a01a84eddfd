"""A box |f_i| <= b_i in parts that neither springs nor dampers couple: each moves by itself, as if there were no other.

A part of one axis is a pair of the paper, solved by the line's engines; a larger one is a box with fewer axes. The
events of all parts make one list, a mode is a word of + 0 -. Parts with the same data, or mirrored ones, have their
events at one time, exactly, and so have those that one change of force or of friction lets go; where others may be at
one time the precision is raised.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball, exact_middle
from numerics.errors import EventUndecided, InvalidScene
from numerics.plane.linear import SIGNS
from numerics.plane.motion import PlaneEvent, PlaneState, Working
from numerics.plane.reduced import reduced
from numerics.plane.system import System
from numerics.plane.vector import Vector, exact
from numerics.scene import Friction, Pair, Scene, State
from numerics.scene.plane import PlanePair, PlaneScene
from numerics.trajectory.status import Status

LETTERS = {sign: letter for letter, sign in SIGNS.items()}


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
    """The motions of all parts as one, at any time: `answers` of each, and the sign -1 of a mirrored one."""

    def __init__(self, scene: PlaneScene, alone: Callable[[Scene | PlaneScene], Any]) -> None:
        """Take what `alone` answers for each part; of parts with the same data, or mirrored ones, once."""
        self.axes, self.x2, solved = scene.pair.parts, scene.x2, dict[Any, Any]()
        self.answers, self.signs = list[Any](), list[int]()
        for axes in self.axes:
            part, mirrored = (part_scene(scene, axes, sign) for sign in (1, -1))
            sign, known = (-1, mirrored) if mirrored in solved else (1, part)
            if known not in solved:
                solved[known] = alone(known)
            self.answers.append(solved[known])
            self.signs.append(sign)

    def at(self, t: Any) -> PlaneState:
        """Return the state at a time."""
        rows = np.empty((4, len(self.x2)), dtype=object)
        for axes, one, sign in zip(self.axes, self.answers, self.signs, strict=True):
            rows[:, axes] = one.sol(t).reshape(4, -1) * sign
        x1, v1, x2, v2 = map(Vector, rows)
        return PlaneState(x1, v1, x2 + exact(self.x2), v2)

    def put(self, word: str, k: int, mode: Any) -> str:
        """Return the word of all axes after one with the mode of a part."""
        found = [*word]
        for axis, letter in zip(self.axes[k], mode if isinstance(mode, str) else LETTERS[mode.sign], strict=True):
            found[axis] = LETTERS[SIGNS[letter] * self.signs[k]]
        return "".join(found)


Run = tuple[Working, Status, str, tuple[PlaneEvent, ...], Parts]
"""What a PlaneTrajectory is made of: how the run ended, the mode at t = 0, the events, and any time."""


def joined(scene: PlaneScene, alone: Callable[[Scene | PlaneScene], Any], most: int) -> Run:
    """Return the motions of the parts, which `alone` solves in balls, as one. Raises EventUndecided, InvalidScene."""
    motion = Parts(scene, alone)
    if not all(one.success for one in motion.answers):
        raise InvalidScene(f"a part of the box has more than {most} events; raise the cap max_events")
    stuck = all(one.status is Status.STUCK_FOR_EVER for one in motion.answers)
    arithmetic, word = Working(2 * max(one.arithmetic.digits for one in motion.answers)), "0" * scene.pair.axes
    for k, one in enumerate(motion.answers):
        word = motion.put(word, k, one.modes[0])
    with arithmetic.context():
        events = _events(motion, System(reduced(scene)[-1], arithmetic.digits), word)
    return arithmetic, Status.STUCK_FOR_EVER if stuck else Status.REACHED_HORIZON, word, events, motion


def _events(motion: Parts, system: System, word: str) -> tuple[PlaneEvent, ...]:
    """Return the events of all parts in order, those at one time as one. Raises EventUndecided."""
    starts, groups = [one.acting.start for one in system.pieces], dict[Any, list[tuple[int, Any]]]()
    for k, answer in enumerate(motion.answers):
        for event in answer.events:
            groups.setdefault(_exact_time(event, starts) or (id(answer), event.t.mid()), []).append((k, event))
    order = sorted(groups.items(), key=lambda one: float(one[1][0][1].t.mid()))
    for (_, before), (_, after) in pairwise(order):
        if before[0][1].t.overlaps(t := after[0][1].t):
            digits = max(one.arithmetic.digits for one in motion.answers)
            raise EventUndecided("which axis has its event first", str(t.str(6)), digits)
    found = []
    for key, group in order:
        t, old, cause = group[0][1].t, word, "guard"
        for k, event in group:
            word, cause = motion.put(word, k, event.after), "jump" if "jump" in (cause, event.cause) else cause
        y, signs = motion.at(t), Vector(arb(SIGNS[one]) for one in word)
        times = [key] if isinstance(key, Fraction) else [exact_middle(t.lower()), exact_middle(t.upper())]
        loads = [_load(system, y, t, sum(one <= when for one in starts[1:])) for when in times]
        load = Vector(x.union(y) for x, y in zip(loads[0], loads[-1], strict=True))
        found.append(PlaneEvent(t, old, word, y, signs / (signs @ signs).max(arb(1)).sqrt(), load, cause))
    return tuple(found)


def _exact_time(event: Any, starts: Sequence[Fraction]) -> Fraction | None:
    """Return the time of an event as a number, of one that a change brings about or that is known so well."""
    at = [one for one in starts if event.t.overlaps(Ball.number(one))] if event.cause == "jump" else []
    return at[0] if len(at) == 1 else exact_middle(event.t) if event.t.is_exact() else None


def _load(system: System, y: PlaneState, t: arb, piece: int) -> Vector:
    """Return the load at t, N, by the force of a piece."""
    drive = system.pieces[piece]
    return system.load(drive.force(t - Ball.number(drive.acting.start)), Vector(y.x1), Vector(y.v1))
