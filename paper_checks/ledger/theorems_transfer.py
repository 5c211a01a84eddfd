"""Past the paper: the least time in which a force on body 1 can move body 2, and what that takes."""

from __future__ import annotations

import sympy as sp

from paper_checks.engines.deciders import condition, equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.ledger.theorem import theorem
from theory import forced_control as control
from theory.filippov import load_threshold
from theory.forced_control import angle, duration, path, strength, velocity_gain
from theory.scaling import stick_frequency
from theory.symbols import a1, a2, b, m1, m2

MASS = m1 + m2
RESPONSE, SPREAD = sp.Symbol("g", positive=True), sp.Symbol("s", real=True)
HALF, PART = sp.Symbol("t_{1/2}", positive=True), sp.Symbol("xi", positive=True)
PLACE_START, PLACE_END = sp.Symbol("{x_2(0)}", real=True), sp.Symbol("{x_2(T)}", real=True)
RATE_START, RATE_END = sp.Symbol("{v_2(0)}", real=True), sp.Symbol("{v_2(T)}", real=True)
FIRST_ANGLE, SECOND_ANGLE, PACE = sp.symbols("alpha_1 alpha_2 Omega", positive=True)


def _arcs() -> dict[sp.Basic, sp.Basic]:
    return {FIRST_ANGLE: control.switching()[0], SECOND_ANGLE: control.switching()[1], PACE: stick_frequency()}


def _off_centre() -> sp.Expr:
    """How far body 2 is from the middle of the places that it can reach."""
    middle = RATE_START * duration + control.middle().subs(velocity_gain, RATE_END - RATE_START)
    return PLACE_END - PLACE_START - middle


TRANSFER = theorem(
    "minimum-transfer-time",
    clause(
        "reach",
        r"Whatever the force, at the time $T$ body 2 has «within», where «spread» and "
        r"$\Delta v_2=v_2(T)-v_2(0)$.",
        within=Formula(
            sp.Abs(PLACE_END - PLACE_START - duration / 2 * (RATE_START + RATE_END)),
            "<=",
            SPREAD,
            condition(lambda: sp.Le(sp.Abs(_off_centre()), SPREAD, evaluate=False)),
            sharp=True,
        ),
        spread=Formula(
            SPREAD,
            "=",
            b / (4 * m2) * (duration**2 - (m2 * velocity_gain / b) ** 2),
            equals(control.spread),
        ),
        kernel=("reach",),
    ),
    clause(
        "least",
        r"From rest to rest over $D>0$ it takes at least «time», and under Coulomb's law that is attained by a pair that sticks at the limit, $|\Lambda|=b$.",
        time=Formula("T", "=", 2 * sp.sqrt(m2 * path / b), equals(control.least_time)),
        kernel=("least-time", "least-time-attained"),
    ),
    clause(
        "literal",
        r"(3)–(4) do not have that motion (sgn-three-valued); under them a stuck pair does it in every longer time.",
    ),
    clause(
        "stuck",
        r"From $x_1(0)=0$ that stuck transfer, and to stay, needs $|u|$ up to the largest of «turn», «hold», and, if «late», of «peak».",
        turn=Formula(
            "u_1",
            "=",
            b * MASS / m2 + a1 * sp.sqrt(b * path / m2) + a2 * path / 2,
            equals(lambda: control.stuck_amplitudes()[0]),
        ),
        hold=Formula("u_2", "=", a2 * path, equals(lambda: control.stuck_amplitudes()[1])),
        late=Formula(
            a2**2 * path - a1**2 * b / m2,
            ">=",
            sp.Integer(0),
            condition(lambda: sp.Ge(control.late_peak(), 0, evaluate=False)),
            sharp=True,
        ),
        peak=Formula(
            "u_3",
            "=",
            a2 * path + a1**2 * b / (2 * a2 * m2) - b * MASS / m2,
            equals(lambda: control.stuck_amplitudes()[2]),
        ),
        kernel=("stuck-transfer-amplitude",),
    ),
    clause(
        "slip",
        r"With slip less will do to arrive. Let «half», and let $g$, the place of body 1 on its spring and damper after a unit "
        r"impulse, not fall on $[0,t_{1/2}]$. From rest at $x_1=0$ body 2 can be at rest at $D$ at the time $2t_{1/2}$ under some $|u|\leqslant U$ exactly if "
        r"$U\geqslant U_{\min}$, «least» with $g=g(t_{1/2})$. Under Coulomb's law body 1 is at rest then, too, if the pair may stick at the limit through the second half under such a force.",
        half=Formula(HALF, "=", sp.sqrt(m2 * path / b), equals(lambda: control.least_time() / 2)),
        least=Formula(
            r"U_{\min}",
            "=",
            b + b * HALF / (m2 * RESPONSE),
            equals(control.slipping_amplitude, lambda: {HALF: control.half_time}),
        ),
        kernel=("least-amplitude", "rest-to-rest"),
    ),
    clause(
        "slip-undamped",
        r"For $a_1=0$, $\theta=\omega_1t_{1/2}$ and «rising» that is «undamped».",
        rising=Formula(
            angle, "<=", sp.pi / 2, condition(lambda: sp.Le(angle, control.response_peak(), evaluate=False)), sharp=True
        ),
        undamped=Formula(
            r"U_{\min}", "=", b + b * m1 / m2 * angle / sp.sin(angle), equals(control.undamped_slipping_amplitude)
        ),
        kernel=("least-amplitude-undamped",),
    ),
    clause(
        "weak",
        r"For a weak force, $a_1=0$, «weak» and «held», «share», nothing breaks the stuck pair in time, and from rest at $x_1=0$ to rest "
        r"at $D$ it takes at least «span», «pace», with «first» and «second»: $u=U$ over the first angle, $-U$ over the "
        r"second.",
        weak=Formula(
            3 * strength,
            "<=",
            b * MASS / m2,
            condition(lambda: sp.Le(control.pressed().subs(angle, sp.pi), load_threshold(), evaluate=False)),
            sharp=True,
        ),
        held=Formula(
            a2 * path,
            "<=",
            strength,
            condition(lambda: sp.Le(control.stuck_amplitudes()[1], strength, evaluate=False)),
            sharp=True,
        ),
        share=Formula(PART, "=", a2 * path / strength, equals(lambda: control.stuck_amplitudes()[1] / strength)),
        span=Formula("T_w", "=", (FIRST_ANGLE + SECOND_ANGLE) / PACE, equals(control.weak_time, _arcs)),
        pace=Formula(PACE, "=", sp.sqrt(a2 / MASS), equals(stick_frequency)),
        first=Formula(
            r"\cos\alpha_1",
            "=",
            1 - PART / 2 - PART**2 / 4,
            equals(lambda: sp.cos(control.switching()[0]), lambda: {PART: control.reduced}),
        ),
        second=Formula(
            r"\cos\alpha_2",
            "=",
            (1 + PART / 2 + PART**2 / 4) / (1 + PART),
            equals(lambda: sp.cos(control.switching()[1]), lambda: {PART: control.reduced}),
        ),
    ),
    open=(
        "The least time of a transfer for forces between the weak ones and those that attain the bound, and for weak forces with $a_2D>U$ or with a damper.",
    ),
)
