"""From the model (2)-(4) to its vector fields, the transversality conditions (9), (10), and sliding motion on S0."""

from __future__ import annotations

from paper_checks.claims.letters import field, guard_rate, in_strip
from paper_checks.claims.section_2 import model as modes
from paper_checks.claims.section_3.sliding import WIDTH
from paper_checks.claims.words import *
from paper_checks.derivation.line import Line, Stage, equation, of_clause, tidy, zero
from theory.filippov import edge_contact, manifest_signs, sliding_weight, weight_margin
from theory.fraction import factored

POSITIVE = "$m_1,m_2,a_2,b>0$"
FREE = f"{POSITIVE}; no damper, $a_1=0$, and no force, $u=0$"
HALF_WIDTH = Symbol("L", positive=True)
OUTSIDE, INSIDE = "transversality-outside/signs", "transversality-strip/signs"


def accelerations(name: str, left: str) -> Formula:
    """Return both accelerations in a mode of the text, which its equations of motion have to leave nothing of."""
    found = branch_named(name)
    equations = modes.mode_equations(int(found.relative_sign))

    def left_over(right: Basic) -> Basic:
        return equations.subs({acceleration1: right[0], acceleration2: right[1]})

    return Formula(left, "=", Matrix([found.acceleration1, found.acceleration2]).applyfunc(tidy), zero(left_over))


def relative(name: str, share: Rational, relation: str) -> Formula:
    """Return the relative acceleration in a branch at z' = 0 that is no mode of the text, where |x1''| relation b/m2."""
    found = branch_named(name)
    difference = found.acceleration1 - found.acceleration2
    mass, load = m1 + m2, u - a1 * v1 - a2 * x1
    left = rf"(\ddot x_1-\ddot x_2)_{{|\ddot x_1|{relation}b/m_2}}"
    return Formula(left, "=", tidy(sp.factor(difference)), zero(lambda right: mass * right - share * load))


MODEL = Stage(
    "derivation-model",
    "The model and its modes",
    f"{POSITIVE}, $a_1\\geqslant 0$, any force $u(t)$.",
    (
        r"""
        Body 1 hangs on a spring and a damper. Body 2 touches nothing but body 1, through dry friction of at most $b$.
        The relative displacement is $z=x_1-x_2$, which is (2), and $\mathrm{sgn}$ is three-valued, (1).
        The paper writes both modes of motion, stick and slip, in one pair of equations, (3) and (4).
        """,
        Line(
            "Define the equations of motion, (3) and (4).",
            "modes-from-closed-form/equations",
            of_clause("modes-from-closed-form/equations", "first", "second"),
        ),
        Line(
            r"""
            Substitute $\mathrm{sgn}(\dot z)=1$ and $-1$, and solve for the accelerations: the two slip modes. The
            second bracket of (4) drops out.
            """,
            "modes-from-closed-form/branches",
            lambda: (
                accelerations("slip+", r"(\ddot x_1,\ddot x_2)_{\dot z>0}"),
                accelerations("slip-", r"(\ddot x_1,\ddot x_2)_{\dot z<0}"),
            ),
        ),
        Line(
            r"""
            Substitute $\mathrm{sgn}(\dot z)=0$ and $-1$ for the second signum, that is $|\ddot x_1|<b/m_2$, and
            solve: stick. Both bodies move as one mass.
            """,
            "modes-from-closed-form/branches",
            lambda: (accelerations("stick", r"(\ddot x_1,\ddot x_2)_{\dot z=0}"),),
        ),
        Line(
            r"""
            Substitute $\mathrm{sgn}(\dot z)=0$ and $0$ or $1$ for the second signum, that is $|\ddot x_1|\geqslant
            b/m_2$, and solve: two more branches, which are neither of the modes of the text. In the first the relative
            acceleration is half of $\ddot x_1$, in the second it is $\ddot x_1$.
            """,
            "modes-from-closed-form/branches",
            lambda: (relative("half adhesion", Rational(1, 2), "="), relative("broken adhesion", Rational(1), ">")),
        ),
        Line(
            r"""
            Neither branch lasts in the free system: $|\ddot x_1|\geqslant b/m_2>0$ there, so $\ddot z\neq 0$, while
            $\dot z=0$ over some time needs $\ddot z=0$. At all but isolated instants two modes are left, stick and slip.
            """,
            "modes-from-closed-form/instants",
            steps=lambda: (argument("both branches leave $\\dot z=0$ at once", modes.leaves_the_surface),),
        ),
    ),
)
FIELDS = Stage(
    "derivation-fields",
    r"The vector fields $\Phi_\pm$",
    f"{FREE}, as in Section III of the paper, from here on.",
    (
        r"""
        Without damper and force the state is $(x_1,v_1,v_2)$ with $v_i=\dot x_i$. The plane $S=\{v_1=v_2\}$ separates
        $\Omega_+=\{v_1>v_2\}$ from $\Omega_-=\{v_1<v_2\}$. In each of these half-spaces one slip mode is in force.
        """,
        Line(
            r"Substitute $a_1=u=0$ into the slip mode of $\Omega_+$.",
            "vector-fields/fields",
            lambda: equation(r"\Phi_+", Matrix(phi(1)).applyfunc(tidy), field(1)),
        ),
        Line(
            r"Do the same in $\Omega_-$.",
            "vector-fields/fields",
            lambda: equation(r"\Phi_-", Matrix(phi(-1)).applyfunc(tidy), field(-1)),
        ),
        Line(
            "Subtract: the field jumps across $S$.",
            "vector-fields/jump",
            lambda: equation(
                r"\Phi_+-\Phi_-", Matrix(phi(1) - phi(-1)).applyfunc(sp.simplify), Matrix([0, -2 * b / m1, 2 * b / m2])
            ),
        ),
    ),
)


