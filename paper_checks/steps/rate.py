"""Steps about the 1/t law: one excursion and one cycle between explicit bounds, for every mass ratio (a1 = 0)."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache

import sympy as sp
from flint import arb

from numerics.arithmetic.ball import Ball, depth_and_cotangent, sine_deficit, versine
from numerics.free.energy import energy_at
from numerics.free.excursions import excursions
from numerics.scene import Pair, Scene, State
from numerics.trajectory.reduced import Frame
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, EvidenceKind
from paper_checks.evidence.formula import form, stating
from paper_checks.solvers.smt import prove
from paper_checks.steps.excursions import vanishes
from theory.excursion import excursion, h, half_tangent_form
from theory.near_critical import cycle_limit, inverse_step, rate_constant, stick_rotation
from theory.rate_bounds import elapsed, excess_bounds, first_angle, first_depth, first_excess
from theory.return_map import depth as depth_of_angle
from theory.return_map import depth_series, in_trigonometry
from theory.symbols import a2, b, epsilon, m1, m2, q, r, theta, v1_0, x1_0


@cache
def limit_of_steps() -> tuple[Evidence, ...]:
    """1/y' - 1/y tends to 9 r/4, the cycle to pi: by Stolz and Cesaro t (E - E_cr) has a limit."""
    printed = b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2) * 4 * sp.pi / 9 * m1 / m2 * sp.sqrt((m1 + m2) / a2)
    ratio = sp.limit(_depth_ratio(), theta, 0)
    return (
        identity(
            r"$c/y\to\tfrac{3}{2}$ as $y\to 0$",
            sp.Matrix([ratio, depth_series(7)[0]]),
            sp.Rational(3, 2) * sp.ones(2, 1),
        ),
        identity(
            r"$\frac{1}{w'}-\frac{1}{w}=\frac{1}{q}\,\frac{r(c/y)^2}{1-r\,c^2/y}\to\frac{9r}{4q}$",
            inverse_step(),
            9 * r / (4 * q),
        ),
        identity(r"a cycle takes the time $\pi/\Omega$ in the limit", cycle_limit(), sp.pi),
        stating(
            identity(
                r"so $t\,(E-E_{cr})\to E_{cr}\,\frac{4\pi}{9}\,\frac{m_1}{m_2}\sqrt{(m_1+m_2)/a}$ along the exits",
                rate_constant(),
                printed,
            ),
            form("lim t*(E - E_cr)", rate_constant()),
            "in units of E_cr/Omega: 4*pi*m1/(9*m2)",
        ),
    )


def _depth_ratio() -> sp.Expr:
    """Return c/h^2 as a function of the slip angle."""
    return sp.simplify(in_trigonometry(depth_of_angle()) / h() ** 2)


def enclosed_limit(share: Fraction, speed: Fraction, time: str, tolerance: Fraction) -> Evidence:
    """Enclose t (E - E_cr) over the constant at a late time: Omega = 1, V = speed on the edge of S0 at the start."""
    pair = Pair(m1=share, m2=1 - share, a2=1, b=1 - share)
    found = energy_at(Scene(pair, State(v1=speed, v2=speed), until=1), time, digits=20)
    with Ball(60).context():
        scaled = (
            found.energy_excess * _number(Fraction(time)) * 9 * _number(1 - share) / (4 * arb.pi() * _number(share))
        )
        near = abs(scaled - 1) < _number(tolerance)
    return Evidence(
        EvidenceKind.ENCLOSURE,
        "numerics.free.energy, balls",
        f"$q={share}$, from $x_1=0$ with $E/E_{{cr}}={speed**2}$: at $\\Omega t={float(Fraction(time)):g}$ the ratio of $t\\,(E-E_{{cr}})$ to its limit "
        f"is within {float(tolerance):g} of 1",
        bool(near),
        found.excursions,
        f"ratio - 1 = {(scaled - 1).str(8)}",
        supports=True,
        counted="excursions",
    )


def _number(value: Fraction | int) -> arb:
    return Ball(60).number(Fraction(value))


