"""Section II and IV-A: eqs (1) to (14) and (5)-(7); every branch solved from the closed form (3), (4).

The closed form contains sgn twice.  ``branch`` puts a value for each and solves for the accelerations; the
forces on the bodies then follow from Newton's law alone, so that nothing presupposes which branches are
physical.
"""

from dataclasses import dataclass
from functools import cache, cached_property

from sympy import Abs, Eq, Expr, Gt, ImmutableMatrix, Integer, Piecewise, Rational, S

from theory.fraction import factored
from theory.linear import root
from theory.symbols import a1, a2, acceleration1, acceleration2, b, free, m1, m2, put, sgn, u, v1, v2, x1

RELATIVE_SIGN = sgn(v1 - v2)
STICTION_SIGN = sgn(Abs(acceleration1) - b / m2)


def signum(value: Expr) -> Expr:
    """Eq (1): the three-valued signum, as a sympy Piecewise; dimensionless, exact.

    >>> [signum(S(value)) for value in (-3, 0, 2)]
    [-1, 0, 1]
    """
    return Piecewise((1, Gt(value, 0)), (0, Eq(value, 0)), (-1, True))


def driving_equation() -> Expr:
    """Eq (3) as left minus right side, N, with sgn and the acceleration unevaluated."""
    inertia = m1 + m2 * (1 - Abs(RELATIVE_SIGN))
    return inertia * acceleration1 + a1 * v1 + a2 * x1 + b * RELATIVE_SIGN - u


def driven_equation() -> Expr:
    """Eq (4) as left minus right side, N, with sgn and the accelerations unevaluated."""
    adhesion = (1 - Abs(RELATIVE_SIGN)) * Rational(1, 2) * (1 - STICTION_SIGN)
    return m2 * acceleration1 * adhesion - m2 * acceleration2 + b * RELATIVE_SIGN


@dataclass(frozen=True)
class Branch:
    """One branch of the closed form: the values of its two signs and what follows from them (SI, exact)."""

    name: str
    relative_sign: Expr
    stiction_sign: Expr | None  # None: the branch does not depend on it
    acceleration1: Expr
    acceleration2: Expr

    @cached_property
    def force_on_first(self) -> Expr:
        """The interface force on body 1, N: what Newton's law leaves after spring, damper and control."""
        return factored(m1 * self.acceleration1 + a1 * v1 + a2 * x1 - u)

    @cached_property
    def force_on_second(self) -> Expr:
        """The interface force on body 2, N: no other force acts on it."""
        return factored(m2 * self.acceleration2)

    @cached_property
    def force_imbalance(self) -> Expr:
        """Sum of both interface forces, N: zero exactly where they are equal and opposite."""
        return factored(self.force_on_first + self.force_on_second)

    @property
    def field(self) -> ImmutableMatrix:
        """The branch as a field on (x1, v1, v2) of the free system."""
        return ImmutableMatrix([v1, free(self.acceleration1), free(self.acceleration2)])


def branch(relative_sign: int, stiction_sign: int, name: str = "") -> Branch:
    """Solve eqs (3), (4) for the accelerations with sgn(z') and sgn(|x1''| - b/m2) put to the given values.

    >>> branch(0, 1).acceleration2
    0
    """
    values = {RELATIVE_SIGN: Integer(relative_sign), STICTION_SIGN: Integer(stiction_sign)}
    return Branch(
        name,
        values[RELATIVE_SIGN],
        None if relative_sign else values[STICTION_SIGN],
        *_accelerations(put(driving_equation(), values), put(driven_equation(), values)),
    )


@cache
def _accelerations(driving: Expr, driven: Expr) -> tuple[Expr, Expr]:
    """The accelerations: eq (3) has that of body 1 alone, eq (4) that of body 2 besides."""
    first = root(driving, acceleration1)
    return factored(first), factored(root(driven.subs(acceleration1, first), acceleration2))


BRANCH_NAMES = {
    (0, -1): "stick",
    (1, -1): "slip+",
    (-1, -1): "slip-",
    (0, 0): "half adhesion",
    (0, 1): "broken adhesion",
}


@cache
def branches() -> tuple[Branch, ...]:
    """The distinct branches of (3), (4): stick, slip+, slip-, and two more at z' = 0 that the text omits.

    All nine pairs of signs are solved; pairs with the same accelerations are one branch.
    """
    distinct: dict[tuple[Expr, Expr], Branch] = {}
    for relative_sign in (0, 1, -1):
        for stiction_sign in (-1, 0, 1):
            name = BRANCH_NAMES.get((relative_sign, stiction_sign), "")
            found = branch(relative_sign, stiction_sign, name)
            distinct.setdefault((found.acceleration1, found.acceleration2), found)
    return tuple(distinct.values())


def branch_named(name: str) -> Branch:
    """The branch with that name; raises KeyError for a name that no branch has."""
    return {found.name: found for found in branches()}[name]


def stick() -> Branch:
    """Mode (i): both bodies move as one mass."""
    return branch_named("stick")


def slip(sign: int) -> Branch:
    """Mode (ii) with sgn(z') = sign, which is 1 or -1."""
    return branch_named({1: "slip+", -1: "slip-"}[sign])


@cache
def free_system(sign: Expr) -> ImmutableMatrix:
    """(5)-(7) with the damper kept: the field on (x1, v1, v2) for a value ``sign`` of sign(v1 - v2).

    Any value is accepted; values strictly between -1 and 1 are the set-valued (Filippov) friction.
    """
    friction = b * sign
    return ImmutableMatrix([v1, (-a2 * x1 - a1 * v1 - friction) / m1, friction / m2])


CASE_STUDY = {m1: Integer(1), m2: Integer(1), a1: S.Zero, a2: Integer(200), u: S.Zero}


@cache
def case_study_closed_form() -> tuple[Expr, Expr]:
    """Right sides of eqs (11), (12), from (3), (4) with unit masses, a2 = 200 and the stiction bracket at 1.

    The second keeps x1'' as a symbol, as eq (12) does.
    """
    kept = {STICTION_SIGN: Integer(-1)}
    first = root(driving_equation().subs(CASE_STUDY), acceleration1)
    second = root(driven_equation().subs(kept).subs(CASE_STUDY), acceleration2)
    return factored(first), second


@cache
def case_study_mode(sign: int) -> tuple[Expr, Expr]:
    """Accelerations (x1'', x2'') of eqs (13) (sign 0) and (14) (sign 1 or -1), from eqs (11), (12)."""
    first, second = (side.subs(RELATIVE_SIGN, Integer(sign)) for side in case_study_closed_form())
    return first, second.subs(acceleration1, first)


@cache
def case_study_eigenfrequency() -> Expr:
    """Angular frequency of the case study in stick, rad/s."""
    stiffness_per_mass = -case_study_mode(0)[0].coeff(x1)
    return stiffness_per_mass ** Rational(1, 2)
