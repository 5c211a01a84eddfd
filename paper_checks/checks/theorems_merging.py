"""Past the paper: the mass ratio at which merging by re-entry begins, and the energies that merge beyond it."""

from __future__ import annotations

from paper_checks.evidence import Finding, Verdict, conclude
from paper_checks.registry import Context, check
from paper_checks.steps.critical_share import all_slips, certificate, one_turning_point, threshold, worst_slip
from paper_checks.steps.excursions import angle_of_excursion
from paper_checks.steps.merging_window import never_from_below, sign_of_excess, windows
from paper_checks.steps.monotone_slips import contact, depth_grows, landings, one_contact


@check("critical-mass-ratio")
def critical_mass_ratio(context: Context) -> Finding:  # noqa: ARG001
    """The least excess after any slip from S touches zero at one slip from the ray, for one share."""
    return conclude(
        Verdict.HOLDS,
        "Slips from $S$ above $E_{cr}$ can merge only if $m_1/m_2\\leqslant-\\cos\\theta^*$, which is $0.79263\\ldots$: heavier driving bodies never merge after their first contact. "
        "For $r=r^*$ the least excess after a slip from $S$ is that on the ray for angles up to $\\theta_1$ and from $\\theta^*$ on, where "
        "$2r^*\\sin^2\\varphi\\leqslant 1$; there $y'$ rises from $0$ at $\\theta=0$, and from $c^2(R^2-r^*)=0$ at $\\theta^*$. In between it is "
        "$\\min_T w'$, which falls to the same $0$ at $\\theta^*$. So $w'\\geqslant 0$, with equality at one slip from the ray. As $w'$ falls with "
        "$r$, it is positive after every slip from $S$ for $r<r^*$, and negative after that one for $r>r^*$.",
        contact(),
        *one_contact(),
        *landings(),
        *angle_of_excursion(),
        *all_slips(),
        *worst_slip(),
        sign_of_excess()[0],
        *one_turning_point(),
        *threshold(),
        certificate("threshold"),
        derivation=(
            "$$\\varphi^*-\\sin\\varphi^*\\cos\\varphi^*=\\sqrt2\\,(\\sin\\varphi^*-\\varphi^*\\cos\\varphi^*),\\qquad "
            "r^*=\\frac{1}{2\\sin^2\\varphi^*},\\qquad \\frac{m_1}{m_2}=-\\cos 2\\varphi^*.$$",
            "The minimum over $T$ touches zero at $\\theta^*$ with a horizontal tangent: $(\\varphi^*,T=1-C)$ is a critical point of $w'$ in both "
            "variables, so a sign of the derivative there would prove nothing; its factors $1-2r\\sin^2\\varphi$ and "
            "$\\varphi-r(\\varphi-\\sin\\varphi\\cos\\varphi)$ do.",
            "At $r=r^*$ itself one energy merges: from $w=q\\,h(\\theta^*)^2$ on a ray the pair lands on $E=E_{cr}$ inside $S_0$.",
            "So for $r<r^*$ a trajectory in the whole state space merges exactly if $E\\leqslant E_{cr}$ where it first meets $S$; it then sticks there "
            "for ever. Otherwise it sticks up to a ray or slips on from $S$, with $E>E_{cr}$ after each slip, and tends to $E_{cr}$ by the dichotomy.",
        ),
    )


@check("merging-set")
def merging_set(context: Context) -> Finding:  # noqa: ARG001
    """R falls and rises once, so the excursions that merge form one interval of angles."""
    return conclude(
        Verdict.HOLDS,
        "The energies on $S_0$ that merge at the first re-entry form one interval; below it the pair creeps for ever. "
        "$w'/q=c^2(R^2-r)$ with $R=h/c$, which falls from $\\infty$ to $\\sqrt{r^*}$ and rises to $\\infty$: $R^2\\leqslant r$ is one interval "
        "$[\\theta_a,\\theta_b]$, empty for $r<r^*$, and $w=q\\,h^2$ rises with $\\theta$. Below it $0<w'<w$ repeats for ever. As $R$ is strictly "
        "monotone on both sides the roots are continuous in $r$ up to $r=1$.",
        *angle_of_excursion(),
        *landings()[3:],
        *depth_grows()[:2],
        *one_turning_point(),
        *threshold(),
        *sign_of_excess(),
        *never_from_below(),
        windows(),
        certificate("bands"),
        derivation=(
            "$$\\text{merges at the first re-entry}\\iff q\\,h(\\theta_a)^2\\leqslant w\\leqslant q\\,h(\\theta_b)^2,\\qquad "
            "h(\\theta_{a,b})=\\sqrt r\\,c(\\theta_{a,b}).$$",
            '"Slightly higher than $E_{cr}$" is thus sharp: below $w_a=q\\,h(\\theta_a)^2$ nothing on $S_0$ merges, at $w_a$ it does.',
            "At the ends $E=E_{cr}$: the landing is in $S_0$, so $\\theta_b\\leqslant\\theta_c$. Between $\\theta_b$ and $\\theta_c$ the pair leaves $S_0$ "
            "again with a smaller $w$, beyond $\\theta_c$ it slips on from $S$: membership is decided by iterating the closed forms.",
            "For $m_1/m_2\\to 0$ all of $[w_a,w_b]$ shrinks to $0$ like $q$; for $m_1/m_2>-\\cos\\theta^*$ it is empty.",
        ),
    )
