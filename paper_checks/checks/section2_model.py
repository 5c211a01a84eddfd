"""Section II, eqs (3), (4): the branches of the closed form, the stiction bracket, the force between the bodies."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.checks.section2_signum import none_under_control
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit, value_at
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.evidence.formula import equation, latex
from paper_checks.ledger import claim_named
from paper_checks.ledger.points import EDGE, INSIDE, START_AT_6MM
from paper_checks.steps.solutions import (
    adhesion_factor,
    bracket_is_off_in_slip,
    edge_is_isolated,
    spurious_branch,
    spurious_branches_leave,
    stick_is_filippov,
    stick_region,
)
from paper_checks.steps.two_laws import agree
from theory.model import (
    branch_named,
    branches,
    driven_equation,
    driving_equation,
)
from theory.symbols import a1, a2, acceleration1, acceleration2, b, m1, m2, u, v1, x1

SPURIOUS = ("half adhesion", "broken adhesion")


def leaves_the_surface() -> tuple[Evidence, ...]:
    """Return the steps that let the spurious branches last no time in the free system."""
    return (*(spurious_branch(name) for name in SPURIOUS), spurious_branches_leave(), edge_is_isolated())


def mode_equations(sign: int) -> sp.Matrix:
    """Return the text's modes as left minus right side, N: (i) for sign 0, (ii) for sign 1 and -1."""
    mass = m1 + m2 if sign == 0 else m1
    first = mass * acceleration1 + a1 * v1 + a2 * x1 + b * sign - u
    second = acceleration1 - acceleration2 if sign == 0 else m2 * acceleration2 - b * sign
    return sp.Matrix([first, second])


def is_mode(name: str) -> Evidence:
    """Substitute the branch's accelerations into the equations of the text's mode."""
    found = branch_named(name)
    motion = {acceleration1: found.acceleration1, acceleration2: found.acceleration2}
    mode = "(i)" if name == "stick" else "(ii)"
    return identity(
        f"the branch {name} of (3), (4) is mode {mode} of the text",
        mode_equations(int(found.relative_sign)).subs(motion),
        0,
    )


@check("modes-from-closed-form")
def modes_from_closed_form(_: Context) -> Finding:
    """Solve (3), (4) for every pair of signs and compare the branches with the two modes."""
    broken, half = branch_named("broken adhesion"), branch_named("half adhesion")
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "Putting each of the nine pairs of values of the two signs into (3), (4) and solving for the accelerations gives "
        f"{len(branches())} different branches, not two. Three are the modes of the text: stick, and slip in either "
        "direction. The others occur at $\\dot z=0$ where the second bracket of (4) is 0 or 1/2: body 1 carries the "
        "total mass, yet body 2 is not accelerated with it. With $u=0$ they last no time, so the motion of the free "
        "system is made of the two modes only.",
        exhibit(
            "at the start of Fig. 4 (a) (3), (4) give $\\ddot x_1\\neq\\ddot x_2$, $(m_1+m_2)\\,\\ddot x_1=-a_2x_1$: the "
            "total mass and no adhesion",
            START_AT_6MM,
            (sp.Abs(broken.acceleration1), ">", b / m2),
            ((m1 + m2) * broken.acceleration1, "=", -a2 * x1),
            (broken.acceleration2, "=", 0),
        ).as_counterexample(),
        exhibit(
            "at $x_1=0.005$, at rest, $|\\ddot x_1|=b/m_2$ and $\\ddot x_2=\\ddot x_1/2$",
            EDGE,
            (sp.Abs(half.acceleration1), "=", b / m2),
            (half.acceleration2, "=", half.acceleration1 / 2),
            (half.acceleration1, "!=", 0),
        ).as_counterexample(),
        carried(
            "branches",
            *(is_mode(name).as_correction() for name in ("stick", "slip+", "slip-")),
            *(spurious_branch(name).as_correction() for name in SPURIOUS),
        ),
        carried(
            "instants",
            argument(
                "Both branches leave $\\dot z=0$ at once, and the edge is met at isolated instants.",
                stick_region(),
                *leaves_the_surface(),
            ).as_correction(),
        ),
        carried("forced", agree().as_correction()),
        carried("none", none_under_control().as_correction()),
        corrected=claim_named("modes-from-closed-form").corrected,
        counterexample="$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, $u=0$ with $x_1=0.006$, $\\dot x_1=\\dot x_2=0$, the "
        f"start of Fig. 4 (a): (3), (4) give $\\ddot x_1={value_at(broken.acceleration1, START_AT_6MM)}$ and "
        f"$\\ddot x_2={value_at(broken.acceleration2, START_AT_6MM)}$, neither mode (i) nor mode (ii).",
        derivation=tuple(
            f"Branch {one.name}: $$\\ddot{{x}}_1={latex(one.acceleration1)},\\qquad "
            f"\\ddot{{x}}_2={latex(one.acceleration2)}$$"
            for one in branches()
        ),
    )