def printed_product(sign: int) -> Expr:
    """Return the product with n_S of the field that the paper prints, on S."""
    return (field(sign).T * Matrix([0, 1, -1]))[0].subs(v2, v1)


def at_place(part: str, sign: int, place: Expr, text: str) -> Formula:
    """Return a product at a place on a part of S, in terms of one sign each; lambda + mu = 1."""
    expected = printed_product(sign).subs(x1, place)
    return Formula(
        rf"\Phi_{'+' if sign > 0 else '-'}\cdot n_S\big|_{{{text}}}",
        "=",
        tidy(manifest_signs()[part, sign]),
        zero(lambda right: (right - expected).subs(lower, 1 - upper)),
    )


def both_at(part: str, place: Expr, text: str) -> tuple[Formula, Formula]:
    """Return both products there."""
    return at_place(part, 1, place, text), at_place(part, -1, place, text)


TRANSVERSALITY = Stage(
    "derivation-transversality",
    r"Transversality: $\Phi_\pm\cdot n_S$ on $S_+$, $S_-$ and $S_0$",
    f"{FREE}.",
    (
        r"""
        Whether a motion crosses $S$ or stays on it depends on the side to which each field points, that is on the
        sign of its product with the normal of $S$. Let $L$ be the place where $\Phi_-\cdot n_S$ vanishes; the next
        stage computes it. $S_+$, $S_-$ and $S_0$ are the parts of $S$ with $x_1>L$, $x_1<-L$ and $|x_1|\leqslant L$.
        """,
        Line(
            r"Differentiate the guard $v_1-v_2$: the normal of $S$, from $\Omega_-$ to $\Omega_+$.",
            f"{OUTSIDE} {INSIDE}",
            of_clause(OUTSIDE, "normal"),
        ),
        Line(
            "Multiply the fields by it, and substitute $v_2=v_1$.",
            f"{OUTSIDE} {INSIDE}",
            lambda: tuple(
                equation(guard_rate(sign), tidy(transversality(sign)), printed_product(sign)) for sign in (1, -1)
            ),
            kernel="rate-above rate-below",
        ),
        Line(
            "On $S_+$ substitute $x_1=L+d$, $d>0$. No term is positive.",
            OUTSIDE,
            lambda: both_at("plus", WIDTH + distance, "x_1=L+d"),
        ),
        Line(
            r"So, on $S_+$, both fields point to $\Omega_-$: the first half of (9).",
            OUTSIDE,
            of_clause(OUTSIDE, "plus_above", "minus_above"),
            kernel="transversal-beyond",
        ),
        Line(
            "On $S_-$ substitute $x_1=-L-d$, $d>0$. No term is negative.",
            OUTSIDE,
            lambda: both_at("minus", -WIDTH - distance, "x_1=-L-d"),
        ),
        Line(
            r"So, on $S_-$, both fields point to $\Omega_+$: the second half of (9). A motion crosses $S$ there.",
            OUTSIDE,
            of_clause(OUTSIDE, "plus_below", "minus_below"),
            kernel="transversal-beyond",
        ),
        Line(
            r"On $S_0$ substitute $x_1=L(\lambda-\mu)$ with $\lambda,\mu\geqslant 0$ and $\lambda+\mu=1$.",
            INSIDE,
            lambda: both_at("sliding", WIDTH * (upper - lower), r"x_1=L(\lambda-\mu)"),
        ),
        Line(
            "So, on $S_0$, each field points to $S$, or along it: (10). A motion that arrives inside the strip cannot cross $S$.",
            INSIDE,
            of_clause(INSIDE, "minus", "plus"),
            kernel="transversal-inside",
        ),
    ),
)


def touches(side_rate: Expr) -> Formula:
    """Return the second derivative of the guard along Phi_- where the pair leaves by x1 = L."""
    return Formula(r"\tfrac{d^2}{dt^2}(v_1-v_2)\big|_{x_1=L}", "=", side_rate, zero(lambda right: right + a2 * v1 / m1))


