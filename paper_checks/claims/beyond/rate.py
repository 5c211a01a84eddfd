"""The $1/t$ law as a limit, and with explicit bounds from a stated time on."""

from collections.abc import Callable
from fractions import Fraction
from functools import cache

import sympy as sp
from flint import arb

from numerics.arithmetic.ball import Ball, depth_and_cotangent, sine_deficit, versine
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from numerics.scene import Pair
from paper_checks.claims.beyond.critical_ratio import one_turning_point, threshold
from paper_checks.claims.beyond.excursions import angle_of_excursion, vanishes
from paper_checks.claims.beyond.slips import depth_grows, landings, rise_is_convex
from paper_checks.claims.letters import R, limit_of_energy, of_share
from paper_checks.claims.words import *
from theory.excursion import excursion, h, half_tangent_form
from theory.near_critical import stick_rotation
from theory.power_series import taylor
from theory.rate_bounds import cycle_times, elapsed, excess_bounds, first_angle, first_depth, first_excess, gains
from theory.return_map import depth as depth_of_angle
from theory.return_map import depth_series, in_trigonometry
from theory.symbols import put


@cache
def depth_over_excess() -> Evidence:
    """The limit of c/y at the ray's end."""
    return identity(
        r"$c/y\to\tfrac{3}{2}$ as $y\to 0$",
        [taylor(in_trigonometry(depth_of_angle()) / h() ** 2, theta, 1), depth_series(7)[0]],
        [Rational(3, 2)] * 2,
    )


@cache
def one_step() -> Steps:
    """a' y^2 <= y - y' <= a y^2, and what that makes of 1/y."""
    before, after, low, high, part = symbols("y z a' a kappa", positive=True)
    given = [after < before, before - after >= low * before**2, before - after <= high * before**2]
    return (
        prove(
            r"$a'y^2\leqslant y-y'$ gives $\frac{1}{y'}-\frac{1}{y}\geqslant a'$ (here $z=y'$)",
            given,
            sp.Ge(before - after, low * before * after, evaluate=False),
        ),
        prove(
            r"$y-y'\leqslant a\,y^2$ and $y-y'\leqslant\kappa\,y$ with $\kappa<1$ give $\frac{1}{y'}-\frac{1}{y}\leqslant\frac{a}{1-\kappa}$",
            [*given, part < 1, before - after <= part * before],
            sp.Le((1 - part) * (before - after), high * before * after, evaluate=False),
        ),
        identity(
            r"$h'(\pi/2)=c(\pi/2)=2-\frac{\pi}{2}<1$: for $\theta\leqslant\pi/2$, $\theta-h$ rises ($h'$ rises) and $q\,c<1$",
            [diff(h(), theta).subs(theta, pi / 2), depth_of_angle().subs(theta, pi / 2)],
            (2 - pi / 2) * sp.ones(2, 1),
        ),
    )


@cache
def one_cycle() -> Steps:
    """Slip and stick last between T_- and T_+."""
    one = excursion()
    landed = -one.velocity / one.position
    speed = Symbol("e", positive=True)
    state = {x1_0: one.position, v1_0: one.velocity, epsilon: speed}
    _, sine = (put(part, state) for part in stick_rotation())
    # sin(pi - alpha - beta), tan alpha = e, tan beta = -V'/X', times the two radii
    expected = (speed * one.position - one.velocity) / (one.position**2 + one.velocity**2)
    shortfall = sqrt(q) * (theta - h()) * q * in_trigonometry(depth_of_angle())
    return (
        vanishes(
            r"the stick turns $(X',V')$ to $(-1,-\varepsilon')$, $\varepsilon'=\sqrt{w'}$: by $\pi-\arctan\varepsilon'-\arctan\frac{-V'}{X'}<\pi$",
            half_tangent_form((sine - expected).subs(speed**2, one.position**2 + one.velocity**2 - 1)),
        ),
        vanishes(
            r"""
            so a cycle is shorter than $\pi+\sqrt q\,\theta$, and with $\arctan x\leqslant x$,
            $\varepsilon'<\varepsilon$ it is longer than $\pi+\sqrt q\,\theta-\varepsilon-\frac{-V'}{X'}=\pi-\sqrt
            q\,(\theta-h)\frac{q\,c}{1-q\,c}$
            """,
            half_tangent_form((sqrt(q) * theta - sqrt(q) * h() - landed) * one.position + shortfall),
        ),
    )


def bounded_run(share: Fraction, start: Fraction, count: int) -> Evidence:
    """Enclose a run and compare it with both bounds at every exit and at the end of every slip, where each is tightest."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        theta_0 = arithmetic.number(start)
        y = (sine_deficit(theta_0) / versine(theta_0)) ** 2
        deep, _ = depth_and_cotangent(theta_0)
        lower, upper = bounds(frame.q, theta_0, y, deep)
        tau, good = arithmetic.number(0), True
        for number, one in enumerate(excursions(frame, frame.q * y)):
            if number == count:
                break
            assert one.stick is not None  # the start is below the level of no merging
            good = good and bool(one.w <= upper(tau) * (1 + arb(10) ** -20))
            good = good and bool(one.w_after > lower(tau + one.slip) and one.w_after < upper(tau + one.slip))
            tau = tau + one.slip + one.stick
        text = f"at the last exit {lower(tau).str(6)} <= w <= {upper(tau).str(6)}"
    return enclosed(
        f"$q={share}$, $\\theta_0={start}$: a run of {count} excursions lies between both bounds",
        good,
        text,
        2 * count,
        engine="numerics, balls",
        supports=True,
    )


def bounds(q_value: arb, theta_0: arb, y: arb, deep: arb) -> tuple[Callable[[arb], arb], Callable[[arb], arb]]:
    """Return both bounds of w, theory's in balls, as functions of the reduced time since the exit with angle theta_0."""
    letters = (q, first_excess, first_depth, first_angle, elapsed)
    sides = [sp.lambdify(letters, one, [{"sqrt": arb.sqrt, "pi": arb.pi()}]) for one in excess_bounds()]

    def lower(time: arb) -> arb:
        return sides[0](q_value, y, deep, theta_0, time)

    def upper(time: arb) -> arb:
        return sides[1](q_value, y, deep, theta_0, time)

    return lower, upper


