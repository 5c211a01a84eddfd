"""Slips from a ray near the critical energy: they end inside $S_0$, and lose energy like $1/t$."""

from paper_checks.claims.section_3.convergence import merges_or_creeps
from paper_checks.claims.words import *
from theory.excursion import angle, h_slope, half_angle_slope, half_tangent_form
from theory.near_critical import inverse_step
from theory.return_map import (
    return_map_slope_residual,
)


def vanishes(statement: str, expression: Expr) -> Evidence:
    """Return that an expression in theta, sin theta, cos theta is 0: decided by its form in theta and tan(theta/2)."""
    form = half_tangent_form(expression)
    value = "0 as a fraction in theta, tan(theta/2)" if form == 0 else f"{form}"
    return Evidence(EvidenceKind.EXACT, "sympy", statement, form == 0, 1, value)


@cache
def angle_of_excursion() -> Steps:
    """The excursion ends at the one angle with h(theta) = u, as h rises from 0 on (0, 2 pi)."""
    _, increment = half_angle_slope()
    return (
        identity(
            r"""
            $h'(2\varphi)=(\sin\varphi-\varphi\cos\varphi)/\sin^3\varphi$, and $\sin\varphi-\varphi\cos\varphi$ is 0 at 0 and has
            the derivative $\varphi\sin\varphi>0$ on $(0,\pi)$, so $h'>0$
            """,
            [h_slope().subs(theta, 2 * angle), increment.subs(angle, 0), diff(increment, angle)],
            [increment / sin(angle) ** 3, 0, angle * sin(angle)],
        ),
    )


@cache
def never_merges() -> Steps:
    """From a ray with w <= q (pi/2 - 1)^2 an excursion ends inside S0 with 0 < w' < w, for every mass ratio."""
    cosine, fraction = symbols("c q", real=True)
    return (
        vanishes(r"$dw'/dw=1-r(1-\cos\theta)$", return_map_slope_residual()),
        prove(
            r"$1-r(1-\cos\theta)>0$ for $\theta\leqslant\pi/2$ and every mass ratio, so $w'$ rises with $w$ from 0",
            [fraction > 0, fraction < 1, cosine >= 0, cosine <= 1],
            signed(1 - (1 - fraction) * (1 - cosine), ">"),
        ),
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
