"""Stick or slip under a force: the rule of modes, its ties, and why modes do not alternate without end."""

from paper_checks.claims.letters import MASS, S, either_sign
from paper_checks.claims.words import *
from theory.forced import U_RATES


@cache
def slip_rates() -> Evidence:
    """w' in slip of both signs, by the load."""
    rates = [forced.relative_rate(sign) for sign in (1, -1)]
    by_load = [forced.coupling() * (forced.load() - sign * b) for sign in (1, -1)]
    return identity(
        r"in slip of sign $s$, $\ddot z=\kappa\,(\Lambda-sb)$, $\kappa=M/(m_1m_2)$",
        rates,
        by_load,
    )


@cache
def finitely_many_events() -> Evidence:
    """No accumulation of events, from the right or from the left."""
    return argument(
        r"""
        Events cannot accumulate from the right: the rule gives a mode that lasts. Let them accumulate from the left at
        a time, $t=0$. Then $\dot z(0)=0$, and $u$, $b$ are analytic up to $0$. If $|\Lambda(0)|\neq b$, either
        $|\Lambda|<b$ near $0$, and once stuck the pair sticks up to $0$; or $s\Lambda>b$, and $s\dot z$ increases in
        every mode, so $\dot z$ has one zero. Let $\Lambda(0)=sb$. Near $0$ slip of sign $-s$ has $s\ddot z>0$, so it
        does not begin, and only slip of sign $s$ and stick are left. If $p=0$ near $0$, $\eta=0$ and $\ddot z=0$ there
        in both modes: no event. Else $\Lambda-sb$ has one sign on some $(-\epsilon,0)$: if it is that of $s$ there is
        no stick, and $s\dot z$ increases; if not, a pair once stuck sticks up to $0$. In each case only finitely many
        events are left. With a piecewise analytic friction $b(t)$ the same holds with $m_2\ddot r=sb(t)$. Where $b$ and
        $\Lambda$ both fall to $0$ at the end of a piece, friction changes $\Lambda$ there by less than every multiple
        of $b$, so $\Lambda/b$ has a limit: where that is not $\pm 1$ it is as where $|\Lambda(0)|\neq b$, where it is
        $s$ as where $\Lambda(0)=sb$.
        """,
        *map(kernel.step, ("mode-stick", "mode-slip", "mode-tie", "mode-marginal", "interface-no-zeno")),
    )


LOAD = Symbol("Lambda", real=True)
P = Symbol("p", real=True)
ETA, ETA_RATE = Symbol("eta", real=True), Symbol(r"\dot{\eta}", real=True)
BESIDE: dict[Symbol, Callable[[int], Expr]] = {
    P: forced.imbalance,
    ETA: lambda _: forced.gap,
    ETA_RATE: lambda _: forced.gap_rate,
}


def tie(order: int) -> Callable[[int], Expr]:
    """Return the derivative of p of this order by the sign."""
    return lambda sign: forced.tie_derivative(sign, order)


@theorem(
    "forced-mode-rule",
    clause(
        "modes",
        r"""
        A force $u(t)$ acts on body 1, $a_1\geqslant 0$. Let «load» be the load: the friction force that sticking
        needs. Slip of sign $s$ has «slip»; the pair can stick where $|\Lambda|\leqslant b$, and then $m_2\ddot
        x_1=\Lambda$.
        """,
        load=equal(LOAD, m2 * (u - a2 * x1 - a1 * v1) / MASS, forced.load),
        slip=Formula(
            r"\ddot z",
            "=",
            MASS / (m1 * m2) * (LOAD - S * b),
            either_sign(forced.relative_rate, {LOAD: lambda _: forced.load()}),
        ),
        kernel="slip-rate stuck-load follow-forced-arc",
    ),
    clause(
        "strict",
        r"""
        Where $v_1=v_2$, with $u$ and its derivatives from the right: the pair sticks right after if $|\Lambda|<b$,
        and slips with the sign $s$ if $s\Lambda>b$.
        """,
        kernel="mode-stick mode-slip",
    ),
    clause(
        "tie",
        r"""
        Where $\Lambda=sb$ and $u$ agrees for a while from there on with a function that is smooth on all of $\mathbb
        R$, the first of $s\dot p,s\ddot p,sp^{(3)},\ldots$ that is not zero decides: slip of sign $s$ if it is
        positive, stick if negative. Here «first», «second», «third», and $p^{(k)}=u^{(k)}$ from then on.
        """,
        first=Formula(r"\dot p", "=", U_RATES[0] - a2 * v1 - S * a1 * b / m2, either_sign(tie(1))),
        second=Formula(r"\ddot p", "=", U_RATES[1] - S * a2 * b / m2, either_sign(tie(2))),
        third=Formula("p^{(3)}", "=", U_RATES[2], either_sign(tie(3))),
        kernel="mode-tie",
    ),
    clause(
        "marginal",
        r"Where all of them are zero and $u$ is analytic, slip of sign $s$ and stick are the same motion.",
        kernel="mode-marginal",
    ),
    clause(
        "jump",
        r"A jump of $u$ moves the strip $|\Lambda|\leqslant b$ and not the state; the rule with the values after it decides what follows.",
        kernel="jump-moves-strip mode-stick mode-slip mode-tie",
    ),
    assuming=UNDER_A_FORCE,
)
def forced_mode_rule() -> Case:
    """Both modes beside the motion that they share at a tie."""
    return because(
        """
        The force that sticking needs decides between stick and slip, on the edge by its derivatives. Where it equals
        the friction limit, slip and stick agree to second order, and the first derivative in which the force departs
        from their common motion decides.
        """,
        slip_rates,
    )


@theorem(
    "forced-no-zeno",
    clause(
        "deviation",
        r"""
        Let $\Lambda=sb$ and $v_1=v_2$ at a time, here $t=0$, and let $\eta$ be the position of body 1 relative to the
        motion with the constant acceleration $sb/m_2$ through the state at that time. With $I=m_1$ in slip of sign $s$
        and $I=M$ in stick, before as after, «deviation» $=p(t)$ and «excess».
        """,
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
        """
        Where $u$ is piecewise analytic, the ends of the pieces included (as piecewise polynomials plus sinusoids are),
        and $b>0$ is constant on pieces of time, finitely many in every bounded time interval, the pair changes its mode
        finitely often in every bounded time interval.
        """,
        kernel="interface-no-zeno scenes-analytic",
    ),
    clause(
        "finite-friction",
        r"So it does where $b>0$ is piecewise analytic, too.",
    ),
    assuming=UNDER_A_FORCE,
)
def forced_no_zeno() -> Case:
    """The load beside the edge has one sign before a time of accumulation."""
    return because(
        "Under a piecewise analytic force no motion is Zeno: what decides a tie for the time after it decides it for the time before it too, so close to any instant the load stays on one side of each edge.",
        carried("deviation"),
        carried("finite-friction", finitely_many_events),
    )