HALF, FIFTH, MOST = Fraction(1, 2), Fraction(1, 5), Fraction(9, 10)


@theorem(
    "sharp-rate-constant",
    clause(
        "limit",
        r"Along every trajectory that never merges «limit» as $t\to\infty$: a limit, the same for every $E(0)$.",
        limit=limit_of_energy(),
        kernel="sharp-law",
    ),
)
def sharp_rate_constant() -> Case:
    """1/w gains 9r/(4q) per excursion and an excursion takes pi, in the limit."""
    return because(
        r"""
        $t\,(E-E_{cr})$ has one limit for all starts that never merge,
        $E_{cr}\,\frac{4\pi}{9}\,\frac{m_1}{m_2}\sqrt{M/a_2}$. A trajectory that never merges tends to $E_{cr}$
        (dichotomy) and from some time on sticks and slips in turn, from ray to ray. There $1/w$ gains $9r/(4q)$ per
        excursion and an excursion with its stick takes $\pi/\Omega$, both in the limit $w\to 0$, so by Stolz and
        Cesàro $1/(\Omega t\,w)\to\frac{9r}{4\pi q}$ along the exits, and as $w_{k+1}/w_k$ and $t_{k+1}/t_k$ tend to
        1, in $t$.
        """,
        depth_over_excess(),
        figure="sharp-rate",
    )


@theorem(
    "rate-bounds-explicit",
    clause(
        "bounds",
        r"""
        Let the pair leave $S_0$ by a ray at $t_0$ with $w_0=q\,y_0$, $y_0\leqslant(\pi/2-1)^2$, $h(\theta_0)^2=y_0$,
        $c_0=c(\theta_0)$. Then for all $t\geqslant t_0$, with $s=\Omega(t-t_0)$, $w=E/E_{cr}-1$ lies between «lower»
        and «upper»,
        """,
        lower=equal(
            r"w_-",
            q / (1 / first_excess + Symbol("A") * (elapsed / Symbol("T_-") + 1)),
            lambda: excess_bounds()[0],
            lambda: {Symbol("A"): gains()[1], Symbol("T_-"): cycle_times()[0]},
        ),
        upper=equal(
            r"w_+",
            q / (1 / first_excess + Symbol("a'") * (elapsed / Symbol("T_+") - 1)),
            lambda: excess_bounds()[1],
            lambda: {Symbol("a'"): gains()[0], Symbol("T_+"): cycle_times()[1]},
        ),
    ),
    clause(
        "constants",
        r"where «slowest», «fastest», «longest», «shortest».",
        slowest=of_share("a'", R * first_depth**2 / first_excess**2, lambda: gains()[0]),
        fastest=of_share("A", 9 * R / 4 / (1 - R * first_depth**2 / first_excess), lambda: gains()[1]),
        longest=equal("T_+", pi + sqrt(q) * first_angle, lambda: cycle_times()[1]),
        shortest=equal(
            "T_-",
            pi - sqrt(q) * (first_angle - sqrt(first_excess)) * q * first_depth / (1 - q * first_depth),
            lambda: cycle_times()[0],
        ),
    ),
)
def rate_bounds_explicit() -> Case:
    """Bounds of one step and of one cycle, valid for all later ones, summed."""
    return because(
        r"""
        From an exit with $w_0\leqslant q(\pi/2-1)^2$ on, $E-E_{cr}$ lies between two explicit functions of time. $c/y$
        falls with $y$ from $\tfrac{3}{2}$ ($c$ is concave in $y$) and $c^2/y=R^{-2}$ rises for $\theta\leqslant\pi/2$,
        so for $y\leqslant y_0$: $a'y^2\leqslant y-y'\leqslant\frac{9r}{4}y^2$ and $y'/y\geqslant 1-r\,c_0^2/y_0$. Hence
        $1/y$ gains between $a'$ and $A$ per excursion; a cycle lasts between $T_-$ and $T_+$; and between two exits $w$
        lies between its values there.
        """,
        *angle_of_excursion(),
        *rise_is_convex(),
        *depth_grows(),
        *landings()[3:],
        *one_turning_point(),
        threshold()[-1],
        depth_over_excess(),
        *one_step(),
        *one_cycle(),
        bounded_run(FIFTH, Fraction(3, 2), 100),
        bounded_run(HALF, Fraction(3, 2), 100),
        bounded_run(MOST, Fraction(1), 100),
        derivation=(
            "$$\\frac{1}{y_0}+n\\,a'\\leqslant\\frac{1}{y_n}\\leqslant\\frac{1}{y_0}+n\\,A,\\qquad n\\,T_-\\leqslant\\tau_n-\\tau_0\\leqslant n\\,T_+.$$",
            "For $\\tau_n\\leqslant\\tau<\\tau_{n+1}$, $s=\\tau-\\tau_0$: $n>s/T_+-1$ and $n+1\\leqslant s/T_-+1$, with $w_{n+1}\\leqslant w\\leqslant w_n$.",
            "As $y_0\\to 0$ both $a'$ and $A$ tend to $\\tfrac{9}{4}r$ and both $T_\\pm$ to $\\pi$: the bounds converge to the sharp constant.",
        ),
        figure="rate-bounds",
    )
