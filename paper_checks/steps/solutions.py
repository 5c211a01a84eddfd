"""Which solutions (3), (4) with u = 0 have: exactly those of (5)-(7) in Filippov's sense, and one for each start.

A solution is absolutely continuous and meets the equations at almost every time. All steps are for a1 >= 0.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.smt import prove
from theory.energy import contraction_rate, contraction_terms, sigma, sigma_other
from theory.filippov import derivative_along, load, load_threshold, sliding_field
from theory.model import RELATIVE_SIGN, STICTION_SIGN, branch_named, driven_equation, free_system, slip, stick
from theory.symbols import a1, a2, acceleration1, b, free, m2, total_mass, v1, v1_other, v2, v2_other

ARGUMENT = (
    "A solution of (3), (4) spends almost every instant of $\\{t:\\dot z=0\\}$ with $\\ddot z=0$. There the branches "
    "with half and with broken adhesion are impossible, so $\\dot z=0$ lasts only in stick with $|\\ddot x_1|<b/m_2$, "
    "which is Filippov's sliding field: the solution is one of (5)–(7) in Filippov's sense.",
    "Conversely, a Filippov solution slides where $|a_2x_1+a_1v_1|\\leqslant b(m_1+m_2)/m_2$, and is on the edge of "
    "that strip at isolated times only, since the load has no double zero there. So it meets (3), (4) at almost every "
    "time.",
    "Existence is Filippov's theorem (the set-valued right side is bounded on bounded sets, convex and closed). Two "
    "solutions never move apart in the energy norm, so forward in time there is only one.",
)


def adhesion_factor(relative_sign: int, stiction_sign: int) -> sp.Expr:
    """Return the factor with which the brackets of (4) hand m2 x1'' on to body 2, dimensionless, for both signs."""
    values = {RELATIVE_SIGN: sp.Integer(relative_sign), STICTION_SIGN: sp.Integer(stiction_sign)}
    return sp.diff(driven_equation().subs(values), acceleration1) / m2


@cache
def bracket_is_off_in_slip() -> Evidence:
    """For z' != 0 the first bracket of (4) is 0, whatever the second is."""
    factors = [adhesion_factor(sign, stiction) for sign in (1, -1) for stiction in (-1, 0, 1)]
    return identity(
        "for $\\dot z\\neq 0$ the brackets of (4) are $0$, whatever $|\\ddot x_1|$ is",
        sp.Matrix(factors),
        sp.zeros(len(factors), 1),
    )


@cache
def slip_is_filippov() -> Evidence:
    """Off S both systems have the same field."""
    fields = sp.Matrix.hstack(*(slip(sign).field for sign in (1, -1)))
    set_valued = sp.Matrix.hstack(*(free_system(sp.Integer(sign)) for sign in (1, -1)))
    return identity("for $\\dot z\\neq 0$, (3), (4) are (5)–(7) (with the damper kept)", fields, set_valued)


@cache
def stick_is_filippov() -> Evidence:
    """The stick branch is Filippov's sliding field."""
    return identity(
        "at $\\dot z=0$ the branch with unbroken adhesion is Filippov's sliding field",
        stick().field.subs(v2, v1),
        sliding_field(damped=True),
    )


@cache
def stick_region() -> Evidence:
    """The stiction ratio and the load ratio are the same number but for the sign: the condition is the strip S0."""
    return identity(
        r"in stick $\ddot{x}_1/(b/m_2)=-(a_2x_1+a_1v_1)/(b(m_1+m_2)/m_2)$, so $|\ddot{x}_1|<b/m_2$ is the interior of "
        "$S_0$, $=$ its edges and $>$ the rest of $S$",
        free(stick().acceleration1) / (b / m2),
        -load(damped=True) / load_threshold(),
    )


def _share(name: str) -> sp.Rational:
    return {"half adhesion": sp.Rational(1, 2), "broken adhesion": sp.Integer(1)}[name]


