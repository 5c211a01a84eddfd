"""Where forward Euler misleads, and by how much: counted in its runs and judged as in the trade, no time measured.

A run is held against the same scene in balls by `judge`: its event sequence as its user would read it (euler_peer), its
error as the largest of final state (relative to L and L Omega), last event's time and dissipated energy.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

import numpy as np

from numerics.scene import Scene, State
from numerics.scene.file import load_scene
from numerics.trade.comparisons.euler_peer import read
from numerics.trade.comparisons.forward_euler import forward_euler
from numerics.trade.comparisons.switching import SwitchedPair
from numerics.trade.contender import peer_outcome
from numerics.trade.judge import judge
from numerics.trade.outcome import Outcome
from numerics.trade.reference import POINT_DIGITS, proved

STEPS = (1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5)
"""The steps that are tried, s."""
STUCK_STEPS = (1e-2, 1e-3, 1e-4, 1e-5)
"""The steps whose energy in stick is measured, s."""
STUCK = "start-at-6mm-literal"
"""Stuck for ever under the law read literally: forward Euler then holds v1 = v2 exactly."""
NUDGE = Fraction(1, 10**9)
"""m/s between the bodies: enough for forward Euler to chatter instead."""


@dataclass(frozen=True)
class EulerOutcome:
    """One run of a step: whether its events are right, its error, and how often it chatters."""

    step: float
    right: bool
    difference: str | None
    error: float
    """log10"""
    chatter: int
    """sign changes of v1 - v2 within the sliding region, each of them a stick that was not held"""


@dataclass(frozen=True)
class EulerFigure:
    """What forward Euler makes of one figure with smaller and smaller steps, over the shipped horizon (s)."""

    figure: str
    events: int
    """of the exact solution"""
    until: float
    outcomes: tuple[EulerOutcome, ...]

    @property
    def right_from(self) -> float | None:
        """Return the largest tried step from which on all have the event sequence right; None if the last has not."""
        return _from_here([one.step for one in self.outcomes], [one.right for one in self.outcomes])

    def step_for(self, error: float) -> tuple[float | None, bool]:
        """Return the step for an error (not its logarithm) with right events, and whether it was tried.

        A step that was not tried is extrapolated from the finest, with the method's order: the error is as the step.
        None where even the finest has other events: then nothing is known.
        """
        good = [one.right and one.error <= math.log10(error) for one in self.outcomes]
        tried = _from_here([one.step for one in self.outcomes], good)
        if tried is not None:
            return tried, True
        last = self.outcomes[-1]
        if not last.right:
            return None, False
        return last.step * min(1.0, error / 10**last.error), False


def _from_here(steps: Sequence[float], good: Sequence[bool]) -> float | None:
    kept = None
    for step, one in zip(reversed(steps), reversed(good), strict=True):
        if not one:
            break
        kept = step
    return kept


def euler_figure(figure: str, scene: Scene, steps: Sequence[float] = STEPS) -> EulerFigure:
    """Return what forward Euler makes of a scene with these steps (s), from coarse to fine."""
    truth = proved(scene)
    outcomes = tuple(_outcome(scene, step, truth) for step in steps)
    return EulerFigure(figure, len(truth.kinds), float(scene.until), outcomes)


def _outcome(scene: Scene, step: float, truth: Outcome) -> EulerOutcome:
    with np.errstate(over="ignore", invalid="ignore"):
        run = forward_euler(scene, step)
        found = judge(peer_outcome(read(SwitchedPair.of(scene), run)), truth, POINT_DIGITS, scene)
    return EulerOutcome(step, found.right, found.difference, found.error or 0.0, run.chatter)


@dataclass(frozen=True)
class StickEnergy:
    """What a stuck pair's energy becomes by the shipped horizon, as a multiple of itself; exactly it stays 1."""

    step: float
    """s"""
    until: float
    """the horizon, s"""
    held: float
    """where v1 = v2 holds exactly"""
    theory: float
    """(1 + (step Omega)^2)^steps, what it should be there"""
    chattering: float | None
    """within the sliding region with v1 - v2 = NUDGE at first: friction takes back what it can; None if it slips out"""
    chatter: int


@cache
def stick_energies() -> tuple[StickEnergy, ...]:
    """Return the energy of the stuck pair for all steps; a second, once a process."""
    return tuple(stick_energy(step) for step in STUCK_STEPS)


def stick_energy(step: float) -> StickEnergy:
    """Return what forward Euler with this step (s) does to the energy of a stuck pair."""
    stuck = load_scene(STUCK)
    held = forward_euler(stuck, step)
    steps = len(held.t) - 1
    theory = (1 + step**2 * float(stuck.pair.a2 / stuck.pair.mass)) ** steps
    # well within the region, so that a pair that gains little energy stays in it
    start = State(x1=stuck.pair.half_width / 2, v1=NUDGE)
    loose = forward_euler(replace(load_scene("start-at-6mm"), initial=start), step)
    out = bool(np.any(np.abs(loose.y[0]) > float(stuck.pair.half_width)))
    ratio = None if out else float(loose.energy[-1] / loose.energy[0])
    return StickEnergy(step, float(stuck.until), float(held.energy[-1] / held.energy[0]), theory, ratio, loose.chatter)
