"""A pair with m2 <= m1 that has once left S0 by a ray with 0 < w < q pi^2/4 sticks and slips in turn for ever (a1 = 0).

The proof is `ARGUMENT`; each function returns the evidence for one step, `never_merges` all of them for one scene.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from flint import arb

from numerics.linear.modes import EventKind
from numerics.trajectory.events import Event
from numerics.trajectory.trajectory import Trajectory
from paper_checks.engines.enclosure import ball, compare, exact
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence
from paper_checks.solvers.smt import prove
from theory.excursion import (
    angle,
    excursion,
    guard_of_u,
    h,
    half_angle_slope,
    half_tangent,
    half_tangent_form,
    next_excess,
)
from theory.power_series import taylor
from theory.symbols import h_value, q, r, theta

LARGEST = sp.pi**2 / 4
"""w/q of the excursion of slip angle pi: proved by `largest_excess`, used by `starts_below`."""

ARGUMENT = (
    "On an exit ray the state is one number, the excess energy $w=E/E_{cr}-1>0$. With $\\nu=\\sqrt{w/q}$ the slip that "
    "starts there ends at the angle $\\theta=\\sqrt{a_2/m_1}\\,t$ for which $h(\\theta)=\\nu$, where "
    "$$h(\\theta)=\\frac{\\theta-\\sin\\theta}{1-\\cos\\theta}$$ increases from $0$; so $\\theta<\\pi$ while "
    "$w<q\\,h(\\pi)^2=q\\pi^2/4$.",
    "The excess $w'$ after the slip increases with $\\theta$ from $0$ if $m_2\\leqslant m_1$: $w'>0$, and $w'<w$ as a "
    "slip dissipates. For $\\theta\\leqslant\\pi$ the slip ends inside $S_0$, since $0<1-X<2q<2$ there.",
    "With $w'>0$ the pair sticks along an arc of $E=E_0>E_{cr}$ until it reaches a ray, after less than half a period, "
    "and leaves by it with $w'<w<q\\pi^2/4$: the same again, without end.",
    "During a slip $|V_1-V_2|=\\sqrt q\\,\\bigl(\\nu(1-\\cos\\theta)-(\\theta-\\sin\\theta)\\bigr)$, largest where "
    "$\\tan(\\theta/2)=\\nu$: $$\\max|\\dot z|=2\\sqrt q\\,(\\nu-\\arctan\\nu)\\,L\\Omega,\\qquad "
    "L\\Omega=\\frac{b\\,(m_1+m_2)}{a_2m_2}\\sqrt{\\frac{a_2}{m_1+m_2}},$$ which falls from slip to slip with $w$.",
)


@cache
def excess_after() -> Evidence:
    """dw'/dtheta in factors, and w' at theta = 0."""
    slope = 2 * q * h() * sp.diff(h(), theta) * (1 - r * (1 - sp.cos(theta)))
    return identity(
        r"$w'=0$ at $\theta=0$ and $\frac{dw'}{d\theta}=2q\,h\,h'\,\bigl(1-r(1-\cos\theta)\bigr)$, $r=m_2/(m_1+m_2)$",
        sp.Matrix([taylor(next_excess(), theta, 1), half_tangent_form(sp.diff(next_excess(), theta))]),
        sp.Matrix([0, half_tangent_form(slope)]),
    )


@cache
def last_factor_is_positive() -> Evidence:
    """1 - r(1 - cos theta) > 0 for m2 <= m1, 0 < theta < pi."""
    cosine = sp.Symbol("c", real=True)
    return prove(
        r"$1-r(1-\cos\theta)>0$ for $m_2\leqslant m_1$ and $0\leqslant\theta<\pi$ ($c=\cos\theta$, $q=1-r$)",
        [sp.Ge(2 * q, 1, evaluate=False), sp.Lt(q, 1), sp.Gt(cosine, -1), sp.Le(cosine, 1)],
        sp.Gt(sp.expand(1 - r * (1 - cosine)), 0, evaluate=False),
    )


@cache
def h_increases() -> Evidence:
    """h' has the sign of sin phi - phi cos phi, phi = theta/2, which grows from 0."""
    factor, increment = half_angle_slope()
    shown = sp.diff(h(), theta).subs(theta, 2 * angle)
    return identity(
        r"with $\varphi=\theta/2\in(0,\pi)$: $h'=\frac{\sin\varphi-\varphi\cos\varphi}{\sin^3\varphi}$, and the "
        r"numerator, $0$ at $\varphi=0$, has the derivative $\varphi\sin\varphi>0$",
        sp.Matrix([sp.expand_trig(shown - factor * increment), increment.subs(angle, 0), sp.diff(increment, angle)]),
        sp.Matrix([0, 0, angle * sp.sin(angle)]),
    )