@cache
def one_step() -> tuple[Evidence, ...]:
    """a' y^2 <= y - y' <= a y^2, and what that makes of 1/y."""
    before, after, low, high, part = sp.symbols("y z a' a kappa", positive=True)
    given = [sp.Lt(after, before), sp.Ge(before - after, low * before**2), sp.Le(before - after, high * before**2)]
    return (
        prove(
            r"$a'y^2\leqslant y-y'$ gives $\frac{1}{y'}-\frac{1}{y}\geqslant a'$ (here $z=y'$)",
            given,
            sp.Ge(before - after, low * before * after, evaluate=False),
        ),
        prove(
            r"$y-y'\leqslant a\,y^2$ and $y-y'\leqslant\kappa\,y$ with $\kappa<1$ give $\frac{1}{y'}-\frac{1}{y}\leqslant\frac{a}{1-\kappa}$",
            [*given, sp.Lt(part, 1), sp.Le(before - after, part * before)],
            sp.Le((1 - part) * (before - after), high * before * after, evaluate=False),
        ),
        identity(
            r"$h'(\pi/2)=c(\pi/2)=2-\frac{\pi}{2}<1$: for $\theta\leqslant\pi/2$, $\theta-h$ rises ($h'$ rises) and $q\,c<1$",
            sp.Matrix([sp.diff(h(), theta).subs(theta, sp.pi / 2), depth_of_angle().subs(theta, sp.pi / 2)]),
            (2 - sp.pi / 2) * sp.ones(2, 1),
        ),
    )


@cache
def one_cycle() -> tuple[Evidence, ...]:
    """Slip and stick last between T_- and T_+."""
    one = excursion()
    landed = -one.velocity / one.position
    speed = sp.Symbol("e", positive=True)
    state = {x1_0: one.position, v1_0: one.velocity, epsilon: speed}
    _, sine = (part.subs(state, simultaneous=True) for part in stick_rotation())
    # sin(pi - alpha - beta), tan alpha = e, tan beta = -V'/X', times the two radii
    expected = (speed * one.position - one.velocity) / (one.position**2 + one.velocity**2)
    shortfall = sp.sqrt(q) * (theta - h()) * q * in_trigonometry(depth_of_angle())
    return (
        vanishes(
            r"the stick turns $(X',V')$ to $(-1,-\varepsilon')$, $\varepsilon'=\sqrt{w'}$: by $\pi-\arctan\varepsilon'-\arctan\frac{-V'}{X'}<\pi$",
            half_tangent_form((sine - expected).subs(speed**2, one.position**2 + one.velocity**2 - 1)),
        ),
        vanishes(
            r"so a cycle is shorter than $\pi+\sqrt q\,\theta$, and with $\arctan x\leqslant x$, $\varepsilon'<\varepsilon$ it is longer than "
            r"$\pi+\sqrt q\,\theta-\varepsilon-\frac{-V'}{X'}=\pi-\sqrt q\,(\theta-h)\frac{q\,c}{1-q\,c}$",
            half_tangent_form((sp.sqrt(q) * theta - sp.sqrt(q) * h() - landed) * one.position + shortfall),
        ),
    )


def bounded_run(share: Fraction, start: Fraction, count: int) -> Evidence:
    """Enclose a run and compare it with both bounds at every exit and at the end of every slip, where each is tightest."""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        theta_0 = arithmetic.number(start)
        y = (sine_deficit(theta_0) / versine(theta_0)) ** 2
        deep, _ = depth_and_cotangent(theta_0)
        lower, upper = bounds(frame.q, theta_0, y, deep)
        tau, good = arithmetic.number(0), True
        for number, one in enumerate(excursions(frame, frame.q * y)):
            if number == count:
                break
            assert one.stick is not None  # the start is below the level of no merging
            good = good and bool(one.w <= upper(tau) * (1 + arb(10) ** -20))
            good = good and bool(one.w_after > lower(tau + one.slip) and one.w_after < upper(tau + one.slip))
            tau = tau + one.slip + one.stick
        text = f"at the last exit {lower(tau).str(6)} <= w <= {upper(tau).str(6)}"
    return Evidence(
        EvidenceKind.ENCLOSURE,
        "numerics, balls",
        f"$q={share}$, $\\theta_0={start}$: a run of {count} excursions lies between both bounds",
        good,
        2 * count,
        text,
        supports=True,
    )


def bounds(q_value: arb, theta_0: arb, y: arb, deep: arb) -> tuple[Callable[[arb], arb], Callable[[arb], arb]]:
    """Return both bounds of w, theory's in balls, as functions of the reduced time since the exit with angle theta_0."""
    letters = (q, first_excess, first_depth, first_angle, elapsed)
    sides = [sp.lambdify(letters, one, [{"sqrt": arb.sqrt, "pi": arb.pi()}]) for one in excess_bounds()]

    def lower(time: arb) -> arb:
        return sides[0](q_value, y, deep, theta_0, time)

    def upper(time: arb) -> arb:
        return sides[1](q_value, y, deep, theta_0, time)

    return lower, upper
