"""Past the paper: which velocities a force on body 1 can give body 2, how exactly they settle, and what damping spoils."""

from __future__ import annotations

import sympy as sp

from paper_checks.engines.deciders import condition, equals, implied
from paper_checks.evidence.clause import Formula, clause
from paper_checks.ledger.theorem import theorem
from paper_checks.ledger.theorems_transfer import PLACE_START, RATE_START, TRANSFER
from theory import forced
from theory import forced_control as control
from theory.energy import critical_energy, on_surface, sigma
from theory.symbols import a1, a2, b, m1, m2, v1, v2, v2_0, x1, x1_0, x2, x2_0

MASS = m1 + m2
OFFSET = sp.Symbol("gamma", real=True)
WAY, WAY_RATE, WAY_BEND = sp.symbols(r"x_{\mathrm{ref}} \dot{x}_{\mathrm{ref}} \ddot{x}_{\mathrm{ref}}", real=True)
THEN, LATER = sp.symbols("t_1 t_2", nonnegative=True)
RATE_THEN, RATE_LATER = sp.symbols(r"\dot{x}_{\mathrm{ref}}(t_1) \dot{x}_{\mathrm{ref}}(t_2)", real=True)
REFERENCE = {WAY: control.r_place, WAY_RATE: control.r_speed, WAY_BEND: control.r_acceleration}
REST, ENERGY, LAST_ENERGY = sp.symbols(r"z_{\infty} E E_{\infty}", real=True)
KAPPA, DISTANCE = sp.Symbol("kappa", positive=True), sp.Symbol("N", nonnegative=True)
START = {PLACE_START: x2_0, RATE_START: v2_0}
FIRST_PLACE, WAY_START = sp.Symbol("{x_1(0)}", real=True), sp.Symbol(r"{x_{\mathrm{ref}}(0)}", real=True)

TRACKING = theorem(
    "trackable-references",
    clause(
        "iff",
        r"Let «place» and «speed». Under Coulomb's law, from a suitable start of body 1, some force makes body 2 follow the velocity $\dot x_{\mathrm{ref}}$ exactly if "
        r"«gentle» for all times $t_1$, $t_2$: no force gives body 2 more.",
        place=Formula(
            r"x_{\mathrm{ref}}(0)", "=", PLACE_START, equals(lambda: control.followed_start()[0], lambda: START)
        ),
        speed=Formula(
            r"\dot x_{\mathrm{ref}}(0)", "=", RATE_START, equals(lambda: control.followed_start()[1], lambda: START)
        ),
        gentle=Formula(
            sp.Abs(RATE_THEN - RATE_LATER),
            "<=",
            b / m2 * sp.Abs(THEN - LATER),
            condition(
                lambda: sp.Le(
                    sp.Abs(RATE_THEN - RATE_LATER), control.strongest() * sp.Abs(THEN - LATER), evaluate=False
                )
            ),
            sharp=True,
        ),
        kernel=("trackable", "driven-acceleration"),
    ),
    clause(
        "literal",
        r"Under (3)–(4) a pair that sticks follows exactly those references with $|\ddot x_{\mathrm{ref}}|<b/m_2$ at almost all times.",
    ),
    clause(
        "sticks",
        r"While «slower» the pair must stick. So where that is so at the start, body 1 has to start with $v_1(0)=v_2(0)$.",
        slower=Formula(
            sp.Abs(WAY_BEND),
            "<",
            b / m2,
            condition(lambda: sp.Lt(sp.Abs(WAY_BEND), control.strongest(), evaluate=False)),
            sharp=True,
        ),
        kernel=("must-stick",),
    ),
    clause(
        "force",
        r"A pair that always sticks has $v_1(0)=v_2(0)$, and follows $x_{\mathrm{ref}}$ under one force only, «force» with «offset».",
        force=Formula(
            "u",
            "=",
            MASS * WAY_BEND + a1 * WAY_RATE + a2 * (WAY + OFFSET),
            equals(lambda: control.stuck_force().subs(control.r_place, control.r_place + OFFSET), lambda: REFERENCE),
        ),
        offset=Formula(
            OFFSET,
            "=",
            FIRST_PLACE - WAY_START,
            equals(control.stuck_offset, lambda: {FIRST_PLACE: x1_0, WAY_START: control.r_start}),
        ),
    ),
)