@cache
def reentry_is_inside() -> Evidence:
    """1 - X at re-entry, in the half angle."""
    depth = half_tangent_form(1 - excursion().position).subs({half_tangent: sp.tan(angle), theta: 2 * angle})
    return identity(
        r"at re-entry $1-X=\frac{2q}{\sin\varphi}(\sin\varphi-\varphi\cos\varphi)$: positive, and at most $2q$ for "
        r"$\varphi\leqslant\pi/2$",
        depth,
        2 * q * (sp.sin(angle) - angle * sp.cos(angle)) / sp.sin(angle),
    )


@cache
def largest_excess() -> Evidence:
    """The excess of the excursion of slip angle pi."""
    return identity(r"$q\,h(\pi)^2=q\pi^2/4$", (q * h() ** 2).subs(theta, sp.pi), q * LARGEST)


@cache
def largest_relative_speed() -> Evidence:
    """The extremum of the guard of an excursion and its value."""
    at = {theta: 2 * sp.atan(h_value)}
    rational = [sp.cancel(sp.expand_trig(one.subs(at))) for one in (sp.diff(guard_of_u(), theta), guard_of_u())]
    return identity(
        r"$(V_1-V_2)/\sqrt q$ is stationary at $\theta=2\arctan\nu$, with the value $-2(\nu-\arctan\nu)$",
        sp.Matrix(rational),
        sp.Matrix([0, -2 * (h_value - sp.atan(h_value))]),
    )


def first_exit(trajectory: Trajectory) -> Event:
    """Return the first exit of a trajectory; raises ValueError where it has none."""
    for event in trajectory.events:
        if event.kind is EventKind.EXIT:
            return event
    raise ValueError("the trajectory has no exit from S0; solve further")


def relative_speed_bound(trajectory: Trajectory, after: Event) -> arb:
    """Return 2 sqrt(q) (u - arctan u) L Omega, m/s, for an exit: |z'| is never larger after it."""
    frame = trajectory.frame
    with trajectory.arithmetic.context():
        u = (after.reduced.w / frame.q).sqrt()
        return 2 * frame.sqrt_q * (u - u.atan()) * frame.speed


def every_excursion() -> tuple[Evidence, ...]:
    """Return the steps of `ARGUMENT` that hold for every pair with m2 <= m1."""
    return (excess_after(), last_factor_is_positive(), h_increases(), reentry_is_inside(), largest_excess())


def starts_below(trajectory: Trajectory, name: str) -> tuple[Evidence, ...]:
    """Return that a scene in balls meets the assumption at its first exit; `name` says which scene.

    Raises ValueError where m2 > m1, or the trajectory has no exit.
    """
    if trajectory.scene.pair.m2 > trajectory.scene.pair.m1:
        raise ValueError("the argument needs m2 <= m1")
    excess = first_exit(trajectory).reduced.w
    with trajectory.arithmetic.context():
        largest = trajectory.frame.q * ball(LARGEST)
    return (
        compare(f"{name}: $w>0$ at the first exit", excess, ">", exact(0)),
        compare(f"{name}: $w<q\\pi^2/4$ at the first exit", excess, "<", largest),
    )


def never_merges(trajectory: Trajectory, name: str) -> tuple[Evidence, ...]:
    """Return all steps of `ARGUMENT` for a scene in balls. Raises as `starts_below`."""
    return (*every_excursion(), *starts_below(trajectory, name))
