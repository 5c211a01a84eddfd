"""Section IV: illustrative case study. Unit masses, a1 = 0, a2 = 200, SI units."""

import sympy as sp

from paper_checks.engines.deciders import condition, equals, fails_at
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.points import START_AT_6MM
from theory.energy import critical_energy, on_surface
from theory.filippov import half_width
from theory.model import (
    CASE_STUDY,
    RELATIVE_SIGN,
    case_study_closed_form,
    case_study_eigenfrequency,
    case_study_mode,
)
from theory.symbols import acceleration1, b, m2, v1, x1

SECTION = "IV"
Z = sp.Symbol(r"\mathrm{sgn}(\dot{z})", real=True)
PULL = sp.Symbol(r"\ddot{x}_1", real=True)


def _reduced(index: int) -> sp.Expr:
    return case_study_closed_form()[index].subs(RELATIVE_SIGN, Z)


def _level() -> sp.Rel:
    """Return the condition E <= E_cr on S for the example, in x1 and the common velocity, with v^2 by itself."""
    speed = sp.Symbol("v_1", real=True)
    return sp.Le(sp.expand(on_surface().subs(CASE_STUDY).subs(v1, speed)), critical_energy().subs(CASE_STUDY))


def _mode(sign: int, index: int, right: sp.Expr) -> Formula:
    """Return an acceleration of (13) (sign 0) or (14)."""
    return Formula(rf"\ddot{{x}}_{index + 1}", "=", right, equals(lambda: case_study_mode(sign)[index]))


EXAMPLE_SYSTEM = (
    Claim(
        "example-eigenfrequency",
        SECTION,
        "IV-A, before eq. (11)",
        (
            clause(
                "frequency",
                r"With unit masses, $a_1=0$ and $a_2=200$ the first moving body is a harmonic oscillator, which has the "
                r"eigenfrequency «frequency» rad/s when the second body is not sliding and rests upon the first one.",
                frequency=Formula(r"\Omega", "=", sp.Integer(10), equals(case_study_eigenfrequency)),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "example-reduction",
        SECTION,
        "eqs. (11), (12)",
        (
            clause(
                "reduction",
                r"For $u=0$ the dynamics (3)–(4) reduces to the autonomous system «first», «second».",
                first=Formula(r"\ddot{x}_1", "=", -(200 * x1 + b * Z) / (2 - sp.Abs(Z)), equals(lambda: _reduced(0))),
                second=Formula(
                    r"\ddot{x}_2",
                    "=",
                    (1 - sp.Abs(Z)) * PULL + b * Z,
                    equals(lambda: _reduced(1).subs(acceleration1, PULL)),
                ),
            ),
        ),
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "example-stiction-never-violated",
        SECTION,
        "after eq. (12)",
        (
            clause(
                "bound",
                r"Equation (12) does not include the acceleration-dependent switching since the system ensures that «bound».",
                bound=Formula(
                    sp.Abs(PULL),
                    "<",
                    b / m2,
                    fails_at(START_AT_6MM, lambda: {PULL: case_study_mode(0)[0]}),
                    false=True,
                ),
            ),
        ),
        Verdict.REFUTED,
        correction=(
            clause("slip", r"Where $\dot z\neq 0$ the acceleration-dependent switching of (4) has no effect."),
            clause(
                "stick",
                r"Where $\dot z=0$ it acts exactly if $|x_1|\geqslant L$, «width»; it does not act if $E\leqslant E_{cr}$, «level» "
                r"(but for $|\ddot x_1|=b/m_2$ at $E=E_{cr}$), nor in any stick phase of (3)–(4).",
                width=Formula("L", "=", b / 100, equals(lambda: half_width().subs(CASE_STUDY))),
                level=Formula("E_{cr}", "=", b**2 / 100, equals(lambda: critical_energy().subs(CASE_STUDY))),
            ),
        ),
    ),
    Claim(
        "example-onset",
        SECTION,
        "after eq. (12)",
        r"An initial condition $x_1\vee\dot{x}_1\neq 0$ ensures a finite energy storage at $t=t_0=0$ and, "
        r"therefore, the onset of the relative motion of the free oscillator.",
        Verdict.REFUTED,
        correction=(
            clause(
                "ever",
                r"Under (3)–(4) the bodies move relative to each other at some time exactly if $\dot x_1(0)\neq\dot x_2(0)$ or "
                r"$E(0)>E_{cr}$; for the example $\dot x_1(0)=\dot x_2(0)$ stays together for ever exactly if «together» at the start.",
                together=Formula(
                    100 * x1**2 + sp.Symbol("v_1", real=True) ** 2,
                    "<=",
                    b**2 / 100,
                    condition(_level),
                    sharp=True,
                ),
                kernel=("sticks-iff",),
            ),
            clause(
                "at-once",
                r"They do so at once exactly if $\dot x_1(0)\neq\dot x_2(0)$, or $|x_1(0)|>L$, or the start is on an exit ray, "
                r"$x_1(0)=\pm L$ with $\pm v>0$.",
                kernel=("slips-beyond", "slips-on-ray", "sticks-inside"),
            ),
        ),
    ),
    Claim(
        "example-two-modes",
        SECTION,
        "eqs. (13), (14)",
        (
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
                r"In the first the system behaves as a pair of synchronized undamped harmonic oscillators with "
                r"$x_1-x_2=\mathrm{const}$ and $\dot{x}_1=\dot{x}_2$.",
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "example-damped-oscillations",
        SECTION,
        "after eq. (14)",
        r"The piecewise linear dynamics (14) leads to the damped oscillations of $(x_1,\dot{x}_1)$ and, "
        r"thus, to a synchronization of the orbits of both inertial bodies, "
        r"$x_1(t)-x_2(t)\to\mathrm{const}$ and $\dot{z}\to 0$.",
        Verdict.HOLDS_CORRECTED,
    ),
)
