"""The three findings of most consequence: what the paper says, what is true, one number and what to see."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache

import sympy as sp

from numerics.linear.modes import Mode
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trajectory.trajectory import Trajectory
from paper_checks.claims.letters import ECR, RATE
from paper_checks.decide.exhibit import value_at
from paper_checks.drawing.captions import caption
from paper_checks.drawing.relative_velocity import PRINTED
from paper_checks.drawing.sharp_rate import LAST, limit_of
from paper_checks.evidence.formula import latex
from paper_checks.report.content.blocks import Picture, Result
from theory.symbols import a2, m1, m2


def _start_at_6mm() -> Result:
    scene = load_scene("start-at-6mm")
    pair, start = scene.pair, scene.initial.x1
    needed = pair.m2 * pair.a2 / pair.mass * start
    return Result(
        f"Fig. 4 (a): from {_decimal(start)} m the pair slips at once",
        "start-at-6mm-sticks",
        "Section IV, Fig. 4 (a)",
        f"with $x_1(t_0)={_decimal(start)}$ the system (11), (12) starts in the stiction mode and remains in this mode at all times.",
        f"that start lies outside the sliding region, which ends at $L={_decimal(pair.half_width)}$ m. Friction cannot hold body 2 "
        "there, so the pair slips at once. The stuck motion solves only the reduced equations (11), (12), which leave out that "
        "friction is limited.",
        f"{_decimal(needed)} N",
        f"are needed to carry body 2 along; friction gives at most {_decimal(pair.b)} N.",
        _picture("force-needed"),
    )


def _synchronisation() -> Result:
    run, printed = _velocities(), _decimal(Fraction(str(PRINTED)))
    _, v1, _, v2 = run.sol(PRINTED)
    slip, start = abs(float(v1 - v2)), float(run.scene.initial.v1)
    entries = [float(event.t) for event in run.events if event.after is Mode.STICK]
    leaves = next(float(event.t) for event in run.events if event.before is Mode.STICK)
    return Result(
        f"Fig. 5 (a): at {printed} s the bodies do not synchronise",
        "synchronisation-time",
        "Section IV, Fig. 5 (a)",
        f"both bodies synchronize as $\\dot z$ approaches zero at the time $t\\approx {printed}$ sec.",
        f"they stick first at {entries[0]:.4f} s, for {leaves - entries[0]:.2f} s. At {printed} s they slip again; from "
        f"{entries[1]:.4f} s they stick once more, and so on for ever. No time of lasting synchronisation exists.",
        f"{1000 * slip:.2f} mm/s",
        f"is their relative velocity at {printed} s, {100 * slip / start:.1f} % of the initial speed.",
        _picture("relative-velocity"),
    )


def _rate() -> Result:
    scene = load_scene("start-with-speed")
    pair, limit = scene.pair, limit_of(scene.pair)
    until = float(limit) / float(scene.energy_excess * pair.critical_energy)
    return Result(
        "Section III: the energy approaches its limit at one sharp rate",
        "sharp-rate-constant",
        "Section III",
        "the energy lies between $E_{cr}+c_1/t$ and $E_{cr}+c_2/t$, with constants that depend on $E(0)$ (row `rate-one-over-t`).",
        "near $t=0$ the lower bound is false: $E$ never exceeds $E(0)$, and $E_{cr}+c_1/t$ does. For the pair of Fig. 4 (b), with the "
        f"limit below as $c_1$, it does up to {1000 * until:.3g} ms. Later more is true: unless "
        "the pair merges with a periodic orbit, $t\\,(E-E_{cr})$ has "
        "a limit, and it does not depend on $E(0)$ at all: "
        f"$\\lim_{{t\\to\\infty}} t\\,(E-E_{{cr}})={_rate_in_words()}$.",
        f"{1000 * float(limit):.4g} mJ s",
        f"is that limit for the pair of Fig. 4 (b); the picture follows it to $10^{{{LAST}}}$ s.",
        _picture("sharp-rate"),
    )


HIGHLIGHTS: dict[str, Callable[[], Result]] = {
    "start-at-6mm-sticks": _start_at_6mm,
    "synchronisation-time": _synchronisation,
    "sharp-rate-constant": _rate,
}
"""The findings of most consequence, by the row that decides each."""


def _picture(name: str) -> Picture:
    title, text = caption(name)
    return Picture(name, text, title)


@cache
def _velocities() -> Trajectory:
    return solve(load_scene("velocities"), digits=12, arithmetic="ball")


def _decimal(value: Fraction) -> str:
    return value_at(sp.Rational(value.numerator, value.denominator), {})


def _rate_in_words() -> str:
    """Return LaTeX of the limit, its factors as a reader expects them: a number, masses, a time, E_cr."""
    masses, total, stiffness = m1 / m2, sp.Symbol("M"), sp.Symbol("a_2")
    number = sp.simplify(RATE / ECR / masses / sp.sqrt((m1 + m2) / a2))
    time = latex(sp.sqrt(total / stiffness)).replace("M", "m_1+m_2")
    return r"\,".join((latex(number), latex(masses), time, latex(ECR)))
