"""Past the paper: where every slip from S ends, in closed form, and what grows with its angle."""

from __future__ import annotations

from fractions import Fraction
from itertools import islice

from numerics.arithmetic.ball import Ball
from numerics.free.excursions import excursions
from numerics.scene import Pair
from numerics.trajectory.reduced import Frame
from paper_checks.checks.registry import Context, check
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.finding import Finding, Verdict, conclude
from paper_checks.steps.excursions import angle_of_excursion
from paper_checks.steps.monotone_slips import (
    contact,
    depth_grows,
    first_factor_positive,
    landings,
    one_contact,
    rise_is_convex,
    stays_or_crosses,
    turns_back,
)


def exits_twice_by(share: Fraction, excess: Fraction, same: bool) -> Evidence:
    """Solve two excursions of the pair q = share from the ray with this excess: by the same ray or by the other one?"""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        sides = [one.side for one in islice(excursions(frame, arithmetic.number(excess)), 2)]
    return Evidence(
        EvidenceKind.ENCLOSURE,
        "numerics, balls",
        f"solved with $q={share}$ from a ray with $w={excess}$: the next exit is by the {'same' if same else 'opposite'} ray",
        len(sides) == 2 and (sides[0] == sides[1]) is same,
        1,
        f"sides {sides}",
        supports=True,
    )


@check("excursion-closed-form")
def excursion_closed_form(context: Context) -> Finding:  # noqa: ARG001
    """The end of every slip from S, whether it stays, and the ray that the pair leaves by next."""
    return conclude(
        Verdict.HOLDS,
        "Every slip from $S$ ends at the root of one monotone equation, and all that it does is an elementary function of its angle. "
        "With the root at its start divided out, the guard of a slip from $S$ is one monotone function of the slip angle, so the slip "
        "has exactly one end; there everything is an elementary function of the angle. On $S_0$ above $E_{cr}$ the velocity keeps "
        "its sign up to the ray, so the sign of $V'=\\sqrt q\\,(h-\\theta)$ tells the ray; $V'=0$ inside $S_0$ is below $E_{cr}$.",
        contact(),
        first_factor_positive(),
        *angle_of_excursion(),
        *one_contact(),
        *landings(),
        *depth_grows()[:2],
        *stays_or_crosses(),
        *turns_back(),
        exits_twice_by(Fraction(1, 5), Fraction(1, 10), same=False),
        exits_twice_by(Fraction(1, 5), Fraction(15), same=True),
        derivation=(
            "In $\\theta=\\tau/\\sqrt q$ the slip from $X=1+q\\,d$, $V_1=V_2=\\sqrt q\\,\\nu$ is "
            "$$X=1-q+q\\bigl((1+d)\\cos\\theta+\\nu\\sin\\theta\\bigr),\\quad V_2=\\sqrt q\\,(\\nu-\\theta).$$",
            "$$\\frac{V_1-V_2}{\\sqrt q\\,(1-\\cos\\theta)}=h(\\theta)-d\\cot\\frac{\\theta}{2}-\\nu$$",
            "$$X'=1-q\\,c(\\theta),\\qquad V'=\\sqrt q\\,(h-\\theta),\\qquad w'=q\\,(h^2-r\\,c^2)\\qquad\\text{from a ray.}$$",
            "Both cases occur: the same ray for $q<q_v$ and $\\theta_b<\\theta<\\theta_c$ (merging-set), a crossing for $\\theta>\\theta_c$.",
        ),
        figure="excursion-curves",
    )


@check("excursion-monotone")
def excursion_monotone(context: Context) -> Finding:  # noqa: ARG001
    """h rises and is convex, c rises and is concave in h^2."""
    return conclude(
        Verdict.HOLDS,
        "$h$ rises and is convex; speed, duration, depth and loss of an excursion grow together. "
        "$h'$ is $(\\sin\\varphi-\\varphi\\cos\\varphi)/\\sin^3\\varphi$ with $\\varphi=\\theta/2$, whose numerator grows from $0$; "
        "$h''>0$ is the inequality of Cusa and Huygens; $c'=h$. The exit speed is $\\sqrt q\\,h$, the duration $\\sqrt q\\,\\theta$, the depth "
        "$q\\,c$ and the excess lost $q\\,r\\,c^2$ (units of the reduced coordinates): each increases with $\\theta$.",
        *angle_of_excursion(),
        *rise_is_convex(),
        *depth_grows(),
        *one_contact(),
        *landings()[3:],
        figure="excursion-curves",
    )
