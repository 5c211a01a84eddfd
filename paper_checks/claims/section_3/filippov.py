"""What a solution of (3), (4) is: Filippov's, of (5)–(7), and its two fields."""

from paper_checks.claims.letters import SIGN, field
from paper_checks.claims.words import *
from theory.energy import contraction_terms

ARGUMENT = (
    r"""
    A solution of (3), (4) spends almost every instant of $\{t:\dot z=0\}$ with $\ddot z=0$. There the branches with
    half and with broken adhesion are impossible, so $\dot z=0$ lasts only in stick with $|\ddot x_1|<b/m_2$, which is
    Filippov's sliding field: the solution is one of (5)–(7) in Filippov's sense.
    """,
    r"""
    Conversely, a Filippov solution slides where $|a_2x_1+a_1v_1|\leqslant b(m_1+m_2)/m_2$, and is on the edge of that
    strip at isolated times only, since the load has no double zero there. So it meets (3), (4) at almost every time.
    """,
    """
    Existence is Filippov's theorem (the set-valued right side is bounded on bounded sets, convex and closed). The flow
    is non-expansive in the energy norm, so forward in time there is only one.
    """,
)


def adhesion_factor(relative_sign: int, stiction_sign: int) -> Expr:
    """Return the factor with which the brackets of (4) hand m2 x1'' on to body 2, dimensionless, for both signs."""
    values = {RELATIVE_SIGN: Integer(relative_sign), STICTION_SIGN: Integer(stiction_sign)}
    return diff(driven_equation().subs(values), acceleration1) / m2


@cache
def bracket_is_off_in_slip() -> Evidence:
    """For z' != 0 the first bracket of (4) is 0, whatever the second is."""
    factors = [adhesion_factor(sign, stiction) for sign in (1, -1) for stiction in (-1, 0, 1)]
    return identity(
        "for $\\dot z\\neq 0$ the brackets of (4) are $0$, whatever $|\\ddot x_1|$ is",
        factors,
    )


@cache
def stick_region() -> Evidence:
    """Off S both systems have one field, on S the stick branch is Filippov's; its condition is the strip S0."""
    return identity(
        r"""
        for $\dot z\neq 0$, (3), (4) are (5)–(7) (with the damper kept), at $\dot z=0$ the branch with unbroken adhesion is
        Filippov's sliding field, and in stick $\ddot{x}_1/(b/m_2)=-(a_2x_1+a_1v_1)/(b(m_1+m_2)/m_2)$
        """,
        [*(slip(sign).field for sign in (1, -1)), stick().field.subs(v2, v1), free(stick().acceleration1) / (b / m2)],
        [
            *(free_system(Integer(sign)) for sign in (1, -1)),
            sliding_field(damped=True),
            -load(damped=True) / load_threshold(),
        ],
    )


SPURIOUS = ("half adhesion", "broken adhesion")
"""The branches of (3), (4) at z' = 0 that are no mode of the text."""


def _share(name: str) -> Rational:
    return {"half adhesion": Rational(1, 2), "broken adhesion": Integer(1)}[name]


@cache
def spurious_branch(name: str) -> Evidence:
    """The relative acceleration in a branch of z' = 0 that is no mode of the text."""
    found, share = branch_named(name), _share(name)
    return identity(
        f"in the branch with {name}, $\\ddot z={share}\\cdot\\ddot x_1$",
        found.acceleration1 - found.acceleration2,
        share * found.acceleration1,
    )


@cache
def spurious_branches_leave() -> Evidence:
    """Where those branches apply the acceleration is not zero."""
    reached = Abs(acceleration1) * m2 >= b
    plain = {acceleration1: Symbol("A", real=True)}
    return prove(
        r"$|\ddot{x}_1|\geqslant b/m_2$ implies $\ddot{x}_1\neq 0$: those branches leave $\dot{z}=0$ at once",
        [reached.subs(plain)],
        sp.Ne(acceleration1, 0).subs(plain),
    )


@cache
def never_apart() -> Evidence:
    """The friction term is never positive, whatever values the set-valued sign takes; the other is -a1 (...)^2."""
    relative, other, first, second = symbols("w k s h", real=True)
    named = {sigma: first, sigma_other: second, v1: v2 + relative, v1_other: v2_other + other}
    friction = expand((contraction_terms()[1] / b).subs(named, simultaneous=True))
    return prove(
        r"""
        $-(\sigma-\tilde\sigma)(\dot z-\dot{\tilde z})\leqslant 0$ for all $\sigma\in\mathrm{Sign}(\dot z)$,
        $\tilde\sigma\in\mathrm{Sign}(\dot{\tilde z})$ (here $s,h$ and $w,k$): the flow is non-expansive
        """,
        [set_valued_sign(first, relative), set_valued_sign(second, other)],
        signed(friction, "<="),
    )


