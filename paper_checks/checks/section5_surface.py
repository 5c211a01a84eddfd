"""Section V, bullet 5: the pair on a surface, with a vector of Coulomb coefficients."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.evidence import argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.steps import plane


@check("motions-on-a-surface")
def motions_on_a_surface(context: Context) -> Finding:  # noqa: ARG001
    """What of (2)-(4) carries over to two translations, and in which form."""
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "By components friction would depend on the axes. A signum for each component is friction that is $\\sqrt2$ times as strong along the diagonal as along an axis. Friction in the direction "
        "of the slip has no such axes, and with it energy falls, a start has one motion, and two motions never move apart, as on a line. The paper itself asks for care with the coupling terms.",
        plane.depends_on_axes().as_counterexample(),
        carried(
            "components",
            argument(
                "A signum for each component takes the power $b(|w_1|+|w_2|)$, which depends on the direction of the slip to the axes.",
                plane.against_the_slip(),
                plane.depends_on_axes(),
            ).as_correction(),
        ),
        carried(
            "direction",
            *(item.as_correction() for item in (plane.one_size(), plane.energy_rate(), plane.never_apart())),
        ),
        carried("line", plane.on_a_line().as_correction()),
        corrected=claim_named("motions-on-a-surface").corrected,
        counterexample="$b=1$ N for $x$ and for $y$, a slip with $\\mathbf w=(1,1)$ m/s: by components $\\mathbf f=(1,1)$ N, of size $\\sqrt2>b$. Turned by 45° the same contact has $\\mathbf w=(\\sqrt2,0)$ and "
        "$|\\mathbf f|=b$: the law depends on how the axes are drawn.",
        derivation=(
            r"$$(\mathbf p-\tilde{\mathbf p})\cdot(\mathbf w-\tilde{\mathbf w})\geqslant 0,\qquad \mathbf f=b\,\mathbf p.$$",
        ),
    )
