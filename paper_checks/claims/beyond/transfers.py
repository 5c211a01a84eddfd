"""Steps on moving body 2 by a force on body 1: friction is all that it feels."""

from functools import cache

import sympy as sp

from paper_checks.claims.beyond.contraction import same_modes
from paper_checks.claims.words import *
from theory import forced
from theory import forced_control as control
from theory.energy import sigma
from theory.forced_control import angle, reduced, strength


@cache
def gentle() -> Evidence:
    """Body 2 has no force but friction."""
    return identity(
        r"$m_2\dot v_2=b\sigma$ with $|\sigma|\leqslant 1$, whatever $u$ is: $|\ddot x_2|\leqslant b/m_2$, attained in slip",
        [m2 * forced.forced_system(sigma)[2], control.strongest()],
        [b * sigma, b / m2],
    )


@cache
def stuck_force() -> Evidence:
    """The force of a stuck motion, and the load that it makes."""
    force = control.stuck_force()
    load = forced.load().subs({u: force, x1: control.r_place, v1: control.r_speed}, simultaneous=True)
    return identity(
        r"the stuck pair follows $x_{\mathrm{ref}}$ under $u=M\ddot x_{\mathrm{ref}}+a_1\dot x_{\mathrm{ref}}+a_2x_{\mathrm{ref}}$ only, and its load is $m_2\ddot x_{\mathrm{ref}}$",
        [force, load],
        [
            total_mass() * control.r_acceleration + a1 * control.r_speed + a2 * control.r_place,
            m2 * control.r_acceleration,
        ],
    )


@cache
def followed() -> Evidence:
    """Exactly the references with |r''| <= b/m2."""
    return argument(
        r"""
        Friction gives body 2 no more. Conversely let body 1 start with $v_1(0)=v_2(0)$. The stuck motion along such
        an $x_{\mathrm{ref}}$, shifted by $x_1(0)-x_{\mathrm{ref}}(0)$, has $|\Lambda|=m_2|\ddot
        x_{\mathrm{ref}}|\leqslant b$ at almost every time: it is a motion under the force of stick; if $\ddot
        x_{\mathrm{ref}}$ jumps, so does $u$.
        """,
        gentle(),
        stuck_force(),
        same_modes(),
    )


@cache
def nothing_breaks() -> Evidence:
    """A weak force does not break the pair within half a turn."""
    share = Symbol("c", real=True)
    return prove(
        r"$|M\ddot x_1|\leqslant U(2-\cos\Omega t)\leqslant 3U\leqslant bM/m_2$ (here $c=\cos\Omega t$)",
        [
            sp.Ge(share, -1, evaluate=False),
            sp.Le(3 * strength * m2, b * total_mass(), evaluate=False),
        ],
        sp.Le(m2 * control.pressed().subs(cos(angle), share), b * total_mass(), evaluate=False),
    )


@cache
def weak_force() -> Evidence:
    """Two arcs, and a sine that no other control serves as well."""
    first, second = control.switching_cosines()
    meets = reduced / 2 + reduced**2 / 4
    return argument(
        r"""
        In units of $U/a_2$ the pair moves about $1$ from $0$, then about $-1$ into $d\leqslant 1$; both circles meet
        at $X=d/2+d^2/4$. Both angles are below $\pi$. Let $T=(\alpha_1+\alpha_2)/\Omega$ and
        $\psi=\sin(\alpha_1-\Omega t)$, which is positive up to the switch and negative after it. Every control that
        brings the stuck pair to rest at $D$ at $T$ has $\int_0^Tu\,\psi\,dt=M(\dot x\psi-x\dot\psi)|_0^T$, the same
        number; for this one it is $U\int|\psi|$, the largest one, so every other control with $|u|\leqslant U$ is
        equal to it. One that arrives earlier could hold $D$ with $u=a_2D\leqslant U$ up to $T$ and would differ.
        Within $T<\pi/\Omega$ no control breaks the pair: $a_2|x_1|\leqslant U(1-\cos\Omega t)$.
        """,
        identity(
            r"the arcs meet on both circles, and turn by these angles",
            [first - (1 - meets), second * (1 + reduced) - (meets + 1)],
        ),
        identity(
            r"$X=d/2+d^2/4$ is on both circles",
            (1 - (meets - 1) ** 2) - ((1 + reduced) ** 2 - (meets + 1) ** 2),
        ),
        nothing_breaks(),
        stuck_force(),
    )
