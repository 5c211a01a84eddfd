"""Past the paper: the return map from ray to ray as a power series with rational coefficients."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.finding import Finding, Verdict, conclude
from paper_checks.evidence.formula import latex
from paper_checks.steps.monotone_slips import depth_grows, landings, rise_is_convex
from paper_checks.steps.return_map import ORDER, coefficients, cycle_time, remainder
from theory.return_map import depth_series


@check("return-map-expansion")
def return_map_expansion(context: Context) -> Finding:  # noqa: ARG001
    """c as one power series in y; the mass ratio enters as a factor only."""
    terms = [
        f"{'+' if c > 0 and n > 1 else ''}{latex(c)}y^{{{n}}}" for n, c in enumerate(depth_series(ORDER - 1), start=1)
    ]
    return conclude(
        Verdict.HOLDS,
        "One power series with rational coefficients is the return map of every pair; the mass ratio is a factor in it. "
        "$h^2$ and $c$ are even analytic functions of the slip angle, $h^2=\\theta^2/9+\\cdots$, so $c$ is a power series in $y=h^2$ without any "
        "parameter, and $y'=y-r\\,c^2$. Its Taylor polynomials are exact; what they miss is bounded on the rim of a disc in balls and by "
        "Schwarz's lemma inside.",
        *landings()[3:],
        *coefficients(),
        *rise_is_convex(),
        depth_grows()[0],
        *remainder(),
        *cycle_time(),
        derivation=("$$c(y)=" + "".join(terms) + "+\\cdots$$", "$$y'=y-r\\,c(y)^2,\\qquad w=q\\,y.$$"),
        figure="return-map",
    )
