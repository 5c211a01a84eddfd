"""Section III with a damper: the energy, and the origin."""

from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.words import *
from theory.closed_forms import discriminant


def _underdamped() -> Formula:
    """Return the condition under which stick is a decaying oscillation."""
    return sharp(a1**2, "<", 4 * a2 * (m1 + m2), lambda: (a1**2, "<", a1**2 - discriminant("stick")))


@claim(
    "viscous-no-direct-effect",
    "III",
    "III, opening paragraph",
    CORRECTED,
    r"""
    Taking $a_1=0$ is justified by the fact that the viscous damping of the driving body, $a_1\dot{x}_1$, is always
    dissipative and does not directly affect the interaction of the inertial pair.
    """,
    correction=(
        clause(
            "friction-of-slip",
            r"Viscous damping of the driving body is dissipative and does not enter the friction force of slip;",
        ),
        clause(
            "tilted-strip",
            r"it changes adhesion, whose region becomes «strip».",
            strip=sharp(
                Abs(a2 * x1 + a1 * v1),
                "<=",
                b * (m1 + m2) / m2,
                lambda: (Abs(load(damped=True)), "<=", load_threshold()),
            ),
            kernel="free-case mode-stick mode-slip stuck-load",
        ),
    ),
)
def viscous_no_direct_effect() -> Case:
    """Show that the sliding region and the adhesion force depend on a1."""
    return because(
        """
        The damper tilts the sliding region and so decides at which states the pair sticks: the force that adhesion
        needs contains $a_1$. That it is dissipative is right, and the friction force of slip does not contain $a_1$.
        """,
        counterexample(
            """
            $m_1=m_2=1$, $a_2=200$, $b=0.5$, $x_1=0.006$, $v_1=v_2=-0.3$: $a_2x_1=1.2>1$ slips without the damper;
            with $a_1=1$ the load is $1.2-0.3=0.9<1$ and the pair sticks.
            """,
            exhibit(
                "with $a_1=1$ its load is below the threshold, without $a_1v_1$ above",
                {**EXAMPLE_PAIR, a1: 1, x1: Rational("0.006"), v1: Rational("-0.3")},
                (Abs(load(damped=True)), "<", load_threshold()),
                (Abs(a2 * x1), ">", load_threshold()),
            ),
        ),
        carried(
            "tilted-strip",
            argument(
                "Adhesion lasts where friction can give the force that it needs, at most $b$ in absolute value.",
                identity(
                    "adhesion needs the interface force $-m_2(a_2x_1+a_1v_1)/(m_1+m_2)$ on body 2 (at $u=0$)",
                    free(stick().force_on_second),
                    -m2 * (a2 * x1 + a1 * v1) / (m1 + m2),
                ),
            ),
        ),
        carried(
            "friction-of-slip",
            identity(
                "in slip the force on body 2 is $\\pm b$, without $a_1$",
                [free(slip(sign).force_on_second) for sign in (1, -1)],
                [b, -b],
            ),
            identity(
                "the damper changes $\\dot E$ by $-a_1v_1^2\\leqslant 0$",
                slip_rate(1) - undamped(slip_rate(1)),
                -a1 * v1**2,
            ),
        ),
    )


@claim(
    "viscous-energy-rate",
    "III",
    "III, last paragraph",
    HOLDS,
    clause(
        "rate",
        r"With viscous friction, the counterpart of (8) reads «rate».",
        rate=equal(
            r"\dot{E}",
            -b * Abs(v1 - v2) - a1 * v1**2,
            lambda: derivative_along(free_system(Abs(v1 - v2) / (v1 - v2)), energy()),
        ),
        kernel="energy-rate",
    ),
)
def viscous_energy_rate() -> Case:
    """Derive dE/dt with a1 > 0 along both slip fields and the sliding field."""
    return because(
        "The chain rule along each slip field and along the sliding field gives the printed rate.",
        dissipation.energy_rate,
    )


@claim(
    "viscous-origin-stable",
    "III",
    "III, last paragraph",
    CORRECTED,
    """
    When a relatively small viscous friction is present, the switching dynamics is similar but the trajectories inside
    the sliding region spiral towards the equilibrium at the origin, which is globally stable in this case.
    """,
    correction=(
        clause(
            "origin",
            r"For every $a_1>0$ the origin is globally asymptotically stable;",
            kernel="viscous-decay viscous-rest",
        ),
        clause(
            "ends",
            """
            the switching ends: every trajectory sticks permanently from a finite time on, while without a damper whole
            families stick and slip in turn without end;
            """,
            kernel="viscous-rest no-merging-from-S0 exit-and-entry-times",
        ),
        clause(
            "spiral",
            r"inside the sliding region the motion is a spiral towards the origin exactly if «small».",
            small=_underdamped(),
        ),
    ),
)
def viscous_origin_stable() -> Case:
    """Global asymptotic stability for every a1 > 0; a spiral exactly below the critical damping of stick."""
    field = sliding_field(damped=True)
    matrix = Matrix(field[:2]).jacobian([x1, v1])
    discriminant = matrix.trace() ** 2 - 4 * matrix.det()
    return because(
        r"""
        The origin is stable as the paper says, but the switching is not similar: with a damper, however small, every
        trajectory switches finitely often; without one whole families stick and slip in turn without end. With a damper
        a trajectory is captured below a level of energy and sticks from then on (see viscous-accelerates). Inside $S_0$
        the motion is a spiral exactly if $a_1<2\sqrt{a_2(m_1+m_2)}$, which makes "relatively small" precise. The flow
        is non-expansive, and $E\to 0$ along every trajectory.
        """,
        counterexample(
            r"""
            $m_1=m_2=1$, $a_2=200$, $b=0.05$, $\dot x_1(0)=0.15$: without a damper the pair sticks and slips in turn
            without end; with any $a_1>0$ it sticks permanently from a finite time on.
            """,
            kernel.step("creeps-b-0.05"),
            kernel.step("viscous-rest"),
        ),
        carried("origin", dissipation.comes_to_rest),
        carried("ends", dissipation.captured),
        carried(
            "spiral",
            identity(
                "in $S_0$ the eigenvalues have the discriminant $(a_1^2-4a_2M)/M^2$, $M=m_1+m_2$",
                discriminant,
                (a1**2 - 4 * a2 * (m1 + m2)) / (m1 + m2) ** 2,
            ),
            prove(
                "both eigenvalues have negative real part: trace $<0$, determinant $>0$",
                [],
                And(
                    signed(matrix.trace(), "<"),
                    signed(matrix.det(), ">"),
                    evaluate=False,
                ),
            ),
        ),
    )
