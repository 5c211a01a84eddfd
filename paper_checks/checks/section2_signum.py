"""Section II, eq. (1): what the three-valued signum allows at zero relative velocity, and what it does not."""

from __future__ import annotations

import sympy as sp

from numerics.linear.modes import Mode
from numerics.scene.file import load_scene
from paper_checks.checks.registry import Context, check
from paper_checks.engines.enclosure import compare, exact, itinerary, solved, text
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit, value_at
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.evidence.formula import equation, latex
from paper_checks.ledger import claim_named
from paper_checks.ledger.points import EXAMPLE_PAIR, INSIDE, START_AT_6MM
from paper_checks.steps import solutions, two_laws
from theory.closed_forms import Regime, residual, solution
from theory.filippov import sliding_field, transversality
from theory.forced import held_at_the_limit
from theory.model import branch_named, case_study_mode, free_system
from theory.symbols import b, m2, t, u, v1, x1

# The control under which eq. (4) stays at its equality: the path of stick with the acceleration b/m2 from rest.
PATH = EXAMPLE_PAIR[b] * t**2 / (2 * EXAMPLE_PAIR[m2])
CONTROL = held_at_the_limit()
CONTRADICTION = (
    "No solution with $u=1+50t^2$: for a short time $\\dot z<0$ is impossible, as $\\ddot z>0$ there. While "
    "$\\dot z\\geqslant 0$, $x_1=t^2/4$ (a linear equation with zero data for the difference). Then $\\dot z$ cannot "
    "grow, as $\\ddot z=0$ where $\\dot z>0$; and it cannot stay 0, as $\\ddot z=1/4$ where $\\dot z=0$."
)


def no_solution_inside() -> Evidence:
    """(5)-(7) with sgn(0) = 0 at a point inside S0: neither staying on S nor leaving it is possible."""
    literal = free_system(sp.Integer(0))
    return exhibit(
        "with $\\mathrm{sgn}(0)=0$ in (5)–(7), at $x_1=0.004$ at rest: both fields point to $S$, so a solution must stay "
        "on it, where $\\dot v_1\\neq\\dot v_2$",
        INSIDE,
        (transversality(1), "<", 0),
        (transversality(-1), ">", 0),
        (literal[1] - literal[2], "!=", 0),
    )


def two_solutions() -> tuple[Evidence, ...]:
    """(11), (12) from the start of Fig. 4 (a): a stick and a slip, both by substitution."""
    slipping = solved(load_scene("start-at-6mm"))
    stuck, loose = (solution(mode, Regime.UNDAMPED) for mode in ("stick", "slip-"))
    return (
        identity(
            "a pair that sticks for ever satisfies (11), (12) (stick, by substitution)", sp.Matrix(residual(stuck)), 0
        ),
        identity(
            "a pair that slips with $\\dot z<0$ satisfies them too (slip, by substitution)",
            sp.Matrix(residual(loose)),
            0,
        ),
        itinerary("from the start of Fig. 4 (a) the slip has $\\dot z<0$ at first", slipping, [Mode.SLIP_MINUS]),
        compare("and until a time $t_1>0$", slipping.events[0].t, ">", exact(0)),
    )


def controlled(name: str, offset: sp.Expr) -> sp.Expr:
    """Return z'' of a branch under `CONTROL` at x1 = path + offset, v1 = velocity of the path (m/s^2)."""
    found = branch_named(name)
    place = {**EXAMPLE_PAIR, u: CONTROL, x1: PATH + offset, v1: sp.diff(PATH, t)}
    return sp.expand((found.acceleration1 - found.acceleration2).subs(place))