@check("stiction-bracket")
def stiction_bracket(_: Context) -> Finding:
    """Evaluate the brackets of (4) for <, = and >, and find where stick satisfies the friction law."""
    stuck = branch_named("stick")
    at_zero = {relation: adhesion_factor(0, sign) for relation, sign in (("<", -1), ("=", 0), (">", 1))}
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "The inequality is printed the wrong way round: $|\\ddot x_1|>b/m_2$ is the violation, the stiction condition is "
        "$|\\ddot x_1|\\leqslant b/m_2$, since adhesion needs the force $m_2|\\ddot x_1|$ and friction gives at most $b$. "
        "The second bracket of (4) is 1 for $<$ and 0 for $>$, as meant; at equality, where $\\mathrm{sgn}(0)=0$, it is "
        "1/2, which is neither adhesion nor release. The first bracket decouples as said.",
        exhibit(
            "at $x_1=0.004$ the condition as printed, $|\\ddot x_1|>b/m_2$, is violated, yet (4) keeps adhesion",
            INSIDE,
            (sp.Abs(stuck.acceleration1), "<=", b / m2),
            (stuck.acceleration2, "=", stuck.acceleration1),
            (adhesion_factor(0, -1), "=", 1),
        ).as_counterexample(),
        exhibit(
            "at $x_1=0.005$, $|\\ddot x_1|=b/m_2$: (4) gives $\\ddot x_2=\\ddot x_1/2$",
            EDGE,
            (sp.Abs(stuck.acceleration1), "=", b / m2),
            (branch_named("half adhesion").acceleration2, "=", stuck.acceleration1 / 2),
        ).as_counterexample(),
        identity(
            "at $\\dot z=0$ the brackets of (4) are $1$, $1/2$, $0$ for $|\\ddot x_1|<,\\,=,\\,>b/m_2$",
            sp.Matrix(list(at_zero.values())),
            sp.Matrix([1, sp.Rational(1, 2), 0]),
        ).as_correction(),
        bracket_is_off_in_slip().as_correction(),
        identity(
            "adhesion needs the force $m_2\\ddot x_1$ on body 2: friction can give it where $|\\ddot x_1|\\leqslant b/m_2$",
            stuck.force_on_second,
            m2 * stuck.acceleration1,
        ).as_correction(),
        stick_is_filippov().as_correction(),
        stick_region().as_correction(),
        corrected=claim_named("stiction-bracket").corrected,
        counterexample="$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, both bodies at rest. At $x_1=0.004$, "
        f"$|\\ddot x_1|={value_at(abs(stuck.acceleration1), INSIDE)}<b/m_2$: the printed condition is violated, and the "
        f"bodies adhere. At $x_1=0.005$, $|\\ddot x_1|={value_at(abs(stuck.acceleration1), EDGE)}=b/m_2$: "
        f"$\\ddot x_2={value_at(branch_named('half adhesion').acceleration2, EDGE)}=\\ddot x_1/2$.",
        derivation=(
            equation("0", driven_equation()),
            f"At $\\dot z=0$, for $|\\ddot x_1|<,\\,=,\\,>b/m_2$: $${latex(sp.Matrix(list(at_zero.values())).T)}$$",
            equation(r"\ddot{x}_1|_{\dot{z}=0}", stuck.acceleration1),
        ),
    )


@check("interface-force-balance")
def interface_force_balance(_: Context) -> Finding:
    """Compare, branch by branch, the interface forces that Newton's law finds on the two bodies."""
    broken, half = branch_named("broken adhesion"), branch_named("half adhesion")
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "In slip and in stick the two forces are opposite, as the text says; where (4) breaks adhesion they are not. The forces "
        "follow from the accelerations by Newton's law. In the branches at $\\dot z=0$ where adhesion breaks, for $|\\ddot x_1|>b/m_2$, body 1 carries both "
        "masses in (3) and so feels $-m_2\\ddot x_1$, while (4) gives body 2 no force at all; at equality body 2 gets half. The paper "
        "does not say that these balance, and they last no time in the free system, so they do no harm there.",
        exhibit(
            "at the start of Fig. 4 (a) the interface pushes body 1 and does not push body 2",
            START_AT_6MM,
            (sp.Abs(broken.acceleration1), ">", b / m2),
            (broken.force_on_first, "=", sp.Rational(3, 5)),
            (broken.force_on_second, "=", 0),
        ).as_counterexample(),
        exhibit(
            "at $x_1=0.005$ the forces on body 1 and body 2 do not add up to 0",
            EDGE,
            (sp.Abs(half.acceleration1), "=", b / m2),
            (half.force_on_second, "=", -half.force_on_first / 2),
            (half.force_imbalance, "!=", 0),
        ).as_counterexample(),
        carried(
            "balanced",
            *(
                identity(
                    f"in the branch {name} the forces on both bodies add up to 0", branch_named(name).force_imbalance, 0
                ).as_correction()
                for name in ("stick", "slip+", "slip-")
            ),
        ),
        carried(
            "broken",
            argument(
                "The two branches leave $\\dot z=0$ at once, or hold at isolated instants.",
                identity(
                    "with broken adhesion the sum of the forces is $-m_2\\ddot x_1$",
                    broken.force_imbalance,
                    -m2 * broken.acceleration1,
                ),
                identity(
                    "with half adhesion it is $-m_2\\ddot x_1/2$", half.force_imbalance, -m2 * half.acceleration1 / 2
                ),
                *leaves_the_surface(),
            ).as_correction(),
        ),
        corrected=claim_named("interface-force-balance").corrected,
        counterexample="$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$, $x_1=0.006$, at rest: the interface force on body 1 is "
        f"$m_1\\ddot x_1+a_2x_1={value_at(broken.force_on_first, START_AT_6MM)}$, on body 2 $m_2\\ddot x_2="
        f"{value_at(broken.force_on_second, START_AT_6MM)}$.",
        derivation=(
            equation("0", driving_equation()),
            equation("0", driven_equation()),
            *(
                f"Branch {one.name}: $$f_1={latex(one.force_on_first)},\\qquad "
                f"f_2={latex(one.force_on_second)},\\qquad f_1+f_2={latex(one.force_imbalance)}$$"
                for one in branches()
            ),
        ),
    )
