"""Where forward Euler misleads and by how much: the words and tables on numerics.trade.euler."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import isinf

from numerics.trade.euler import NUDGE, EulerFigure, StickEnergy
from numerics.trade.table import error_text
from paper_checks.report.content.blocks import Block, Paragraph, Table
from paper_checks.speed.wording import listed, step_text


def forward_euler(figures: Sequence[EulerFigure], energies: Sequence[StickEnergy]) -> Iterator[Block]:
    """Yield the energy that forward Euler makes in stick, its chatter, and the step that each figure needs."""
    if energies:
        yield from _energy(energies)
    if figures:
        yield from _steps(figures)
        yield from _chatter(figures)


def _energy(energies: Sequence[StickEnergy]) -> Iterator[Block]:
    # the method's own arithmetic is rounded in every step, so the two agree to about steps times 1e-16
    far = [one for one in energies if abs(one.held / one.theory - 1) > 1e-8]
    agreement = (
        f"but not with steps of {listed([step_text(one.step) for one in far])} s" if far else "in every run below"
    )
    text = (
        "Exactly, a stuck pair keeps its energy. Where forward Euler holds $v_1=v_2$, its energy grows by the factor "
        f"$1+(h\\Omega)^2$ in each step $h$, by theory and, to 8 digits, {agreement}."
    )
    ratios = [one.chattering for one in energies if one.chattering is not None]
    if ratios:
        text += (
            f" Where $v_1$ and $v_2$ at first differ by {step_text(float(NUDGE))} m/s it chatters instead, and the "
            f"friction of the chatter takes energy back: the ratio is then between {min(ratios):.5f} and {max(ratios):.5f}. So an energy that looks right does not "
            "mean that the run is."
        )
    yield Paragraph(text)
    rows = tuple(
        (
            step_text(one.step),
            f"{one.held:.6g}",
            f"{one.theory:.6g}",
            "slips out" if one.chattering is None else f"{one.chattering:.6f}",
            f"{one.chatter:,}",
        )
        for one in energies
    )
    until = f"{energies[0].until:g}"
    ratio = f"$E({until})/E(0)$"
    yield Table(
        ("step (s)", f"{ratio}, $v_1=v_2$ held", "by theory", f"{ratio} in chatter", "sign changes"),
        rows,
        f"The pair of Fig. 4 (a), stuck for {until} s: exactly the ratios are 1 and there are no sign changes",
    )


def _steps(figures: Sequence[EulerFigure]) -> Iterator[Block]:
    tried = figures[0].outcomes
    yield Paragraph(
        f"Steps from {step_text(tried[0].step)} to {step_text(tried[-1].step)} s were tried over each figure's time; a step counts only if all "
        "finer ones are right too. An error is the worst of final state (in units of $L$ and $L\\Omega$), last event "
        "and dissipated energy. “About” marks a step finer than all that were tried: the error is taken to shrink with the step."
    )
    rows = tuple(
        (
            f"Fig. {one.figure}",
            f"{one.events} in {one.until:g} s",
            "none tried" if one.right_from is None else step_text(one.right_from),
            _need(one.step_for(1e-2)),
            _need(one.step_for(1e-3)),
            _error(one.outcomes[-1].error),
        )
        for one in figures
    )
    head = ("figure", "events", "right events from", "error of 1 %", "error of $10^{-3}$", "error at the finest")
    yield Table(head, rows, "The step (s) that forward Euler needs")


def _error(log10: float) -> str:
    """Return an error from its decimal logarithm, to one digit."""
    return error_text(log10) if isinf(log10) else step_text(float(error_text(log10)))


def _need(found: tuple[float | None, bool]) -> str:
    step, tried = found
    if step is None:
        return "not known"
    return step_text(step) if tried else f"about {step_text(step)}"


def _chatter(figures: Sequence[EulerFigure]) -> Iterator[Block]:
    steps = sorted({one.step for figure in figures for one in figure.outcomes}, reverse=True)
    shown = [step for step in steps if f"{step:e}".startswith(("1.0", "2.0"))]
    none = [
        f"Fig. {figure.figure} up to {step_text(min(missed))} s"
        for figure in figures
        if (missed := [one.step for one in figure.outcomes if one.chatter == 0])
    ]
    yield Paragraph(
        "Forward Euler does not stick. It chatters: within the sliding region the sign of $v_1-v_2$ changes back and "
        "forth, where the exact solution keeps $v_1-v_2=0$."
        + (" Finer steps give more chatter, not less." if all(map(_grows, figures)) else "")
        + (f" Runs that never chatter have missed every phase of stick: {listed(none)}." if none else "")
    )
    rows = tuple((f"Fig. {figure.figure}", *(_count(figure, step) for step in shown)) for figure in figures)
    yield Table(
        ("figure", *(f"{step_text(step)} s" for step in shown)),
        rows,
        "Sign changes within the sliding region, by step; a cross marks wrong events",
    )


def _grows(figure: EulerFigure) -> bool:
    counts = [one.chatter for one in figure.outcomes]  # from coarse to fine steps
    return all(one <= other for one, other in pairwise(counts))


def _count(figure: EulerFigure, step: float) -> str:
    one = next((one for one in figure.outcomes if one.step == step), None)
    return "–" if one is None else f"{one.chatter:,}" + ("" if one.right else " ×")