def no_solution_under_control() -> tuple[Evidence, ...]:
    """(3), (4) with a control: each branch contradicts itself."""
    place = {**EXAMPLE_PAIR, u: CONTROL, x1: PATH, v1: sp.diff(PATH, t)}
    offset = sp.Symbol("delta", real=True)
    return (
        identity(
            "with $u=1+50t^2$ from rest, $\\dot z=0$ gives $x_1=t^2/4$ and $\\ddot x_1=b/m_2$ for all $t$",
            branch_named("half adhesion").acceleration1.subs(place),
            (b / m2).subs(EXAMPLE_PAIR),
        ),
        identity(
            "there (4) leaves half of the adhesion: $\\ddot z=1/4\\neq 0$",
            controlled("half adhesion", sp.Integer(0)),
            sp.Rational(1, 4),
        ),
        identity("with $\\dot z>0$ it gives $\\ddot z=0$ at $x_1=t^2/4$", controlled("slip+", sp.Integer(0)), 0),
        identity(
            "with $\\dot z<0$ it gives $\\ddot z=2-200\\delta$ at $x_1=t^2/4+\\delta$: positive near $\\delta=0$",
            controlled("slip-", offset),
            2 - 200 * offset,
        ),
    )


def none_under_control() -> Evidence:
    """(3), (4) with that control: the inference over these branches."""
    return argument(CONTRADICTION, *no_solution_under_control())


@check("sgn-three-valued")
def sgn_three_valued(_: Context) -> Finding:
    """Existence and uniqueness at z' = 0 in (3)-(4), in (5)-(7) with sgn(0) = 0, and in (11)-(12)."""
    first_contact = solved(load_scene("start-at-6mm")).events[0].t
    literal = free_system(sp.Integer(0))
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "What gives (3)–(4) well-defined solutions at $\\dot z=0$ is the total mass in (3) with the stiction bracket in (4), "
        "not $\\mathrm{sgn}(0)=0$. With $u=0$ every initial state has exactly one solution, the Filippov solution, and under a force it has that one or none. Put into "
        "Coulomb's law alone, (5)–(7), the three-valued signum leaves no solution through the interior of $S_0$ with "
        "$x_1\\neq 0$; where the bracket is dropped, (11)–(12), solutions are not unique; and under a control that holds "
        "$|\\ddot x_1|=b/m_2$, (3)–(4) itself has none.",
        no_solution_inside().as_counterexample(),
        *(item.as_counterexample() for item in two_solutions()),
        *(item.as_counterexample() for item in no_solution_under_control()),
        carried("same", solutions.equivalent().as_correction()),
        carried("unique", solutions.one_solution().as_correction()),
        carried("forced", two_laws.agree().as_correction()),
        carried("none", none_under_control().as_correction()),
        corrected=claim_named("sgn-three-valued").corrected,
        counterexample="$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$. (5)–(7) with $\\mathrm{sgn}(0)=0$ from $x_1=0.004$ at "
        f"rest: $\\dot v_1={value_at(literal[1], INSIDE)}$ and $\\dot v_2=0$ on $S$, while off $S$ both fields lead back: no "
        "solution. (11)–(12) from $x_1=0.006$ at rest: $x_1=0.006\\cos 10t$ with $\\dot z=0$ for ever, and a slip with "
        f"$\\dot z<0$ until $t_1=$ {text(first_contact)} s: two of its solutions. (3)–(4) with $u=1+50t^2$ from rest at 0: none.",
        derivation=(
            *solutions.ARGUMENT,
            equation(r"(\dot{x}_1,\dot{v}_1,\dot{v}_2)|_{\dot{z}=0}", sliding_field(damped=True).T),
            CONTRADICTION,
            "Both solutions of (11)–(12): with $\\dot z=0$ and with $\\dot z<0$ they read "
            f"$${latex(sp.Matrix([case_study_mode(0), case_study_mode(-1)]))}$$ for $(\\ddot x_1,\\ddot x_2)$; at "
            f"$x_1=0.006$ the second gives $\\ddot z={value_at(case_study_mode(-1)[0] - case_study_mode(-1)[1], START_AT_6MM)}"
            "<0$.",
        ),
        figure=None,
    )