def set_valued_sign(value: Symbol, velocity: Symbol) -> Basic:
    """Return the condition that a value belongs to Sign of a velocity: 1, -1, or anything between at velocity 0."""
    return sp.Or(
        And(velocity > 0, sp.Eq(value, 1)),
        And(velocity < 0, sp.Eq(value, -1)),
        And(sp.Eq(velocity, 0), value <= 1, value >= -1),
    )


@cache
def equivalent() -> Evidence:
    """The solutions of (3), (4) are those of (5)-(7) in Filippov's sense: written out, and no more than that."""
    return argument(" ".join(ARGUMENT[:2]), stick_region)


@cache
def one_solution() -> Evidence:
    """There is exactly one for each start."""
    return argument(ARGUMENT[2], equivalent, never_apart, cites=("Filippov's theorem on existence",))


@claim(
    "vector-fields",
    "III",
    "after (7)",
    HOLDS,
    clause(
        "fields",
        r"The velocity field of (5)–(7) is «minus» in $\Omega_-=\{v_1<v_2\}$ and «plus» in $\Omega_+=\{v_1>v_2\}$,",
        minus=equal(r"\Phi_-", field(-1), lambda: phi(-1)),
        plus=equal(r"\Phi_+", field(1), lambda: phi(1)),
    ),
    clause("jump", r"with a discontinuity on $S=\{v_1=v_2\}$."),
)
def vector_fields() -> Case:
    """Compare the printed components with the slip branches of (3), (4)."""
    jump = identity(
        r"$\Phi_+-\Phi_-=(0,-2b/m_1,2b/m_2)\neq 0$: discontinuous on $S$",
        phi(1) - phi(-1),
        sp.ImmutableMatrix([0, -2 * b / m1, 2 * b / m2]),
    )
    return because(
        """
        Solving (3) and (4) for the accelerations with the sign of the relative velocity put to 1 and to -1 gives the
        printed components; they jump across the switching surface.
        """,
        carried("fields"),
        carried("jump", jump),
    )


@claim(
    "filippov-equivalence",
    "III",
    "before (5)",
    CORRECTED,
    clause(
        "equivalence",
        """
        With $a_1=0$ and $u=0$ the system (2)–(4) is equivalent to (5)–(7): «place», «first», «second», where
        $a=a_2>0$.
        """,
        place=equal(r"\dot{x}_1", v1, lambda: undamped(free_system(SIGN))[0]),
        first=equal(r"m_1\dot{v}_1", -a2 * x1 - b * SIGN, lambda: m1 * undamped(free_system(SIGN))[1]),
        second=equal(r"m_2\dot{v}_2", b * SIGN, lambda: m2 * undamped(free_system(SIGN))[2]),
    ),
    correction=(
        clause(
            "same-solutions",
            """
            With $a_1=u=0$, the solutions of (2)–(4) (absolutely continuous, equations met at almost every time) are
            exactly the solutions of (5)–(7) in Filippov's sense.
            """,
            kernel="switching-iff",
        ),
    ),
)
def filippov_equivalence() -> Case:
    """Compare the two systems off S, inside S0, and on the rest of S."""
    literal = undamped(free_system(Integer(0)))
    return because(
        r"""
        With the three-valued signum of eq. (1), which the text prefers, (5)–(7) has no solution through the interior of
        $S_0$ with $x_1\neq 0$; in Filippov's sense, as in Section III, it has the same solutions as (2)–(4). With
        sgn(0) = 0 a solution would have to stay on $S$, but its accelerations differ there. On $S$ outside the open
        strip the right sides of (3)–(4) and of Filippov's system differ too, at isolated instants only.
        """,
        counterexample(
            r"""
            $m_1=m_2=1$, $a=200$, $b=0.5$, $x_1=0.004$, $v_1=v_2=0$: (3)–(4) sticks; (5)–(7) with sgn(0) = 0 requires
            $\dot v_1=-0.8$, $\dot v_2=0$ on $S$, and off $S$ leads back to it.
            """,
            identity(
                "with sgn(0) = 0 in (5)–(7), $\\dot v_1-\\dot v_2=-a x_1/m_1$ on $S$: not 0 where $x_1\\neq 0$",
                literal[1] - literal[2],
                -a2 * x1 / m1,
            ),
        ),
        carried("same-solutions", equivalent),
    )
