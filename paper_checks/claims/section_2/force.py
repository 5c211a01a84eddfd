"""Section II: what the force u(t) stands for, and in which direction friction acts."""

from paper_checks.claims.beyond import transfers
from paper_checks.claims.words import *
from theory.forced import energy_rate as forced_energy_rate
from theory.forced import forced_system

REFERENCE, REFERENCE_RATE, DISTURBANCE = symbols(r"x_{\mathrm{ref}} \dot{x}_{\mathrm{ref}} u_d", real=True)
STIFFNESS, VISCOSITY = symbols("k_1 k_2", positive=True)


COMMAND = DISTURBANCE - STIFFNESS * (x1 - REFERENCE) - VISCOSITY * (v1 - REFERENCE_RATE)
VIRTUAL = {a1: a1 + VISCOSITY, a2: a2 + STIFFNESS}


def _feedback() -> Expr:
    """Return the force u of (3) for a feedback on the place and velocity beside a reference, and a disturbance, N."""
    return expand(driving_equation().subs(VIRTUAL, simultaneous=True) - driving_equation() + COMMAND)


AT_REST = {**EXAMPLE_PAIR, u: Rational("0.01"), x1: Rational("0.00005")}


@claim(
    "force-as-reference-or-disturbance",
    "II",
    "paragraph after Fig. 2",
    CORRECTED,
    """
    The virtual spring and damper can represent mechanical components as well as feedback control terms. For a
    feedback controlled body $u(t)$ is then an exogenous input that can be either a reference motion trajectory, or a
    generalized disturbing force, or a combination of both.
    """,
    correction=(
        clause(
            "input",
            r"""
            With the feedback $-k_1(x_1-x_{\mathrm{ref}})-k_2(v_1-\dot x_{\mathrm{ref}})$ and a disturbing force $u_d$,
            (3) and (4) hold with $a_2+k_1$, $a_1+k_2$ in place of $a_2$, $a_1$ and with «input»: the reference enters
            through the gains, as a force.
            """,
            input=equal(
                "u",
                STIFFNESS * REFERENCE + VISCOSITY * REFERENCE_RATE + DISTURBANCE,
                _feedback,
            ),
        ),
    ),
)
def force_as_reference_or_disturbance() -> Case:
    """Put a feedback into (3), and a reference in the place of the force."""
    return because(
        """
        Feedback terms do add to spring and damper, and what is left is an exogenous force. But a reference trajectory
        is a position in m, and $u$ a force in N: the reference enters through the gains, as a force.
        """,
        counterexample(
            "$m_1=m_2=1$, $a_2=200$, $b=0.5$, at rest under the constant $u=x_{\\mathrm{ref}}=0.01$: by (3) it is $x_1=x_{\\mathrm{ref}}/a_2=0.00005$, not $x_{\\mathrm{ref}}$.",
            exhibit(
                "with $u=x_{\\mathrm{ref}}=0.01$ the pair of Section IV rests at $x_1=0.00005$, not at $0.01$",
                AT_REST,
                (a2 * x1, "=", u),
                (x1, "!=", u),
            ),
        ),
        carried("input"),
        correction(
            identity(
                r"(3) under the feedback is (3) with the gains beside $a_2$, $a_1$, under that $u$",
                driving_equation().subs(u, COMMAND),
                driving_equation().subs(VIRTUAL, simultaneous=True).subs(u, _feedback()),
            ),
            identity(
                r"(4) has no $u$, $a_1$, $a_2$",
                [diff(driven_equation(), one) for one in (u, a1, a2)],
            ),
        ),
    )


SLIPPING = {b: Rational(1, 2), u: 0, a1: 0, sigma: 1, v1: Rational("0.15"), v2: 0}
"""The start of Fig. 4 (b), in slip with z' > 0."""


@claim(
    "free-interface",
    "II",
    "second paragraph after Fig. 2",
    CORRECTED,
    """
    The interface is free of additional constraints: the second body experiences unrestricted tangential motion and no
    force constraints other than the normal loading caused by the Coulomb frictional force $f(t)$.
    """,
    correction=(
        clause(
            "tangential",
            r"Friction is no normal loading, nor does it cause one: it is tangential, the one force on body 2 along its motion, «force», and adds the power «power», which is negative in slip.",
            force=equal(r"m_2\ddot x_2", b * sigma, lambda: m2 * forced_system(sigma)[2]),
            power=equal("P", -b * sigma * (v1 - v2), lambda: forced_energy_rate() - u * v1 + a1 * v1**2),
        ),
        clause(
            "bounded",
            r"The normal load is not in the equations but in their coefficient $b$, the most that friction can be; with it body 2 changes its velocity by at most $b/m_2$ times the time.",
        ),
    ),
)
def free_interface() -> Case:
    """The direction of friction, by the power that it takes, and what bounds it."""
    return because(
        """
        Friction is tangential; the normal load is not its effect but limits it. The second body is free along the
        surface, as the paper says. A force normal to the surface does no work in a motion along it, and friction does.
        """,
        counterexample(
            "Fig. 4 (b), $b=0.5$, $\\dot x_1=0.15$, $\\dot x_2=0$: the interface takes 0.075 W, which no force normal to the surface does.",
            exhibit(
                r"at the start of Fig. 4 (b) friction takes the power $b\dot z=0.075$ W from a motion along the surface; a normal force takes none",
                SLIPPING,
                (forced.energy_rate(), "=", -Rational("0.075")),
                (v1 - v2, ">", 0),
            ),
        ),
        carried("tangential"),
        carried("bounded", transfers.gentle),
    )
