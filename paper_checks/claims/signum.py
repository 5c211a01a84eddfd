"""The three-valued signum of (1): what (3), (4) mean with it, and what becomes of them under a force."""

from functools import cache

import sympy as sp

from numerics.linear.modes import Mode
from numerics.scene.file import load_scene
from paper_checks.claims import filippov
from paper_checks.claims.contraction import one_solution, same_modes
from paper_checks.claims.filippov import spurious_branch, spurious_branches_leave
from paper_checks.claims.points import EXAMPLE_PAIR, INSIDE, START_AT_6MM
from paper_checks.claims.transfers import stuck_force
from paper_checks.claims.words import *
from paper_checks.decide.enclosure import compare, exact, itinerary, solved, text
from theory import forced
from theory import forced_control as control
from theory.closed_forms import DampingRegime, residual, solution
from theory.filippov import sliding_field, transversality
from theory.forced import held_at_the_limit, load
from theory.model import branch_named, case_study_mode, free_system, stick


@cache
def stiction_by_load() -> Evidence:
    """The bracket of (4) asks for the load."""
    return identity(
        r"in stick under a force $m_2\ddot x_1=\Lambda$: the bracket of (4) is $1$, $\frac12$, $0$ where $|\Lambda|<,\,=,\,>b$",
        m2 * stick().acceleration1,
        forced.load(),
    )


@cache
def agree() -> Evidence:
    """Every solution of (3), (4) is the motion of Coulomb's law, which is one of them if it is at the limit almost never."""
    return argument(
        r"""
        A solution of (3), (4) has $\ddot z=0$ at almost every time with $\dot z=0$, so neither half nor broken adhesion
        there: it sticks with $|\Lambda|<b$, and is the one motion of Coulomb's law. Conversely, that motion has $\ddot
        z=0$ at almost every time with $\dot z=0$, so its friction is $\Lambda$, $|\Lambda|\leqslant b$; where
        $|\Lambda|<b$ it meets (3), (4), and where $|\Lambda|=b$ it does not, as (4) transmits half.
        """,
        spurious_branch("half adhesion"),
        spurious_branch("broken adhesion"),
        spurious_branches_leave(),
        stiction_by_load(),
        same_modes(),
        one_solution(),
    )


@cache
def stuck_below_the_limit() -> Evidence:
    """A stuck pair that asks for less than all of the friction obeys (3), (4), too; it needs no more time than one likes."""
    slower = Symbol("k", positive=True)
    return argument(
        r"""
        A pair that sticks along a reference has the load $m_2\ddot x_{\mathrm{ref}}$: with $|\ddot
        x_{\mathrm{ref}}|<b/m_2$ it satisfies (3), (4) as it satisfies Coulomb's law. Half of the way with the
        acceleration $4D/T^2$ and half with its opposite takes the time $T$, and requires less than $b/m_2$ if $T$
        exceeds the least time.
        """,
        stuck_force(),
        agree(),
        identity(
            r"at the least time that acceleration is $b/m_2$",
            4 * control.path / control.least_time() ** 2,
            control.strongest(),
        ),
        prove(
            r"in $k>1$ times the least time it is less, $b/(m_2k^2)<b/m_2$",
            [slower > 1],
            sp.Lt(b, b * slower**2, evaluate=False),
        ),
    )


def under_a_force() -> tuple[Clause, ...]:
    """Return what becomes of (3), (4) under a force, where a correction says it for the free system."""
    return (
        clause(
            "forced",
            r"""
            Under a force $u(t)$ (3)–(4) have a solution exactly if the motion of Coulomb's law from the same start
            has $|\Lambda|=b$ at almost no time with $\dot z=0$, where «load»; then it is that motion, else there is
            none.
            """,
            load=equal(r"\Lambda", m2 * (u - a1 * v1 - a2 * x1) / (m1 + m2), load),
        ),
        clause(
            "none",
            r"So there is none for $m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$ from rest at $0$ under «held».",
            held=equal("u", 1 + 50 * t**2, held_at_the_limit),
        ),
    )


# Where the control that holds eq. (4) at its equality takes body 1: the path of stick with the acceleration b/m2 from rest.
PATH = EXAMPLE_PAIR[b] * t**2 / (2 * EXAMPLE_PAIR[m2])
CONTRADICTION = r"""
No solution with $u=1+50t^2$: for a short time $\dot z<0$ is impossible, as $\ddot z>0$ there. While $\dot z\geqslant
0$, $x_1=t^2/4$ (a linear equation with zero data for the difference). Then $\dot z$ cannot grow, as $\ddot z=0$ where
$\dot z>0$; and it cannot stay 0, as $\ddot z=1/4$ where $\dot z=0$.
"""


