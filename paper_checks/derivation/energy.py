"""The energy and its rate, (8); the ellipse in the strip and E_cr; the arcs above it."""

from __future__ import annotations

from paper_checks.claims.letters import ECR, in_strip
from paper_checks.claims.section_3 import capture, filippov
from paper_checks.claims.section_3.levels import LEVEL
from paper_checks.claims.section_3.sliding import WIDTH
from paper_checks.claims.words import *
from paper_checks.derivation.line import Line, Stage, equation, gathered, of_clause, zero
from paper_checks.derivation.surface import FREE, HALF_WIDTH, SLIDING_FIELD, in_width
from theory.energy import arc_speed_terms, edge_speed_squared, energy, level_semi_axis, semi_axis_margin, slip_rate
from theory.fraction import factored

RATE, CONSERVED = "energy-rate/rate", "energy-dissipation-places/conserved"
CLOSED, ABOVE = "critical-energy/closed", "critical-energy/above"
ARCS, EXITS, OTHER = "supercritical-arcs/arcs", "supercritical-arcs/exits", "supercritical-arcs/other"
WHOLE = a2 * x1**2 / 2 + (m1 + m2) * v1**2 / 2
"""The energy of one mass m1 + m2 on the spring, J."""


def slipping(name: str, sign: int) -> Formula:
    """Return the rate of the energy in a half-space, which friction's power -b |v1 - v2| has to be."""
    return Formula(
        rf"\dot E\big|_{{\Omega_{name}}}",
        "=",
        sp.factor(undamped(slip_rate(sign))),
        zero(lambda right: right + sign * b * (v1 - v2)),
    )


ENERGY = Stage(
    "derivation-energy",
    r"The energy $E$ and its rate, (8)",
    f"{FREE}.",
    (
        "The energy of the pair is that of the spring and that of both bodies.",
        Line("Define the energy.", RATE, of_clause(RATE, "energy")),
        Line(
            r"""
            Differentiate along $\Phi_+$ and along $\Phi_-$. The forces of the spring cancel; the power of friction on the
            relative motion is left.
            """,
            RATE,
            lambda: (slipping("+", 1), slipping("-", -1)),
            kernel="energy-rate",
        ),
        Line(
            r"Differentiate along Filippov's field: stick conserves the energy.",
            CONSERVED,
            lambda: equation(
                r"\dot E\big|_{S_0}", undamped(stick_rate()), derivative_along(SLIDING_FIELD, energy()).subs(v2, v1)
            ),
            kernel="energy-rate",
        ),
        Line(
            r"As $v_1-v_2=\pm|v_1-v_2|$ in $\Omega_\pm$ and $v_1-v_2=0$ on $S$, the three rates are one formula, (8).",
            f"{RATE} energy-rate/sign",
            lambda: (*of_clause(RATE, "rate")(), *of_clause("energy-rate/sign", "sign")()),
            kernel="energy-rate energy-decreases",
        ),
    ),
)


def in_level(expression: Expr) -> Expr:
    """Return an expression in b with the letter E_cr in its place."""
    return factored(expression.subs(b, sqrt(2 * a2 * ECR) * m2 / (m1 + m2)))


def stays_inside(formula: Formula) -> Evidence:
    """Decide that on S an energy of at most E_cr keeps the pair on S0."""
    below = signed(on_surface() - critical_energy(), "<=")
    inside = signed(cleared(x1**2 - sp.sympify(formula.right).subs(HALF_WIDTH, WIDTH)), formula.relation)
    return prove(f"on $S$, $E\\leqslant E_{{cr}}$ implies ${formula.latex}$", [below], inside)


