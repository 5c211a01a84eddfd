"""A damper on body 1: the time T from which the pair sticks permanently, and R from which it rests, against a1."""

from paper_checks.claims.letters import MASS
from paper_checks.claims.words import *
from theory.energy import energy as stored
from theory.near_critical import rate_constant

TIME, ROOT, REACH, WITHIN, SWING = symbols("T s X d Omega", positive=True)


# The start of Fig. 5 (a), and one that is stuck at first with a1 = 4 N s/m.
FIGURE = {**EXAMPLE_PAIR, b: Rational("0.05"), v1: Rational("0.15")}
STUCK = {**dict.fromkeys((m1, m2, a2, b, v1, v2), 1), x1: -4}


def sticks_from(point: dict[Symbol, Rational | int], damper: str) -> arb:
    """Return the time, s, from which a start sticks permanently; nan where that is not proved."""
    run = solved(scene_at({**point, a1: Rational(damper)}, "12"))
    return [arb(0), *(one.t for one in run.events)][-1] if stuck_for_ever("", run).passed else arb.nan()


def lasts(damper: str, digits: str) -> Formula:
    """Return T for the start of Fig. 5 (a), enclosed, as a decimal fraction that goes on."""
    return decimal(f"T({damper})", digits, lambda: sticks_from(FIGURE, damper))


def growth() -> Formula:
    """Return the limit of sqrt(a1) T as a1 -> 0."""
    value = pi ** Rational(3, 2) / 3 * sqrt(m1 * MASS / (m2 * SWING))
    return tends(sqrt(a1) * TIME, value, _growth, lambda: {SWING: sqrt(a2 / MASS)})


def _growth() -> Expr:
    excess, friction = symbols("w C", positive=True)
    damper = slip_rate(1).coeff(v1, 2).subs(b, 0) / MASS
    time = sp.integrate(1 / (excess**2 / friction - damper), (excess, 0, oo))
    return sqrt(a1) * time.subs(friction, rate_constant() / critical_energy())


@cache
def slows() -> Evidence:
    """Near the critical orbit friction takes w^2/C per time, the damper a1/M."""
    return argument(
        r"""
        Let the motion with $a_1=0$ slip without end: then it sticks and slips in turn, and $w=E/E_{cr}-1$ falls to $0$.
        A damper is the force $-a_1v_1$, so the motion with it is up to $t_0$ within $a_1t_0\sqrt{2E(0)}/m_1$ of that in
        the energy norm: for small $a_1$ it sticks at a $t_0$ with $0<w\leqslant w_0$, whatever $w_0$. From there on, as
        $a_1,w_0\to 0$: in each half turn of $\pi/\Omega\,(1+o(1))$ the damper takes
        $\frac{\pi}{\Omega}\frac{a_1}{M}(1+o(1))$ from $w$. While $w\geqslant\eta\sqrt{a_1}$, with a fixed $\eta>0$, the
        load reaches its edge with the rate $a_2L\,\Omega\sqrt w\,(1+o(1))$; the slip from there lasts
        $3\sqrt w/\Omega\,(1+o(1))$, ends inside the strip and takes $\frac{\pi}{\Omega}\frac{w^2}{C}(1+o(1))$, as with
        $a_1=0$, where $tw\to C$. So down to $\eta\sqrt{a_1}$ it takes
        $\int_{\eta\sqrt{a_1}}^{w_0}dw/(\frac{w^2}{C}+\frac{a_1}{M})\,(1+o(1))$, and below at most
        $\eta M/\sqrt{a_1}\,(1+o(1))$ until $E$ is below the captive level, which is $E_{cr}(1-O(a_1^2))$, and the pair
        sticks at its next contact. Let $a_1\to 0$, then $\eta\to 0$. If the motion with $a_1=0$ has $E(t_0)<E_{cr}$, so
        has that with a small $a_1$, below the captive level: it sticks from its next contact on.
        """,
        *map(kernel.step, ("sharp-law", "interface-input-to-state", "captive-sticks", "contact")),
    )


def least_time() -> Formula:
    """Return the bound of T from below."""
    return Formula(
        TIME,
        ">=",
        m2 / b * (v2 - 2 * sqrt(b * REACH / m2)),
        implied(lambda: [v1**2 <= 4 * ROOT**2, m2 * v2 <= m2 * v1 + b * TIME], lambda: {REACH: m2 * ROOT**2 / b}),
    )


def stops() -> Formula:
    """Return the limit of R as a1 -> oo, of a start with |x1| < d."""

    def derived() -> Expr:
        left = stored().subs({v1: 0, v2: b * ROOT / m2}) - a2 * WITHIN**2 / 2
        rest = sp.solve(left.subs(ROOT, sqrt(REACH)), REACH)[0]
        return m2 * Abs(v2) / b - sqrt(rest)

    return tends("R", m2 / b * (Abs(v2) - sqrt(a2 * (WITHIN**2 - x1**2) / m2)), derived)


@cache
def passes_once() -> Evidence:
    """E passes a level once, at a time that is continuous in a1; with a heavy damper it creeps there."""
    return argument(
        r"""
        For $a_1>0$ $E$ falls strictly while it is not $0$: $\dot E=0$ needs $v_1=v_2=0$, which is left at once where
        $x_1\neq 0$. As $E$ is continuous in $t$ and $a_1\geqslant 0$, so is the time at which it passes a level where
        $a_1>0$. As $a_1\to\infty$ $v_1\to 0$ and $x_1\to x_1(0)$ at every $t>0$, while $|v_2|$ falls at the rate
        $b/m_2$ to $0$; the pair then sticks, $x_1$ has the slow rate $\frac{a_2}{a_1}(1+O(a_1^{-2}))$, and
        $E=\frac12a_2x_1^2(1+O(a_1^{-2}))$.
        """,
        *map(kernel.step, ("energy-rate", "interface-input-to-state", "heavy-damping")),
        decays,
    )


