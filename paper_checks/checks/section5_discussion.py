"""Section V, bullets 4 and 6: the two readings of the signum, and the bound of the driven body's acceleration."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from numerics.linear.modes import Mode
from numerics.scene.file import load_scene
from paper_checks.checks.registry import Context, check
from paper_checks.checks.section2_signum import none_under_control
from paper_checks.engines.enclosure import compare, exact, itinerary, solved, stuck_for_ever, text
from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit, value_at
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.evidence.formula import equation, latex
from paper_checks.ledger import claim_named
from paper_checks.ledger.points import EXAMPLE_PAIR, START_AT_6MM
from paper_checks.solvers.smt import prove
from paper_checks.steps import solutions, transfers, two_laws
from theory.filippov import load, load_threshold, phi, sliding_field
from theory.model import CASE_STUDY, branch_named, branches, case_study_mode
from theory.symbols import a1, b, m2, x1

COMPARED_AT = Fraction(1, 5)
"""A time (s) at which both readings of Fig. 4 (a) are compared."""
APART = sp.Rational("0.0004")
"""A distance (m) by which they then differ."""


def readings_part() -> tuple[Evidence, ...]:
    """Fig. 4 (a): the literal reading sticks for ever, the Filippov law slips at once; how far x2 is apart."""
    literal, filippov = solved(load_scene("start-at-6mm-literal")), solved(load_scene("start-at-6mm"))
    apart = abs(literal.sol(COMPARED_AT)[2] - filippov.sol(COMPARED_AT)[2])
    return (
        stuck_for_ever("from the start of Fig. 4 (a), (11)–(12) read literally stick for ever", literal),
        itinerary("Filippov's solution slips at once, then sticks", filippov, [Mode.SLIP_MINUS, Mode.STICK]),
        compare("at $t=0.2$ s their values of $x_2$ are more than 0.4 mm apart", apart, ">", exact(APART)),
    )


def same_fields() -> tuple[Evidence, ...]:
    """(11)-(12) and the Filippov law of the example have the same accelerations in slip and in stick."""
    fields = (
        ("slip with $\\dot z>0$", 1, phi(1)),
        ("slip with $\\dot z<0$", -1, phi(-1)),
        ("stick in $S_0$", 0, sliding_field()),
    )
    return tuple(
        identity(
            f"{name}: (11)–(12) and (5)–(7) in Filippov's sense have the same accelerations",
            sp.Matrix(case_study_mode(sign)),
            field[1:, 0].subs(CASE_STUDY),
        )
        for name, sign, field in fields
    )


@check("two-descriptions")
def two_descriptions(_: Context) -> Finding:
    """Compare the solutions of (3)-(4), of (11)-(12) and of (5)-(7)."""
    literal, filippov = (
        solved(load_scene(name)).sol(COMPARED_AT)[2] for name in ("start-at-6mm-literal", "start-at-6mm")
    )
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "The two readings describe the same motion for (2)–(4) with $u=0$, and not beyond. There the stiction bracket makes them agree. Under a force that holds the load at the limit $b$ of a "
        "stuck pair (3)–(4) have no solution; and for (11)–(12), where the bracket is dropped, they part. There the three-valued signum (1) lets the bodies stick beyond $S_0$, where friction "
        "cannot hold them: that is a different law, and the convergence shown for the Filippov system says nothing about "
        "such solutions. Both agree until the pair first meets $S$ outside $S_0$, or leaves $S_0$ by a ray.",
        *(item.as_counterexample() for item in readings_part()),
        exhibit(
            "for that literal stick, body 2 has $m_2|\\ddot x_2|>b$: more than friction can give",
            START_AT_6MM,
            (sp.Abs(m2 * case_study_mode(0)[1]), ">", b),
        ).as_counterexample(),
        carried("same", solutions.equivalent().as_correction(), solutions.one_solution().as_correction()),
        carried(
            "example",
            argument(
                "In slip and on $S_0$ (11)–(12) have Filippov's accelerations, so his solutions satisfy them; a stick that is kept beyond $S_0$ is another solution.",
                *same_fields(),
                *readings_part(),
            ).as_correction(),
        ),
        carried("forced", two_laws.agree().as_correction()),
        carried("none", none_under_control().as_correction()),
        corrected=claim_named("two-descriptions").corrected,
        counterexample="Fig. 4 (a), $x_1(0)=0.006$, $b=0.5$, at rest: read literally, (11)–(12) stick for ever and give "
        f"$x_2(0.2)=$ {text(literal)} m; the Filippov law, and (3)–(4), slip at once and give {text(filippov)} m.",
        derivation=(
            *solutions.ARGUMENT,
            equation(r"(\dot{x}_1,\dot{v}_1,\dot{v}_2)|_{S_0}", sliding_field().T),
            equation(r"(\ddot{x}_1,\ddot{x}_2)|_{(13)}", sp.Matrix(case_study_mode(0)).T),
        ),
        figure="start-at-6mm",
    )


def bounded_in_slip() -> Evidence:
    """m2 x2'' is plus or minus b in slip."""
    return identity(
        "in slip $m_2\\ddot x_2=\\pm b$: the bound is attained",
        sp.Matrix([m2 * branch_named(name).acceleration2 for name in ("slip+", "slip-")]),
        sp.Matrix([b, -b]),
    )


def bounded_in_stick() -> Evidence:
    """On S0 stick has m2 |x2''| <= b, for all parameters, a1 >= 0."""
    force, width = sp.fraction(load_threshold())
    pull = load(damped=True)
    masses, carried = sp.fraction(sp.cancel(-pull / sliding_field(damped=True)[2]))
    # m2 |x2''| = m2 |load|/M <= b, with M = masses/carried put on the other side.
    closed = {a1: sp.Symbol("a1", nonnegative=True)}
    return prove(
        "on $S_0$ stick has $|\\ddot x_2|\\leqslant b/m_2$, with $(m_1+m_2)\\,\\ddot x_2=-(a_2x_1+a_1v_1)$",
        [sp.Le(sp.Abs(pull) * width, force).subs(closed)],
        sp.Le(sp.Abs(pull) * m2 * carried, b * masses).subs(closed),
    )


@check("acceleration-bound")
def acceleration_bound(_: Context) -> Finding:
    """Bound x2'' in every mode, and read the sentence literally."""
    slipping, literal = case_study_mode(1), case_study_mode(0)
    unloaded = {**EXAMPLE_PAIR, x1: sp.solve(slipping[0], x1)[0].subs(EXAMPLE_PAIR)}
    rest = [one for one in branches() if one.name in ("half adhesion", "broken adhesion")]
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "What the control can demand of body 2 is bounded by friction: $|\\ddot x_2|\\leqslant b/m_2$ in every mode under "
        "the Filippov law and (3)–(4), attained throughout slip. The equation $\\ddot x_1=\\ddot x_2$ of (13) is not that bound: "
        "in slip $|\\ddot x_2|$ exceeds $|\\ddot x_1|$ when the driving body passes its rest position. Under (11)–(12) read "
        "literally nothing bounds $|\\ddot x_2|=100\\,|x_1|$ in stick.",
        exhibit(
            "in slip with $\\dot z>0$ at $x_1=-b/200$, $\\ddot x_1=0$ and $|\\ddot x_2|>|\\ddot x_1|$",
            unloaded,
            (slipping[0], "=", 0),
            (sp.Abs(slipping[1]), ">", sp.Abs(slipping[0])),
        ).as_counterexample(),
        exhibit(
            "under (11)–(12) the start of Fig. 4 (a) has $|\\ddot x_2|>b/m_2$",
            START_AT_6MM,
            (sp.Abs(literal[1]), ">", b / m2),
        ).as_counterexample(),
        carried("bound", transfers.gentle().as_correction()),
        carried(
            "modes",
            *(item.as_correction() for item in (bounded_in_slip(), bounded_in_stick(), solutions.stick_is_filippov())),
        ),
        carried(
            "equality",
            two_laws.agree().as_correction(),
            *(
                identity(
                    f"in the branch with {one.name}, $\\ddot x_2={share}\\cdot\\ddot x_1$, no more than $b/m_2$",
                    one.acceleration2,
                    share * one.acceleration1,
                ).as_correction()
                for one, share in zip(rest, (sp.Rational(1, 2), sp.Integer(0)), strict=True)
            ),
        ),
        corrected=claim_named("acceleration-bound").corrected,
        counterexample="$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$. In slip with $\\dot z>0$ at "
        f"$x_1={value_at(x1, unloaded)}$: $\\ddot x_1={value_at(slipping[0], unloaded)}$, "
        f"$\\ddot x_2={value_at(slipping[1], unloaded)}$. Under (11)–(12) at $x_1=0.006$, $\\dot z=0$: "
        f"$|\\ddot x_2|={value_at(sp.Abs(literal[1]), START_AT_6MM)}>{value_at(b / m2, START_AT_6MM)}=b/m_2$.",
        derivation=(
            equation(r"\ddot{x}_2|_{\dot{z}>0}", branch_named("slip+").acceleration2),
            equation(r"\ddot{x}_2|_{\dot{z}<0}", branch_named("slip-").acceleration2),
            equation(r"\ddot{x}_2|_{\mathrm{stick}}", sliding_field(damped=True)[2]),
            f"On $S_0$: $$|{latex(load(damped=True))}|\\leqslant {latex(load_threshold())}$$",
        ),
    )
