"""A slip from S in closed form, the return map from ray to ray, and its expansion."""

from __future__ import annotations

from paper_checks.claims.beyond.excursions import angle_of_excursion, never_merges, vanishes
from paper_checks.claims.beyond.return_map import LEFT_OUT, remainders
from paper_checks.claims.beyond.slips import depth_grows, one_contact
from paper_checks.claims.letters import R
from paper_checks.claims.words import *
from paper_checks.derivation.line import Line, Stage, equation, gathered, of_clause, tidy, zero
from paper_checks.derivation.surface import FREE
from theory.excursion import excursion, h_slope
from theory.near_critical import cycle
from theory.return_map import depth, gap, in_trigonometry, push, reduced_guard, return_map_slope_residual
from theory.scaling import reduced_energy, reduced_slip, stick_frequency

CONTACT, LANDING, STAYS = (f"excursion-closed-form/{name}" for name in ("contact", "landing", "stays"))
MAP, CREEPS = "return-map-expansion/map", "no-merging-near-critical/creeps"


def slip_equation(guard: Basic) -> list[Expr]:
    """Return what the guard over sqrt(q) leaves of its differential equation and of its start, in theta.

    With V1' = -(X - r)/q, V2' = -1 and theta = tau/sqrt(q) the guard g has g'' = -(g + V2)/1, V2 = sqrt(q)(nu - theta).
    """
    start = {theta: 0}
    rate = -(1 + q * gap - r) / q + 1
    return [
        diff(guard, theta, 2) + guard + push - theta,
        guard.subs(start),
        diff(guard, theta).subs(start) - rate,
    ]


def shrinks(formula: Formula) -> Evidence:
    """Decide the slope of the return map by the closed forms of both excesses."""
    found = vanishes(f"${formula.latex}$", return_map_slope_residual())
    same = identity(f"${formula.latex}$", formula.right, (1 - R * (1 - cos(theta))))
    return same if same.passed is not True else found


def expanded(formula: Formula) -> Evidence:
    """Decide the return map in powers of w by the series of the excess in epsilon = sqrt(w)."""
    series = cycle().next_excess
    terms = sum(series.coeff(epsilon, 2 * n) * w**n for n in range(1, 4))
    return identity(f"${formula.latex}$, up to $w^3$", sp.sympify(formula.right).subs(R, r), terms)