@cache
def decays() -> Evidence:
    """The stuck pair is a linear oscillator."""
    rate = Symbol("lambda")
    return identity(
        r"stuck, the rates $\lambda$ of decay have $M\lambda^2-a_1\lambda+a_2=0$: their product is $a_2/M$, their sum $a_1/M$",
        MASS * Matrix(sliding_field(damped=True)[:2]).jacobian([x1, v1]).charpoly(rate).as_expr().subs(rate, -rate),
        MASS * rate**2 - a1 * rate + a2,
    )


@theorem(
    "synchronisation-against-damping",
    clause(
        "monotone",
        r"""
        Let $T(a_1)$ be the time from which the pair sticks permanently. It is monotone neither way: from the start of
        Fig. 5 (a), $x_1=x_2=v_2=0$, $v_1=0.15$, $b=0.05$, «first» and «later», but «last» (in s, $a_1$ in N s/m); and a
        damper may be better than both less and more: with $m_1=m_2=a_2=b=1$, $x_1=-4$, $v_1=v_2=1$, $T(4)=0$,
        $T(0)>0$ and $T(7)>0$.
        """,
        first=lasts("0.56", "3.2046"),
        later=lasts("0.63", "3.2378"),
        last=lasts("1", "2.5101"),
    ),
    clause(
        "light",
        r"""
        As $a_1\to 0$: if the motion without a damper slips again and again without end, «growth», $\Omega=\sqrt{a_2/M}$,
        from whatever start and for whatever $b$; if it comes to $E<E_{cr}$, $T$ stays bounded.
        """,
        growth=growth(),
    ),
    clause(
        "heavy",
        r"""
        As $a_1\to\infty$ $T\to m_2|v_2(0)|/b$. So $\inf T=0$ if $v_2(0)=0$. If not, the infimum may be less than this
        limit, and is $0$ in the second example; with $v_2(0)>0$ «least» for every $a_1$, where $X=\sqrt{2E(0)/a_2}$.
        """,
        least=least_time(),
    ),
    clause(
        "rest",
        r"""
        Let $R(a_1)$ be the time from which $E\leqslant a_2d^2/2$, so that $|x_1|\leqslant d$ from then on. $R$ is
        continuous for $a_1>0$. As $a_1\to\infty$, if $|x_1(0)|>d$, $R\sim\frac{a_1}{a_2}\ln\frac{|x_1(0)|}{d}$; if
        $|x_1(0)|<d$, «stops» where that is positive, with the initial $x_1,v_2$, and $R\to 0$ where it is not. As
        $a_1\to 0$, if without a damper $E$ stays above $a_2d^2/2$, $R\to\infty$. So a damper that is best for rest exists if
        $E$ stays above $a_2d^2/2$ without one and $|x_1(0)|>d$; if $x_1(0)=v_2(0)=0$, $R\to 0$ as $a_1\to\infty$.
        """,
        stops=stops(),
    ),
    clause(
        "critical",
        r"""
        As $d\to 0$ with a fixed $a_1>0$ and $E(0)>0$, $R/\ln\frac1d$ tends to $1/\lambda$, where $\lambda$ is the smaller real part of
        the rates at which the stuck pair decays: at most $\sqrt{a_2/M}$, and that for $a_1=2\sqrt{a_2M}$ only. Two
        exceptions are faster: a motion that ends exactly on the faster of two real rates, or at rest at a contact.
        """,
    ),
    assuming=f"{POSITIVE} No force, $u=0$; a damper $a_1\\geqslant 0$.",
)
def synchronisation_against_damping() -> Case:
    """The time of adhesion and the time of rest as functions of the damper."""
    at_once, pull = solved(scene_at({**STUCK, a1: 4}, "9")), Abs(load(damped=True))
    return because(
        """
        A heavy damper stops body 1, and friction alone stops body 2; a light one takes, near the critical orbit, what
        friction no longer takes. A larger damper saves slips: $T$ may fall in steps, and rise between two of them.
        """,
        carried(
            "monotone",
            enclosed(
                "the second start sticks permanently with $a_1=4$, without an event",
                stuck_for_ever("", at_once).passed and at_once.modes == (Mode.STICK,),
                at_once.message,
            ),
            exhibit("with $a_1=0$ it slips at once", {**STUCK, a1: 0}, (pull, ">", load_threshold())),
            exhibit("and with $a_1=7$", {**STUCK, a1: 7}, (pull, ">", load_threshold())),
        ),
        carried("light", slows),
        carried(
            "heavy",
            kernel.step("heavy-damping"),
            argument(
                r"""
                In every mode $|\dot v_2|\leqslant b/m_2$. So $v_2(0)\leqslant v+bT/m_2$ with the velocity $v$ at $T$; and
                if $v>0$ the stuck pair goes on by at least $m_2v^2/(2b)$, while $|x_1|\leqslant X$: $v^2\leqslant
                4bX/m_2=4s^2$.
                """,
                kernel.step("energy-decreases"),
            ),
        ),
        carried("rest", passes_once),
        carried(
            "critical",
            argument(
                r"""
                From $T$ on $E$ is that of the stuck pair, so $\ln E/t\to-2\lambda$, with the slower rate unless its part
                is $0$, or all is. Of two rates with the product $a_2/M$ the smaller real part is at most $\sqrt{a_2/M}$, and that
                only where they are equal.
                """,
                decays,
            ),
        ),
    )
