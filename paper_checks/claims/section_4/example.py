"""Section IV: the example system, its frequency and its equations."""

from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.words import *
from theory.model import case_study_closed_form, case_study_eigenfrequency

Z = Symbol(r"\mathrm{sgn}(\dot{z})", real=True)


def _reduced(index: int) -> Expr:
    return case_study_closed_form()[index].subs(RELATIVE_SIGN, Z)


def _mode(sign: int, index: int, right: Expr) -> Formula:
    """Return an acceleration of (13) (sign 0) or (14)."""
    return equal(rf"\ddot{{x}}_{index + 1}", right, lambda: case_study_mode(sign)[index])


@claim(
    "example-eigenfrequency",
    "IV",
    "IV-A, before eq. (11)",
    HOLDS,
    clause(
        "frequency",
        """
        With unit masses, $a_1=0$ and $a_2=200$ the first moving body is a harmonic oscillator, which has the
        eigenfrequency «frequency» rad/s when the second body is not sliding and rests upon the first one.
        """,
        frequency=equal(r"\Omega", 10, case_study_eigenfrequency),
    ),
)
def example_eigenfrequency() -> Case:
    """Derive the frequency of stick and put the oscillation into (13)."""
    return because(
        r"""
        With the second body resting on the first, (3) is $2\ddot x_1+200\,x_1=0$: the frequency is
        $\sqrt{a_2/(m_1+m_2)}=\sqrt{200/2}$ rad/s. Alone, in slip, the driving body would oscillate with $\sqrt{200}$
        rad/s.
        """,
        carried("frequency"),
    )


@claim(
    "example-reduction",
    "IV",
    "eqs. (11), (12)",
    CORRECTED,
    clause(
        "reduction",
        r"For $u=0$ the dynamics (3)–(4) reduces to the autonomous system «first», «second».",
        first=equal(r"\ddot{x}_1", -(200 * x1 + b * Z) / (2 - Abs(Z)), lambda: _reduced(0)),
        second=equal(
            r"\ddot{x}_2",
            (1 - Abs(Z)) * PULL + b * Z,
            lambda: _reduced(1).subs(acceleration1, PULL),
        ),
    ),
    correction=(
        clause(
            "corrected",
            r"""
            (3)–(4) reduce to (11) and, where $\dot z\neq 0$ or $|x_1|<b/100$, to (12). At $\dot z=0$ with
            $|x_1|>b/100$, (4) gives $\ddot x_2=0$; with $|x_1|=b/100$, $\ddot x_2=\ddot x_1/2$.
            """,
            kernel="case-study-reduction",
        ),
    ),
)
def example_reduction() -> Case:
    """Derive (11) and (12) with the stiction bracket left open, and find where (12) follows."""
    broken, literal = branch_named("broken adhesion"), case_study_mode(0)
    acceleration = Symbol("A", real=True)
    return because(
        r"""
        (12) follows from (4) for $\dot z\neq 0$, but at $\dot z=0$ only where $|\ddot x_1|<b$, that is $|x_1|<b/100$;
        (11) follows from (3) without a condition. Elsewhere on $\dot z=0$ the second bracket of (4) leaves body 2
        without acceleration, or at equality with half of it, while (12) makes it stick whatever force that requires.
        """,
        counterexample(
            (
                "$b=0.5$, $x_1=0.006$, both bodies at rest, the start of Fig. 4 (a): (4) gives "
                f"$\\ddot x_2={value_at(broken.acceleration2, START_AT_6MM)}$, (12) gives "
                f"$\\ddot x_2=\\ddot x_1={value_at(literal[1], START_AT_6MM)}$."
            ),
            exhibit(
                "at the start of Fig. 4 (a), $x_1=0.006$, $b=0.5$, (4) gives $\\ddot x_2=0$ and (12) gives $\\ddot x_2\\neq 0$",
                START_AT_6MM,
                (Abs(broken.acceleration1), ">", b),
                (broken.acceleration2, "=", 0),
                (literal[1], "=", literal[0]),
                (literal[1], "<", 0),
            ),
        ),
        carried(
            "corrected",
            argument(
                "(11) is (3), and (12) is (4) where its second bracket is 1.",
                prove(
                    "in stick $|\\ddot x_1|<b$ exactly where $|x_1|<b/100$, and $|\\ddot x_1|=b$ where $|x_1|=b/100$",
                    [sp.Eq(acceleration, literal[0])],
                    And(
                        sp.Equivalent(Abs(acceleration) < b, 100 * Abs(x1) < b),
                        sp.Equivalent(sp.Eq(Abs(acceleration), b), sp.Eq(100 * Abs(x1), b)),
                    ),
                ),
            ),
        ),
    )


@claim(
    "example-two-modes",
    "IV",
    "eqs. (13), (14); before (13)",
    HOLDS,
    clause(
        "first",
        r"The two modes of the relative motion are «stick», $\ddot{x}_2=\ddot{x}_1$ if $\mathrm{sgn}(\dot{z})=0$,",
        stick=_mode(0, 0, -100 * x1),
    ),
    clause(
        "second",
        r"and «slip_1», «slip_2» for $\dot{z}>0$ and «slip_3», «slip_4» for $\dot{z}<0$.",
        slip_1=_mode(1, 0, -200 * x1 - b),
        slip_2=_mode(1, 1, b),
        slip_3=_mode(-1, 0, -200 * x1 + b),
        slip_4=_mode(-1, 1, -b),
    ),
    clause(
        "together",
        r"""
        In the first the system behaves as a pair of synchronized undamped harmonic oscillators with
        $x_1-x_2=\mathrm{const}$ and $\dot{x}_1=\dot{x}_2$;
        """,
    ),
    clause(
        "sliding", r"in the other the second mass slides with respect to the first one and, thus, dissipates energy."
    ),
)
def example_two_modes() -> Case:
    """Put sgn(z') = 0, 1, -1 into (11), (12), and solve the first mode."""
    together = solution("stick", DampingRegime.UNDAMPED)
    return because(
        r"""
        (13) and (14) are (11) and (12) with the signum at 0 and at $\pm 1$, upper signs for $\dot z>0$. In (13) both
        bodies move by the same oscillation and $x_1-x_2$ keeps its initial value; energy is conserved. Read with the
        set-valued signum, (13) lasts only while $|x_1|\leqslant b/100$.
        """,
        carried("first"),
        carried("second"),
        carried(
            "together",
            identity(
                "the closed form of stick satisfies (3), (4), by substitution; in it $x_1-x_2$ is constant, and $\\dot x_1=\\dot x_2$",
                [*residual(together), together.x1 - together.x2, together.v1],
                [0] * len(residual(together)) + [x1_0 - x2_0, together.v2],
            ),
            identity("undamped: $\\dot E=0$", undamped(stick_rate())),
        ),
        carried("sliding", dissipation.energy_rate, dissipation.energy_never_grows),
    )
