"""Past the paper: the response to a periodic force, what moves body 2 on, and what attracts without a damper."""

from __future__ import annotations

import sympy as sp

from paper_checks.engines.deciders import condition, equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.ledger.theorem import theorem
from theory import forced
from theory import jumping_force as jumping
from theory.forced_response import rates
from theory.symbols import a2, m1, t, undamped

AHEAD, NATURAL = sp.Symbol("beta", real=True), sp.Symbol("omega_1", positive=True)
"""What both velocities of one pair are ahead of those of another, and the frequency of body 1 alone."""
DISTANCE = sp.Symbol("N", nonnegative=True)

RESPONSE = theorem(
    "forced-periodic-response",
    clause(
        "one",
        r"Let $u$ be bounded with the period $T$ and $a_1>0$. Exactly one motion of $(x_1,v_1,v_2)$ has this period, and every motion tends "
        r"to it.",
        kernel=("periodic-response",),
    ),
    clause(
        "drift",
        r"In one period body 2 moves on by $\int_0^T v_2\,dt$ of that motion; by nothing if $u(t+T/2)=-u(t)$.",
        kernel=("drift", "no-drift"),
    ),
    clause(
        "undamped",
        r"Let $a_1=0$, and let some motion of period $T$ leave a stick at an instant at which $u$ is continuous and before which $|\Lambda|<b$, "
        r"slip with one sign $s$ for a time $t_s$, after which friction is no longer $sb$, and have $\omega_1t_s\notin 2\pi\mathbb Z$, «natural». Then "
        r"every motion tends to it. For what keeps its distance from it differs in that slip by «place» and «relative» at the time $t$ after the exit, "
        r"$\beta$ being the lead of both velocities at it, and both pairs have $\dot z=0$ at $t=t_s$.",
        natural=Formula(NATURAL, "=", sp.sqrt(a2 / m1), equals(lambda: undamped(rates()[1]))),
        place=Formula(
            r"x_1-\tilde x_1",
            "=",
            AHEAD / NATURAL * sp.sin(NATURAL * t),
            equals(lambda: forced.undamped_difference()[0], lambda: {AHEAD: forced.velocity_gap}),
        ),
        relative=Formula(
            r"\dot z-\dot{\tilde z}",
            "=",
            AHEAD * (sp.cos(NATURAL * t) - 1),
            equals(lambda: forced.undamped_difference()[1], lambda: {AHEAD: forced.velocity_gap}),
        ),
    ),
    clause(
        "jump",
        r"Where $u$ jumps at the exit, that may fail. For $m_1=m_2=a_2=b=1$, $a_1=0$, let «push» for the time «slip», $u=0$ for the time «stick» after it, and "
        r"then the same with the opposite sign, again and again. From «place», $v_1=v_2=v$, every $v$ with «slowest» and «fastest» starts a motion of the "
        r"period $2(t_s+t_h)$ with $\omega_1t_s=\pi/2$: a slip and a stick in each half period. Two of them keep the distance «apart» for ever: none attracts another.",
        push=Formula("u", "=", 1 - sp.pi / 4, equals(lambda: jumping.PUSH)),
        slip=Formula("t_s", "=", sp.pi / 2, equals(lambda: jumping.SLIP_TIME)),
        stick=Formula("t_h", "=", 2 * sp.sqrt(2) * sp.atan(sp.sqrt(2)), equals(jumping.stick_time)),
        place=Formula("x_1", "=", -3 * sp.pi / 4 - jumping.speed, equals(lambda: jumping.exit_state()[0])),
        slowest=Formula(
            jumping.speed,
            ">",
            1 - sp.pi / 2,
            condition(lambda: sp.Gt(jumping.speed, jumping.slowest_and_fastest()[0], evaluate=False)),
            sharp=True,
        ),
        fastest=Formula(
            jumping.speed,
            "<",
            2 - 3 * sp.pi / 4,
            condition(lambda: sp.Lt(jumping.speed, jumping.slowest_and_fastest()[1], evaluate=False)),
            sharp=True,
        ),
        apart=Formula(DISTANCE**2, "=", 3 * (jumping.speed - jumping.other_speed) ** 2, equals(jumping.apart_squared)),
    ),
)

RESPONSES = (RESPONSE,)