RING = theorem(
    "tolerance-ring",
    clause(
        "tube",
        r"Let $N$ be the energy distance of forced-contraction to some motion under the same force. The tube $N\leqslant\varepsilon$ around that motion is "
        r"entered at most once, and never left. With $a_1>0$, $\varepsilon>0$ and a bounded force every motion enters it.",
        kernel=("forced-contraction", "tolerance-ring"),
    ),
    clause(
        "ring",
        r"In the tube the relative velocities differ by at most «radius», «kappa»: «within», and no smaller factor will do.",
        radius=Formula(
            r"r_\varepsilon",
            "=",
            sp.sqrt(KAPPA) * control.tolerance,
            equals(control.ring_radius, lambda: {KAPPA: control.ring_ratio()}),
        ),
        kappa=Formula(KAPPA, "=", MASS / (m1 * m2), equals(control.ring_ratio)),
        within=Formula(
            (v1 - v2) ** 2,
            "<=",
            KAPPA * DISTANCE**2,
            implied(
                where=lambda: {
                    KAPPA: control.ring_ratio(),
                    DISTANCE: sp.sqrt(a2 * x1**2 + m1 * v1**2 + m2 * v2**2),
                }
            ),
        ),
        kernel=("ring-factor",),
    ),
    clause(
        "blind",
        r"$N$ does not see $x_1-x_2$: moving $x_2(0)$ moves the relative motion by as much, for ever. So a ring in the plane of $x_1-x_2$ and its rate is "
        r"centred on the limit of the motion itself.",
        kernel=("displacement-unseen",),
    ),
    clause(
        "centre",
        r"Without a force $x_1-x_2$ has a limit $z_\infty$, and with the energy $E$ at a time there is «near» then, $E_\infty=\lim E$.",
        near=Formula(
            sp.Abs(x1 - x2 - REST),
            "<=",
            (ENERGY - LAST_ENERGY) / b,
            condition(
                lambda: sp.Le(
                    sp.Abs(x1 - x2 - REST), (ENERGY - LAST_ENERGY) * control.path_per_energy(), evaluate=False
                )
            ),
            sharp=True,
        ),
        kernel=("displacement-limit", "displacement-paid"),
    ),
)

DAMPING = theorem(
    "damping-can-desynchronise",
    clause(
        "sticks",
        r"Let a free pair be stuck at $x_1=0$ with the velocity $v_1>0$. Without a damper it sticks for ever if «captive».",
        captive=Formula(
            v1**2,
            "<=",
            b**2 * MASS / (a2 * m2**2),
            condition(lambda: sp.Le(v1**2, sp.solve(on_surface().subs(x1, 0) - critical_energy(), v1**2)[0])),
            sharp=True,
        ),
        kernel=("capture",),
    ),
    clause(
        "breaks",
        r"With a damper it slips at once if «strong».",
        strong=Formula(
            a1, ">", b * MASS / (m2 * v1), condition(lambda: sp.Gt(a1, forced.breaking_damping())), sharp=True
        ),
        kernel=("damper-breaks",),
    ),
    clause(
        "heavy",
        r"As $a_1\to\infty$ body 1 creeps, with «creeps» in slip of sign $\sigma$ and the velocity of body 1 of order $1/a_1$, and from every start the time after which "
        r"the pair sticks for ever tends to «time», with $v_2$ at the start.",
        creeps=Formula(r"a_2x_1+a_1v_1", "->", -b * sigma, equals(forced.creeping_load)),
        time=Formula("T", "->", m2 * sp.Abs(v2) / b, equals(lambda: sp.Abs(v2) / control.strongest())),
    ),
)

CONTROL = (TRACKING, TRANSFER, RING, DAMPING)
