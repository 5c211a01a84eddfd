"""What the paper says of its model in passing: units, the stiff limit, the energy, the parts of S, two senses of sliding."""

from paper_checks.claims.letters import DISTANCE, SIGN
from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.section_3 import filippov
from paper_checks.claims.words import *
from theory import presliding
from theory.filippov import guard, surface
from theory.presliding import deflection, deflection_rate, slider_rate, stiffness, variation
from theory.scaling import about_an_axis, radius

FIRST_SIGN, SECOND_SIGN, PACE = Symbol("s_1", real=True), Symbol("s_2", real=True), Symbol("c", positive=True)
SIGNS = {RELATIVE_SIGN: FIRST_SIGN, STICTION_SIGN: SECOND_SIGN}


@claim(
    "energy-as-lyapunov-function",
    "I",
    "last paragraph",
    HOLDS,
    clause("positive", "The convergence analysis is in terms of the system energy, which is a Lyapunov function: it is positive except at rest at the origin,"),
    clause(
        "falls",
        "and never grows along a motion, in the switched and in the non-switched modes of the relative motion.",
        kernel="energy-decreases",
    ),
)  # fmt: skip
def energy_as_lyapunov_function() -> Case:
    """Positive definite, and never growing."""
    moved = sp.Or(*(sp.Ne(one, 0, evaluate=False) for one in (x1, v1, v2)))
    return because(
        """
        The energy is positive definite in $(x_1,v_1,v_2)$ and never grows, with a damper or without. It is no strict
        Lyapunov function of the origin: without a damper it is constant in stick, so periodic motions persist there.
        """,
        carried("positive", prove("$E>0$ unless $x_1=v_1=v_2=0$", [moved], signed(energy(), ">"))),
        carried("falls", dissipation.energy_never_grows),
    )


@claim(
    "translational-or-rotational",
    "II",
    "before Fig. 2",
    HOLDS,
    "It does not matter whether a translational or rotational degree of freedom of the relative motion is meant.",
)
def translational_or_rotational() -> Case:
    """At a radius R the equations of translation are R^-1 times those of rotation, with the same signs."""
    equations = [put_signs(equation) for equation in (driving_equation(), driven_equation())]
    arguments = [RELATIVE_SIGN.args[0], STICTION_SIGN.args[0]]
    return because(
        r"""
        With angles for displacements, moments of inertia for masses and torques for forces, (3) and (4) are the same
        equations. At a radius $R$, with $x=R\varphi$, $m=J/R^2$, a force that is a torque over $R$, and $a_1,a_2,b$
        accordingly, each of them is multiplied by $1/R$, the argument of each signum by $R>0$, and the energy by 1. So
        every statement about one holds for the other, in its units.
        """,
        carried(
            "statement",
            identity(
                r"""
                at the radius $R$ (3) and (4) become $1/R$ times the same equations in the letters of rotation, the energy is the
                same, and $\dot z$ and $|\ddot x_1|-b/m_2$ become $R>0$ times their counterparts: both signs are unchanged
                """,
                [*(radius * about_an_axis(one) for one in equations), *map(about_an_axis, (energy(), *arguments))],
                [*equations, energy(), *(radius * one for one in arguments)],
            ),
        ),
    )


def put_signs(equation: Expr) -> Expr:
    """Return an equation with letters for the values of its two signs."""
    return equation.subs(SIGNS)


def _spring_against_coulomb() -> Evidence:
    """The rate of the distance, split into what the spring stores and what both sliders take."""
    relative, force = Symbol(r"\dot{\tilde{z}}", real=True), stiffness * deflection
    coulomb = b * sigma_other
    named = {v1: v2 + deflection_rate + slider_rate, v1_other: v2_other + relative}
    return identity(
        r"""
        with $\dot z=\dot\delta+s$, $s$ the velocity of the slider, $\tfrac12\frac{d}{dt}N^2$ is $-a_1(v_1-\tilde
        v_1)^2-k\delta\dot\delta+b\tilde\sigma\dot\delta-(k\delta-b\tilde\sigma)\,s+(k\delta-b\tilde\sigma)\,\dot{\tilde z}$
        """,
        presliding.distance_rate().subs(named, simultaneous=True),
        (
            -a1 * (v1 - v1_other) ** 2
            - force * deflection_rate
            + coulomb * deflection_rate
            - (force - coulomb) * slider_rate
            + (force - coulomb) * relative
        ).subs(named, simultaneous=True),
    )


def _sliders_only_take() -> Evidence:
    """The last two terms are never positive."""
    spring, coulomb, slider, relative = symbols("g h s w", real=True)
    return prove(
        r"with $g=k\delta/b\in\mathrm{Sign}(s)$ and $h=\tilde\sigma\in\mathrm{Sign}(w)$, $w=\dot{\tilde z}$: $-(g-h)\,s\leqslant 0$ and $(g-h)\,w\leqslant 0$",
        [filippov.set_valued_sign(spring, slider), filippov.set_valued_sign(coulomb, relative)],
        And(sp.Le(-(spring - coulomb) * slider, 0), sp.Le((spring - coulomb) * relative, 0)),
    )


