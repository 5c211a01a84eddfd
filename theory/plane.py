"""Friction in the plane: a sign for each component, beside the friction that has the direction of the slip.

Vectors have two components; w is the relative velocity v1 - v2, m/s, and f the friction on body 2, N.
"""

from sympy import Abs, Expr, ImmutableMatrix, Matrix, cos, sin, sqrt, symbols

from theory.symbols import a1, a2, b, m1, m2

direction = symbols("alpha", real=True)  # angle between the slip and the first axis, rad
slip_1, slip_2, other_1, other_2 = symbols(r"w_1 w_2 \tilde{w}_1 \tilde{w}_2", real=True)
share_1, share_2, share_other_1, share_other_2 = symbols(r"p_1 p_2 \tilde{p}_1 \tilde{p}_2", real=True)
"""Friction by b, dimensionless, of two motions: of size 1 and along the slip where there is one, else at most 1."""
SLIP, OTHER = ImmutableMatrix([slip_1, slip_2]), ImmutableMatrix([other_1, other_2])
SHARE, SHARE_OTHER = ImmutableMatrix([share_1, share_2]), ImmutableMatrix([share_other_1, share_other_2])
place_1, place_2, first_1, first_2, second_1, second_2 = symbols("x_1 y_1 v_1 v_2 v_3 v_4", real=True)
PLACE, FIRST, SECOND = Matrix([place_1, place_2]), Matrix([first_1, first_2]), Matrix([second_1, second_2])


def along(angle: Expr) -> ImmutableMatrix:
    """Return the unit vector at an angle to the first axis."""
    return ImmutableMatrix([cos(angle), sin(angle)])


def by_components(slip: ImmutableMatrix) -> ImmutableMatrix:
    """Return b sgn(w_i) for each component, N, for a slip along none of the axes."""
    return ImmutableMatrix([b * one / Abs(one) for one in slip])


def by_direction(slip: ImmutableMatrix) -> ImmutableMatrix:
    """Return b w/|w|, N."""
    return slip * b / sqrt(slip.dot(slip))


def against_slip(angle: Expr) -> Expr:
    """Return how much of the friction by components is along a slip at this angle, N: b (|cos| + |sin|)."""
    return by_components(along(angle)).dot(along(angle))


def energy_rate() -> Expr:
    """Return dE/dt, W, for the friction b p on body 2 and its opposite on body 1; scalar masses and spring, u = 0."""
    friction = b * Matrix(SHARE)
    accelerations = (-a2 * PLACE - a1 * FIRST - friction) / m1, friction / m2
    return (a2 * PLACE.dot(FIRST) + m1 * FIRST.dot(accelerations[0]) + m2 * SECOND.dot(accelerations[1])).expand()


def contraction_by_friction() -> Expr:
    """Return what friction adds to half the rate of the squared energy distance of two motions, W."""
    return -b * (SHARE - SHARE_OTHER).dot(SLIP - OTHER)