SLIP = Stage(
    "derivation-slip",
    "A slip from $S$, and the return map",
    f"{FREE}.",
    (
        r"""
        Take $L$ as the unit of length and the reciprocal of the frequency $\Omega$ of stick as that of time: $X=x_1/L$,
        $V_i=v_i/(L\Omega)$, $\tau=\Omega t$. Then $S_0$ is $|X|\leqslant 1$, and of the parameters only the mass shares
        $q$ and $r=1-q$ are left. The excess energy is $w=E/E_{cr}-1$.
        """,
        Line(
            r"Read the frequency off $\Phi_0$, and define the mass shares.",
            LANDING,
            lambda: (
                equation(r"\Omega", gathered(stick_frequency()), sqrt(a2 / (m1 + m2))),
                *of_clause(LANDING, "share", "rest")(),
            ),
        ),
        Line(
            r"Substitute the units into $\Phi_-$ and into $E/E_{cr}$.",
            CONTACT,
            lambda: (
                equation(
                    r"\tfrac{d}{d\tau}(X,V_1,V_2)",
                    Matrix(reduced_slip(-1)).applyfunc(tidy),
                    Matrix([V1, -(X - r) / q, -1]),
                ),
                equation(
                    r"\frac{E}{E_{cr}}",
                    sp.collect(sp.expand(reduced_energy()), [V2], sp.factor),
                    X**2 + q * V1**2 + r * V2**2,
                ),
            ),
        ),
        r"""
        A slip that starts on $S$ starts on the edge or beyond it: at $X=1+q\,d$, $d\geqslant 0$, up to the mirror image, and with
        $V_1=V_2=\sqrt q\,\nu$, where $\nu>0$ if $d=0$. Its angle is $\theta=\tau/\sqrt q$.
        """,
        Line(
            r"Solve the linear equations, and subtract the velocities: the guard along the slip.",
            CONTACT,
            lambda: Formula(
                r"\frac{V_1-V_2}{\sqrt q}",
                "=",
                sp.collect(reduced_guard(), [push, gap], sp.factor),
                zero(slip_equation),
            ),
        ),
        Line(
            r"""
            Divide by $1-\cos\theta$, which is $0$ only at the start, and set what is left to $0$: the condition that ends
            the slip.
            """,
            CONTACT,
            of_clause(CONTACT, "contact", "rise"),
        ),
        Line(
            r"""
            Differentiate $h$. On $(0,2\pi)$ it increases from $0$ to infinity, and $-d\cot(\theta/2)$ increases from
            $-\infty$ for $d>0$. So their sum is $\nu$, and the slip ends, at exactly one angle.
            """,
            CONTACT,
            lambda: equation(
                "h'", tidy(h_slope()), (2 * (1 - cos(theta)) - theta * sin(theta)) / (1 - cos(theta)) ** 2
            ),
            steps=lambda: (*angle_of_excursion(), *one_contact()),
        ),
        Line(
            "Substitute that angle into the solution: where the slip ends, and what it costs.",
            LANDING,
            of_clause(LANDING, "depth", "gap", "push", "loss"),
            kernel="gap-slip",
        ),
        r"""
        From now on the slip starts on the ray $\ell_+$, that is $d=0$ and $w=\varepsilon^2$, $\varepsilon=\sqrt q\,\nu>0$.
        It ends inside $S_0$ if it is short; then, if $w'>0$, the pair sticks up to the next ray, with its energy unchanged.
        Energy on one ray against energy on the next is the return map.
        """,
        Line(
            r"Substitute $d=0$: the slip ends at $X'=1-q\,c(\theta)$, on $S_0$ for $c\leqslant c^*$, where $X'=-1$ at $c^*$.",
            STAYS,
            of_clause(STAYS, "edge"),
            steps=lambda: (
                vanishes(r"$1-X'=q\,c(\theta)$", 1 - excursion().position - q * in_trigonometry(depth())),
                *depth_grows()[:2],
            ),
        ),
        Line(
            r"Write $y=w/q$, so that $y=h^2$ at the start. The return map, with $h$ and $c$ at one angle:",
            MAP,
            of_clause(MAP, "map"),
        ),
        Line(
            r"""
            Differentiate. The slope is positive for $\theta\leqslant\pi/2$, that is $w\leqslant q\,(\pi/2-1)^2$, and the slip ends
            inside $S_0$. So $0<w'<w$ there: the energy falls, and does not reach $E_{cr}$.
            """,
            CREEPS,
            lambda: Formula(r"\frac{dy'}{dy}", "=", 1 - R * (1 - cos(theta)), shrinks),
            steps=never_merges,
            kernel="no-merging-from-S0",
        ),
    ),
)
EXPANSION = Stage(
    "derivation-expansion",
    "The expansion of the return map",
    f"{FREE}; the pair leaves $S_0$ by a ray with a small excess $w$.",
    (
        Line(
            "Expand $c$ in powers of $y=h^2$ by reverting the series of $h$, up to $y^3$.",
            "return-map-expansion/series",
            of_clause("return-map-expansion/series", "series"),
            steps=lambda: remainders()[:1],
        ),
        Line(
            r"Substitute $y=w/q$ and expand, up to $w^3$. There is no linear loss: a slip costs an energy of the order $w^2$.",
            MAP,
            lambda: Formula(
                "w'",
                "=",
                w - 9 * R / (4 * q) * w**2 + 81 * R / (40 * q**2) * w**3,
                expanded,
            ),
        ),
        Line(
            f"Bound what the expansion of $y'$ up to $y^8$ leaves out: at most ${LEFT_OUT}$ for $\\theta\\leqslant 2$.",
            "return-map-expansion/remainder",
            steps=lambda: remainders()[1:],
        ),
    ),
)
STAGES = (SLIP, EXPANSION)
