"""Steps about which slips from S end at or below E_cr: none for r < r*, one interval of excursions from a ray beyond."""

from __future__ import annotations

from functools import cache

from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.steps import capture
from paper_checks.steps.certified import certificate
from paper_checks.steps.critical_share import all_slips, one_turning_point, threshold, worst_slip
from paper_checks.steps.excursions import angle_of_excursion
from paper_checks.steps.merging_window import sign_of_excess
from paper_checks.steps.monotone_slips import contact, depth_grows, landings, one_contact


@cache
def no_slip_merges() -> Evidence:
    """Below r* no slip from S above E_cr ends at or below it."""
    return argument(
        "For $r=r^*$ the least excess after a slip from $S$ is that on the ray for angles up to $\\theta_1$ and from $\\theta^*$ on, where "
        "$2r^*\\sin^2\\varphi\\leqslant 1$; there $y'$ rises from $0$ at $\\theta=0$, and from $0$ at $\\theta^*$. In between it is the least "
        "over all starts, which falls to the same $0$. So $w'\\geqslant 0$, and as $w'$ falls with $r$, $w'>0$ for $r<r^*$.",
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
    )


@cache
def first_landing() -> Evidence:
    """Where the first slip after S0 ends at or below E_cr: one interval of energies."""
    return argument(
        "On $S_0$ above $E_{cr}$ the pair sticks up to a ray with the same $w$, and slips. It merges at the end of that slip exactly if "
        "$w'\\leqslant 0$ there, which is $R^2\\leqslant r$: as $R$ falls to $\\sqrt{r^*}$ and rises again, for $r\\geqslant r^*$ one closed "
        "interval of angles, and of $w=q\\,h^2$, which rises with the angle.",
        *capture.leaves_above_critical(),
        *angle_of_excursion(),
        *landings()[3:],
        *depth_grows()[:2],
        *one_turning_point(),
        *threshold(),
        *sign_of_excess(),
    )
