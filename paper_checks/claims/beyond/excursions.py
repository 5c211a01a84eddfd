"""Slips from a ray near the critical energy: they end inside $S_0$, and lose energy like $1/t$."""

from itertools import islice

from numerics.arithmetic.ball import Ball
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from paper_checks.claims.section_3 import capture
from paper_checks.claims.section_3.capture import mirror_image
from paper_checks.claims.section_3.convergence import merges_or_creeps
from paper_checks.claims.words import *
from theory.excursion import angle, excursion, guard_of_u, h, h_limits, h_slope, half_angle_slope, half_tangent_form
from theory.near_critical import cycle_limit, inverse_step, quadratic_coefficient, rate_constant
from theory.rate_bounds import no_merging_excess
from theory.return_map import (
    depth,
    depth_slope_residual,
    in_trigonometry,
    return_map_residuals,
    return_map_slope_residual,
)


def vanishes(statement: str, expression: Expr) -> Evidence:
    """Return that an expression in theta, sin theta, cos theta is 0: decided by its form in theta and tan(theta/2)."""
    form = half_tangent_form(expression)
    value = "0 as a fraction in theta, tan(theta/2)" if form == 0 else f"{form}"
    return Evidence(EvidenceKind.EXACT, "sympy", statement, form == 0, 1, value)


@cache
def angle_of_excursion() -> Steps:
    """The excursion ends at the one angle with h(theta) = u; h rises from 0 to infinity on (0, 2 pi)."""
    _, increment = half_angle_slope()
    at_zero, at_full_turn = h_limits()
    return (
        vanishes(
            r"""
            the guard is $(1-\cos\theta)(h(\theta)-\nu)$, $h=\frac{\theta-\sin\theta}{1-\cos\theta}$: its double root
            at the start divided out
            """,
            guard_of_u() - (1 - cos(theta)) * (h() - h_value),
        ),
        identity(
            r"$h'(2\varphi)=(\sin\varphi-\varphi\cos\varphi)/\sin^3\varphi$",
            h_slope().subs(theta, 2 * angle),
            increment / sin(angle) ** 3,
        ),
        identity(
            r"$\sin\varphi-\varphi\cos\varphi$ is 0 at 0 and has the derivative $\varphi\sin\varphi>0$ on $(0,\pi)$, so $h'>0$",
            [increment.subs(angle, 0), diff(increment, angle)],
            [0, angle * sin(angle)],
        ),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"$h\to 0$ as $\theta\to 0$ and $h\to\infty$ as $\theta\to 2\pi$",
            (at_zero, at_full_turn) == (0, oo),
            2,
            f"limits {at_zero} and {'unbounded' if at_full_turn == oo else at_full_turn}",
        ),
    )


@cache
def never_merges() -> Steps:
    """From a ray with w <= q (pi/2 - 1)^2 an excursion ends inside S0 with 0 < w' < w, for every mass ratio."""
    cosine, fraction = symbols("c q", real=True)
    before, after = return_map_residuals()
    return (
        mirror_image(),
        vanishes(r"with $y=w/q$: $y=h^2$ at the start of the slip", before),
        vanishes(
            r"and $y'=h^2-r\,c^2$ after it, $c(\theta)=2-\theta\cot(\theta/2)$, $r=m_2/(m_1+m_2)$; so $w'<w$", after
        ),
        vanishes(r"$dw'/dw=1-r(1-\cos\theta)$", return_map_slope_residual()),
        prove(
            r"$1-r(1-\cos\theta)>0$ for $\theta\leqslant\pi/2$ and every mass ratio, so $w'$ rises with $w$ from 0",
            [fraction > 0, fraction < 1, cosine >= 0, cosine <= 1],
            signed(1 - (1 - fraction) * (1 - cosine), ">"),
        ),
        vanishes(r"$c'=h>0$: the depth grows with the angle", depth_slope_residual()),
        identity(
            r"from $c\to 0$ as $\theta\to 0$ to $c(\pi)=2$",
            [taylor(in_trigonometry(depth()), theta, 1), depth().subs(theta, pi)],
            [0, 2],
        ),
        vanishes(
            r"at re-entry $1-X=q\,c(\theta)$, so in $(0,2)$ for $\theta\leqslant\pi$: inside $S_0$",
            1 - excursion().position - q * in_trigonometry(depth()),
        ),
        identity(r"the level at $\theta=\pi/2$ is $w=q(\pi/2-1)^2$", no_merging_excess(), q * (pi / 2 - 1) ** 2),
    )


