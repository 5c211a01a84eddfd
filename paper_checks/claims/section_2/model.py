"""Section II, eqs (3), (4): their branches, the stiction bracket, the force between the bodies."""

from paper_checks.claims.section_2.signum import under_a_force
from paper_checks.claims.section_3.filippov import (
    SPURIOUS,
    adhesion_factor,
    spurious_branch,
    spurious_branches_leave,
)
from paper_checks.claims.words import *
from theory.model import Branch, branches

Z, ADHESION = (
    Symbol(r"\mathrm{sgn}(\dot{z})", real=True),
    Symbol(r"\mathrm{sgn}(|\ddot{x}_1|-b\,m_2^{-1})", real=True),
)


LETTERS = {RELATIVE_SIGN: Z, STICTION_SIGN: ADHESION}


def _factor(sign: int) -> Expr:
    """Return what the brackets of (4) hand on of m2 x1'' at z' = 0 for a sign of |x1''| - b/m2."""
    return diff(driven_equation().subs({RELATIVE_SIGN: 0, STICTION_SIGN: sign}), acceleration1) / m2


SHARES = Matrix([Rational(1, 2), 1])
"""The share of x1'' that is the relative acceleration in these branches."""


def _by_acceleration(quantity: Callable[[Branch], Expr]) -> Matrix:
    """Return a quantity of these branches as a multiple of x1''."""
    found = (branch_named(name) for name in SPURIOUS)
    return Matrix([sp.cancel(quantity(one) / one.acceleration1) * acceleration1 for one in found])


def leaves_the_surface() -> Steps:
    """Return the steps that let the spurious branches last no time in the free system."""
    return (*(spurious_branch(name) for name in SPURIOUS), spurious_branches_leave())


def mode_equations(sign: int) -> Matrix:
    """Return the text's modes as left minus right side, N: (i) for sign 0, (ii) for sign 1 and -1."""
    mass = m1 + m2 if sign == 0 else m1
    first = mass * acceleration1 + a1 * v1 + a2 * x1 + b * sign - u
    second = acceleration1 - acceleration2 if sign == 0 else m2 * acceleration2 - b * sign
    return Matrix([first, second])


@claim(
    "modes-from-closed-form",
    "II",
    "eqs. (3), (4); V, first paragraph",
    CORRECTED,
    clause(
        "equations",
        r"The equations of motion are «first» and «second».",
        first=equal(
            "u",
            (m1 + m2 * (1 - Abs(Z))) * acceleration1 + a1 * v1 + a2 * x1 + b * Z,
            lambda: driving_equation().subs(LETTERS) + u,
        ),
        second=equal(
            "0",
            m2 * acceleration1 * (1 - Abs(Z)) * (1 - ADHESION) / 2 - m2 * acceleration2 + b * Z,
            lambda: driven_equation().subs(LETTERS),
        ),
    ),
    clause(
        "modes",
        r"""
        Including the signum in (3) and (4) switches directly between the two modes: (i) $\dot{x}_1=\dot{x}_2$, no
        frictional damping, and the driving body carries the total mass $m_1+m_2$; (ii) the second body slides under
        the friction force, which accelerates or decelerates both bodies. Neither if-else statements nor case
        differences are required.
        """,
    ),
    correction=(
        clause(
            "branches",
            r"""
            For $\dot z\neq 0$ (3), (4) are mode (ii). For $\dot z=0$ they are mode (i) where $|\ddot x_1|<b/m_2$;
            where $|\ddot x_1|>b/m_2$ body 2 is left without acceleration, and where $|\ddot x_1|=b/m_2$ with half of
            $\ddot x_1$.
            """,
        ),
        clause(
            "instants",
            r"The free system is in these two branches at isolated instants only.",
            kernel="edges-isolated switching-iff filippov-iff",
        ),
        *under_a_force(),
    ),
)
def modes_from_closed_form() -> Case:
    """Solve (3), (4) for every pair of signs and compare the branches with the two modes."""
    broken = branch_named("broken adhesion")
    return because(
        (
            "Putting each of the nine pairs of values of the two signs into (3), (4) and solving for the accelerations gives "
            f"{len(branches())} different branches, not two. Three are the modes of the text: stick, and slip in either "
            "direction. The others occur at $\\dot z=0$ where the second bracket of (4) is 0 or 1/2: body 1 carries the "
            "total mass, yet body 2 is not accelerated with it. With $u=0$ they last no time, so the motion of the free "
            "system is made of the two modes only."
        ),
        counterexample(
            (
                "$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, $u=0$ with $x_1=0.006$, $\\dot x_1=\\dot x_2=0$, the "
                f"start of Fig. 4 (a): (3), (4) give $\\ddot x_1={value_at(broken.acceleration1, START_AT_6MM)}$ and "
                f"$\\ddot x_2={value_at(broken.acceleration2, START_AT_6MM)}$, neither mode (i) nor mode (ii)."
            ),
            exhibit(
                r"""
                at the start of Fig. 4 (a) (3), (4) give $\ddot x_1\neq\ddot x_2$, $(m_1+m_2)\,\ddot x_1=-a_2x_1$: the
                total mass and no adhesion
                """,
                START_AT_6MM,
                (Abs(broken.acceleration1), ">", b / m2),
                ((m1 + m2) * broken.acceleration1, "=", -a2 * x1),
                (broken.acceleration2, "=", 0),
            ),
        ),
        carried(
            "branches",
            *(spurious_branch(name) for name in SPURIOUS),
        ),
    )


