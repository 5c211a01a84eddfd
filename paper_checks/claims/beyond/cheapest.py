"""The cheapest transfer of body 2 from rest to rest: least energy and least work while stuck, and what slipping can gain."""

from paper_checks.claims.beyond import transfers
from paper_checks.claims.letters import MASS
from paper_checks.claims.words import *
from theory import cheapest
from theory.cheapest import beyond, height, mu, nu, once, rate, twice, weight
from theory.forced_control import angle, duration, path, r_acceleration, r_place, r_speed, stuck_force
from theory.scaling import stick_frequency

PACE, WIDTH = symbols("Omega L", positive=True)
FORCE, FORCE_RATE = Symbol("u_{*}", real=True), Symbol(r"\dot{u}_{*}", real=True)
FORCED = {FORCE: weight, FORCE_RATE: rate}


@cache
def certificate() -> Evidence:
    """A lower bound on int u^2 for every w, mu and nu."""
    return argument(
        r"""
        $u^2\geqslant 2wu-w^2$. By the identity $\int_0^Twu\,dt=\mu D+\int_0^T\rho\,\dot v_1\,dt$: the function whose rate
        is left is $0$ at the start, where $x_1=v_1=0$, and $\mu D$ at $T$, where $v_1=S=R=0$. Finally
        $|\dot v_1|\leqslant b/m_2$. The same with $\int wu\,dt\leqslant\max|u|\int|w|\,dt$ bounds the peak, with equality
        if $\rho=0$ and $u=U\,\mathrm{sgn}\,w$.
        """,
        identity(
            r"$wu=\rho\dot v_1+\frac{\mathrm d}{\mathrm dt}\bigl[(\mu(T-t)-\nu)v_1+\mu x_1-a_1Sv_1-a_2(Rv_1+Sx_1)\bigr]$ along a stuck motion",
            weight * stuck_force(),
            cheapest.misfit() * r_acceleration + cheapest.along(cheapest.gathered()),
        ),
        transfers.gentle,
    )


@cache
def only_one() -> Evidence:
    """The convex problem has one solution, and multipliers."""
    return argument(
        r"""
        The accelerations $|\dot v_1|\leqslant b/m_2$ with $v_1(T)=0$, $x_1(T)=D$ are a closed, bounded, convex set of
        $L^2(0,T)$, and not empty. On it $\int u^2$ is continuous and strictly convex, as $u$ is affine in $\dot v_1$ and
        determines it: there is one minimum, at an $u_*$. With $T>2\sqrt{m_2D/b}$ the pair $(x_1(T),v_1(T))=(D,0)$ is in
        the interior of what such accelerations reach (Slater's condition), so there are multipliers: $u_*$ minimises
        $\int u^2-2\int(\mu(T-t)-\nu)\dot v_1$ over all $|\dot v_1|\leqslant b/m_2$. That means
        $\int\rho\,(\dot v_1-\dot v_{1*})\geqslant 0$ for all of them, with $w=u_*$; hence the signs of $\rho$. Conversely
        those signs give $\int u_*(u-u_*)=\int\rho\,(\dot v_1-\dot v_{1*})\geqslant 0$, and
        $\int u^2=\int u_*^2+2\int u_*(u-u_*)+\int(u-u_*)^2$. Where $\rho=0$, also $\ddot\rho=0$, which is the equation of
        $u_*$; where that holds from $0$ to $T$, suitable $\mu,\nu$ make $\rho=0$.
        """,
        certificate,
        cites=("Lagrange multipliers of a convex program under the condition of Slater",),
    )


@cache
def least_work() -> Evidence:
    """The trapezoid has the least int v1^2."""
    return argument(
        r"""
        Let $w$ be the trapezoid and $v_1$ the velocity of another stuck transfer. $\int(v_1-w)=0$, so
        $\int v_1^2-\int w^2\geqslant 2\int w(v_1-w)=2\int(c-w)(w-v_1)\geqslant 0$: where $w<c$, $w$ is the largest
        velocity that $|\dot v_1|\leqslant b/m_2$ and rest at both ends permit.
        """,
        identity(
            r"$uv_1=a_1v_1^2+\frac{\mathrm d}{\mathrm dt}\bigl[\frac12Mv_1^2+\frac12a_2x_1^2\bigr]$ along a stuck motion",
            r_speed * stuck_force(),
            a1 * r_speed**2 + cheapest.along((total_mass() * r_speed**2 + a2 * r_place**2) / 2),
        ),
        transfers.gentle,
    )


