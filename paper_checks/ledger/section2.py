"""Section II: dynamics of a pair of bodies with frictional interface."""

import sympy as sp

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Clause, Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from theory.energy import sigma
from theory.forced import energy_rate as forced_energy_rate
from theory.forced import forced_system, held_at_the_limit, load
from theory.model import RELATIVE_SIGN, STICTION_SIGN, branch_named, driven_equation, driving_equation
from theory.symbols import a1, a2, acceleration1, acceleration2, b, m1, m2, t, u, v1, v2, x1

SECTION = "II"
Z, ADHESION = (
    sp.Symbol(r"\mathrm{sgn}(\dot{z})", real=True),
    sp.Symbol(r"\mathrm{sgn}(|\ddot{x}_1|-b\,m_2^{-1})", real=True),
)
LETTERS = {RELATIVE_SIGN: Z, STICTION_SIGN: ADHESION}


def _factor(sign: int) -> sp.Expr:
    """Return what the brackets of (4) hand on of m2 x1'' at z' = 0 for a sign of |x1''| - b/m2."""
    return sp.diff(driven_equation().subs({RELATIVE_SIGN: 0, STICTION_SIGN: sign}), acceleration1) / m2


REFERENCE, REFERENCE_RATE, DISTURBANCE = sp.symbols(r"x_{\mathrm{ref}} \dot{x}_{\mathrm{ref}} u_d", real=True)
STIFFNESS, VISCOSITY = sp.symbols("k_1 k_2", positive=True)


def _feedback() -> sp.Expr:
    """Return the force u of (3) for a feedback on the place and velocity beside a reference, and a disturbance, N."""
    command = DISTURBANCE - STIFFNESS * (x1 - REFERENCE) - VISCOSITY * (v1 - REFERENCE_RATE)
    virtual = {a1: a1 + VISCOSITY, a2: a2 + STIFFNESS}
    closed, given = (driving_equation() + u).subs(virtual, simultaneous=True), driving_equation() + u
    return sp.expand(closed - given + command)


def under_a_force() -> tuple[Clause, ...]:
    """Return what becomes of (3), (4) under a force, where a correction says it for the free system."""
    return (
        clause(
            "forced",
            r"Under a force $u(t)$ (3)–(4) have a solution exactly if the motion of Coulomb's law from the same start has $|\Lambda|=b$ at almost no time with $\dot z=0$, where «load»; then it is that "
            r"motion, else there is none.",
            load=Formula(r"\Lambda", "=", m2 * (u - a1 * v1 - a2 * x1) / (m1 + m2), equals(load)),
        ),
        clause(
            "none",
            r"So there is none for $m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$ from rest at $0$ under «held».",
            held=Formula("u", "=", 1 + 50 * t**2, equals(held_at_the_limit)),
        ),
    )


