"""The report's chapter on the pair under a force: what is proved, in the numbers and the pictures of one pair.

Its formulas are those of the rows, its numbers are enclosed; its pictures stand in `paper_checks.drawing.under_a_force`.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from flint import arb

from numerics.control.response import response
from numerics.control.ring import ring_entry
from numerics.control.thresholds import thresholds
from numerics.control.tracking import track
from numerics.control.transfer import fastest_transfer
from numerics.scene import Pair
from numerics.scene.file import load_reference, load_scene
from paper_checks.decide.enclosure import rounded
from paper_checks.drawing import under_a_force as drawing
from paper_checks.report.content.blocks import Block, Heading, Paragraph, Section, Table
from paper_checks.report.content.phrases import formula, picture
from theory.forced import breaking_damping
from theory.forced_response import harmonic_amplitude, multiple, resonant_amplitude
from theory.symbols import b, m1, m2, v1

ID, TITLE = "under-a-force", "Under a force"
FREQUENCIES = (6, 9, 12, 20, 40)
"""Frequencies, rad/s, at which both thresholds are listed."""
SPEED = sp.Rational("0.03")
"""A velocity, m/s, with which the stuck pair passes its rest position."""


def section() -> Section:
    """Return the whole chapter."""
    parts = (_model, _regimes, _resonance, _tracking, _transfer, _ring, _drift, _jump, _damping)
    return Section(ID, TITLE, tuple(block for part in parts for block in part()))


PICTURED = {
    "entrainment-threshold": "thresholds-over-frequency",
    "forced-resonance-bound": "resonance",
    "trackable-references": "tracked-reference",
    "minimum-transfer-time": "fastest-transfer",
    "cheapest-transfer": "cheapest-transfer",
    "tolerance-ring": "tolerance-ring-of-a-scene",
    "ring-of-tolerance": "tolerance-ring-of-a-scene",
}
"""The figure of the chapter that a claim shows too, by the claim's id."""


def _formula(row: str, clause: str, name: str) -> str:
    """Return a formula of a row, displayed."""
    return f"$${formula(row, clause, name)}$$"


def _of(pair: Pair) -> dict[sp.Symbol, sp.Rational]:
    known = {m1: pair.m1, m2: pair.m2, b: pair.b}
    return {one: sp.Rational(value.numerator, value.denominator) for one, value in known.items()}


def _digits(value: sp.Expr) -> str:
    return str(sp.N(value, 5))


def _model() -> Iterator[Block]:
    pair = drawing.PAIR
    yield Paragraph(
        "The equations (2) to (4) have a force $u(t)$ on body 1, and the paper leaves it to future work. This chapter states what is "
        f"proved of it here. Its examples are the pair of Section IV, $m_1={pair.m1}$ kg, $m_2={pair.m2}$ kg, $a_2={pair.a2}$ N/m, "
        f"$b={float(pair.b):g}$ N. Every number below is computed with a proved error."
    )
    yield Paragraph(
        "One number decides what the pair does: the load, the friction force that sticking would need. Inside the strip $|\\Lambda|\\leqslant b$ "
        "the pair can stick; a force moves that strip. On its edge the derivatives of the force decide (`forced-mode-rule`). Under a piecewise "
        "analytic force events do not accumulate (`forced-no-zeno`), and the flow is non-expansive in the energy norm (`forced-contraction`)."
        + _formula("forced-mode-rule", "modes", "load")
    )


def _regimes() -> Iterator[Block]:
    yield Heading("Stuck, in between, or without a stop", "regimes-under-a-sine")
    yield Paragraph(
        "Under $u=U\\sin\\omega t$ there are three regimes (`entrainment-threshold`). Up to $U_*$ a motion that "
        "sticks permanently exists. Below $U_{**}$ none slips without a stop, one way for half a period and then the other way; from $U_{**}$ on one does "
        "if $\\dot z$ keeps its sign between the turns. For $a_1=0$ and $\\omega>\\omega_1$ it always does; else it does from some amplitude on, which may "
        "lie above $U_{**}$ (for $a_1=0$ unless $\\omega_1$ is an odd multiple of $\\omega$). With a damper every motion tends to one (`forced-periodic-response`): "
        "to one of these two, or in between to one that slips, and sticks or reverses more than twice, in each period."
        + _formula("entrainment-threshold", "stuck", "threshold")
        + _formula("entrainment-threshold", "non-stop-undamped", "threshold")
    )
    yield Table(
        (
            "$\\omega$ (rad/s)",
            *(f"${letter}$ (N), $a_1={float(pair.a1):g}$ N s/m" for pair in PAIRS for letter in ("U_*", "U_{**}")),
        ),
        tuple(_thresholds(rate) for rate in FREQUENCIES),
        "Both thresholds at some frequencies; the second formula is for $a_1=0$",
    )
    third = harmonic_amplitude().subs(multiple, 3)
    yield Paragraph(
        "Without a damper there is one exception. If the stuck pair's own frequency is $n=3,5,\\ldots$ times that of the force, a free oscillation can flatten the "
        f"peaks of the load, and the pair may stick up to an amplitude above $U_*$: for $n=3$ by the factor {_digits(third)}."
        + _formula("entrainment-threshold", "undamped", "harmonic")
    )
    yield picture("thresholds-over-frequency")


PAIRS = (drawing.PAIR, drawing.DAMPED)


def _thresholds(rate: int) -> tuple[str, ...]:
    found = [thresholds(pair, rate) for pair in PAIRS]
    return (str(rate), *(rounded(one, 4) for two in found for one in (two.entrainment, two.non_stop)))


