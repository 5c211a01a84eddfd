"""Past the paper: the mass ratio at which merging by re-entry begins, and the energies that merge beyond it."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps.certified import certificate
from paper_checks.steps.critical_share import one_turning_point, threshold
from paper_checks.steps.merging_no_slip import first_landing, no_slip_merges
from paper_checks.steps.merging_window import never_from_below, windows
from paper_checks.steps.reentry import reentry_above_critical


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
        carried("root", *threshold(), *one_turning_point(), certificate("threshold")),
        carried("heavier", no_slip_merges()),
        carried(
            "lighter",
            argument(
                "For $r>r^*$ the interval of merging-set is not empty, for $r=r^*$ it is one point.", first_landing()
            ),
        ),
        carried(
            "equal",
            argument(
                "$R=h/c$ falls to $\\sqrt{r^*}$ at $\\theta^*$ and rises from there, strictly: $R^2\\leqslant r^*$ at $\\theta^*$ alone.",
                first_landing(),
                *threshold(),
                *one_turning_point(),
            ),
        ),
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
        figure="merging-window",
    )


def below_the_interval() -> Evidence:
    """Below the interval the pair creeps for ever."""
    return argument(
        "Below $\\theta_a$ every slip from a ray ends in $S_0$ with $0<w'<w$, so below $\\theta_a$ again, by induction without end.",
        first_landing(),
        *never_from_below(),
    )


@check("merging-set")
def merging_set(context: Context) -> Finding:  # noqa: ARG001
    """R falls and rises once, so the excursions that merge form one interval of angles."""
    return conclude(
        Verdict.HOLDS,
        "The energies on $S_0$ that merge at the first re-entry form one interval, whether the pair crosses $S$ before it or not; "
        "below it the pair creeps for ever. "
        "$w'/q=c^2(R^2-r)$ with $R=h/c$, which falls from $\\infty$ to $\\sqrt{r^*}$ and rises to $\\infty$: $R^2\\leqslant r$ is one interval "
        "$[\\theta_a,\\theta_b]$, empty for $r<r^*$, and $w=q\\,h^2$ rises with $\\theta$. Below it $0<w'<w$ repeats for ever. As $R$ is strictly "
        "monotone on both sides the roots are continuous in $r$ up to $r=1$. A pair that crosses $S$ does so in long and short slips in "
        "turn, and its re-entry, at the end of a short one, is above $E_{cr}$.",
        carried("interval", first_landing()),
        carried("roots", first_landing(), *threshold(), *one_turning_point()),
        carried("leads", first_landing()),
        carried(
            "crossings",
            argument("The first re-entry after crossings does not merge.", reentry_above_critical(), first_landing()),
        ),
        carried(
            "same",
            argument("The first re-entry after crossings does not merge.", reentry_above_critical(), first_landing()),
        ),
        carried("below", below_the_interval()),
        carried(
            "none",
            argument("For $r<r^*\\leqslant R^2$, $w'>0$ after every slip from a ray.", first_landing(), *threshold()),
        ),
        carried(
            "limits",
            argument(
                "$R$ is strictly monotone on both sides of $\\varphi^*$, so both roots are continuous in $r$ up to $r=1$.",
                first_landing(),
                windows(),
                *threshold(),
            ),
        ),
        derivation=(
            "$$\\text{merges at the first re-entry}\\iff q\\,h(\\theta_a)^2\\leqslant w\\leqslant q\\,h(\\theta_b)^2,\\qquad "
            "h(\\theta_{a,b})=\\sqrt r\\,c(\\theta_{a,b}).$$",
            '"Slightly higher than $E_{cr}$" is thus sharp: below $w_a=q\\,h(\\theta_a)^2$ nothing on $S_0$ merges, at $w_a$ it does.',
            "At the ends $E=E_{cr}$: the landing is in $S_0$, so $\\theta_b\\leqslant\\theta_c$. Between $\\theta_b$ and $\\theta_c$ the pair leaves $S_0$ "
            "again with a smaller $w$; beyond $\\theta_c$ it slips on from $S$, and its first re-entry is above $E_{cr}$.",
            "With $k=\\cot(\\theta/2)$, $D=d+c$, $e=D-2/q$: $$\\nu'=h+kD,\\qquad \\nu'-\\kappa_ce=(h+2k/q)+(k-\\kappa_c)\\,e,\\qquad "
            "w'/q=h^2-2(1-hk)D+(k^2+q)D^2.$$",
            "For $m_1/m_2\\to 0$ all of $[w_a,w_b]$ shrinks to $0$ like $q$; for $m_1/m_2>-\\cos\\theta^*$ it is empty.",
        ),
        figure="merging-map",
    )