STRIP = Stage(
    "derivation-strip",
    r"The half width $L$, the strip $S_0$, the rays $\ell_\pm$",
    f"{FREE}.",
    (
        Line(
            r"""
            Set $\Phi_-\cdot n_S$ to $0$ and solve for $x_1$. By symmetry $\Phi_+\cdot n_S$ vanishes at $x_1=-L$, so
            $S_0$ is a strip.
            """,
            f"{OUTSIDE} {INSIDE} sliding-region/region",
            lambda: (
                Formula(
                    "L", "=", half_width(), zero(lambda right: [right - WIDTH, transversality(-1).subs(x1, right)])
                ),
                equation(
                    r"\Phi_+\cdot n_S\big|_{x_1=-L}",
                    transversality(1).subs(x1, -half_width()).simplify(),
                    printed_product(1).subs(x1, -WIDTH),
                ),
            ),
            kernel="transversal-inside",
        ),
        r"""
        The rays $\ell_+=\{x_1=L,\ v_1=v_2>0\}$ and $\ell_-=\{x_1=-L,\ v_1=v_2<0\}$ are the parts of the edges of $S_0$
        through which the pair leaves it. On $\ell_+$ the field $\Phi_-$ is tangent to $S$, so the second derivative
        decides.
        """,
        Line(
            r"""
            Differentiate $v_1-v_2$ twice along $\Phi_-$, and substitute $x_1=L$. With $v_1>0$, that is on $\ell_+$, the
            second derivative is negative: the pair leaves $S_0$ into $\Omega_-$.
            """,
            "supercritical-arcs/exits",
            lambda: (
                equation(
                    r"\tfrac{d}{dt}(v_1-v_2)\big|_{x_1=L}", edge_contact(1).first, printed_product(-1).subs(x1, WIDTH)
                ),
                touches(edge_contact(1).second),
            ),
            kernel="slips-on-ray",
        ),
    ),
)


def in_width(expression: Expr) -> Expr:
    """Return an expression in b with the letter L in its place."""
    return factored(expression.subs(b, a2 * m2 * HALF_WIDTH / (m1 + m2)))


def within_unit(formula: Formula) -> Evidence:
    """Decide that the weight is a convex one on S0."""
    return prove(f"${formula.latex}$ on $S_0$", in_strip(), signed(weight_margin(), formula.relation))


def only_on_strip(formula: Formula) -> Evidence:
    """Decide that elsewhere on S it is not."""
    inside = signed(cleared(x1**2 - sp.sympify(formula.right).subs(HALF_WIDTH, WIDTH)), formula.relation)
    return prove(f"$0\\leqslant\\alpha\\leqslant 1$ implies ${formula.latex}$", [signed(weight_margin(), ">=")], inside)


SLIDING_FIELD = Matrix([v1, -a2 * x1 / (m1 + m2), -a2 * x1 / (m1 + m2)])
FILIPPOV = Stage(
    "derivation-filippov",
    "Filippov's field on $S_0$",
    f"{FREE}.",
    (
        r"""
        On $S_0$ Filippov's method replaces the jump by the one convex combination
        $\alpha\Phi_++(1-\alpha)\Phi_-$, $0\leqslant\alpha\leqslant 1$, that is tangent to $S$. In mechanical terms:
        friction takes the value between $-b$ and $b$ that keeps both bodies together.
        """,
        Line(
            r"Set $\alpha\,\Phi_+\cdot n_S+(1-\alpha)\,\Phi_-\cdot n_S$ to $0$ and solve for $\alpha$.",
            "sliding-region/region",
            lambda: Formula(
                r"\alpha",
                "=",
                tidy(sliding_weight()),
                zero(lambda right: right * printed_product(1) + (1 - right) * printed_product(-1)),
            ),
        ),
        Line(
            "Factor: with $L$ as above, the product of both weights has the sign of $L^2-x_1^2$.",
            "sliding-region/region",
            lambda: Formula(
                r"\alpha(1-\alpha)",
                "=",
                in_width(weight_margin()),
                zero(lambda right: right.subs(HALF_WIDTH, WIDTH) - (1 - (x1 / WIDTH) ** 2) / 4),
            ),
        ),
        Line(
            "So the combination is convex on $S_0$, and only there.",
            "sliding-region/region",
            lambda: (
                Formula(r"\alpha(1-\alpha)", ">=", 0, within_unit),
                Formula("x_1^2", "<=", HALF_WIDTH**2, only_on_strip),
            ),
        ),
        Line(
            "Substitute the weight: Filippov's field. It is the stick mode, one mass $m_1+m_2$ on the spring.",
            "sliding-region/modes",
            lambda: Formula(
                r"\Phi_0",
                "=",
                Matrix(sliding_field()),
                zero(lambda right: [right - SLIDING_FIELD, right - undamped(branch_named("stick").field)]),
            ),
        ),
    ),
)
STAGES = (MODEL, FIELDS, TRANSVERSALITY, STRIP, FILIPPOV)
