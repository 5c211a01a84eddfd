"""Section III, first half: the model as a Filippov system, its energy and its sliding region."""

import sympy as sp

from paper_checks.engines.deciders import condition, equals, implied
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.letters import BEYOND, SIGN, WITHIN, field, guard_rate
from theory.energy import critical_energy, energy, slip_rate
from theory.filippov import derivative_along, half_width, load, load_threshold, normal, phi, transversality
from theory.model import free_system
from theory.symbols import a1, a2, b, m1, m2, undamped, v1, v2, x1

SECTION = "III"
WIDTH = b * (m1 + m2) / (a2 * m2)
LEVEL = b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2)


def width() -> Formula:
    """Return the half width of S0 as printed."""
    return Formula("L", "=", WIDTH, equals(half_width))


def _at_guard(sign: int, relation: str, side: int) -> Formula:
    """Return what is printed of a field's product with n_S on S_+ (side 1), S_- (side -1) or S_0 (side 0)."""
    given = {1: BEYOND[1], -1: BEYOND[-1], 0: WITHIN}[side]
    product = guard_rate(sign)
    return Formula(product, relation, sp.Integer(0), implied(given, lambda: {product: transversality(sign)}))


SLIDING = (
    Claim(
        "viscous-no-direct-effect",
        SECTION,
        "opening paragraph",
        r"Taking $a_1=0$ is justified by the fact that the viscous damping of the driving body, "
        r"$a_1\dot{x}_1$, is always dissipative and does not directly affect the interaction of the "
        r"inertial pair.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "friction-of-slip",
                r"Viscous damping of the driving body is dissipative and does not enter the friction force of slip;",
            ),
            clause(
                "tilted-strip",
                r"it changes adhesion, whose region becomes «strip».",
                strip=Formula(
                    sp.Abs(a2 * x1 + a1 * v1),
                    "<=",
                    b * (m1 + m2) / m2,
                    condition(lambda: sp.Le(sp.Abs(load(damped=True)), load_threshold(), evaluate=False)),
                    sharp=True,
                ),
            ),
        ),
    ),
    Claim(
        "filippov-equivalence",
        SECTION,
        "before (5)",
        (
            clause(
                "equivalence",
                r"With $a_1=0$ and $u=0$ the system (2)–(4) is equivalent to (5)–(7): «place», «first», «second», where "
                r"$a=a_2>0$.",
                place=Formula(r"\dot{x}_1", "=", v1, equals(lambda: undamped(free_system(SIGN))[0])),
                first=Formula(
                    r"m_1\dot{v}_1", "=", -a2 * x1 - b * SIGN, equals(lambda: m1 * undamped(free_system(SIGN))[1])
                ),
                second=Formula(r"m_2\dot{v}_2", "=", b * SIGN, equals(lambda: m2 * undamped(free_system(SIGN))[2])),
            ),
        ),
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "same-solutions",
                r"With $a_1=u=0$, the solutions of (2)–(4) (absolutely continuous, equations met at almost every time) "
                r"are exactly the solutions of (5)–(7) in Filippov's sense.",
                kernel=("switching-iff",),
            ),
        ),
    ),
    Claim(
        "vector-fields",
        SECTION,
        "after (7)",
        (
            clause(
                "fields",
                r"The velocity field of (5)–(7) is «minus» in $\Omega_-=\{v_1<v_2\}$ and «plus» in $\Omega_+=\{v_1>v_2\}$,",
                minus=Formula(r"\Phi_-", "=", field(-1), equals(lambda: phi(-1))),
                plus=Formula(r"\Phi_+", "=", field(1), equals(lambda: phi(1))),
            ),
            clause("jump", r"with a discontinuity on $S=\{v_1=v_2\}$."),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "energy-rate",
        SECTION,
        "(8)",
        (
            clause(
                "rate",
                r"With «energy», «rate» along every trajectory of (5)–(7),",
                energy=Formula("E", "=", a2 * x1**2 / 2 + m1 * v1**2 / 2 + m2 * v2**2 / 2, equals(energy)),
                rate=Formula(
                    r"\dot E",
                    "=",
                    -b * sp.Abs(v1 - v2),
                    equals(
                        lambda: derivative_along(undamped(free_system(sp.Abs(v1 - v2) / (v1 - v2))), energy()),
                    ),
                ),
                kernel=("energy-rate",),
            ),
            clause(
                "sign",
                r"and «sign».",
                sign=Formula(-b * sp.Abs(v1 - v2), "<=", sp.Integer(0), implied()),
                kernel=("energy-decreases",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "energy-dissipation-places",
        SECTION,
        "after (8)",
        (
            clause(
                "dissipated",
                r"The energy is dissipated on those parts of a trajectory which belong to $\Omega_-\cup\Omega_+$: «above» in "
                r"$\Omega_+$, «below» in $\Omega_-$;",
                above=Formula(
                    -b * (v1 - v2),
                    "<",
                    sp.Integer(0),
                    implied(lambda: [sp.Gt(v1, v2)]),
                ),
                below=Formula(b * (v1 - v2), "<", sp.Integer(0), implied(lambda: [sp.Lt(v1, v2)])),
                kernel=("energy-rate",),
            ),
            clause(
                "conserved",
                r"it is conserved on the parts which belong to $S$: «conserved».",
                conserved=Formula(r"\dot E", "=", sp.Integer(0), equals(lambda: undamped(slip_rate(1)).subs(v2, v1))),
                kernel=("energy-rate",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "transversality-outside",
        SECTION,
        "(9)",
        (
            clause(
                "signs",
                r"With the normal «normal», which points from $\Omega_-$ to $\Omega_+$, «plus_above», «minus_above» on $S_+$ and «plus_below», «minus_below» on $S_-$, where $S_\pm$ are the parts of "
                r"$S$ with $\pm x_1>L$, «width».",
                plus_above=_at_guard(1, "<", 1),
                minus_above=_at_guard(-1, "<", 1),
                plus_below=_at_guard(1, ">", -1),
                minus_below=_at_guard(-1, ">", -1),
                width=width(),
                normal=Formula("n_S", "=", sp.Matrix([0, 1, -1]), equals(lambda: sp.Matrix(normal()))),
                kernel=("rate-above", "rate-below", "transversal-beyond"),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "transversality-strip",
        SECTION,
        "(10)",
        (
            clause(
                "signs",
                r"«minus» and «plus» on $S_0$, the part of $S$ with $|x_1|\leqslant L$, «width».",
                minus=_at_guard(-1, ">=", 0),
                plus=_at_guard(1, "<=", 0),
                width=width(),
                kernel=("rate-above", "rate-below", "transversal-inside"),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "sliding-region",
        SECTION,
        "after (10)",
        (
            clause("region", r"$S_0$ is the sliding region;", kernel=("transversal-inside", "sticks-inside")),
            clause(
                "modes",
                r"it consists of trajectories and parts thereof known as sliding modes, each in the intersection of $S_0$ with an "
                r"ellipsoid $E=E_0$ of constant energy.",
                kernel=("sticks-inside", "energy-rate"),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "critical-energy",
        SECTION,
        "after (10)",
        (
            clause(
                "closed",
                r"For $E_0\leqslant E_{cr}$, «level», the intersection $\{E=E_0\}\cap S_0$ is a closed elliptic trajectory;",
                level=Formula("E_{cr}", "=", LEVEL, equals(critical_energy)),
            ),
            clause("open", r"for $E_0>E_{cr}$ it is not.", kernel=("ellipse-iff",)),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "supercritical-arcs",
        SECTION,
        "after (10)",
        (
            clause(
                "arcs",
                r"For $E_0>E_{cr}$ the intersection $\{E=E_0\}\cap S_0$ consists of two disjoint elliptic arcs, "
                r"each being a part of a trajectory.",
            ),
            clause(
                "exits",
                r"One of these trajectories exits $S_0$ through the ray $\ell_-$ into $\Omega_+$,",
                kernel=("arc-to-left-ray", "slips-on-ray"),
            ),
            clause("other", r"the other through the ray $\ell_+$ into $\Omega_-$."),
        ),
        Verdict.HOLDS,
    ),
)
