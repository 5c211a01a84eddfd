"""The response to a periodic force: the one that attracts, and what moves body 2 on."""

from paper_checks.claims.beyond import jumping_force
from paper_checks.claims.letters import DISTANCE
from paper_checks.claims.words import *
from theory import jumping_force as jumping
from theory.forced_response import natural, rates


@cache
def goes_round() -> Evidence:
    """On a surface what keeps its distance from a motion whose friction goes round is that motion."""
    return argument(
        r"""
        Let $\mathbf v_i^*$ rotate with the force, with the friction $\mathbf f^*$ of rotating-force. The flow is
        non-expansive, so $N$ has a limit, and limit motions keep their distance: $\mathbf v_1=\mathbf v_1^*$, so
        $\mathbf f-\mathbf f^*$ is a constant, which is $0$, as $\mathbf v_2$ is bounded, and $\mathbf w-\mathbf
        w^*=\mathbf c$ is a constant, too. Where $|\mathbf f^*|<b$ neither slips, and $\mathbf c=0$. Where $|\mathbf
        f^*|=b$ both $\mathbf w$ and $\mathbf w^*$ are along $\mathbf f^*$, or $0$: so is $\mathbf c$ while $\mathbf
        f^*$ rotates, and $\mathbf c=0$.
        """,
        kernel.step("system-contraction"),
        kernel.step("rotating-motion"),
    )


@cache
def undamped_attraction() -> Evidence:
    """Without a damper one stick exit with a slip after it is enough, where the force is continuous at that exit."""
    return argument(
        r"""
        Let $\eta_*$ be the periodic motion, $\zeta$ a limit of another one shifted by periods: $N(\zeta-\eta_*)$ is
        constant, so at almost every time both have the same $\dot z$ or the same friction. While $\eta_*$ sticks with
        $|\Lambda_*|<b$ then $\zeta$ sticks; while $\eta_*$ slips $\zeta$ has its friction $sb$. At the exit both loads
        are continuous, as $u$ is. Before it neither is beyond $b$; after it both have friction $sb$ and $s\dot
        z\geqslant 0$, so neither is within. So both loads are $sb$ there, hence $x_1=\tilde x_1$, and both velocities
        differ by one $\beta$. In the slip $v_2-\tilde v_2=\beta$ and $v_1-\tilde v_1=\beta\cos\omega_1t$. At its end
        $\dot z_*=0$. At times after it, arbitrarily close to it, friction of $\eta_*$ is not $sb$; then $\zeta$ has the
        same friction or the same $\dot z$, either way $s\dot z\leqslant 0$. So $\dot z=0$ for $\zeta$ at that end, too,
        hence $\beta(\cos\omega_1t_s-1)=0$, $\beta=0$, and $\zeta=\eta_*$.
        """,
        *map(kernel.step, ("forced-contraction", "mode-stick", "mode-slip", "mode-tie")),
    )


def natural_frequency() -> Formula:
    """The frequency of body 1 alone without a damper."""
    return equal(natural, sqrt(a2 / m1), lambda: undamped(rates()[1]))


AHEAD, NATURAL = Symbol("beta", real=True), Symbol("omega_1", positive=True)
"""What both velocities of one pair are ahead of those of another, and the frequency of body 1 alone."""


@theorem(
    "forced-periodic-response",
    clause(
        "one",
        """
        Let $u$ be bounded with the period $T$ and $a_1>0$. Exactly one motion of $(x_1,v_1,v_2)$ has this period, and
        every motion tends to it.
        """,
        kernel="periodic-response",
    ),
    clause(
        "drift",
        r"In one period body 2 advances by $\int_0^T v_2\,dt$ of that motion; by nothing if $u(t+T/2)=-u(t)$.",
        kernel="drift no-drift",
    ),
    clause(
        "round",
        r"""
        On a surface, with scalar masses, spring and damper, $a_1>0$, and friction of at most $b$ against the slip,
        every motion under the force of rotating-force tends to the one that rotates with it.
        """,
    ),
    clause(
        "undamped",
        r"""
        Let $a_1=0$, and let some motion of period $T$ leave a stick at an instant at which $u$ is continuous and before
        which $|\Lambda|<b$, slip with one sign $s$ for a time $t_s$, after which friction is no longer $sb$, and have
        $\omega_1t_s\notin 2\pi\mathbb Z$, «natural». Then every motion tends to it. For a motion that keeps its
        distance from it differs in that slip by «place» and «relative» at the time $t$ after the exit, $\beta$ being
        the difference of both velocities at the exit, and both have $\dot z=0$ at $t=t_s$.
        """,
        natural=equal(NATURAL, sqrt(a2 / m1), lambda: undamped(rates()[1])),
        place=equal(
            r"x_1-\tilde x_1",
            AHEAD / NATURAL * sin(NATURAL * t),
            lambda: forced.undamped_difference()[0],
            lambda: {AHEAD: forced.velocity_gap},
        ),
        relative=equal(
            r"\dot z-\dot{\tilde z}",
            AHEAD * (cos(NATURAL * t) - 1),
            lambda: forced.undamped_difference()[1],
            lambda: {AHEAD: forced.velocity_gap},
        ),
    ),
    clause(
        "jump",
        r"""
        Where $u$ jumps at the exit, that may fail. For $m_1=m_2=a_2=b=1$, $a_1=0$, let «push» for the time «slip»,
        $u=0$ for the time «stick» after it, and then the same with the opposite sign, repeatedly. From «place»,
        $v_1=v_2=v$, every $v$ with «slowest» and «fastest» starts a motion of the period $2(t_s+t_h)$ with
        $\omega_1t_s=\pi/2$: a slip and a stick in each half period. Two of them keep the distance «apart» permanently:
        none attracts another.
        """,
        push=equal("u", 1 - pi / 4, lambda: jumping.PUSH),
        slip=equal("t_s", pi / 2, lambda: jumping.SLIP_TIME),
        stick=equal("t_h", 2 * sqrt(2) * sp.atan(sqrt(2)), jumping.stick_time),
        place=equal("x_1", -3 * pi / 4 - jumping.speed, lambda: jumping.exit_state()[0]),
        slowest=sharp(jumping.speed, ">", 1 - pi / 2, lambda: (jumping.speed, ">", jumping.slowest_and_fastest()[0])),
        fastest=sharp(
            jumping.speed, "<", 2 - 3 * pi / 4, lambda: (jumping.speed, "<", jumping.slowest_and_fastest()[1])
        ),
        apart=equal(DISTANCE**2, 3 * (jumping.speed - jumping.other_speed) ** 2, jumping.apart_squared),
    ),
    assuming=f"{POSITIVE} A periodic force $u(t)$ on body 1; $a_1>0$, or $a_1=0$ where stated.",
)
def forced_periodic_response() -> Case:
    """One response, what moves body 2 on, and when the same holds without a damper."""
    return because(
        """
        With a damper a periodic force has one response, and every motion tends to it. Without a damper, a single exit
        from stick has the same effect if the slip after it does not last a multiple of the natural period of body 1
        alone and the force does not jump at that exit. With a jump there, whole families of periodic motions may
        coexist.
        """,
        carried("round", goes_round),
        carried("undamped", undamped_attraction),
        carried("jump", jumping_force.keeps_apart),
    )
