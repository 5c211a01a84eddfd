"""Past the paper: the 1/t law with an error term, and what of it E(0) alone fixes."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.evidence import argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps.rate_with_error import law_with_error
from paper_checks.steps.uniform_rate import no_lower, upper


@check("rate-with-error")
def rate_with_error(context: Context) -> Finding:  # noqa: ARG001
    """What one cycle adds to both sides of the law, enclosed and summed."""
    return conclude(
        Verdict.HOLDS,
        "The next term of the $1/t$ law is a logarithm, and what is left is bounded by the start alone. One cycle adds $\\pi G-F$ to what is "
        "left. Each of the two is at most a constant, the same for every mass ratio, times a difference that telescopes along the exits; so "
        "the sum is bounded.",
        carried("error", law_with_error()),
        derivation=(
            "$$\\frac{C}{w_n}+\\pi B\\ln\\frac{w_n}{w_0}=\\frac{C}{w_0}+\\tau_n+R_n,\\qquad R_n=\\sum_{k<n}(\\pi G_k-F_k).$$",
            "The bounds are uniform in $n$; they are loose for small $r=m_2/M$, where the law itself takes long to set in.",
        ),
        figure="rate-with-error",
    )


@check("uniform-rate")
def uniform_rate(context: Context) -> Finding:  # noqa: ARG001
    """An upper bound that E(0) fixes; a family that shows that there is no lower one."""
    return conclude(
        Verdict.HOLDS,
        "$E(0)$ fixes an upper bound of $E-E_{cr}$ over all trajectories, and no lower one. From above: $S$ is met within a bounded time, few "
        "slips cross, and every other cycle adds to $1/w$. From below: trajectories with one $E(0)$ may lose as much of it as one likes "
        "in their first slip. For starts on $S_0$ slightly above $E_{cr}$ both constants exist (rate-one-over-t).",
        carried(
            "one",
            argument(
                "$\\tau w_+$ is bounded: $w_+\\leqslant q\\,y_0$ up to some time, and is at most a constant over $\\tau$ after it, both by $E(0)$ alone.",
                upper(),
            ),
        ),
        carried("upper", upper()),
        carried("lower", no_lower()),
        derivation=(
            "$$X=r,\\quad V=\\sqrt{1-r^2+\\delta},\\qquad V_1-V_2=V(\\cos\\sigma-1)-\\sqrt q\\,\\sigma<0\\quad(\\sigma>0)$$",
        ),
        figure="uniform-rate",
    )
