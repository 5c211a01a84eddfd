"""Section III, last paragraph: the pair with a1 > 0."""

from __future__ import annotations

import sympy as sp

from numerics.scene.file import load_scene
from paper_checks.checks.registry import Context, check
from paper_checks.engines.enclosure import solved
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.evidence.formula import latex
from paper_checks.ledger import claim_named
from paper_checks.solvers.polynomial import cleared
from paper_checks.solvers.smt import prove
from paper_checks.steps import capture, dissipation
from paper_checks.steps.perpetual_slips import never_merges
from theory.energy import slip_rate, stick_rate
from theory.filippov import sliding_field
from theory.scaling import damping_ratio
from theory.symbols import a1, a2, b, m1, m2, v1, v2, x1


@check("viscous-energy-rate")
def viscous_energy_rate(context: Context) -> Finding:
    """Derive dE/dt with a1 > 0 along both slip fields and the sliding field."""
    modes = [
        identity(
            f"in slip of sign {sign:+d}, $\\dot E=-b\\,({sign:+d})(v_1-v_2)-a_1v_1^2$",
            slip_rate(sign),
            -b * sign * (v1 - v2) - a1 * v1**2,
            seed=context.seed,
        )
        for sign in (1, -1)
    ]
    return conclude(
        Verdict.HOLDS,
        "The chain rule along each slip field and along the sliding field gives the printed rate.",
        carried(
            "rate",
            argument(
                "A solution has a derivative at almost every time, that of the value that friction takes there; the chain rule "
                "gives the rate.",
                *capture.energy_decreases(),
                *modes,
                identity(r"on $S_0$, $\dot E=-a_1v_1^2$", stick_rate(), -a1 * v1**2, seed=context.seed),
            ),
        ),
        derivation=(f"$$\\dot E|_{{S_0}}={latex(stick_rate())}$$",),
    )


@check("viscous-origin-stable")
def viscous_origin_stable(context: Context) -> Finding:
    """Global asymptotic stability for every a1 > 0; a spiral exactly below the critical damping of stick."""
    field = sliding_field(damped=True)
    matrix = sp.Matrix(field[:2]).jacobian([x1, v1])
    discriminant = matrix.trace() ** 2 - 4 * matrix.det()
    creeping = solved(load_scene("velocities"))
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "The origin is stable as the paper says, but the switching is not similar: with a damper, however small, every trajectory "
        "switches finitely often; without one whole families stick and slip in turn for ever. With a damper a trajectory is captured "
        "below a level of energy and sticks from there on (see viscous-accelerates). Inside $S_0$ the motion is a spiral exactly if "
        '$a_1<2\\sqrt{a_2(m_1+m_2)}$, which makes "relatively small" precise. Two solutions never move apart, and $E\\to 0$ along every trajectory.',
        *(item.as_counterexample() for item in never_merges(creeping, "the start of Fig. 5 (a) without a damper")),
        dissipation.captured().as_counterexample(),
        carried("origin", dissipation.comes_to_rest().as_correction()),
        carried("ends", dissipation.captured().as_correction()),
        carried(
            "spiral",
            identity(
                "in $S_0$ the eigenvalues have the discriminant $(a_1^2-4a_2M)/M^2$, $M=m_1+m_2$",
                discriminant,
                (a1**2 - 4 * a2 * (m1 + m2)) / (m1 + m2) ** 2,
                seed=context.seed,
            ).as_correction(),
            identity(
                "so the damping ratio is $a_1/(2\\sqrt{a_2M})$",
                damping_ratio(),
                a1 / (2 * sp.sqrt(a2 * (m1 + m2))),
                seed=context.seed,
            ).as_correction(),
            prove(
                "both eigenvalues have negative real part: trace $<0$, determinant $>0$",
                [],
                sp.And(
                    sp.Lt(cleared(matrix.trace()), 0, evaluate=False),
                    sp.Gt(cleared(matrix.det()), 0, evaluate=False),
                    evaluate=False,
                ),
            ).as_correction(),
        ),
        corrected=claim_named("viscous-origin-stable").corrected,
        counterexample="$m_1=m_2=1$, $a_2=200$, $b=0.05$, $\\dot x_1(0)=0.15$: without a damper the pair sticks and slips in turn for "
        "ever; with any $a_1>0$ it sticks for ever from a finite time on.",
        derivation=(
            *dissipation.SYNCHRONISATION,
            *dissipation.REST,
            f"$$\\dot{{\\begin{{pmatrix}}x_1\\\\v_1\\end{{pmatrix}}}}={latex(matrix)}\\begin{{pmatrix}}x_1\\\\v_1\\end{{pmatrix}}$$",
        ),
    )
