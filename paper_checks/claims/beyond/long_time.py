"""The next terms of the $1/t$ law: a logarithm, and one number that is left of the start."""

from paper_checks.claims.beyond.uniform_rate import quotients
from paper_checks.claims.letters import R, of_share
from paper_checks.claims.words import *
from theory.long_time import (
    balanced_share,
    leading_coefficient,
    logarithm_weight,
    map_coefficients,
)


@theorem(
    "long-time-expansion",
    clause(
        "expansion",
        r"""
        With $\tau=\Omega t$, from some exit of a trajectory that never merges on, at the exits,
        $w=\frac{C}{\tau}\Bigl(1-\frac{\pi B\ln(\alpha\tau/\pi)+K}{\tau}+O(\tau^{-3/2})\Bigr)$ with «leading», «alpha»,
        «weight» and one number $K$.
        """,
        leading=of_share("C", 4 * pi * q / (9 * R), leading_coefficient),
        alpha=of_share(r"\alpha", Rational(9, 4) * R, lambda: map_coefficients()[0]),
        weight=of_share("B", 1 - 2 / (5 * R), logarithm_weight),
    ),
    clause(
        "balanced",
        r"The logarithm vanishes for «ratio».",
        ratio=equal("m_1/m_2", Rational(3, 2), lambda: 1 / balanced_share() - 1),
    ),
)
def long_time_expansion() -> Case:
    """The Abel function of the return map, to the order that leaves a convergent sum."""
    return because(
        r"""
        The next term of $w$ is a logarithm, with $B=1-\frac{2}{5r}$; the initial state enters after it, as one number
        $K$. Along the exits $A(y)=\frac{1}{\alpha y}+B\ln y$ grows by $1+O(y^2)$ and the time by $\pi+O(y^{3/2})$; both
        errors are summable, as $y_n\sim\frac{1}{\alpha n}$, so $\pi A(y_n)-\tau_n$ tends to a number $K$, with the
        error $O(\tau^{-1/2})$ of the second tail. Solved for $y$ that is the expansion. Only $K$ depends on the start.
        """,
        carried("expansion", kernel.step("long-time"), quotients),
        carried("balanced"),
    )