SECTION_2 = (
    Claim(
        "force-as-reference-or-disturbance",
        SECTION,
        "paragraph after Fig. 2",
        r"The virtual spring and damper can represent mechanical components as well as feedback control terms. For a feedback controlled "
        r"body $u(t)$ is then an exogenous input that can be either a reference motion trajectory, or a generalized disturbing "
        r"force, or a combination of both.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "input",
                r"With the feedback $-k_1(x_1-x_{\mathrm{ref}})-k_2(v_1-\dot x_{\mathrm{ref}})$ and a disturbing force $u_d$, (3) and (4) hold with $a_2+k_1$, $a_1+k_2$ in the places of "
                r"$a_2$, $a_1$ and «input»: the reference enters through the gains, as a force.",
                input=Formula(
                    "u",
                    "=",
                    STIFFNESS * REFERENCE + VISCOSITY * REFERENCE_RATE + DISTURBANCE,
                    equals(_feedback),
                ),
            ),
        ),
    ),
    Claim(
        "free-interface",
        SECTION,
        "second paragraph after Fig. 2",
        r"The interface is free of additional constraints: the second body experiences unrestricted tangential motion and no force constraints other than the normal loading caused by "
        r"the Coulomb frictional force $f(t)$.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "tangential",
                r"Friction is no normal loading, nor does it cause one: it is tangential, the one force on body 2 along its motion, «force», and adds the power «power», which is negative in slip.",
                force=Formula(r"m_2\ddot x_2", "=", b * sigma, equals(lambda: m2 * forced_system(sigma)[2])),
                power=Formula(
                    "P", "=", -b * sigma * (v1 - v2), equals(lambda: forced_energy_rate() - u * v1 + a1 * v1**2)
                ),
            ),
            clause(
                "bounded",
                r"The normal load is not in the equations but in their coefficient $b$, the most that friction can be; with it body 2 changes its velocity by at most $b/m_2$ times the time.",
            ),
        ),
    ),
    Claim(
        "sgn-three-valued",
        SECTION,
        "eq. (1) and the sentence after it",
        r"The signum is three-valued, $\mathrm{sgn}(v)=1,\,0,\,-1$ for $v>0$, $v=0$, $v<0$, unlike a "
        r"set-valued sign operator; this allows well-defined solutions at zero differential velocity "
        r"between the two moving bodies.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "same",
                r"For $u=0$ the solutions of (3)–(4) (absolutely continuous, equations met at almost every time) are those of "
                r"(5)–(7), with the damper of (3) kept in (6), in Filippov's sense, where $\mathrm{sgn}(0)$ is the whole interval $[-1,1]$;",
                kernel=("switching-iff",),
            ),
            clause(
                "unique",
                r"from every initial state there is exactly one such solution, forward in time.",
                kernel=("filippov-well-posed",),
            ),
            *under_a_force(),
        ),
    ),
    Claim(
        "modes-from-closed-form",
        SECTION,
        "eqs. (3), (4)",
        (
            clause(
                "equations",
                r"The equations of motion are «first» and «second».",
                first=Formula(
                    "u",
                    "=",
                    (m1 + m2 * (1 - sp.Abs(Z))) * acceleration1 + a1 * v1 + a2 * x1 + b * Z,
                    equals(lambda: driving_equation().subs(LETTERS) + u),
                ),
                second=Formula(
                    "0",
                    "=",
                    m2 * acceleration1 * (1 - sp.Abs(Z)) * (1 - ADHESION) / 2 - m2 * acceleration2 + b * Z,
                    equals(lambda: driven_equation().subs(LETTERS)),
                ),
            ),
            clause(
                "modes",
                r"Including the signum in (3) and (4) switches directly between the two modes: (i) $\dot{x}_1=\dot{x}_2$, no "
                r"frictional damping, and the driving body carries the total mass $m_1+m_2$; (ii) the second body slides under the "
                r"friction force, which accelerates or decelerates both bodies. Neither if-else statements nor case differences "
                r"are required.",
            ),
        ),
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "branches",
                r"For $\dot z\neq 0$ (3), (4) are mode (ii). For $\dot z=0$ they are mode (i) where $|\ddot x_1|<b/m_2$; where $|\ddot x_1|>b/m_2$ body 2 is left without "
                r"acceleration, and where $|\ddot x_1|=b/m_2$ with half of $\ddot x_1$.",
            ),
            clause("instants", r"The free system is in these two branches at isolated instants only."),
            *under_a_force(),
        ),
    ),
    Claim(
        "stiction-bracket",
        SECTION,
        "eq. (4), last sentence of Section II",
        r"Decoupling of the bodies, that is switching to mode (ii), is enabled in (4) by the first bracket "
        r"for $\dot{z}\neq 0$ and by the second bracket, "
        r"$\tfrac{1}{2}\bigl(1-\mathrm{sgn}(|\ddot{x}_1|-b\,m_2^{-1})\bigr)$, for the case when the "
        r"stiction condition, printed as $|\ddot{x}_1|>b\,m_2^{-1}$, is violated.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "brackets",
                r"At $\dot z=0$ the brackets of (4) hand on $m_2\ddot x_1$ with the factor «kept» where $|\ddot x_1|<b/m_2$, «half» where "
                r"$|\ddot x_1|=b/m_2$ and «broken» where $|\ddot x_1|>b/m_2$.",
                kept=Formula("f", "=", sp.Integer(1), equals(lambda: _factor(-1))),
                half=Formula("f", "=", sp.Rational(1, 2), equals(lambda: _factor(0))),
                broken=Formula("f", "=", sp.Integer(0), equals(lambda: _factor(1))),
            ),
            clause(
                "condition",
                r"The stiction condition of Coulomb's law is $|\ddot x_1|\leqslant b/m_2$, equality included; $|\ddot x_1|>b/m_2$ is "
                r"its violation.",
            ),
        ),
    ),
    Claim(
        "interface-force-balance",
        SECTION,
        "eqs. (3), (4)",
        r"The friction force acts between the bodies: in mode (ii) it impacts the momentum of both, which accelerate or decelerate "
        r"each other. The interface should allow for the conservation of momentum of the moving pair (Section I).",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "balanced",
                r"The forces that (3), (4) put on the two bodies add up to nothing in the modes of the text: in stick, where "
                r"$|\ddot x_1|<b/m_2$, and in slip with $\dot z>0$ and with $\dot z<0$ these sums are «sum»;",
                sum=Formula(
                    "f_1+f_2",
                    "=",
                    sp.zeros(3, 1),
                    equals(
                        lambda: sp.Matrix([branch_named(name).force_imbalance for name in ("stick", "slip+", "slip-")])
                    ),
                ),
            ),
            clause(
                "broken",
                r"where (4) breaks adhesion at $\dot z=0$ they do not, but the free system is there at isolated instants only, so it "
                r"conserves the balance of momentum at almost every time.",
            ),
        ),
    ),
)
