"""Where forward Euler misleads, and by how much: counted in its runs and judged as in the trade, no time measured."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile
from typing import NamedTuple

import numpy as np

from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.trade.comparisons.forward_euler import forward_euler, read
from numerics.trade.comparisons.switched import SwitchedPair
from numerics.trade.judge import judge, proved

STEPS = (1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5)
"""The steps that are tried, s."""
STUCK = "start-at-6mm-literal"
"""Stuck for ever under the law read literally: forward Euler then holds v1 = v2 exactly."""


class EulerOutcome(NamedTuple):
    """One run of a step (s): whether its events are right, the digits of its worst error, and how often it chatters."""

    step: float
    right: bool
    digits: float
    chatter: int
    """Sign changes of v1 - v2 within the sliding region, each of them a stick that was not held."""


class EulerFigure(NamedTuple):
    """What forward Euler makes of a scene with smaller and smaller steps, and how many events it has exactly."""

    events: int
    outcomes: tuple[EulerOutcome, ...]

    def right_from(self, digits: float = -np.inf) -> float | None:
        """Return the largest step from which on all have right events and so many digits; None if the last has not."""
        good = list(takewhile(lambda one: one.right and one.digits >= digits, reversed(self.outcomes)))
        return good[-1].step if good else None


def euler_figure(scene: Scene, steps: Sequence[float] = STEPS) -> EulerFigure:
    """Return what forward Euler makes of a scene with these steps (s), from coarse to fine."""
    truth, first, outcomes = proved(scene), SwitchedPair(scene).mode, []
    for step in steps:
        run = forward_euler(scene, step)
        found = judge(read(first, run), truth, scene)
        digits = -np.inf if found.digits is None else found.digits
        outcomes.append(EulerOutcome(step, found.difference is None, digits, run.chatter))
    return EulerFigure(len(truth.times), tuple(outcomes))


def stick_energy(step: float) -> tuple[float, float]:
    """Return the energy of the stuck pair at its horizon as a multiple of itself, exactly 1, and what it should be.

    In stick every step of forward Euler multiplies it by 1 + (step Omega)^2.
    """
    scene = load_scene(STUCK)
    energy = forward_euler(scene, step).energy
    theory = (1 + step**2 * float(scene.pair.a2 / scene.pair.mass)) ** (len(energy) - 1)
    return float(energy[-1] / energy[0]), theory