CRITICAL = Stage(
    "derivation-critical-energy",
    "The ellipse in the strip, and $E_{cr}$",
    f"{FREE}.",
    (
        r"""
        In stick the pair is one mass $M=m_1+m_2$ on the spring, and conserves its energy. So it moves on an ellipse, and it
        sticks from then on exactly if this ellipse lies within the strip $|x_1|\leqslant L$. In one line:
        on $S$, $E=\frac12a_2x_1^2+\frac12Mv_1^2$; at $v_1=0$, $|x_1|=\sqrt{2E/a_2}$; sticking needs $|x_1|\leqslant L$; hence
        $E\leqslant\frac12a_2L^2=E_{cr}$.
        """,
        Line(
            "Substitute $v_2=v_1$ into the energy: its level sets on $S$ are ellipses.",
            CLOSED,
            lambda: equation(r"E\big|_S", sp.collect(on_surface(), v1, sp.factor), WHOLE),
        ),
        Line(
            "Set $v_1=0$ and $E=E_0$, and solve for $x_1>0$: the semi-axis along $x_1$.",
            CLOSED,
            lambda: Formula(
                r"x_1\big|_{v_1=0}",
                "=",
                gathered(level_semi_axis()),
                zero(lambda right: [WHOLE.subs({x1: right, v1: 0}) - E0, right - sqrt(right**2)]),
            ),
        ),
        Line(
            "Set the semi-axis equal to $L$ and solve for $E_0$: the critical energy, the largest that fits.",
            f"{CLOSED} {ABOVE}",
            lambda: Formula(
                r"E_{cr}=\tfrac12a_2L^2",
                "=",
                critical_energy(),
                zero(lambda right: [right - LEVEL, right - a2 * WIDTH**2 / 2]),
            ),
            kernel="ellipse-iff",
        ),
        "![ellipse-in-strip]",
        Line(
            r"""
            Subtract the squares. The difference has the sign of $E_0-E_{cr}$: the ellipse lies within the strip for
            $E_0\leqslant E_{cr}$, and reaches beyond it for $E_0>E_{cr}$.
            """,
            f"{CLOSED} {ABOVE}",
            lambda: Formula(
                r"x_1^2\big|_{v_1=0}-L^2",
                "=",
                in_level(-semi_axis_margin()),
                zero(lambda right: right.subs(ECR, LEVEL) - (2 * E0 / a2 - WIDTH**2)),
            ),
        ),
        Line(
            r"The same for every point of the ellipse: on $S$, $E\leqslant E_{cr}$ implies",
            f"{CLOSED} {ABOVE}",
            lambda: Formula("x_1^2", "<=", HALF_WIDTH**2, stays_inside),
        ),
        Line(
            r"""
            So for $E_0\leqslant E_{cr}$ the whole ellipse is a motion in stick: it solves (3) and (4), its energy is constant, and
            it never meets an edge of $S_0$ with $v_1\neq 0$. For $E_0=E_{cr}$ it touches each edge once a period, with
            $|\ddot x_1|=b/m_2$: at these instants friction is at its limit $b$, and (4) does not hold.
            """,
            f"{CLOSED} {ABOVE}",
            steps=lambda: (
                argument(
                    "the ellipse is a closed trajectory",
                    capture.stays_below_critical,
                    capture.stick_is_a_motion,
                    filippov.stick_region,
                ),
            ),
            kernel="ellipse-iff",
        ),
    ),
)


def never_at_rest(formula: Formula) -> Evidence:
    """Decide that above E_cr no point of S0 is at rest."""
    above = signed(on_surface() - critical_energy(), ">")
    differs = sp.Ne(v1, formula.right, evaluate=False)
    return prove(f"on $S_0$, $E>E_{{cr}}$ implies ${formula.latex}$", [above, *in_strip()], differs)


SUPERCRITICAL = Stage(
    "derivation-arcs",
    "The arcs above $E_{cr}$",
    f"{FREE}; $E_0>E_{{cr}}$.",
    (
        "Above $E_{cr}$ the edges cut the ellipse into two arcs, and the pair does not stay on them.",
        Line(
            r"Substitute $x_1=\pm L$ and $E=E_0$, and solve for $v_1^2$. It is positive for $E_0>E_{cr}$: the ellipse meets both edges.",
            ARCS,
            lambda: Formula(
                r"v_1^2\big|_{x_1=\pm L}",
                "=",
                in_level(edge_speed_squared()),
                zero(lambda right: right.subs(ECR, LEVEL) - (2 * E0 - a2 * WIDTH**2) / (m1 + m2)),
            ),
        ),
        Line(
            r"Do the same at any $x_1$ and subtract. On $S_0$ the difference is not negative: $v_1^2$ is least at the edges.",
            ARCS,
            lambda: Formula(
                r"v_1^2-v_1^2\big|_{x_1=\pm L}",
                "=",
                in_width(arc_speed_terms()[1]),
                zero(lambda right: right.subs(HALF_WIDTH, WIDTH) - a2 * (WIDTH**2 - x1**2) / (m1 + m2)),
            ),
        ),
        Line(
            "So, on $S_0$ with $E>E_{cr}$, $v_1$ keeps its sign: there are two arcs, one with $v_1>0$ and one with $v_1<0$.",
            ARCS,
            lambda: Formula("v_1", "!=", 0, never_at_rest),
        ),
        Line(
            r"""
            As $\dot x_1=v_1$, the pair runs along the arc with $v_1>0$ to the ray $\ell_+$, and leaves $S_0$ there into
            $\Omega_-$. The mirror image $(x_1,v_1,v_2)\to(-x_1,-v_1,-v_2)$ is the other arc, the ray $\ell_-$ and $\Omega_+$.
            """,
            f"{EXITS} {OTHER}",
            steps=lambda: (
                argument(
                    "each arc ends on its ray",
                    identity("along $\\Phi_0$, $\\dot x_1=v_1$", sliding_field()[0], v1),
                    identity("$L$ is as printed", half_width(), WIDTH),
                    capture.mirror_image,
                ),
            ),
            kernel="arc-to-left-ray slips-on-ray",
        ),
    ),
)
STAGES = (ENERGY, CRITICAL, SUPERCRITICAL)