@cache
def spurious_branch(name: str) -> Evidence:
    """The relative acceleration in a branch of z' = 0 that the text omits."""
    found, share = branch_named(name), _share(name)
    return identity(
        f"in the branch with {name}, $\\ddot z={share}\\cdot\\ddot x_1$",
        found.acceleration1 - found.acceleration2,
        share * found.acceleration1,
    )


@cache
def spurious_branches_leave() -> Evidence:
    """Where those branches apply the acceleration is not zero."""
    reached = sp.Ge(sp.Abs(acceleration1) * m2, b)
    plain = {acceleration1: sp.Symbol("A", real=True)}
    return prove(
        r"$|\ddot{x}_1|\geqslant b/m_2$ implies $\ddot{x}_1\neq 0$: those branches leave $\dot{z}=0$ at once",
        [reached.subs(plain)],
        sp.Ne(acceleration1, 0).subs(plain),
    )


@cache
def edge_is_isolated() -> Evidence:
    """Along sliding motion the load obeys p'' = -(a1 p' + a2 p)/M: on the edge not both p' and p'' vanish."""
    field, force = sliding_field(damped=True), load(damped=True)
    rate = derivative_along(field, force)
    return identity(
        "along sliding motion the load $p=a_2x_1+a_1v_1$ has $(m_1+m_2)\\,\\ddot p=-a_1\\dot p-a_2p$: "
        "where $|p|$ is at the edge, $\\dot p$ and $\\ddot p$ do not vanish together",
        total_mass() * derivative_along(field, rate),
        -a1 * rate - a2 * force,
    )


@cache
def contraction() -> Evidence:
    """Half the squared energy distance of two solutions changes by a damper term and a friction term."""
    return identity(
        "half the squared energy distance of two solutions changes at the rate "
        r"$-a_1(v_1-\tilde v_1)^2-b(\sigma-\tilde\sigma)(\dot z-\dot{\tilde z})$",
        contraction_rate(),
        -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (v1 - v2 - v1_other + v2_other),
    )


@cache
def never_apart() -> Evidence:
    """The friction term is never positive, whatever values the set-valued sign takes; the other is -a1 (...)^2."""
    relative, other, first, second = sp.symbols("w k s h", real=True)
    named = {sigma: first, sigma_other: second, v1: v2 + relative, v1_other: v2_other + other}
    friction = sp.expand((contraction_terms()[1] / b).subs(named, simultaneous=True))
    return prove(
        r"$-(\sigma-\tilde\sigma)(\dot z-\dot{\tilde z})\leqslant 0$ for all $\sigma\in\mathrm{Sign}(\dot z)$, "
        r"$\tilde\sigma\in\mathrm{Sign}(\dot{\tilde z})$ (here $s,h$ and $w,k$): two solutions never move apart",
        [set_valued_sign(first, relative), set_valued_sign(second, other)],
        sp.Le(friction, 0, evaluate=False),
    )


def set_valued_sign(value: sp.Symbol, velocity: sp.Symbol) -> sp.Basic:
    """Return the condition that a value belongs to Sign of a velocity: 1, -1, or anything between at velocity 0."""
    return sp.Or(
        sp.And(sp.Gt(velocity, 0), sp.Eq(value, 1)),
        sp.And(sp.Lt(velocity, 0), sp.Eq(value, -1)),
        sp.And(sp.Eq(velocity, 0), sp.Le(value, 1), sp.Ge(value, -1)),
    )


def same_solutions() -> tuple[Evidence, ...]:
    """Return all steps of `ARGUMENT`."""
    return (
        slip_is_filippov(),
        stick_is_filippov(),
        stick_region(),
        spurious_branch("half adhesion"),
        spurious_branch("broken adhesion"),
        spurious_branches_leave(),
        edge_is_isolated(),
        contraction(),
        never_apart(),
    )


@cache
def equivalent() -> Evidence:
    """The solutions of (3), (4) are those of (5)-(7) in Filippov's sense: written out, and no more than that."""
    return argument(" ".join(ARGUMENT[:2]), *same_solutions()[:-2])


@cache
def one_solution() -> Evidence:
    """There is exactly one for each start."""
    return argument(ARGUMENT[2], equivalent(), contraction(), never_apart(), cites=("Filippov's theorem on existence",))