@cache
def with_slip() -> Evidence:
    """The force of any motion beside that of the stuck motion with the same x2."""
    return argument(
        r"""
        Whatever the motion, $|\dot v_2|\leqslant b/m_2$, so a stuck pair can have the same $x_2(t)$, under a force $u_s$,
        and $\int u_*(u_s-u_*)\geqslant 0$. With $z$ the change of $x_1-x_2$, $u-u_s=m_1\ddot z+a_1\dot z+a_2z$, and
        by the identity with $w=u_*$, $\int u_*(u-u_s)=\int\kappa\,\dot z$: the function whose rate is left is $0$ where
        $\dot z=z=0$ and where $\dot z=S=0$, and $u_*$ is Lipschitz continuous, as the signs of $\rho$ say that $\dot v_{1*}$ is
        $\dot v_{1*}-\rho/M^2$, which is so, cut off at $\pm b/m_2$. If $x_2$ is the same, $u_s=u_*$ and
        $\int u^2=\int u_*^2+2\int\kappa\,\dot z+\int(u-u_*)^2$, the last term quadratic in $z$. Such a $\dot z$ is $0$ where
        $|\dot v_2|<b/m_2$ and else has the sign of $\dot v_2$; any smooth one with that sign is possible.
        """,
        only_one,
        identity(
            r"$w(m_1\ddot z+a_1\dot z+a_2z)=\kappa\dot z+\frac{\mathrm d}{\mathrm dt}[m_1w\dot z-a_2Sz]$",
            weight * cheapest.slip_force(),
            cheapest.slip_weight() * cheapest.slip + cheapest.along(cheapest.slip_gathered()),
        ),
    )


@cache
def far_away() -> Evidence:
    """Hops of a fixed cost against a spring that is held."""
    return argument(
        r"""
        Stuck: let $x_1$ be largest, $X\geqslant D$, at the time $s$. After its last passage before $s$ through the place
        $X-y$ the pair stops within $y$, so there $0\leqslant v_1\leqslant\sqrt{2by/m_2}$, and $u\geqslant
        a_2x_1-bM/m_2=a_2(x_1-L)$. These passages take $\mathrm dy/v_1$ each: the integral with $h=X-L\geqslant D-L$.
        With slips: move the stuck pair by $d_0$; bring body 1 back to $0$ and to rest along any smooth path in the time
        $\tau$, never forwards; hold it there until body 2 rests. Body 2 is never accelerated by more than $b/m_2$, so it then has not come
        back by more than $b\tau^2/m_2<d_0$ for small $\tau$, and all is as at the start but for $x_2$, on which
        nothing depends. Such hops have the same cost each, and a stuck transfer does what is left of $D$.
        """,
        transfers.gentle,
    )


@cache
def for_all() -> Evidence:
    """The kinetic energy that a mean velocity needs."""
    return argument(
        r"""
        Somewhere $v_2$ has its largest value $V\geqslant D/T$. It rises to it, and friction drives body 2 only if
        $v_1\geqslant v_2$: there $v_1\geqslant V$, and $E\geqslant MV^2/2$. But $\dot E\leqslant uv_1\leqslant|u|\sqrt{2E/m_1}$, so
        $\sqrt{2E}$ grows by at most $|u|/\sqrt{m_1}$ per time, and $MV^2\leqslant\frac1{m_1}\bigl(\int|u|\bigr)^2\leqslant
        \frac T{m_1}\int u^2$.
        """,
        kernel.step("forced-energy-rate"),
        transfers.gentle,
    )


