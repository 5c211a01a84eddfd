"""Steps under a periodic force: one response that attracts, its drift, and resonance of the slipping pair."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.steps.forced_distance import energy_rate, force_cancels, never_apart, one_solution
from paper_checks.steps.forced_rule import strict_rule, tie_rule
from theory import forced
from theory import forced_response as response
from theory.energy import sigma
from theory.filippov import STATE
from theory.symbols import a2, b, m1, m2, t, u, v1, x1


@cache
def bounded() -> Evidence:
    """Body 1 is a damped oscillator under a bounded force; body 2 is slowed down when it is faster."""
    push = forced.forced_system(sigma)
    return argument(
        r"Body 1 is a linear oscillator with $a_1>0$ under the bounded force $u-b\sigma$, so $x_1$ and $v_1$ are bounded. Where $|v_2|$ exceeds the bound of $|v_1|$, "
        r"$\dot z$ has the sign of $-v_2$, and $|v_2|$ falls at the rate $b/m_2$.",
        identity(
            r"body 2 has $m_2\dot v_2=b\sigma$, body 1 $m_1\dot v_1+a_1v_1+a_2x_1=u-b\sigma$",
            sp.Matrix([m2 * push[2], (m1 * push[1] - u).subs({x1: 0, v1: 0})]),
            sp.Matrix([b * sigma, -b * sigma]),
        ),
    )


@cache
def approach() -> Evidence:
    """With a damper two motions under one bounded force approach each other."""
    return argument(
        r"$N$ has a limit. Motions from which it is taken (limits of both, moved in time) keep their distance, so $v_1=\tilde v_1$ and the friction forces differ by $-a_2(x_1-\tilde x_1)$, a constant; "
        r"as $v_2-\tilde v_2$ is bounded, the constant is $0$. Then $\dot z-\dot{\tilde z}=c$ is constant under equal friction. If $c\neq 0$, $\dot z$ and $\dot z-c$ never have opposite signs, so $\dot z$ "
        r"does not enter the interval between $0$ and $c$: it keeps one sign, friction is always $b$ or always $-b$, and $v_2$ is not bounded. So $N\to 0$.",
        bounded(),
        never_apart(),
        force_cancels(),
    )


@cache
def one_response() -> Evidence:
    """Existence by a fixed point, uniqueness and attraction by the approach."""
    return argument(
        r"The map over one period does not increase $N$, and its orbits are bounded: it has a fixed point. Every motion approaches the one through it.",
        approach(),
        one_solution(),
        cites=("Browder and Petryshyn: a nonexpansive map with a bounded orbit has a fixed point",),
    )


@cache
def drift() -> Evidence:
    """The mirror of the response under a force with u(t + T/2) = -u(t) is the response."""
    letters = {one: -one for one in STATE}
    mirrored = forced.forced_system(-sigma, -u).subs(letters, simultaneous=True)
    return argument(
        r"$x_2$ gains the integral of $v_2$. If $u(t+T/2)=-u(t)$, minus the response, moved by half a period, is a response too, so the same one: $v_2(t+T/2)=-v_2(t)$, and its integral over "
        r"a period is $0$.",
        identity(r"the equations are odd in the state, $\sigma$ and $u$", -mirrored, forced.forced_system(sigma)),
        one_response(),
    )


@cache
def undamped_attraction() -> Evidence:
    """Without a damper one stick exit with a slip after it is enough, where the force is continuous at that exit."""
    place, relative = forced.undamped_difference()
    frequency = sp.Symbol("omega_1", positive=True)
    return argument(
        r"Let $\eta_*$ be the periodic motion, $\zeta$ a limit of another one moved by periods: $N(\zeta-\eta_*)$ is constant, so at almost every time both have the same $\dot z$ or the same friction. While $\eta_*$ sticks with "
        r"$|\Lambda_*|<b$ then $\zeta$ sticks; while $\eta_*$ slips $\zeta$ has its friction $sb$. At the exit both loads are continuous, as $u$ is. Before it neither is beyond $b$; after it both have friction $sb$ and $s\dot z\geqslant 0$, so "
        r"neither is within. So both loads are $sb$ there, hence $x_1=\tilde x_1$, and both velocities differ by one $\beta$. In the slip $v_2-\tilde v_2=\beta$ and $v_1-\tilde v_1=\beta\cos\omega_1t$. At its end $\dot z_*=0$. At times "
        r"after it, as close to it as one likes, friction of $\eta_*$ is not $sb$; then $\zeta$ has the same friction or the same $\dot z$, either way $s\dot z\leqslant 0$. So $\dot z=0$ for $\zeta$ at that end, too, hence "
        r"$\beta(\cos\omega_1t_s-1)=0$, $\beta=0$, and $\zeta=\eta_*$.",
        identity(
            r"the difference starts as $0$ with the rate $\beta$, and $\dot z-\dot{\tilde z}$ vanishes with $\beta$ or $\cos\omega_1t=1$",
            sp.Matrix([place.subs(t, 0), sp.diff(place, t).subs(t, 0), relative]),
            sp.Matrix([0, forced.velocity_gap, forced.velocity_gap * (sp.cos(frequency * t) - 1)]),
        ),
        identity(
            r"in stick the load falls by $(m_2/M)a_2$ with $x_1$: equal loads are equal places",
            sp.diff(forced.load(), x1),
            -m2 * a2 / (m1 + m2),
        ),
        never_apart(),
        strict_rule(),
        tie_rule(),
    )


@cache
def resonant_rate() -> Evidence:
    """z' has no state in it."""
    return identity(
        r"with $a_2=m_1\omega_1^2$, $e^{i\omega_1t}\dot A=(u-b\sigma)/m_1$",
        response.amplitude_rate(),
        (u - b * sp.Symbol("sigma", real=True)) / m1,
    )