def no_solution_inside() -> Evidence:
    """(5)-(7) with sgn(0) = 0 at a point inside S0: neither staying on S nor leaving it is possible."""
    literal = free_system(Integer(0))
    return exhibit(
        r"""
        with $\mathrm{sgn}(0)=0$ in (5)–(7), at $x_1=0.004$ at rest: both fields point to $S$, so a solution must stay
        on it, where $\dot v_1\neq\dot v_2$
        """,
        INSIDE,
        (transversality(1), "<", 0),
        (transversality(-1), ">", 0),
        (literal[1] - literal[2], "!=", 0),
    )


def two_solutions() -> Steps:
    """(11), (12) from the start of Fig. 4 (a): a stick and a slip, both by substitution."""
    slipping = solved(load_scene("start-at-6mm"))
    stuck, loose = (solution(mode, DampingRegime.UNDAMPED) for mode in ("stick", "slip-"))
    return (
        identity("a pair that sticks permanently satisfies (11), (12) (stick, by substitution)", residual(stuck)),
        identity(
            "a pair that slips with $\\dot z<0$ satisfies them too (slip, by substitution)",
            residual(loose),
        ),
        itinerary("from the start of Fig. 4 (a) the slip has $\\dot z<0$ at first", slipping, [Mode.SLIP_MINUS]),
        compare("and until a time $t_1>0$", slipping.events[0].t, ">", exact(0)),
    )


def controlled(name: str, offset: Expr) -> Expr:
    """Return z'' of a branch under that control at x1 = path + offset, v1 = velocity of the path (m/s^2)."""
    found = branch_named(name)
    place = {**EXAMPLE_PAIR, u: held_at_the_limit(), x1: PATH + offset, v1: diff(PATH, t)}
    return expand((found.acceleration1 - found.acceleration2).subs(place))


def no_solution_under_control() -> Steps:
    """(3), (4) with a control: each branch contradicts itself."""
    place = {**EXAMPLE_PAIR, u: held_at_the_limit(), x1: PATH, v1: diff(PATH, t)}
    offset = Symbol("delta", real=True)
    return (
        identity(
            "with $u=1+50t^2$ from rest, $\\dot z=0$ gives $x_1=t^2/4$ and $\\ddot x_1=b/m_2$ for all $t$",
            branch_named("half adhesion").acceleration1.subs(place),
            (b / m2).subs(EXAMPLE_PAIR),
        ),
        identity(
            "there (4) leaves half of the adhesion: $\\ddot z=1/4\\neq 0$",
            controlled("half adhesion", Integer(0)),
            Rational(1, 4),
        ),
        identity("with $\\dot z>0$ it gives $\\ddot z=0$ at $x_1=t^2/4$", controlled("slip+", Integer(0))),
        identity(
            "with $\\dot z<0$ it gives $\\ddot z=2-200\\delta$ at $x_1=t^2/4+\\delta$: positive near $\\delta=0$",
            controlled("slip-", offset),
            2 - 200 * offset,
        ),
    )


def none_under_control() -> Evidence:
    """(3), (4) with that control: the inference over these branches."""
    return argument(CONTRADICTION, *no_solution_under_control())


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
                f"rest: $\\dot v_1={value_at(literal[1], INSIDE)}$ and $\\dot v_2=0$ on $S$, while off $S$ both fields lead back: no "
                "solution. (11)–(12) from $x_1=0.006$ at rest: $x_1=0.006\\cos 10t$ with $\\dot z=0$ permanently, and a slip with "
                f"$\\dot z<0$ until $t_1=$ {text(first_contact)} s: two of its solutions. (3)–(4) with $u=1+50t^2$ from rest at 0: none."
            ),
            no_solution_inside(),
            *two_solutions(),
            *no_solution_under_control(),
        ),
        carried("same", filippov.equivalent()),
        carried("unique", filippov.one_solution()),
        carried("forced", agree()),
        carried("none", none_under_control()),
        derivation=(
            *filippov.ARGUMENT,
            equation(r"(\dot{x}_1,\dot{v}_1,\dot{v}_2)|_{\dot{z}=0}", sliding_field(damped=True).T),
            CONTRADICTION,
            "Both solutions of (11)–(12): with $\\dot z=0$ and with $\\dot z<0$ they read "
            f"$${latex(Matrix([case_study_mode(0), case_study_mode(-1)]))}$$ for $(\\ddot x_1,\\ddot x_2)$; at "
            f"$x_1=0.006$ the second gives $\\ddot z={value_at(case_study_mode(-1)[0] - case_study_mode(-1)[1], START_AT_6MM)}"
            "<0$.",
        ),
        figure=None,
    )
