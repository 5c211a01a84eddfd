"""Is creeping robust? Static friction above kinetic, by any jump, ends it; a finite slope of friction keeps its rate."""

from paper_checks.claims.letters import limit_of_energy
from paper_checks.claims.words import *
from theory import finite_slope
from theory.finite_slope import SCALED, scaled_time, slope
from theory.scaling import to_si


@cache
def merges_or_tends() -> Evidence:
    """With a finite slope a motion merges, or from some time on its excess tends to 0 from ray to ray."""
    return argument(
        r"""
        $E$ falls, and as $b(\cdot)\geqslant b_{\min}$ the velocities agree again and again. Where they do with
        $E\leqslant E_{cr}$ the pair sticks permanently: that is a motion, and there is only one. Otherwise $E>E_{cr}$
        always; $\dot z\to 0$, so friction in slip tends to $b$, and the path of $\dot z$ is finite, so the pair tends
        to a stuck motion whose load is within $b$. Hence $E\to E_{cr}$. Where that motion has $|\Lambda|<b$ the pair
        sticks from some time on, up to $|\Lambda|=b$: it leaves $S_0$ by the rays, with $w\to 0$.
        """,
        kernel.step("interface-synchronises"),
        kernel.step("state-well-posed"),
    )


@cache
def slope_drops_out() -> Evidence:
    """One excursion: in scaled time its equations tend to those of a constant friction, and its end is simple."""
    place, speed, relative = SCALED
    return argument(
        r"""
        Let $b(\cdot)=(1-g)\,b$ in a slip from a ray with the speed $\varepsilon=\sqrt w$. In the time $\varepsilon s$,
        $X=1+\varepsilon^2\xi$, $V_2=\varepsilon\eta$ and $V_2-V_1=\varepsilon^3y$ have $\xi'=\eta-\varepsilon^2y$,
        $\eta'=-1+g$, $y'=(\xi+g/\varepsilon^2)/q$, and $|g|\leqslant\ell\,\varepsilon^3|y|$ as the slope is bounded: it
        drops out as $\varepsilon\to 0$. On $s\leqslant 4$ the quotient $y/s^2$ tends uniformly to $(3-s)/(6q)$, so the
        slip ends at $s\to 3$. It loses $2r\varepsilon^4\int(1-g)\,y\,ds$, in the limit as much as with constant
        friction, so $\frac1{w'}-\frac1w\to\frac{9r}{4q}$. It ends with $X=1-\frac32w+o(w)$,
        $V=-2\varepsilon+o(\varepsilon)$, inside $S_0$, with $0<w'<w$, and the pair sticks until it leaves by the other
        ray, $\pi+o(\varepsilon)$ after the first exit. So it goes on without end if $w$ is small.
        """,
        identity(
            r"with $g=k\,\varepsilon^3y$ these are the equations",
            finite_slope.scaled_field(),
            [
                speed - epsilon**2 * relative,
                slope * epsilon**3 * relative - 1,
                (place + slope * epsilon * relative) / q,
            ],
        ),
        identity(
            r"as $\varepsilon\to 0$, $y\to s^2(3-s)/(6q)$",
            finite_slope.path()[2].coeff(epsilon, 0),
            scaled_time**2 * (3 - scaled_time) / (6 * q),
        ),
    )


@cache
def next_term() -> Evidence:
    """What the slope adds to the gain, and the sum of that."""
    return argument(
        r"""
        With $b(\rho)/b=1-\kappa\rho+o(\rho)$ the same limits are taken with the next power of $\varepsilon$; as $y_0$
        vanishes at $s=3$, the end of the slip changes the loss at the power after that only. So $\frac1{w_n}$ is
        $an+2c\sqrt{an}+o(\sqrt n)$ with $a=\frac{9r}{4q}$, $c=\frac{6k}{5q}$, and the time is $\pi n+o(\sqrt n)$. Between two
        exits $w$ and the time change by the factor $1+O(1/n)$.
        """,
        slope_drops_out,
        cites=("Stolz and Cesàro",),
    )


