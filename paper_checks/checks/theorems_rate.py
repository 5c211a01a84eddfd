"""Past the paper: the 1/t law as a limit, with explicit bounds from a stated time on, and its next terms."""

from __future__ import annotations

from fractions import Fraction

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.finding import Finding, Verdict, conclude
from paper_checks.steps.critical_share import one_turning_point, threshold
from paper_checks.steps.excursions import angle_of_excursion
from paper_checks.steps.long_time import constant_found_again, expansion
from paper_checks.steps.monotone_slips import depth_grows, landings, rise_is_convex
from paper_checks.steps.rate import bounded_run, enclosed_limit, limit_of_steps, one_cycle, one_step
from paper_checks.steps.return_map import coefficients, cycle_time

HALF, FIFTH, MOST = Fraction(1, 2), Fraction(1, 5), Fraction(9, 10)


@check("sharp-rate-constant")
def sharp_rate_constant(context: Context) -> Finding:  # noqa: ARG001
    """1/w gains 9r/(4q) per excursion and an excursion takes pi, in the limit."""
    return conclude(
        Verdict.HOLDS,
        "$t\\,(E-E_{cr})$ has one limit for all starts that never merge, $E_{cr}\\,\\frac{4\\pi}{9}\\,\\frac{m_1}{m_2}\\sqrt{M/a}$. "
        "A trajectory that never merges tends to $E_{cr}$ (dichotomy) and from some time on sticks and slips in turn, from ray to ray. "
        "There $1/w$ gains $9r/(4q)$ per excursion and an excursion with its stick takes $\\pi/\\Omega$, both in the limit $w\\to 0$, so "
        "by Stolz and Cesàro $1/(\\Omega t\\,w)\\to\\frac{9r}{4\\pi q}$ along the exits, and as $w_{k+1}/w_k$ and $t_{k+1}/t_k$ tend to 1, in $t$.",
        *angle_of_excursion(),
        *landings()[3:],
        *limit_of_steps(),
        enclosed_limit(HALF, Fraction(3, 2), "1e12", Fraction(1, 10**10)),
        enclosed_limit(HALF, Fraction(11, 10), "1e12", Fraction(1, 10**10)),
        enclosed_limit(MOST, Fraction(3, 2), "1e12", Fraction(1, 10**8)),
        derivation=(
            "$$\\lim_{t\\to\\infty}t\\,(E-E_{cr})=E_{cr}\\,\\frac{4\\pi}{9}\\,\\frac{m_1}{m_2}\\sqrt{\\frac{m_1+m_2}{a}}"
            "=\\frac{2\\pi}{9}\\,\\frac{b^2m_1(m_1+m_2)^{5/2}}{a^{3/2}m_2^3}$$",
        ),
        figure="sharp-rate",
    )


@check("rate-bounds-explicit")
def rate_bounds_explicit(context: Context) -> Finding:  # noqa: ARG001
    """Bounds of one step and of one cycle, valid for all later ones, summed."""
    return conclude(
        Verdict.HOLDS,
        "From an exit with $w_0\\leqslant q(\\pi/2-1)^2$ on, $E-E_{cr}$ lies between two explicit functions of time. "
        "$c/y$ falls with $y$ from $\\tfrac{3}{2}$ ($c$ is concave in $y$) and $c^2/y=R^{-2}$ rises for $\\theta\\leqslant\\pi/2$, so for $y\\leqslant y_0$: "
        "$a'y^2\\leqslant y-y'\\leqslant\\frac{9r}{4}y^2$ and $y'/y\\geqslant 1-r\\,c_0^2/y_0$. Hence $1/y$ gains between $a'$ and $A$ per excursion; a "
        "cycle lasts between $T_-$ and $T_+$; and between two exits $w$ lies between its values there.",
        *angle_of_excursion(),
        *rise_is_convex(),
        *depth_grows(),
        *landings()[3:],
        *one_turning_point()[:4],
        threshold()[-1],
        limit_of_steps()[0],
        *one_step(),
        *one_cycle(),
        bounded_run(FIFTH, Fraction(3, 2), 100),
        bounded_run(HALF, Fraction(3, 2), 100),
        bounded_run(MOST, Fraction(1), 100),
        derivation=(
            "$$\\frac{1}{y_0}+n\\,a'\\leqslant\\frac{1}{y_n}\\leqslant\\frac{1}{y_0}+n\\,A,\\qquad n\\,T_-\\leqslant\\tau_n-\\tau_0\\leqslant n\\,T_+.$$",
            "For $\\tau_n\\leqslant\\tau<\\tau_{n+1}$, $s=\\tau-\\tau_0$: $n>s/T_+-1$ and $n+1\\leqslant s/T_-+1$, with $w_{n+1}\\leqslant w\\leqslant w_n$.",
            "As $y_0\\to 0$ both $a'$ and $A$ tend to $\\tfrac{9}{4}r$ and both $T_\\pm$ to $\\pi$: the bounds close on the sharp constant.",
        ),
        figure="rate-bounds",
    )


@check("long-time-expansion")
def long_time_expansion(context: Context) -> Finding:  # noqa: ARG001
    """The Abel function of the return map, to the order that leaves a convergent sum."""
    return conclude(
        Verdict.HOLDS,
        "The next term of $w$ is a logarithm, with $B=1-\\frac{2}{5r}$; the start enters after it, as one number $K$. "
        "Along the exits $A(y)=\\frac{1}{\\alpha y}+B\\ln y$ grows by $1+O(y^2)$ and the time by $\\pi+O(y^{3/2})$; both errors are summable, as "
        "$y_n\\sim\\frac{1}{\\alpha n}$, so $\\pi A(y_n)-\\tau_n$ tends to a number $K$, with the error $O(\\tau^{-1/2})$ of the second tail. Solved for $y$ "
        "that is the expansion. $K$ is all that is left of the start.",
        *landings()[3:],
        *coefficients(),
        *cycle_time(),
        *expansion(),
        constant_found_again(HALF, Fraction(3, 2)),
        constant_found_again(HALF, Fraction(11, 10)),
        constant_found_again(MOST, Fraction(3, 2)),
        derivation=(
            "$$\\frac{E-E_{cr}}{E_{cr}}=\\frac{C}{\\tau}\\Bigl(1-\\frac{\\pi B\\ln(\\alpha\\tau/\\pi)+K}{\\tau}+O(\\tau^{-3/2})\\Bigr)$$",
            "$E(0)$ enters at the order $\\tau^{-2}$ only, through $K$: two trajectories differ by $C\\,(K_2-K_1)/\\tau^2$ in $w$.",
            "The error of $\\tau^{-1/2}$ in $K$ is $\\varepsilon=\\sqrt w$ to leading order: the next term of the time is $-\\varepsilon$.",
        ),
        figure="long-time",
    )