@cache
def heads_for_the_other_ray() -> Evidence:
    """At re-entry V < 0 after an excursion from l_+: the stick that follows ends on l_-, near half a turn on."""
    inward = (sin(theta) - theta * cos(theta)) / (1 - cos(theta))
    return vanishes(
        r"""
        at re-entry $-V=\sqrt q\,\frac{\sin\theta-\theta\cos\theta}{1-\cos\theta}>0$ for $\theta<\pi$: the pair moves
        away from the ray that it left, to the other one
        """,
        excursion().velocity / sqrt(q) + inward,
    )


def no_merging_at_any_energy() -> Evidence:
    """For m2 <= m1 the factor 1 - r (1 - cos theta) is never negative: no excursion from a ray merges by re-entry."""
    cosine, share = symbols("c r", real=True)
    return prove(
        r"for $m_2\leqslant m_1$, $1-r(1-\cos\theta)\geqslant 0$ at every angle, so $w'>0$ after every excursion from a ray",
        [share > 0, 2 * share <= 1, cosine >= -1, cosine <= 1],
        signed(1 - share * (1 - cosine), ">="),
    )


def enclosed_rate(share: Fraction, start: Fraction, count: int, tolerance: Fraction) -> Evidence:
    """Enclose tau w over its limit 4 pi q/(9 r) after many excursions, for m1/M = share and excess `start`."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        tau, w = arithmetic.number(0), arithmetic.number(start)
        for one in islice(excursions(frame, w), count):
            tau, w = tau + one.slip + one.stick, one.w_after
        ratio = tau * w * 9 * frame.r / (4 * arb.pi() * frame.q)
        near = abs(ratio - 1) < arithmetic.number(tolerance)
        text = str(ratio.mid().str(12, radius=False))
    return enclosed(
        f"$m_1/M={share}$, $w_0={start}$: after {count} excursions $\\tau w$ over its limit is within {float(tolerance):.0%} of 1",
        bool(near),
        text,
        count,
        engine="numerics, balls",
        supports=True,
    )


EVENTUALLY = """
The trajectory tends to one motion on the critical ellipse. Near its crossing of $x_1=0$ both fields push to $S$, so
the trajectory is on $S_0$ there from some time on; it then sticks up to a ray, which it leaves with a small excess
$w$, and the excursion ends inside $S_0$ again.
"""


@cache
def creeps_for_ever() -> Evidence:
    """From S0 slightly above E_cr the pair never merges, and tends to the critical orbit."""
    return argument(
        r"""
        On $S_0$ above $E_{cr}$ the pair sticks up to a ray. From there with $w\leqslant q(\pi/2-1)^2$ every excursion
        ends inside $S_0$ with $0<w'<w$, by induction without end; so $E>E_{cr}$ permanently, and the trajectory tends
        to the critical orbit.
        """,
        capture.leaves_above_critical,
        angle_of_excursion,
        never_merges,
        merges_or_creeps,
    )


def printed_rate_constant() -> Expr:
    """Return the sharp constant of the 1/t law as the report states it, J s."""
    return b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2) * 4 * pi / 9 * m1 / m2 * sqrt((m1 + m2) / a2)


@cache
def sharp_limit() -> Evidence:
    """Return that t (E - E_cr) tends to the sharp constant."""
    return argument(
        r"""
        Along the exits $1/w$ gains $9r/(4q)$ and the time $\pi/\Omega$ per cycle, both in the limit, so $1/(t\,w)$
        tends to their quotient; between two exits $w$ lies between its values there, whose ratio tends to 1, as does
        that of the times.
        """,
        creeps_for_ever,
        identity("$1/w'-1/w\\to 9r/(4q)$ as $w\\to 0$", inverse_step(), 9 * r / (4 * q)),
        identity("equivalently $w'=w-\\tfrac{9r}{4q}w^2+\\dots$", quadratic_coefficient(), 9 * r / (4 * q)),
        identity("the time of a cycle tends to $\\pi/\\Omega$", cycle_limit(), pi),
        identity(
            "so $t\\,(E-E_{cr})\\to E_{cr}\\,\\tfrac{4\\pi}{9}\\tfrac{m_1}{m_2}\\sqrt{(m_1+m_2)/a_2}$",
            rate_constant(),
            printed_rate_constant(),
        ),
        identity("with $E_{cr}$ as derived", critical_energy(), b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2)),
        cites=("Stolz and Cesàro",),
    )


@cache
def two_sided() -> Evidence:
    """Return that t (E - E_cr) is bounded from both sides, by numbers that depend on E(0) alone."""
    return argument(
        r"""
        A continuous positive $t\,w(t)$ with a positive limit is bounded from both sides on $[t_0,\infty)$. A start on
        $S_0$ with $E(0)>E_{cr}$ is on one of two arcs, mirror images of each other, on which only the time to the
        ray, at most half a period, depends on the start: over these times the bounds are attained, so they depend on
        $E(0)$ and $t_0$ alone.
        """,
        sharp_limit,
    )
