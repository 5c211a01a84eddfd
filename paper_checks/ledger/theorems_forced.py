"""Past the paper, under a force u(t): which mode follows, that events do not accumulate, the distance of two motions."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from paper_checks.engines.deciders import equals, implied
from paper_checks.evidence.clause import Formula, clause
from paper_checks.ledger.letters import S, either_sign
from paper_checks.ledger.theorem import theorem
from theory import forced
from theory.energy import sigma, sigma_other
from theory.forced import U_RATES
from theory.symbols import a1, a2, b, m1, m2, t, u, v1, v1_other, v2, v2_other, x1, x1_other

LOAD = sp.Symbol("Lambda", real=True)
P = sp.Symbol("p", real=True)
ETA, ETA_RATE = sp.Symbol("eta", real=True), sp.Symbol(r"\dot{\eta}", real=True)
BESIDE: dict[sp.Symbol, Callable[[int], sp.Expr]] = {
    P: forced.imbalance,
    ETA: lambda _: forced.gap,
    ETA_RATE: lambda _: forced.gap_rate,
}
DISTANCE = sp.Symbol("N", nonnegative=True)
MASS = m1 + m2


def _quotable() -> dict[sp.Basic, sp.Basic]:
    """Return what N stands for, and letters without a tilde for the second solution."""
    letters = {one: sp.Symbol(f"{one.name[-4]}_k{one.name[-1]}", real=True) for one in (x1_other, v1_other, v2_other)}
    return {DISTANCE: sp.sqrt(forced.distance_squared().subs(letters)), **letters}


def tie(order: int) -> Callable[[int], sp.Expr]:
    """Return the derivative of p of this order by the sign."""
    return lambda sign: forced.tie_derivative(sign, order)


RULE = theorem(
    "forced-mode-rule",
    clause(
        "modes",
        r"A force $u(t)$ acts on body 1, $a_1\geqslant 0$. Let «load» be the load: the friction force "
        r"that sticking needs. Slip of sign $s$ has «slip»; the pair can stick where $|\Lambda|\leqslant b$, and then $m_2\ddot x_1=\Lambda$.",
        load=Formula(LOAD, "=", m2 * (u - a2 * x1 - a1 * v1) / MASS, equals(forced.load)),
        slip=Formula(
            r"\ddot z",
            "=",
            MASS / (m1 * m2) * (LOAD - S * b),
            either_sign(forced.relative_rate, {LOAD: lambda _: forced.load()}),
        ),
        kernel=("slip-rate", "stuck-load", "follow-forced-arc"),
    ),
    clause(
        "strict",
        r"Where $v_1=v_2$, with $u$ and its derivatives from the right: the pair sticks right after if $|\Lambda|<b$, and slips with the "
        r"sign $s$ if $s\Lambda>b$.",
        kernel=("mode-stick", "mode-slip"),
    ),
    clause(
        "tie",
        r"Where $\Lambda=sb$ and $u$ agrees for a while from there on with a function that is smooth on all of $\mathbb R$, the first of $s\dot p,s\ddot p,sp^{(3)},\ldots$ that is not zero decides: slip of sign $s$ if it is positive, stick if "
        r"negative. Here «first», «second», «third», and $p^{(k)}=u^{(k)}$ from then on.",
        first=Formula(r"\dot p", "=", U_RATES[0] - a2 * v1 - S * a1 * b / m2, either_sign(tie(1))),
        second=Formula(r"\ddot p", "=", U_RATES[1] - S * a2 * b / m2, either_sign(tie(2))),
        third=Formula("p^{(3)}", "=", U_RATES[2], either_sign(tie(3))),
        kernel=("mode-tie",),
    ),
    clause(
        "marginal",
        r"Where all of them are zero, and $u$ is analytic, slip of sign $s$ and stick are one and the same motion.",
        kernel=("mode-marginal",),
    ),
    clause(
        "jump",
        r"A jump of $u$ moves the strip $|\Lambda|\leqslant b$ and not the state; the rule with the values after it decides what follows.",
        kernel=("jump-moves-strip", "mode-stick", "mode-slip", "mode-tie"),
    ),
)

NO_ZENO = theorem(
    "forced-no-zeno",
    clause(
        "deviation",
        r"Let $\Lambda=sb$ and $v_1=v_2$ at a time, here $t=0$, and let $\eta$ be the place of body 1 beside the motion with the constant "
        r"acceleration $sb/m_2$ through the state at that time. With $I=m_1$ in slip of sign $s$ and $I=M$ in stick, before as after, "
        r"«deviation» $=p(t)$ and «excess».",
        deviation=Formula(
            r"I\ddot\eta+a_1\dot\eta+a_2\eta",
            "=",
            u - a2 * (x1 + v1 * t + S * b * t**2 / (2 * m2)) - a1 * (v1 + S * b * t / m2) - S * b * MASS / m2,
            either_sign(lambda sign: forced.deviation_force("stick", sign)),
        ),
        excess=Formula(
            LOAD - S * b,
            "=",
            m2 / MASS * (P - a1 * ETA_RATE - a2 * ETA),
            either_sign(forced.excess_load, BESIDE),
        ),
    ),
    clause(
        "finite",
        r"Where $u$ is analytic by pieces (polynomials plus sinusoids by pieces are) and $b>0$ is constant by pieces, the pair changes "
        r"its mode finitely often in every bounded interval of time.",
        kernel=("no-zeno-varying", "scenes-analytic"),
    ),
    clause(
        "finite-friction",
        r"So it does where $b>0$, too, is analytic by pieces.",
    ),
)

CONTRACTION = theorem(
    "forced-contraction",
    clause(
        "energy",
        r"Under a force «rate», where $\sigma$ is the value of $\mathrm{sign}(\dot z)$, in $[-1,1]$ where $\dot z=0$.",
        rate=Formula(r"\dot E", "=", u * v1 - a1 * v1**2 - b * sigma * (v1 - v2), equals(forced.energy_rate)),
        kernel=("forced-energy-rate",),
    ),
    clause(
        "rate",
        r"Two solutions under one force, the second with tildes, have «squared» and «rate» $\leqslant 0$,",
        squared=Formula(
            DISTANCE**2,
            "=",
            a2 * (x1 - x1_other) ** 2 + m1 * (v1 - v1_other) ** 2 + m2 * (v2 - v2_other) ** 2,
            equals(forced.distance_squared),
        ),
        rate=Formula(
            r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
            "=",
            -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (v1 - v2 - v1_other + v2_other),
            equals(forced.contraction_rate),
        ),
    ),
    clause("distance", r"so their distance $N$ never grows.", kernel=("forced-contraction",)),
    clause(
        "unique",
        r"For every force with a continuous impulse $\int u\,dt$ there is one solution from every start.",
        kernel=("forced-well-posed",),
    ),
    clause(
        "forces",
        r"Under two forces that are continuous but for jumps $N(t)\leqslant N(0)+m_1^{-1/2}\int_0^t|u-\tilde u|\,ds$, as «speed».",
        speed=Formula(
            m1 * (v1 - v1_other) ** 2,
            "<=",
            DISTANCE**2,
            implied(where=_quotable),
        ),
        kernel=("varying-input-to-state",),
    ),
    clause(
        "interface",
        r"With a friction $b(t)>0$ that is constant on each of finitely many pieces of time there is one solution from every start, too, and the distance of two never grows.",
        kernel=("varying-contraction", "varying-well-posed"),
    ),
    clause(
        "interface-rates",
        r"The rate of the energy holds with $b(t)$ in the place of $b$, and the bound under two forces as it is,",
        kernel=("varying-energy-rate", "varying-input-to-state"),
    ),
    clause("interface-contraction", r"and so does the rate of $N^2$;"),
    clause("interface-for-ever", r"all of it where there are finitely many pieces in every bounded time, without end."),
)

FORCED = (RULE, NO_ZENO, CONTRACTION)