def _resonance() -> Iterator[Block]:
    edge = resonant_amplitude().subs(_of(drawing.PAIR))
    yield Heading("Resonance", "at-resonance")
    yield Paragraph(
        "Friction takes energy out of a resonant oscillation, but only so much. Without a damper, a force with more than $4b/\\pi$ at the frequency of body 1 alone "
        f"makes every motion grow; with less, $x_1$ and both velocities stay bounded (`forced-resonance-bound`). For $b={float(drawing.PAIR.b):g}$ N that is "
        f"{_digits(edge)} N. The growth is at least" + _formula("forced-resonance-bound", "grows", "growth")
    )
    yield Paragraph(
        "With just as much, the rest of the force decides. If it has the period of that oscillation, every motion is bounded. A part at a fraction $r$ of its "
        "frequency makes friction turn a little early or late, and every motion grows as $t^{1/3}$:"
        + _formula("forced-resonance-bound", "one-part", "limit")
    )
    yield picture("resonance")


def _tracking() -> Iterator[Block]:
    found = track(load_scene("at-rest"), load_reference("s-curve"))
    yield Heading("What body 2 can follow", "what-body-2-can-follow")
    yield Paragraph(
        "Body 2 can follow a reference, from a suitable initial state of body 1, exactly if the reference never requires more acceleration than $b/m_2$ and starts with the position and the velocity of body 2 (`trackable-references`). A pair that "
        "sticks does it, under one force:" + _formula("trackable-references", "force", "force")
    )
    yield Paragraph(
        f"The reference in the picture requires {rounded(100 * found.share, 1)} % of the friction available."
    )
    yield picture("tracked-reference")


def _transfer() -> Iterator[Block]:
    found = fastest_transfer(load_scene("at-rest"), "0.001", amplitude="1.08")
    least = found.least_amplitude
    assert least is not None  # the half time is below a quarter turn of body 1
    yield Heading("The fastest transfer", "the-fastest-transfer")
    yield Paragraph(
        "No force, however strong, brings body 2 from rest to rest over a distance sooner than its friction allows (`minimum-transfer-time`):"
        + _formula("minimum-transfer-time", "least", "time")
    )
    yield Paragraph(
        f"Over 1 mm that is {rounded(1000 * found.bound, 2)} ms. A pair that sticks all the way needs a force of up to {rounded(found.stuck_amplitude, 4)} N. If body 1 "
        f"may slip ahead in the first half, {rounded(least, 4)} N are enough, and no smaller force arrives in time."
    )
    yield picture("fastest-transfer")
    yield Paragraph(
        "In a longer time the force can be cheaper. While the pair sticks, the least $\\int u^2\\,dt$ is known and proved (`cheapest-transfer`); without a "
        "damper, and below the limit of friction, it is" + _formula("cheapest-transfer", "undamped", "energy")
    )
    yield picture("cheapest-transfer")


def _ring() -> Iterator[Block]:
    found = ring_entry(load_scene("velocities"), "0.001", rate=20)
    yield Heading("The ring of Fig. 1", "the-ring")
    yield Paragraph(
        "The flow is non-expansive, so a tube around a motion is entered at most once and never left, and a ring that contains its image is not left after that "
        "(`tolerance-ring`). A ring needs its centre at a limit of the motion itself, if it has one: nothing acts on $x_1-x_2$ (`ring-of-tolerance`)."
        + _formula("tolerance-ring", "ring", "within")
    )
    yield Paragraph(f"The scene of Fig. 5 (a) enters the ring of 1 mm permanently at {rounded(found.entry, 4)} s.")
    yield picture("tolerance-ring-of-a-scene")


def _drift() -> Iterator[Block]:
    found = response(drawing.DRIVEN)
    largest = max((abs(one) for one in found.multipliers or ()), key=float, default=arb(0))
    yield Heading("Drift", "drift-of-body-2")
    yield Paragraph(
        "In a period body 2 advances by the integral of its velocity. With a damper, under a force whose second half period is the first with the opposite sign, it does not drift at all "
        "(`forced-periodic-response`); any asymmetry may make it drift; speed and direction depend on the phases of the harmonics. At the symmetric end of the picture the periodic motion attracts: "
        f"deviations shrink to {rounded(100 * largest, 1)} % in a period."
    )
    yield picture("drift-against-asymmetry")


def _jump() -> Iterator[Block]:
    yield Heading("A force that jumps", "a-force-that-jumps")
    yield Paragraph(
        "Without a damper one slip after an exit from stick, unless it lasts a multiple of the natural period of body 1 alone, makes a periodic motion attract all others, if the force is continuous at that exit "
        "(`forced-periodic-response`). Where it jumps there, all motions of a whole family may slip and stick at the same times, and none attracts another. Two of them keep the distance"
        + _formula("forced-periodic-response", "jump", "apart")
    )


def _damping() -> Iterator[Block]:
    edge = breaking_damping().subs(_of(drawing.PAIR)).subs(v1, SPEED)
    yield Heading("More damping is not always better")
    yield Paragraph(
        "A damper acts on body 1 alone. If a stuck pair passes its rest position with the velocity $v_1$, a strong one breaks adhesion at once "
        f"(`damping-can-desynchronise`): at {float(SPEED):g} m/s by more than {_digits(edge)} N s/m. Without a damper it would have stuck permanently."
        + _formula("damping-can-desynchronise", "breaks", "strong")
    )
