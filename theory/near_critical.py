"""Near the critical orbit: the excursion in powers of the exit speed, the durations, the 1/t law (a1 = 0).

All series are in epsilon = sqrt(w), the reduced speed on the ray, and are obtained from the closed forms of
``theory.excursion`` by reverting h(theta) = epsilon/sqrt(q).  They are approximate: terms from
epsilon^order on are dropped.
"""

from dataclasses import dataclass
from functools import cache

from sympy import Expr, Integer, Symbol, asin, atan2, cos, expand, factor, sin, sqrt

from theory.closed_forms import DampingRegime, rate, rates, solution
from theory.energy import critical_energy
from theory.excursion import displacement_of_angle, excursion, h, next_excess
from theory.filippov import at_edge
from theory.fraction import in_lowest_terms
from theory.linear import root, roots
from theory.power_series import composed, reverted, taylor
from theory.scaling import canonical_pair, excess, half_width, stick_frequency, to_si
from theory.symbols import V1, V2, X, epsilon, put, q, t, theta, v1_0, w, x1, x1_0

ORDER = 8  # enough for two terms beyond the leading one in w'


def truncate(expression: Expr, variable: Symbol, order: int) -> Expr:
    """The part of a polynomial below variable**order."""
    polynomial = expand(expression)
    return sum((polynomial.coeff(variable, n) * variable**n for n in range(order)), Integer(0))


@cache
def slip_angle(order: int = ORDER) -> Expr:
    """theta(epsilon): the reversion of h(theta) = epsilon/sqrt(q), dimensionless."""
    return in_speed(theta, order)


def in_speed(expression: Expr, order: int = ORDER) -> Expr:
    """A closed form in theta as a series in epsilon below epsilon**order."""
    coefficients = reverted(h(), theta, order, expression)
    return sum((expand(one / sqrt(q) ** n) * epsilon**n for n, one in enumerate(coefficients)), Integer(0))


@dataclass(frozen=True)
class CycleSeries:
    """One slip excursion from l_+ and the stick after it, as series in epsilon (dimensionless)."""

    slip_angle: Expr
    slip_duration: Expr
    position: Expr
    velocity: Expr
    displacement: Expr
    next_excess: Expr
    stick_duration: Expr
    cycle_duration: Expr


@cache
def stick_rotation() -> tuple[Expr, Expr]:
    """(cos, sin) of the stick time from (X, V) at re-entry to the exit by l_-, solved from the stick motion.

    Entries are functions of x10 = X, v10 = V and epsilon, the speed V = -epsilon of the next exit.
    """
    found = solution("stick", DampingRegime.UNDAMPED)
    unit = {rate: put(rates("stick", DampingRegime.UNDAMPED)[rate], canonical_pair())}
    cosine, sine = Symbol("c"), Symbol("s")
    motion = [found.x1.subs(unit) + 1, found.v1.subs(unit) + epsilon]
    motion = [entry.subs({cos(t): cosine, sin(t): sine}) for entry in motion]
    return roots(motion, [cosine, sine])


def angle_of(cosine: Expr, sine: Expr, order: int) -> Expr:
    """The angle in (-pi, pi] with this cosine and sine, series in epsilon, as such a series (approximate).

    It is the angle at epsilon = 0 and a small one, whose sine is that of the difference.
    """
    first = atan2(sine.subs(epsilon, 0), cosine.subs(epsilon, 0))
    rest = expand(sine * cos(first) - cosine * sin(first))
    return first + composed(asin(epsilon), epsilon, order, rest)


@cache
def cycle(order: int = ORDER) -> CycleSeries:
    """The series of one excursion and the following stick, below epsilon**order (approximate)."""
    one = excursion()
    position, velocity = in_speed(one.position, order), in_speed(one.velocity, order)
    excess_after = in_speed(next_excess(), order)
    speed_after = expand(
        epsilon * composed(sqrt(1 + epsilon), epsilon, order - 2, expand(excess_after / epsilon**2) - 1)
    )
    state = {x1_0: position, v1_0: velocity, epsilon: speed_after}
    cosine, sine = (taylor(put(part, state), epsilon, order - 1) for part in stick_rotation())
    stick = angle_of(cosine, sine, order - 1)
    slip = sqrt(q) * slip_angle(order)
    return CycleSeries(
        slip_angle=slip_angle(order),
        slip_duration=expand(slip),
        position=position,
        velocity=velocity,
        displacement=q * in_speed(displacement_of_angle(), order),
        next_excess=excess_after,
        stick_duration=stick,
        cycle_duration=truncate(stick + expand(slip), epsilon, order - 1),
    )


@cache
def inverse_step() -> Expr:
    """lim (1/w' - 1/w) as w -> 0, dimensionless: the constant gain of 1/w per excursion."""
    after = cycle().next_excess
    return in_lowest_terms(taylor(in_lowest_terms((epsilon**2 - after) / (after * epsilon**2)), epsilon, 1))


@cache
def cycle_limit() -> Expr:
    """Limit of the reduced duration of slip plus stick as w -> 0."""
    return cycle().cycle_duration.subs(epsilon, 0)


@cache
def reduced_rate_constant() -> Expr:
    """lim tau w, dimensionless.

    1/w gains ``inverse_step`` in the limit per ``cycle_limit`` of time, so 1/(tau w) tends to their quotient
    (Stolz-Cesaro); it does not depend on where w started.
    """
    return in_lowest_terms(cycle_limit() / inverse_step())


@cache
def rate_constant() -> Expr:
    """lim t (E - E_cr) in SI, J s, for every trajectory that never merges; independent of E(0)."""
    return factor(critical_energy() * to_si(reduced_rate_constant()) / stick_frequency())


@dataclass(frozen=True)
class CriticalLimits:
    """Limits along a trajectory that tends to the critical orbit (SI, exact): seconds, metres, m/s."""

    stick_duration: Expr
    slip_duration: Expr
    exit_position: Expr
    exit_velocity: Expr
    entry_position: Expr
    entry_velocity: Expr


@cache
def exit_speed() -> Expr:
    """V of the ray l_+ with excess w, dimensionless: solved from the energy on the edge X = 1."""
    squared = Symbol("V2", positive=True)
    common = sqrt(squared)
    return sqrt(root(put(excess(), {X: 1, V1: common, V2: common}) - w, squared))


@cache
def critical_limits() -> CriticalLimits:
    """Limits for w -> 0 of the durations and of the exit and entry points on the side of l_+."""
    found = cycle()
    length, frequency = half_width(), stick_frequency()
    speed = length * frequency
    return CriticalLimits(
        stick_duration=found.stick_duration.subs(epsilon, 0) / frequency,
        slip_duration=found.slip_duration.subs(epsilon, 0) / frequency,
        exit_position=at_edge(x1, 1),
        exit_velocity=exit_speed().subs(w, 0) * speed,
        entry_position=found.position.subs(epsilon, 0) * length,
        entry_velocity=found.velocity.subs(epsilon, 0) * speed,
    )


def excess_ratio_limit() -> Expr:
    """lim w'/w as w -> 0, dimensionless: 1, so the decay is slower than every exponential."""
    return taylor(cycle().next_excess / epsilon**2, epsilon, 1)