@cache
def most_friction() -> Evidence:
    """The mean of |cos| over a period."""
    return identity(r"the mean of $|\cos|$ is $2/\pi$", response.mean_absolute_cosine(), 2 / sp.pi)


@cache
def grows() -> Evidence:
    """Above the bound every motion grows."""
    return argument(
        r"Over a period $T$ the force adds $U_1T/(2m_1)$ to $A$ in one direction, and friction, $|b\sigma|\leqslant b$, takes at most $bT/m_1$ times the mean of $|\cos|$ in it. The rest of a period adds a "
        r"bounded amount.",
        resonant_rate(),
        most_friction(),
        identity(
            r"so $|A|$ gains $(U-4b/\pi)/(2m_1)$ in the mean",
            response.growth_rate(),
            (response.amplitude / 2 - 2 * b / sp.pi) / m1,
        ),
    )


@cache
def stays_bounded() -> Evidence:
    """Below the bound the energy falls over periods in which it is large."""
    offset = sp.Symbol("c", positive=True)
    slope = sp.diff(response.path_beside(offset), offset)
    return argument(
        r"Over $n$ periods $A$ and $v_2$ change by at most a constant, $|A|=R$. So the work of $u$ is at most $R\,U_1nT/2$ and a constant (for $\omega_1T\notin 2\pi\mathbb Z$: $R\,\epsilon nT$, with $\epsilon$ as "
        r"small as one likes for a large $n$), and the path of $\dot z$ is at least the integral of $|R\cos\omega_1t-v_2|$ with one $v_2$, less a constant: at least $(2/\pi)R\,nT$, and at least $(|v_2|-R)nT$. So over "
        r"$n$ periods $E$ falls wherever it is large enough, and in between it rises by a bounded factor only.",
        energy_rate(),
        resonant_rate(),
        most_friction(),
        identity(
            r"$\int|\cos s-c|\,ds$ over a turn is $4$ at $c=0$ and has the slope $4\arcsin c\geqslant 0$",
            sp.Matrix([response.path_beside(offset).subs(offset, 0), slope]),
            sp.Matrix([4, 4 * sp.asin(offset)]),
        ),
    )


@cache
def sine_at_resonance() -> Evidence:
    """U** tends to the bound."""
    return identity(
        r"$U_{**}\to 4b/\pi$ as $\omega\to\omega_1=\sqrt{a_2/m_1}$",
        response.resonant_non_stop_amplitude(),
        4 * b / sp.pi,
    )