@theorem(
    "cheapest-transfer",
    clause(
        "bound",
        r"""
        Let the pair stick on its way from rest at $x_1=0$ to rest at $D>0$ in the time $T$. Whatever the function $w(t)$ and
        the numbers $\mu,\nu$ are, $\int_0^Tu^2\,dt\geqslant 2\mu D-\frac{2b}{m_2}\int_0^T|\rho|\,dt-\int_0^Tw^2\,dt$ with
        «misfit», $S=\int_t^Tw\,ds$, $R=\int_t^TS\,ds$.
        """,
        misfit=equal(r"\rho", MASS * weight + a1 * once + a2 * twice + nu - mu * (duration - t), cheapest.misfit),
    ),
    clause(
        "least",
        r"""
        For $T>2\sqrt{m_2D/b}$ one of these motions has the least $\int u^2\,dt$, under a force $u_*$, and that of every other
        one is larger by $\int(u-u_*)^2\,dt$ or more. It is the one for which, with $w=u_*$ and some $\mu,\nu$, $\rho=0$ where
        $|\dot v_1|<b/m_2$ and $\rho\,\dot v_1\leqslant 0$ elsewhere. There is equality in the bound then, and while
        $|\dot v_1|<b/m_2$ one has «adjoint».
        """,
        adjoint=equal(r"\ddot u_*", (a1 * FORCE_RATE - a2 * FORCE) / MASS, cheapest.adjoint, lambda: FORCED),
    ),
    clause(
        "undamped",
        r"""
        For $a_1=0$, $\theta=\Omega T$, $\Omega^2=a_2/M$ the least is «energy» if $|\dot v_1|\leqslant b/m_2$ along the motion under the
        $u=A\sin\Omega t+B\cos\Omega t$ that arrives.
        """,
        energy=equal(
            r"\int u_*^2\,dt",
            2 * a2 * MASS * PACE * path**2 * (angle + sin(angle) * cos(angle)) / (angle**2 - sin(angle) ** 2),
            cheapest.undamped_energy,
            lambda: {PACE: stick_frequency()},
        ),
    ),
    clause(
        "work",
        r"""
        The work of the force, $\int uv_1\,dt=\frac12a_2D^2+a_1\int v_1^2\,dt$, is the same for all these motions if $a_1=0$. Else
        it is least, «work», if $v_1$ rises at $b/m_2$ to $c$, stays and falls at $b/m_2$, «height», $c\leqslant bT/2m_2$.
        """,
        work=equal(
            "W",
            a2 * path**2 / 2 + a1 * height**2 * (duration - 4 * m2 * height / (3 * b)),
            cheapest.work,
        ),
        height=equal(path, height * (duration - m2 * height / b), lambda: cheapest.trapezoid(1)),
    ),
    clause(
        "slip",
        r"""
        Every motion, slipping or not, from rest at $x_1=0$ to rest of both bodies, with body 2 at $D$, in such a $T$ has
        $\int u^2\,dt\geqslant\int u_*^2\,dt+2\int\kappa\,\dot z\,dt$, «weight», $S=\int_t^Tu_*\,ds$. Of those with the same $x_2(t)$
        as the stuck one some need less than it if $\kappa\,\dot v_2<0$ at a time within an interval of $|\dot v_2|=b/m_2$, and none
        if there is no such time.
        """,
        weight=equal(r"\kappa", a1 * FORCE + a2 * once - m1 * FORCE_RATE, cheapest.slip_weight, lambda: FORCED),
    ),
    clause(
        "far",
        r"""
        While stuck, $D=L+h$ with «width» and $h>0$ needs «stuck», in whatever time. With slips some $T$ and
        $\int u^2\,dt$ that are proportional to $D$ are enough for large $D$: slipping is cheaper then, by any factor.
        """,
        width=equal("L", b * MASS / (a2 * m2), half_width),
        stuck=sharp(
            Symbol(r"\int{u^2}\,dt"),
            ">=",
            16 * a2**2 * beyond**2 / 15 * sqrt(beyond * m2 / (2 * b)),
            lambda: (Symbol(r"\int{u^2}\,dt"), ">=", cheapest.far_energy()),
        ),
    ),
    clause(
        "all",
        r"""
        Every motion, slipping or not, from rest at $x_1=0$, by which body 2 is at rest at $D$ at the time $T$, has
        $\int_0^Tu^2\,dt\geqslant m_1MD^2/T^3$.
        """,
    ),
    clause(
        "peak",
        r"""
        While stuck, $\max|u|\int_0^T|w|\,dt\geqslant\mu D-\frac{b}{m_2}\int_0^T|\rho|\,dt$, too. If $w$ obeys the equation of
        $u_*$, $\rho=0$ for some $\nu$ and «multiplier» at $t=T$: a force $U\,\mathrm{sgn}\,w$ that arrives has the least peak.
        Under the weak forces of minimum-transfer-time that is so of all forces, slipping or not, in the time $T_w$ or less.
        """,
        multiplier=equal(r"\mu", a1 * weight - MASS * rate, cheapest.end_multiplier),
    ),
    open=(
        "Whether slipping can be cheaper where the cheapest stuck transfer keeps friction below its limit, and by how much at most.",
    ),
    assuming=UNDER_A_FORCE,
)
def cheapest_transfer() -> Case:
    """A convex problem while the pair sticks; not one when it slips."""
    return because(
        r"""
        While the pair sticks, $\dot v_1$ is all there is to choose. It is bounded by friction, and the force is linear in it: the
        problem is convex, and its multipliers prove the minimum. Slipping leaves this class. It gains nothing for certain motions,
        and much for far ones.
        """,
        carried("bound", certificate),
        carried("least", only_one),
        carried("undamped", only_one),
        carried("work", least_work),
        carried("slip", with_slip),
        carried("far", far_away),
        carried("all", for_all),
        carried(
            "peak",
            argument(
                r"""
                Under a force with $|u|\leqslant U$ the pair sticks until $T_w<\pi/\Omega$, and does not arrive before it: so the bound
                while stuck is one for each force of at most the peak $U$ that arrives by then.
                """,
                certificate,
                *map(kernel.step, ("weak-sticks", "weak-takes", "weak-attained")),
            ),
        ),
    )