@theorem(
    "static-friction-stops-creeping",
    clause(
        "costs",
        r"""
        Let friction be $b_k>0$ in slip and up to $b_s>b_k$ at rest, $u=0$, $a_1\geqslant 0$, and let a pair with $\dot
        z=0$ stick while its load has $|\Lambda|<b_s$, also where a slip ends that could go over into the other. Then a
        slip from a contact to the next one lasts longer than $h_0$ and dissipates at least $e_0$:
        $h_0=(b_s-b_k)/\bigl(2C+(b_s-b_k)\sqrt{a_2/m_1}\bigr)$, $e_0=b_k\kappa\,(b_s-b_k)\,h_0^2/16$,
        $\kappa=\frac1{m_1}+\frac1{m_2}$, and
        $C=\frac{m_2}{m_1+m_2}\bigl(a_2\sqrt{2E/m_1}+\frac{a_1}{m_1}(a_2\sqrt{2E/a_2}+a_1\sqrt{2E/m_1}+b_s)\bigr)$ with
        $E=E(0)$.
        """,
        kernel="static-slip-costs",
    ),
    clause("few", r"So there are at most $E(0)/e_0$ such slips,", kernel="static-few-slips"),
    clause("sticks", r"and the pair sticks permanently from a finite time on.", kernel="static-sticks-at-last"),
    clause(
        "choice",
        r"""
        That sticks are kept must be assumed: for $a_1=0$ a stuck pair with $b_k<|\Lambda|<b_s$ has motions that leave
        the stick at each time of an interval.
        """,
        kernel="jump-ill-posed",
    ),
    clause("exists", r"A motion that keeps them exists from every state.", kernel="static-kept"),
    clause(
        "slope",
        r"""
        A finite slope is no jump. Let friction in slip be $b(|\dot z|)\geqslant b_{\min}>0$ with a bounded slope, at rest up
        to $b=b(0)$, $u=0$, $a_1=0$. Then every motion that never merges has «limit», whatever the slope; and all that
        leave $S_0$ by a ray with a small enough $w=E/E_{cr}-1$ never merge.
        """,
        limit=limit_of_energy(),
    ),
    clause(
        "step",
        r"""
        If $b(\rho)=b\,(1-\kappa\rho+o(\rho))$, then with $k=\kappa L\Omega$ an excursion from a ray to the next has
        «gain», but for $o(\sqrt w)$,
        """,
        gain=equal(
            r"\tfrac{4q}{9r}\bigl(\tfrac1{w'}-\tfrac1w\bigr)",
            1 + 6 * slope * sqrt(w) / (5 * q),
            finite_slope.gain,
            lambda: {sqrt(w): epsilon},
        ),
    ),
    clause(
        "approach",
        r"""
        so that, with $\tau=\Omega t$ and $C=\frac{4\pi q}{9r}$, «approach»: friction that falls lets $t\,(E-E_{cr})$ come to its
        limit from below, friction that rises from above.
        """,
        approach=tends(
            r"\sqrt\tau\,\bigl(\tfrac{\tau w}C-1\bigr)",
            -Rational(8, 5) * slope * (m1 + m2) * sqrt(pi / (m1 * m2)),
            lambda: to_si(finite_slope.approach()),
        ),
    ),
    assuming="$m_1,m_2,a_2>0$. No force, $u=0$; and not Coulomb's law with one $b$: friction at rest is larger than in slip, or friction depends on the speed of slip.",
)
def static_friction_stops_creeping() -> Case:
    """Every slip after a jump begins with more than friction takes; a slope is felt by its square root of w only."""
    return because(
        r"""
        With static friction above kinetic by any jump the free pair sticks permanently from a finite time on, if sticks are
        kept; with any finite slope the $1/t$ law keeps its constant. A stick that is kept up to $b_s$ ends with a load that
        exceeds kinetic friction by $b_s-b_k$, and the load changes at a bounded rate: the slip that follows has a least
        duration and a least loss. Without the jump slips near $E_{cr}$ are so slow, $|\dot z|$ of the order $w^{3/2}$, that
        friction is almost $b$ in them, and they may lose arbitrarily little.
        """,
        carried("slope", merges_or_tends, slope_drops_out),
        carried("step", next_term),
        carried("approach", next_term),
        figure="static-friction",
    )