@claim(
    "stiff-limit",
    "II",
    "second paragraph after Fig. 2",
    HOLDS,
    clause(
        "rate",
        """
        The Coulomb frictional force represents a rate-independent damping: where all velocities are $c>0$ times as
        large it takes the power «power», so its work along a path does not depend on the speed;
        """,
        power=equal(r"\dot E", -PACE * b * SIGN * (v1 - v2), lambda: _power_at(PACE)),
    ),
    clause(
        "stiffness",
        r"""
        it can be understood in combination with infinite stiffness within the pre-slide friction regime: let the
        interface be a spring of stiffness $k$ in series with a slider that slips at the force $b$. Its presliding
        displacement «deflection» vanishes as $k\to\infty$, and its motion tends to that of Coulomb's law from the same
        start, uniformly on bounded times: $N$, their distance in energy, has «distance», where $V$ is the variation until
        then of Coulomb's friction force over $b$, that of sticks included.
        """,
        deflection=equal(r"|\delta|\leqslant\delta_{\max}", b / stiffness, presliding.largest_deflection),
        distance=sharp(
            DISTANCE**2,
            "<=",
            b**2 * (5 + 2 * variation) / stiffness,
            lambda: (DISTANCE**2, "<=", presliding.distance_squared()),
        ),
    ),
)
def stiff_limit() -> Case:
    """Compare a spring and slider in series with Coulomb's law by the energy distance."""
    return because(
        r"""
        Read as a limit: Coulomb's friction, any force up to $b$ in stick, is that of a spring in series with a slider
        as its stiffness grows without bound. So stick is the stiff limit of presliding, for the pair as for its
        friction force: two motions from one initial state differ by no more than $b\sqrt{(5+2V)/k}$ in the energy norm.
        """,
        carried("rate"),
        carried(
            "stiffness",
            argument(
                r"""
                Both sliders only dissipate, so $\tfrac12\frac{d}{dt}(N^2+k\delta^2)\leqslant b\tilde\sigma\dot\delta$.
                By parts $\int\tilde\sigma\dot\delta\,dt\leqslant(2+V)\,b/k$ as $|\delta|\leqslant b/k$, and
                $k\delta^2\leqslant b^2/k$ at the start. For a $\tilde\sigma$ of infinite variation the integral still
                tends to 0, as $\delta$ does uniformly, $\dot\delta$ is bounded by the energy, and smooth functions
                approximate $\tilde\sigma$.
                """,
                _spring_against_coulomb,
                _sliders_only_take,
                cites=("the stop operator of a spring and slider is Lipschitz continuous (Krasnosel'skii, Pokrovskii)",),
            ),
        ),
    )  # fmt: skip


def _power_at(pace: Symbol) -> Expr:
    """Return dE/dt in slip of either sign, W, a1 = 0, where all velocities are `pace` times as large."""
    forwards, backwards = (undamped(slip_rate(sign)).subs({v1: pace * v1, v2: pace * v2}) for sign in (1, -1))
    return (1 + SIGN) / 2 * forwards + (1 - SIGN) / 2 * backwards


@claim(
    "parts-of-the-surface",
    "III",
    "before (9)",
    HOLDS,
    clause("parts", r"$S=S_-\cup S_0\cup S_+$, three parts without a common point,"),
    clause("rays", r"and the rays $\ell_\pm$ belong to the boundary of the strip $S_0$."),
)
def parts_of_the_surface() -> Case:
    """Each point of S is in one part; a ray is on an edge."""
    found = surface()
    on_surface = sp.Eq(v1, v2, evaluate=False)
    minus, strip, plus = (_polynomial(one) for one in (found.minus, found.sliding, found.plus))
    beside = half_width() + distance
    return because(
        r"Where $v_1=v_2$, $x_1$ is below $-L$, above $L$ or between them, and on a ray $|x_1|=L$.",
        carried(
            "parts",
            prove("each point of $S$ is in one of the three", [on_surface], sp.Or(minus, strip, plus)),
            prove(
                "and in no two of them",
                [on_surface],
                sp.Not(sp.Or(And(minus, strip), And(plus, strip), And(minus, plus)), evaluate=False),
            ),
        ),
        carried(
            "rays",
            prove(
                r"each point of $\ell_\pm$ is in $S_0$",
                [sp.Or(_polynomial(found.ray_minus), _polynomial(found.ray_plus))],
                strip,
            ),
            prove(
                r"and each $x_1=\pm(L+d)$, $d>0$, on $S$ is outside: arbitrarily close to the rays",
                [on_surface, sp.Or(*(signed(side * x1 - beside, "=") for side in (1, -1)))],
                sp.Not(strip, evaluate=False),
            ),
        ),
    )


def _polynomial(condition: Basic) -> Basic:
    """Return a condition on the state with the denominators of its relations cleared."""
    if isinstance(condition, And):
        return And(*map(_polynomial, condition.args))
    return signed(condition.lhs - condition.rhs, {"==": "="}.get(condition.rel_op, condition.rel_op))


@claim(
    "two-senses-of-sliding",
    "III",
    "second footnote; I, first footnote",
    HOLDS,
    clause(
        "exclude",
        r"""
        The sliding modes in Filippov's sense should be distinguished from frictional sliding, where the bodies experience a
        relative displacement with respect to each other, $\dot x_1-\dot x_2\neq 0$.
        """,
        kernel="sticks-inside",
    ),
)
def two_senses_of_sliding() -> Case:
    """On S0 the relative velocity is and stays 0."""
    return because(
        r"""
        They exclude each other: in a sliding mode of Filippov's the state stays on $S_0$, so $\dot z=0$ and the bodies
        stick; in frictional sliding $\dot z\neq 0$ and the state is off $S$.
        """,
        carried(
            "exclude",
            argument(
                r"A sliding mode moves on $S$, where $\dot z=0$, and its field keeps it there; where $\dot z\neq 0$ the state is not on $S$.",
                identity(r"$\ddot z=0$ along the sliding field", derivative_along(sliding_field(), guard())),
            ),
        ),
    )