@claim(
    "stiction-bracket",
    "II",
    "eq. (4), last sentence of Section II",
    CORRECTED,
    r"""
    Decoupling of the bodies, that is switching to mode (ii), is enabled in (4) by the first bracket for $\dot{z}\neq
    0$ and by the second bracket, $\tfrac{1}{2}\bigl(1-\mathrm{sgn}(|\ddot{x}_1|-b\,m_2^{-1})\bigr)$, for the case
    when the stiction condition, printed as $|\ddot{x}_1|>b\,m_2^{-1}$, is violated.
    """,
    correction=(
        clause(
            "brackets",
            r"""
            At $\dot z=0$ the brackets of (4) transmit $m_2\ddot x_1$ with the factor «kept» where $|\ddot x_1|<b/m_2$,
            «half» where $|\ddot x_1|=b/m_2$ and «broken» where $|\ddot x_1|>b/m_2$.
            """,
            kept=equal("f", 1, lambda: _factor(-1)),
            half=equal("f", Rational(1, 2), lambda: _factor(0)),
            broken=equal("f", 0, lambda: _factor(1)),
        ),
        clause(
            "condition",
            r"""
            The stiction condition of Coulomb's law is $|\ddot x_1|\leqslant b/m_2$, equality included; $|\ddot
            x_1|>b/m_2$ is its violation.
            """,
        ),
    ),
)
def stiction_bracket() -> Case:
    """Evaluate the brackets of (4) for <, = and >, and find where stick satisfies the friction law."""
    stuck = branch_named("stick")
    return because(
        r"""
        The inequality is printed the wrong way round: $|\ddot x_1|>b/m_2$ is the violation, the stiction condition is
        $|\ddot x_1|\leqslant b/m_2$, since adhesion needs the force $m_2|\ddot x_1|$ and friction gives at most $b$.
        The second bracket of (4) is 1 for $<$ and 0 for $>$, as meant; at equality, where $\mathrm{sgn}(0)=0$, it is
        1/2, which is neither adhesion nor release. The first bracket decouples as said.
        """,
        counterexample(
            (
                "$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, both bodies at rest. At $x_1=0.004$, "
                f"$|\\ddot x_1|={value_at(abs(stuck.acceleration1), AT_4MM)}<b/m_2$: the printed condition is violated, and the "
                f"bodies adhere. At $x_1=0.005$, $|\\ddot x_1|={value_at(abs(stuck.acceleration1), AT_5MM)}=b/m_2$: "
                f"$\\ddot x_2={value_at(branch_named('half adhesion').acceleration2, AT_5MM)}=\\ddot x_1/2$."
            ),
            exhibit(
                "at $x_1=0.004$ the condition as printed, $|\\ddot x_1|>b/m_2$, is violated, yet (4) keeps adhesion",
                AT_4MM,
                (Abs(stuck.acceleration1), "<=", b / m2),
                (stuck.acceleration2, "=", stuck.acceleration1),
                (adhesion_factor(0, -1), "=", 1),
            ),
        ),
        carried("brackets"),
        carried(
            "condition",
            identity(
                r"adhesion needs the force $m_2\ddot x_1$ on body 2, the share $\ddot x_1/(b/m_2)$ of $b$",
                [stuck.force_on_second, stuck.force_on_second / b],
                [m2 * stuck.acceleration1, stuck.acceleration1 / (b / m2)],
            ),
        ),
        correction(
            reading(
                "stiction condition",
                r"that friction can give the force of adhesion, $b\sigma=m_2\ddot x_1$ with $-1\leqslant\sigma\leqslant 1$",
            )
        ),
    )


