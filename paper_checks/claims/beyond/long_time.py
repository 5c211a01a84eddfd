"""The next terms of the $1/t$ law: a logarithm, and one number that is left of the start."""

from numerics.arithmetic.ball import Ball
from numerics.free.energy import energy_at
from paper_checks.claims.beyond.rate import HALF, MOST
from paper_checks.claims.beyond.return_map import coefficients, cycle_time
from paper_checks.claims.beyond.uniform_rate import quotients
from paper_checks.claims.letters import R, of_share
from paper_checks.claims.words import *
from theory.long_time import (
    abel_defect,
    balanced_share,
    expansion_defect,
    leading_coefficient,
    logarithm_coefficient,
    logarithm_weight,
    map_coefficients,
)

TIMES = ("1e6", "1e12", "1e30")
DIGITS = 45
"""Right digits of the excess: 15 are left of K at the last time. One number, so that one return map serves all times."""


@cache
def expansion() -> Steps:
    """The Abel equation to leading order, solved for the excess."""
    return (
        identity(
            r"$y'=y-\alpha y^2+\beta y^3-\cdots$ with $\alpha=\tfrac{9}{4}r$, $\beta=\tfrac{81}{40}r$",
            map_coefficients(),
            [9 * r / 4, 81 * r / 40],
        ),
        identity(
            r"$A(y)=\frac{1}{\alpha y}+B\ln y$ has $A(y')-A(y)=1+O(y^2)$, a sum that converges along the exits, as $y_n\sim\frac{1}{\alpha n}$",
            abel_defect(),
        ),
        identity(
            r"""
            $\frac{\pi}{\alpha}\cdot\frac{1}{y}+\pi B\ln y=\tau+K$ is solved by
            $y=\frac{\pi}{\alpha\tau}\bigl(1-\frac{\pi B\ln(\alpha\tau/\pi)+K}{\tau}\bigr)$ up to
            $O(\tau^{-1}\ln^2\tau)$ in the equation
            """,
            expansion_defect(),
        ),
        stating(
            identity(
                r"the coefficient of $-C\ln\tau/\tau^2$ is $\pi B=\pi\bigl(1-\frac{2}{5r}\bigr)$",
                logarithm_coefficient(),
                pi * (1 - 2 / (5 * r)),
            ),
            form("pi*B", logarithm_coefficient()),
        ),
    )


def constant_at(share: Fraction, speed: Fraction, time: str) -> arb:
    """Return K, from the excess at the next exit after a late reduced time (Omega = 1); call inside a precision.

    Raises ArithmeticError where the pair slips at that time: choose another.
    """
    pair = Pair(m1=share, m2=1 - share, a2=1, b=1 - share)
    found = energy_at(Scene(pair, State(v1=speed, v2=speed), until=1), time, digits=DIGITS)
    if found.mode is not Mode.STICK or found.state is None:
        raise ArithmeticError(f"the pair slips at {time}")
    w, position, velocity = found.energy_excess, found.state.X, found.state.V1
    if not (velocity > 0 or velocity < 0):
        raise ArithmeticError(f"the pair turns at {time}")
    # the stick rotates (X, V) to (-1, -sqrt(w)), or the mirror image
    mirrored = -1 if velocity > 0 else 1
    to_exit = arb.pi() - w.sqrt().atan() - arb.atan2(abs(velocity), mirrored * position)
    q_value, r_value = (Ball(250).number(one) for one in (share, 1 - share))
    exit_time = Ball(250).number(Fraction(time)) + to_exit
    leading = 4 * arb.pi() * q_value / (9 * r_value)
    logarithm = (9 * r_value * exit_time / (4 * arb.pi())).log()
    weight = 1 - 2 / (5 * r_value)
    return exit_time * (1 - w * exit_time / leading) - arb.pi() * weight * logarithm


def constant_found_again(share: Fraction, speed: Fraction) -> Evidence:
    """Compare K at three times: its error is O(tau^(-1/2)), so 1e-2 and 1e-5 are ample."""
    with Ball(250).context():
        early, late, last = (constant_at(share, speed, time) for time in TIMES)
        small, smaller = arb(1) / 100, arb(1) / 100_000
        agree = bool(abs(early - last) < small and abs(late - last) < smaller)
        text = f"K = {last.str(20)}; less that at 1e6: {(early - last).str(5)}, at 1e12: {(late - last).str(5)}"
    return enclosed(
        f"$q={share}$, from $x_1=0$ with $E/E_{{cr}}={speed**2}$: $K$ from the exits after $\\tau=10^6$, $10^{{12}}$, $10^{{30}}$ is the same number, with "
        "differences that fall as $\\tau^{-1/2}$",
        agree,
        text,
        len(TIMES),
        engine="numerics.free.energy, balls",
        supports=True,
    )


@theorem(
    "long-time-expansion",
    clause(
        "expansion",
        r"""
        With $\tau=\Omega t$, from some exit of a trajectory that never merges on, at the exits,
        $w=\frac{C}{\tau}\Bigl(1-\frac{\pi B\ln(\alpha\tau/\pi)+K}{\tau}+O(\tau^{-3/2})\Bigr)$ with «leading», «alpha»,
        «weight» and one number $K$.
        """,
        leading=of_share("C", 4 * pi * q / (9 * R), leading_coefficient),
        alpha=of_share(r"\alpha", Rational(9, 4) * R, lambda: map_coefficients()[0]),
        weight=of_share("B", 1 - 2 / (5 * R), logarithm_weight),
    ),
    clause(
        "balanced",
        r"The logarithm vanishes for «ratio».",
        ratio=equal("m_1/m_2", Rational(3, 2), lambda: 1 / balanced_share() - 1),
    ),
)
def long_time_expansion() -> Case:
    """The Abel function of the return map, to the order that leaves a convergent sum."""
    return because(
        r"""
        The next term of $w$ is a logarithm, with $B=1-\frac{2}{5r}$; the initial state enters after it, as one number
        $K$. Along the exits $A(y)=\frac{1}{\alpha y}+B\ln y$ grows by $1+O(y^2)$ and the time by $\pi+O(y^{3/2})$; both
        errors are summable, as $y_n\sim\frac{1}{\alpha n}$, so $\pi A(y_n)-\tau_n$ tends to a number $K$, with the
        error $O(\tau^{-1/2})$ of the second tail. Solved for $y$ that is the expansion. Only $K$ depends on the start.
        """,
        carried("expansion", kernel.step("long-time"), quotients),
        coefficients,
        cycle_time,
        expansion,
        carried("balanced"),
        constant_found_again(HALF, Fraction(3, 2)),
        constant_found_again(HALF, Fraction(11, 10)),
        constant_found_again(MOST, Fraction(3, 2)),
    )
