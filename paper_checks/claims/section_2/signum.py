"""The three-valued signum of (1): what (3), (4) mean with it, and what becomes of them under a force."""

from paper_checks.claims.section_3 import filippov
from paper_checks.claims.words import *
from theory.forced import held_at_the_limit, load


def under_a_force() -> tuple[Clause, ...]:
    """Return what becomes of (3), (4) under a force, where a correction says it for the free system."""
    return (
        clause(
            "forced",
            r"""
            Under any force $u(t)$ the solutions of (3)–(4) are the motions of Coulomb's law, in Filippov's sense, with
            $|\Lambda|<b$ at almost every time with $\dot z=0$, and only they, where «load».
            """,
            load=equal(r"\Lambda", m2 * (u - a1 * v1 - a2 * x1) / (m1 + m2), load),
            kernel="forced-switching-iff",
        ),
        clause(
            "start",
            r"""
            So under a force that is integrable and continuous at almost every time, by pieces for instance, (3)–(4)
            have a solution from an initial state exactly if the one motion of Coulomb's law from there has
            $|\Lambda|=b$ at almost no time with $\dot z=0$; then it is that motion, else there is none.
            """,
            kernel="forced-well-posed forced-filippov-iff literal-solutions",
        ),
        clause(
            "none",
            r"So there is none for $m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$ from rest at $0$ under «held».",
            held=equal("u", 1 + 50 * t**2, held_at_the_limit),
            kernel="no-solution-under-control",
        ),
    )


def no_solution_inside() -> Evidence:
    """(5)-(7) with sgn(0) = 0 at a point inside S0: the fields beside S, and the one on it."""
    literal = free_system(Integer(0))
    return exhibit(
        r"""
        with $\mathrm{sgn}(0)=0$ in (5)–(7), at $x_1=0.004$ at rest: both fields point to $S$, and on it $\dot
        v_1\neq\dot v_2$
        """,
        AT_4MM,
        (transversality(1), "<", 0),
        (transversality(-1), ">", 0),
        (literal[1] - literal[2], "!=", 0),
    )


def two_solutions() -> Evidence:
    """(11), (12) from the start of Fig. 4 (a): a stick and a slip, both by substitution."""
    found = [residual(solution(mode, DampingRegime.UNDAMPED)) for mode in ("stick", "slip-")]
    return identity(
        "a pair that sticks permanently satisfies (11), (12), and one that slips with $\\dot z<0$, too (by substitution)",
        found,
    )


@claim(
    "sgn-three-valued",
    "II",
    "eq. (1) and the sentence after it",
    CORRECTED,
    r"""
    The signum is three-valued, $\mathrm{sgn}(v)=1,\,0,\,-1$ for $v>0$, $v=0$, $v<0$, unlike a set-valued sign
    operator; this allows well-defined solutions at zero differential velocity between the two moving bodies.
    """,
    correction=(
        clause(
            "same",
            r"""
            For $u=0$ the solutions of (3)–(4) (absolutely continuous, equations met at almost every time) are those
            of (5)–(7), with the damper of (3) kept in (6), in Filippov's sense, where $\mathrm{sgn}(0)$ is the whole
            interval $[-1,1]$;
            """,
            kernel="switching-iff",
        ),
        clause(
            "unique",
            r"from every initial state there is exactly one such solution, forward in time.",
            kernel="filippov-well-posed",
        ),
        *under_a_force(),
    ),
)
def sgn_three_valued() -> Case:
    """Existence and uniqueness at z' = 0 in (3)-(4), in (5)-(7) with sgn(0) = 0, and in (11)-(12)."""
    first_contact = solved(load_scene("start-at-6mm")).events[0].t
    literal = free_system(Integer(0))
    return because(
        r"""
        What gives (3)–(4) well-defined solutions at $\dot z=0$ is the total mass in (3) with the stiction bracket in
        (4), not $\mathrm{sgn}(0)=0$. With $u=0$ every initial state has exactly one solution, the Filippov solution,
        and under a force it has that one or none. In Coulomb's law alone, (5)–(7), the three-valued signum leaves no
        solution through the interior of $S_0$ with $x_1\neq 0$; where the bracket is dropped, (11)–(12), solutions are
        not unique; and under a control that holds $|\ddot x_1|=b/m_2$, (3)–(4) itself has none.
        """,
        counterexample(
            (
                "$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$. (5)–(7) with $\\mathrm{sgn}(0)=0$ from $x_1=0.004$ at "
                f"rest: $\\dot v_1={value_at(literal[1], AT_4MM)}$ and $\\dot v_2=0$ on $S$, while off $S$ both fields lead back: no "
                "solution. (11)–(12) from $x_1=0.006$ at rest: $x_1=0.006\\cos 10t$ with $\\dot z=0$ permanently, and a slip with "
                f"$\\dot z<0$ until $t_1=$ {text(first_contact)} s: two of its solutions. (3)–(4) with $u=1+50t^2$ from rest at 0: none."
            ),
            no_solution_inside,
            two_solutions,
            compare("that slip lasts until a time $t_1>0$", first_contact, ">", point(0)),
            kernel.step("no-solution-under-control"),
        ),
        carried("same", filippov.equivalent),
        carried("unique", filippov.one_solution),
    )
