"""Where forward Euler misleads, and by how much: its runs are computed and judged as in the trade, no time is measured."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import takewhile
from typing import NamedTuple

from numerics.linear.exact_start import mode_at_start
from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.trade.forward_euler import forward_euler, read
from numerics.trade.judge import judge, proved
from paper_checks.report.content.blocks import Block, Paragraph, Table
from paper_checks.report.content.phrases import listed

STEPS = (1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5)
"""The steps that are tried, s."""
SCENES = {
    "4 (a)": "start-at-6mm",
    "4 (b), and 5 (b) with b = 0.5 N": "start-with-speed",
    "5 (a), and 5 (b) with b = 0.05 N": "velocities",
    "5 (b) with b = 0.2 N": "relative-motion-b02",
    "3 (a)": "itinerary-that-merges",
    "3 (b)": "itinerary-that-creeps",
}
"""The shipped scene that a figure of the paper shows."""
STUCK = "start-at-6mm-literal"
"""Stuck for ever under the law read literally: forward Euler then holds v1 = v2 exactly."""


class Outcome(NamedTuple):
    """One run of a step (s): the digits of its worst error, -1 where an event is wrong; and how often it chatters."""

    step: float
    digits: float
    chatter: int
    """Sign changes of v1 - v2 within the sliding region, each of them a stick that was not held."""


@cache
def outcomes(scene: Scene, steps: Sequence[float] = STEPS) -> list[Outcome]:
    """Return what forward Euler makes of a scene with these steps (s), from coarse to fine."""
    truth, first, found = proved(scene), mode_at_start(scene).sign, []
    for step in steps:
        run = forward_euler(scene, step)
        verdict = judge(read(first, run), truth)
        digits = min(one for one in (verdict.time_digits, verdict.state_digits) if one is not None)
        found.append(Outcome(step, -1 if verdict.note else max(0, digits), run.chatter))
    return found


def right_from(found: Sequence[Outcome], digits: float = 0) -> str:
    """Return the largest step from which on all events are right, with so many digits; or that none was fine enough."""
    good = list(takewhile(lambda one: one.digits >= digits, reversed(found)))
    return f"{good[-1].step:g}" if good else "finer than tried"


def stick_energy(step: float) -> tuple[float, float]:
    """Return the energy of the stuck pair at its horizon as a multiple of itself, exactly 1, and what it should be.

    In stick every step of forward Euler multiplies it by 1 + (step Omega)^2.
    """
    scene = load_scene(STUCK)
    energy = forward_euler(scene, step).energy
    theory = (1 + step**2 * float(scene.pair.a2 / scene.pair.mass)) ** (len(energy) - 1)
    return float(energy[-1] / energy[0]), theory


def blocks() -> Iterator[Block]:
    """Yield the energy that forward Euler makes in stick, and the steps that each figure needs; takes seconds."""
    energies = [
        "{:.4g} (by theory {:.4g}) with {:g} s".format(*stick_energy(step), step) for step in (1e-2, 1e-3, 1e-4)
    ]
    yield Paragraph(
        "A stuck pair conserves its energy exactly. Where forward Euler holds $v_1=v_2$, each step $h$ multiplies it by $1+(h\\Omega)^2$: in Fig. 4 (a), "
        f"over the whole run, by {listed(energies)}. Elsewhere it does not stick but chatters: $v_1-v_2$ changes its sign back and forth within the "
        f"sliding region. Steps from {STEPS[0]:g} to {STEPS[-1]:g} s were tried; a step counts only if all finer ones are right too."
    )
    figures = {name: outcomes(load_scene(scene)) for name, scene in SCENES.items()}
    yield Table(
        ("figure", "right events from", "error of 1 %", "error of $10^{-3}$", "sign changes, coarsest", "finest"),
        tuple(
            (f"Fig. {name}", *(right_from(some, n) for n in (0, 2, 3)), *(f"{some[k].chatter:,}" for k in (0, -1)))
            for name, some in figures.items()
        ),
        "The step (s) that forward Euler needs, and its sign changes within the sliding region",
    )