@claim(
    "friction-opposes-displacement",
    "I",
    "before the outline",
    CORRECTED,
    "The Coulomb-type friction has a constant magnitude, independent of speed, and the sign opposed to the relative displacement.",
    correction=(
        clause(
            "rate",
            r"""
            In slip the friction on body 1 has the constant magnitude $b$ and the sign opposed to the rate of the
            relative displacement $z=x_1-x_2$, whatever the sign of $z$: for $\dot z>0$ and for $\dot z<0$ it is
            «friction».
            """,
            friction=equal(
                "f_1",
                Matrix([-b, b]),
                lambda: Matrix([branch_named(name).force_on_first for name in ("slip+", "slip-")]),
            ),
        ),
    ),
)
def friction_opposes_displacement() -> Case:
    """A slip that takes a displaced body back, in which friction and displacement have one sign."""
    back = {**EXAMPLE_PAIR, x1: Rational(1, 1000), x2: 0, v1: Rational(-1, 10), v2: 0}
    return because(
        r"""
        The magnitude is as the text says. The sign is that of $-\dot z$, as in (3), (4); with that of $-z$
        friction would be a spring of constant force, which gives back what it takes.
        """,
        counterexample(
            "$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, $x_1=0.001$, $v_1=-0.1$, body 2 at rest at 0: body 1 is displaced by $z=0.001>0$, and friction pushes it by $+0.5$ N.",
            exhibit(
                r"with $z>0$ and $\dot z<0$ the friction on body 1 has the sign of $z$",
                back,
                (x1 - x2, ">", 0),
                (v1 - v2, "<", 0),
                (branch_named("slip-").force_on_first, "=", Rational(1, 2)),
            ),
        ),
        carried("rate"),
    )


@claim(
    "interface-force-balance",
    "II",
    "eqs. (3), (4)",
    CORRECTED,
    """
    The friction force acts between the bodies: in mode (ii) it impacts the momentum of both, which accelerate or
    decelerate each other. The interface should allow for the conservation of momentum of the moving pair (Section I).
    """,
    correction=(
        clause(
            "balanced",
            r"""
            The forces that (3), (4) put on the two bodies add up to nothing in the modes of the text: in stick, where
            $|\ddot x_1|<b/m_2$, and in slip with $\dot z>0$ and with $\dot z<0$ these sums are «sum»;
            """,
            sum=equal(
                "f_1+f_2",
                sp.zeros(3, 1),
                lambda: Matrix([branch_named(name).force_imbalance for name in ("stick", "slip+", "slip-")]),
            ),
        ),
        clause(
            "broken",
            r"""
            where (4) breaks adhesion at $\dot z=0$ they do not: for $|\ddot x_1|=b/m_2$ and for $|\ddot x_1|>b/m_2$
            they are «sum», with «leaves» by (3) and (4);
            """,
            sum=equal(
                "f_1+f_2", -m2 * acceleration1 * SHARES, lambda: _by_acceleration(lambda one: one.force_imbalance)
            ),
            leaves=equal(
                r"\ddot z",
                acceleration1 * SHARES,
                lambda: _by_acceleration(lambda one: one.acceleration1 - one.acceleration2),
            ),
        ),
        clause(
            "isolated",
            r"along the free motions such instants are isolated.",
            kernel="edges-isolated switching-iff filippov-iff",
        ),
        clause(
            "almost",
            r"""
            Every solution of (3), (4) with $u=0$ conserves the balance of momentum, $f_1+f_2=0$, at almost every time.
            """,
            kernel="momentum-balance",
        ),
    ),
)
def interface_force_balance() -> Case:
    """Compare, branch by branch, the interface forces that Newton's law finds on the two bodies."""
    broken = branch_named("broken adhesion")
    return because(
        r"""
        In slip and in stick the two forces are opposite, as the text says; where (4) breaks adhesion they are not.
        The forces follow from the accelerations by Newton's law. In the branches at $\dot z=0$ where adhesion breaks,
        for $|\ddot x_1|>b/m_2$, body 1 carries both masses in (3) and so feels $-m_2\ddot x_1$, while (4) gives body
        2 no force at all; at equality body 2 gets half. Momentum is not conserved at such an instant; they last no
        time in the free system.
        """,
        counterexample(
            (
                "$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, $x_1=0.006$, at rest: the interface force on body 1 is "
                f"$m_1\\ddot x_1+a_2x_1={value_at(broken.force_on_first, START_AT_6MM)}$, on body 2 $m_2\\ddot x_2="
                f"{value_at(broken.force_on_second, START_AT_6MM)}$."
            ),
            exhibit(
                "at the start of Fig. 4 (a) the interface pushes body 1 and does not push body 2",
                START_AT_6MM,
                (Abs(broken.acceleration1), ">", b / m2),
                (broken.force_on_first, "=", Rational(3, 5)),
                (broken.force_on_second, "=", 0),
            ),
        ),
        carried("balanced"),
        carried("broken"),
    )
