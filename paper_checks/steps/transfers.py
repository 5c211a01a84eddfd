"""Steps on what a force on body 1 makes body 2 do: references, where it can be, and transfers. For a1 >= 0."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.smt import prove
from paper_checks.steps.forced_distance import same_modes
from theory import forced
from theory import forced_control as control
from theory.energy import sigma
from theory.forced_control import angle, half_time, path, reduced, strength
from theory.symbols import a1, a2, b, m1, m2, t, total_mass, u, v1, x1


@cache
def gentle() -> Evidence:
    """Body 2 has no force but friction."""
    return identity(
        r"$m_2\dot v_2=b\sigma$ with $|\sigma|\leqslant 1$, whatever $u$ is: $|\ddot x_2|\leqslant b/m_2$, attained in slip",
        sp.Matrix([m2 * forced.forced_system(sigma)[2], control.strongest()]),
        sp.Matrix([b * sigma, b / m2]),
    )


@cache
def stuck_force() -> Evidence:
    """The force of a stuck motion, and the load that it makes."""
    force = control.stuck_force()
    load = forced.load().subs({u: force, x1: control.r_place, v1: control.r_speed}, simultaneous=True)
    return identity(
        r"the stuck pair follows $x_{\mathrm{ref}}$ under $u=M\ddot x_{\mathrm{ref}}+a_1\dot x_{\mathrm{ref}}+a_2x_{\mathrm{ref}}$ only, and its load is $m_2\ddot x_{\mathrm{ref}}$",
        sp.Matrix([force, load]),
        sp.Matrix(
            [
                total_mass() * control.r_acceleration + a1 * control.r_speed + a2 * control.r_place,
                m2 * control.r_acceleration,
            ]
        ),
    )


@cache
def followed() -> Evidence:
    """Exactly the references with |r''| <= b/m2."""
    return argument(
        r"Friction gives body 2 no more. Conversely let body 1 start with $v_1(0)=v_2(0)$. The stuck motion along such an $x_{\mathrm{ref}}$, shifted by $x_1(0)-x_{\mathrm{ref}}(0)$, has $|\Lambda|=m_2|\ddot x_{\mathrm{ref}}|\leqslant b$ at almost every time: it is a motion under the force of "
        r"stick; if $\ddot x_{\mathrm{ref}}$ jumps, so does $u$.",
        gentle(),
        stuck_force(),
        same_modes(),
    )


@cache
def must_stick() -> Evidence:
    """Less than full friction is stick."""
    return argument(
        r"Slip has $|\ddot x_2|=b/m_2$; so where $|\ddot x_{\mathrm{ref}}|<b/m_2$ there is none, at the start neither.",
        gentle(),
        same_modes(),
    )


@cache
def spread() -> Evidence:
    """The farthest place: full acceleration first."""
    return argument(
        r"$x_2(T)-x_2(0)-v_2(0)T=\int_0^T(T-t)\,\dot v_2\,dt$ with $|\dot v_2|\leqslant b/m_2$ and a given integral is largest where all that is positive comes first. Its switch is at "
        r"$T/2+m_2\Delta v_2/2b$.",
        gentle(),
        identity(
            r"so the place is $s$ away from $\frac T2(v_2(0)+v_2(T))$",
            control.spread(),
            b / (4 * m2) * (control.duration**2 - (m2 * control.velocity_gain / b) ** 2),
        ),
    )


@cache
def least_time() -> Evidence:
    """From rest to rest."""
    turn = control.least_time() / 2
    return argument(
        r"With $v_2=0$ at both ends $D\leqslant bT^2/4m_2$. The stuck motion with $\ddot x=b/m_2$, then $-b/m_2$, attains it.",
        spread(),
        followed(),
        identity(
            r"both halves meet at half the time: place and velocity",
            sp.Matrix(
                [control.bang(True) - control.bang(False), sp.diff(control.bang(True) + control.bang(False), t)]
            ).subs(t, turn),
            sp.zeros(2, 1),
        ),
    )


@cache
def stuck_amplitude() -> Evidence:
    """The largest |u| of the stuck transfer and of holding it."""
    first, second = control.transfer_force(True), control.transfer_force(False)
    step = 2 * total_mass() * control.strongest()
    return argument(
        r"$u$ rises in the first half, up to $u_1$. In the second half, by the time $t$ to the end, it is a parabola that starts at $a_2D-bM/m_2$, turns at $t=a_1/a_2$, and at $t_{1/2}$ is less than $u_1$: it is never below "
        r"$-bM/m_2\geqslant-u_1$, and above $u_1$ at its turn at most. At the end $u=a_2D$ holds the pair.",
        stuck_force(),
        identity(
            r"the slopes are $a_1b/m_2+a_2bt/m_2$ and $a_1b/m_2-a_2bt/m_2$; at $t_{1/2}$ the force falls by $2bM/m_2$",
            sp.Matrix([sp.diff(first, t), sp.diff(second, t), (first - second).subs(t, control.least_time() / 2)]),
            sp.Matrix([(a1 + a2 * t) * b / m2, (a1 - a2 * t) * b / m2, step]),
        ),
        identity(
            r"the turn is inside where $a_2^2D\geqslant a_1^2b/m_2$",
            control.late_peak(),
            a2**2 * path - a1**2 * b / m2,
        ),
    )


@cache
def addition() -> Evidence:
    """The impulse response of body 1: its equation and its addition formula."""
    return identity(
        r"$m_1g''+a_1g'+a_2g=0$ and $g(t+s)=g(t)\,(m_1g'(s)+a_1g(s))+m_1g'(t)\,g(s)$",
        sp.Matrix([control.response_residual(), control.addition_residual()]),
        sp.zeros(2, 1),
    )


@cache
def contact_margin() -> Evidence:
    """w <= 0 in the second half: g(t + s) - 2 g(s) <= g(t) (1 - s/t) by numbers that the argument bounds."""
    whole, part, sum_of, first, second, share = sp.symbols("g h k p r s", real=True)
    given = [
        sp.Ge(whole, 0, evaluate=False),
        sp.Ge(part, share * whole, evaluate=False),
        sp.Le(first, 1, evaluate=False),
        sp.Le(second, 1, evaluate=False),
        sp.Ge(share, 0, evaluate=False),
        sp.Ge(part, 0, evaluate=False),
        sp.Eq(sum_of, whole * first + second * part, evaluate=False),
    ]
    return prove(
        r"$g(t_{1/2}+s)-2g(s)\leqslant g(t_{1/2})(1-s/t_{1/2})$ (here $g=g(t_{1/2})$, $h=g(s)$, $k=g(t_{1/2}+s)$, $p=m_1g'(s)+a_1g(s)$, $r=m_1g'(t_{1/2})$, $s$ for $s/t_{1/2}$)",
        given,
        sp.Le(sum_of - 2 * part, whole * (1 - share), evaluate=False),
    )


@cache
def slipping_amplitude() -> Evidence:
    """Lower bound for every control, and the control that attains it."""
    g = sp.Symbol("g", positive=True)
    reached = (control.slipping_amplitude() - b) * g
    return argument(
        r"To arrive at $2t_{1/2}$ friction is $b$ up to $t_{1/2}$, then $-b$: so $\dot z\geqslant 0$, then $\dot z\leqslant 0$, and $v_1(t_{1/2})=bt_{1/2}/m_2$. As $v_1(t_{1/2})=\int_0^{t_{1/2}} g'(t_{1/2}-s)(u-b)\,ds\leqslant(U-b)\,g(t_{1/2})$, $U\geqslant U_{\min}$. With $u=U\geqslant U_{\min}$ up to $t_{1/2}$ at "
        r"$U_{\min}$: $g$ is concave where $g'\geqslant 0$, so $v_1=(U-b)g(t)\geqslant bt/m_2$. Then $u=-U$: $v_1=(U-b)(g(t_{1/2}+s)-2g(s))$ at the time $t_{1/2}+s$. As $m_1g'+a_1g=1-a_2\int g\leqslant 1$ and "
        r"$g(s)\geqslant g(t_{1/2})s/t_{1/2}$, $\dot z\leqslant 0$ up to $2t_{1/2}$. A larger bound of the force allows the same control. A pair that sticks at the limit from $t_{1/2}$ on has $v_1=v_2=b(2t_{1/2}-t)/m_2$, which is $0$ at $2t_{1/2}$.",
        gentle(),
        addition(),
        contact_margin(),
        identity(r"$(U_{\min}-b)\,g(t_{1/2})=bt_{1/2}/m_2$", reached, b * half_time / m2),
    )


@cache
def undamped_slipping_amplitude() -> Evidence:
    """g = sin(omega_1 t)/(m1 omega_1)."""
    return identity(
        r"for $a_1=0$, $g(t_{1/2})=\sin\theta/(m_1\omega_1)$ and $U_{\min}=b+\frac{m_1}{m_2}b\,\theta/\sin\theta$; $g'\geqslant 0$ up to $\theta=\pi/2$",
        control.undamped_slipping_amplitude(),
        b + b * m1 / m2 * angle / sp.sin(angle),
    )


@cache
def nothing_breaks() -> Evidence:
    """A weak force does not break the pair within half a turn."""
    share = sp.Symbol("c", real=True)
    return prove(
        r"$|M\ddot x_1|\leqslant U(2-\cos\Omega t)\leqslant 3U\leqslant bM/m_2$ (here $c=\cos\Omega t$)",
        [
            sp.Ge(share, -1, evaluate=False),
            sp.Le(3 * strength * m2, b * total_mass(), evaluate=False),
        ],
        sp.Le(m2 * control.pressed().subs(sp.cos(angle), share), b * total_mass(), evaluate=False),
    )


@cache
def weak_force() -> Evidence:
    """Two arcs, and a sine that no other control serves as well."""
    first, second = control.switching()
    meets = reduced / 2 + reduced**2 / 4
    return argument(
        r"In units of $U/a_2$ the pair moves about $1$ from $0$, then about $-1$ into $d\leqslant 1$; both circles meet at $X=d/2+d^2/4$. Both angles are below $\pi$. Let $T=(\alpha_1+\alpha_2)/\Omega$ and $\psi=\sin(\alpha_1-\Omega t)$, which is "
        r"positive up to the switch and negative after it. Every control that brings the stuck pair to rest at $D$ at $T$ has $\int_0^Tu\,\psi\,dt=M(\dot x\psi-x\dot\psi)|_0^T$, the same number; for this one it is $U\int|\psi|$, the largest one, so "
        r"every other control with $|u|\leqslant U$ is equal to it. One that arrives earlier could hold $D$ with $u=a_2D\leqslant U$ up to $T$ and would differ. Within $T<\pi/\Omega$ no control breaks the pair: "
        r"$a_2|x_1|\leqslant U(1-\cos\Omega t)$.",
        identity(
            r"the arcs meet on both circles, and turn by these angles",
            sp.Matrix([sp.cos(first) - (1 - meets), sp.cos(second) * (1 + reduced) - (meets + 1)]),
            sp.zeros(2, 1),
        ),
        identity(
            r"$X=d/2+d^2/4$ is on both circles",
            (1 - (meets - 1) ** 2) - ((1 + reduced) ** 2 - (meets + 1) ** 2),
            0,
        ),
        nothing_breaks(),
        stuck_force(),
    )
