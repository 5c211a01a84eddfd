"""Section IV-B, Fig. 5 (a): the velocities for b = 0.05: decay of v1, saw tooth of v2, time of synchronisation."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import sympy as sp
from flint import arb

from numerics.linear.modes import Mode
from numerics.scene import Law
from paper_checks.checks.registry import Context, check
from paper_checks.engines.enclosure import compare, itinerary, rounded, solved, stuck_for_ever, within
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, Subject
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.steps.velocity_peaks import SLIPS, decrements, peak_after_adhesion, velocities_scene
from theory.model import slip
from theory.symbols import a2, b, free, m1, m2, undamped, v1, x1


@check("constant-damping-rate")
def damping_rate(context: Context, friction: Fraction | None = None) -> Finding:
    """Enclose the positive peaks of v1 and what each cycle takes from them."""
    scene = velocities_scene(friction)
    run = solved(scene)
    peaks, lost = decrements(run)
    with run.arithmetic.context():
        linear = 4 * run.arithmetic.number(scene.pair.b) / run.arithmetic.number(scene.pair.a2 * scene.pair.m1).sqrt()
        spread = (lost[0] - lost[-1]) / linear
        seventh = abs(lost[6] / linear - 1)
        ratios = peaks[1] / peaks[0], peaks[-1] / peaks[-2]
        late = (peaks[-1] - peak_after_adhesion(run)) / linear
    falling = all(after < before for before, after in pairwise(lost))
    return conclude(
        Verdict.HOLDS_CORRECTED,
        f"The loss per cycle is nearly constant, not exactly, and only while the pair slips. The {len(peaks)} positive peaks of $v_1$ before the first adhesion fall "
        f"by {_milli(lost[0])}, {_milli(lost[1])}, ..., {_milli(lost[-2])}, {_milli(lost[-1])} mm/s: never twice by the same, each "
        f"time by less. The first seven decrements are within 1 % of $4b/\\sqrt{{a_2m_1}}={_milli(linear)}$ mm/s per cycle, which Coulomb "
        "friction takes from an oscillator; the nine spread by 7 %. From the first adhesion on the peaks creep to $L\\Omega=5$ "
        f"mm/s, and no rate is constant. (Under (11)–(12) read literally nothing is damped after the first contact, at {first_contact(friction)} s.)",
        replace(
            compare("the decrements fall from cycle to cycle; the last is below the first", lost[-1], "<", lost[0]),
            passed=falling,
            cases=len(lost),
            about=Subject.COUNTEREXAMPLE,
        ),
        compare(
            "after the first adhesion the decrement is below half of $4b/\\sqrt{a_2m_1}$ (ratio shown)",
            late,
            "<",
            arb("0.5"),
        ).as_counterexample(),
        *(item.as_correction() for item in _linear_decay(context)),
        within("first decrement over $4b/\\sqrt{a_2m_1}$", lost[0] / linear, "0.99", "1").as_correction(),
        within("seventh decrement: relative distance from it", seventh, "0", "0.01").as_correction(),
        within("spread of the nine decrements over it", spread, "0.068", "0.069").as_correction(),
        within("not exponential: ratio of the first two peaks", ratios[0], "0.89", "0.90").as_correction(),
        within("and of the last two", ratios[1], "0.43", "0.44").as_correction(),
        corrected=claim_named("constant-damping-rate").corrected,
        counterexample="The paper's own: $m_1=m_2=1$, $a_2=200$, $b=0.05$, $\\dot x_1(0)=0.15$; the enclosures of the first and the "
        "last decrement are disjoint.",
        derivation=(
            "In slip $x_1$ turns about $\\mp b/a_2$ with a constant amplitude $A$; at a crossing the centre jumps by $2b/a_2$: "
            "$$A_-^2-A_+^2=-\\frac{4b}{a_2}x_1,\\qquad A_+-A_-=\\frac{2b}{a_2}\\cdot\\frac{2x_1}{A_++A_-}.$$",
            "Were $v_1=0$ at the crossings, $2x_1=A_++A_-$ and each cycle would take exactly $4b/a_2$ of amplitude, "
            "$4b/\\sqrt{a_2m_1}$ of $v_1$. But the pair crosses at $v_1=v_2\\neq 0$, so it takes less, and the less the smaller "
            "the amplitude.",
        ),
        figure="velocities",
    )


def _milli(value: arb) -> str:
    """Return a speed in mm/s, as text of the digits that are right."""
    return str((1000 * value).str(6, radius=False))


def _linear_decay(context: Context) -> tuple[Evidence, ...]:
    """Return the centre of oscillation in each slip, and what the jump of the centre does to the squared amplitude."""
    force = [undamped(free(slip(sign).acceleration1)) for sign in (1, -1)]
    squares = [(x1 + sign * b / a2) ** 2 + m1 / a2 * v1**2 for sign in (1, -1)]
    return (
        identity(
            "in slip$\\pm$ $\\ddot x_1=-\\frac{a_2}{m_1}(x_1\\pm b/a_2)$",
            sp.Matrix(force),
            sp.Matrix([-a2 / m1 * (x1 + sign * b / a2) for sign in (1, -1)]),
            seed=context.seed,
        ),
        identity(
            "at a crossing the squared amplitude changes by $-4bx_1/a_2$",
            squares[1] - squares[0],
            -4 * b * x1 / a2,
            seed=context.seed,
        ),
    )


@check("saw-tooth")
def saw_tooth(context: Context, friction: Fraction | None = None) -> Finding:
    """Show that v2 has the slopes +b and -b in turn up to the first adhesion."""
    run = solved(velocities_scene(friction))
    slopes = sp.Matrix([free(slip(sign).acceleration2) for sign in (1, -1)])
    return conclude(
        Verdict.HOLDS,
        f"Up to the first adhesion, at {rounded(run.events[len(SLIPS) - 1].t, 4)} s, $v_2$ consists of 21 straight pieces of slopes exactly $+b$ and $-b$ in turn: ten "
        "teeth and a last rise. After it the teeth go on, rounded where the bodies stick and straight where they slip. (Under "
        f"(11)–(12) read literally there is one rise only, up to the first contact at {first_contact(friction)} s.)",
        carried(
            "slopes",
            identity(
                "in slip$\\pm$ $\\ddot x_2=\\pm b/m_2$, at every instant",
                slopes,
                sp.Matrix([b / m2, -b / m2]),
                seed=context.seed,
            ),
            itinerary("slip+ and slip- in turn, 21 pieces, then stick", run, (*SLIPS, Mode.STICK)),
            within("first adhesion (s)", run.events[len(SLIPS) - 1].t, "4.549769", "4.549770"),
        ),
        *literal_reading(friction),
        derivation=("$$\\ddot x_2=\\frac{b}{m_2}\\,\\mathrm{sgn}(\\dot z)=\\pm 0.05\\ \\mathrm{m/s^2}$$",),
        figure="velocities",
    )


def first_contact(friction: Fraction | None) -> str:
    """Return the time of the first contact under (11), (12) read literally, s, as a decimal."""
    return rounded(solved(replace(velocities_scene(friction), law=Law.THREE_VALUED_SGN)).events[0].t, 4)


def literal_reading(friction: Fraction | None) -> tuple[Evidence, ...]:
    """Return what (11), (12) read literally do from the same start."""
    run = solved(replace(velocities_scene(friction), law=Law.THREE_VALUED_SGN))
    return (
        itinerary("(11), (12) read literally: slip+, then stick", run, (Mode.SLIP_PLUS, Mode.STICK)),
        stuck_for_ever("and that stick lasts for ever", run),
        within("from the first contact on, at (s)", run.events[0].t, "0.106886", "0.106887"),
    )
