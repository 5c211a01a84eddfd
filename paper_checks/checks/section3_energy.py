"""Section III, the energy: its rate along every solution, and where it is dissipated."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.evidence.formula import latex
from paper_checks.solvers.polynomial import cleared
from paper_checks.solvers.smt import prove
from theory.energy import energy, sigma, slip_rate, stick_rate
from theory.filippov import derivative_along
from theory.model import free_system
from theory.symbols import b, undamped, v1, v2


def energy_identity(context: Context) -> Evidence:
    """Return that dE/dt = -b sigma (v1 - v2) for every value of the set-valued sign, (8) for every solution."""
    return identity(
        r"$\dot E=-b\,\sigma\,(v_1-v_2)$ for every $\sigma\in[-1,1]$ that friction may take, so $\dot E=-b|v_1-v_2|$ for "
        r"every $\sigma\in\mathrm{Sign}(v_1-v_2)$",
        derivative_along(undamped(free_system(sigma)), energy()),
        -b * sigma * (v1 - v2),
        seed=context.seed,
    )


@check("energy-rate")
def energy_rate(context: Context) -> Finding:
    """Derive dE/dt along the fields of both half-spaces and of the sliding region."""
    modes = [
        identity(
            f"in slip of sign {sign:+d}, $\\dot E=-b\\,({sign:+d})(v_1-v_2)$",
            undamped(slip_rate(sign)),
            -b * sign * (v1 - v2),
            seed=context.seed,
        )
        for sign in (1, -1)
    ]
    return conclude(
        Verdict.HOLDS,
        "Along every value that set-valued friction can take, the chain rule gives $-b\\sigma(v_1-v_2)$, and "
        "$\\sigma(v_1-v_2)=|v_1-v_2|$. As the right side is continuous, $E$ is continuously differentiable along every "
        "trajectory, events included.",
        carried(
            "rate",
            argument(
                "A solution has a derivative at almost every time, that of the value that friction takes there; the chain rule "
                "gives the rate, and $\\sigma(v_1-v_2)=|v_1-v_2|$ for $\\sigma\\in\\mathrm{Sign}(v_1-v_2)$.",
                energy_identity(context),
                *modes,
                identity(r"on $S_0$, $\dot E=0$ along the sliding field", undamped(stick_rate()), 0, seed=context.seed),
            ),
        ),
        carried(
            "sign",
            prove(
                "$-b\\,|v_1-v_2|\\leqslant 0$ (case $v_1\\geqslant v_2$; the other is its mirror)",
                [sp.Ge(v1, v2)],
                sp.Le(-b * (v1 - v2), 0, evaluate=False),
            ),
        ),
        derivation=(
            f"$$E={latex(energy())}$$",
            f"$$\\dot E={latex(sp.factor(derivative_along(undamped(free_system(sigma)), energy())))}$$",
        ),
    )


@check("energy-dissipation-places")
def energy_dissipation_places(context: Context) -> Finding:
    """Strict decrease off S, conservation on S."""
    return conclude(
        Verdict.HOLDS,
        "The rate $-b|v_1-v_2|$ is negative exactly where the velocities differ.",
        carried(
            "dissipated",
            energy_identity(context),
            prove(
                "in $\\Omega_+$, $\\dot E<0$",
                [sp.Gt(v1, v2)],
                sp.Lt(cleared(undamped(slip_rate(1))), 0, evaluate=False),
            ),
            prove(
                "in $\\Omega_-$, $\\dot E<0$",
                [sp.Lt(v1, v2)],
                sp.Lt(cleared(undamped(slip_rate(-1))), 0, evaluate=False),
            ),
        ),
        carried(
            "conserved",
            identity(r"on $S$, $\dot E=0$", undamped(slip_rate(1)).subs(v2, v1), 0, seed=context.seed),
        ),
        derivation=("$$\\dot E<0\\iff v_1\\neq v_2$$",),
    )
