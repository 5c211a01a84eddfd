"""Steps for u = U sin(omega t): motions that always stick, that slip without a stop, and with two stops in a period."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.steps.forced_response import one_response
from paper_checks.steps.forced_rule import strict_rule, tie_rule
from theory import forced
from theory import forced_response as response
from theory.forced_response import amplitude, decayed, decline, multiple, omega, swing
from theory.model import slip, stick
from theory.symbols import a1, a2, b, m1, m2, t, total_mass, u, v1, x1


@cache
def stuck_response() -> Evidence:
    """The stuck pair's response to the sine, and the friction that it needs."""
    place = amplitude * sp.sin(omega * t) / (a2 - total_mass() * omega**2)
    undamped = sp.diff(place, t, 2) - stick().acceleration1.subs(
        {a1: 0, u: amplitude * sp.sin(omega * t), x1: place, v1: sp.diff(place, t)}, simultaneous=True
    )
    return argument(
        r"The stuck pair is one body of mass $M$: its response has $|x_1|=U/|Z|$, $Z=a_2-M\omega^2+ia_1\omega$, and needs the friction $m_2\omega^2|x_1|\leqslant b$.",
        identity(
            r"force by place of the stuck pair on $e^{i\omega t}$",
            response.stuck_impedance(),
            a2 - total_mass() * omega**2 + sp.I * a1 * omega,
        ),
        identity(r"for $a_1=0$ the response is $U\sin\omega t/(a_2-M\omega^2)$", undamped, 0),
    )


@cache
def sticks_for_ever() -> Evidence:
    """With a damper: exactly up to U*, and then all motions tend to it."""
    return argument(
        r"A motion that sticks for ever is that of one damped body, so it tends to the response and needs its friction: $U\leqslant U_*$. If so, the response is a motion, periodic, and attracts all. If $U<U_*$, "
        r"near it $|\Lambda|\leqslant b-\eta$: a slip has $s\ddot z\leqslant-\kappa\eta$ and ends, and the stick after it lasts.",
        stuck_response(),
        one_response(),
        strict_rule(),
    )


@cache
def harmonic_curve() -> Evidence:
    """cos(phi) - share cos(n phi) is largest at pi/(2 n)."""
    phi = sp.Symbol("phi", real=True)
    share = sp.sin(sp.pi / (2 * multiple)) / multiple
    curve = sp.cos(phi) - share * sp.cos(multiple * phi)
    quotient = multiple * sp.cos(multiple * phi) * sp.sin(phi) - sp.sin(multiple * phi) * sp.cos(phi)
    return argument(
        r"On $(0,\pi/2n)$ the quotient $\sin n\varphi/\sin\varphi$ falls, to $1/\sin(\pi/2n)$; beyond, $\sin n\varphi\leqslant 1<\sin\varphi/\sin(\pi/2n)$ up to $\pi/2$. So $\cos\varphi-\frac{1}{n}\sin(\pi/2n)\cos n\varphi$ rises up to "
        r"$\pi/2n$, falls from there to $0$ at $\pi/2$ ($n$ odd), and is even in $\varphi$ and odd beside $\pi/2$: its largest size is $\cos(\pi/2n)$.",
        identity(
            r"its slope is $\sin(\pi/2n)\sin n\varphi-\sin\varphi$", sp.diff(curve, phi), response.harmonic_slope()
        ),
        identity(
            r"the numerator of the quotient's rate starts at $0$ and has the rate $(1-n^2)\sin n\varphi\sin\varphi<0$",
            sp.Matrix([quotient.subs(phi, 0), sp.diff(quotient, phi)]),
            sp.Matrix([0, (1 - multiple**2) * sp.sin(multiple * phi) * sp.sin(phi)]),
        ),
        identity(
            r"at $\pm\pi/2n$ a free oscillation adds opposite values: any $A\cos n\varphi+B\sin n\varphi$ has the sum $0$ there",
            sum(
                (
                    sp.cos(multiple * one) + sp.sin(multiple * one)
                    for one in (sp.pi / 2 / multiple, -sp.pi / 2 / multiple)
                ),
                sp.S.Zero,
            ),
            0,
        ),
    )


@cache
def undamped_stuck() -> Evidence:
    """Without a damper: the response with any free oscillation."""
    return argument(
        r"A motion that sticks for ever has $\ddot x_1=-\omega^2X\sin\omega t$ and a free oscillation of frequency $\Omega$. Take the values at $\omega t=\pi/2+\pi k$ with the signs $(-1)^k$ and their mean over $k$: the first part "
        r"gives $\omega^2X$, the second one a geometric mean that tends to $0$, unless $\Omega/\omega$ is odd. So $\omega^2X\leqslant b/m_2$ is needed. If $\Omega=n\omega$, $n\geqslant 3$ odd, take $\omega t=\pi/2\pm\pi/2n$: the mean is "
        r"$\omega^2X\cos(\pi/2n)$ whatever is added, and a free oscillation attains it. If $\Omega=\omega$ the stuck motion grows like $t$.",
        stuck_response(),
        harmonic_curve(),
        _geometric(),
    )


@cache
def _geometric() -> Evidence:
    angle = sp.Symbol("psi", real=True)
    return identity(
        r"$|1-e^{i\psi}|^2=4\sin^2(\psi/2)$ with $\psi=\pi(\Omega/\omega+1)$: the ratio of the geometric mean is $1$ for odd $\Omega/\omega$ only",
        (1 - sp.cos(angle)) ** 2 + sp.sin(angle) ** 2,
        4 * sp.sin(angle / 2) ** 2,
    )


@cache
def square_wave() -> Evidence:
    """h and h' continue to a motion that is its own negative half a period later."""
    stiffness = m1 * (decline**2 + swing**2)
    place, speed = (sp.cancel(response.half_turn(one) * stiffness) for one in response.square_wave())
    c, s = (response.half_turn(one(sp.pi * swing / omega)) for one in (sp.cos, sp.sin))
    first, second = place - 1, sp.cancel((speed + decline * (place - 1)) / swing)
    later = 1 + decayed * (first * c + second * s)
    later_speed = decayed * ((swing * second - decline * first) * c - (swing * first + decline * second) * s)
    return identity(
        r"under 1 N the place $k$ and the velocity $k'$ become $-k$ and $-k'$ in half a period, by $k=\tan(\pi\omega_d/2\omega)$",
        sp.Matrix([later + place, later_speed + speed]),
        sp.zeros(2, 1),
    )


@cache
def load_positive() -> Evidence:
    """M/m2 - a2 h - a1 h' > 0: the cosine part of the limit motion is negative."""
    place, speed = response.square_wave()
    stiffness, damping = m1 * (decline**2 + swing**2), 2 * m1 * decline
    left = 1 + 2 * decayed * sp.cos(sp.pi * swing / omega) + decayed**2
    found = (-stiffness * place - damping * speed) * left
    shown = 1 - decayed**2 + 2 * decayed * decline / swing * sp.sin(sp.pi * swing / omega)
    return argument(
        r"$\delta^{-1}-\delta=2\sinh(\pi\lambda/\omega)\geqslant 2\pi\lambda/\omega\geqslant 2\frac{\lambda}{\omega_d}|\sin(\pi\omega_d/\omega)|$, so $-a_2k-a_1k'\geqslant 0$.",
        identity(
            r"$(-a_2k-a_1k')(1+2\delta\cos(\pi\omega_d/\omega)+\delta^2)=1-\delta^2+2\delta\frac{\lambda}{\omega_d}\sin(\pi\omega_d/\omega)$",
            response.half_turn(found),
            response.half_turn(shown),
        ),
    )


@cache
def non_stop() -> Evidence:
    """Permanent slip, exactly from U** on if the relative velocity keeps its sign at U**."""
    in_phase, out_of_phase = response.non_stop_parts()
    lowest = -slip(1).acceleration2 * sp.pi / omega / 2
    speed = in_phase * omega - b * response.square_speed
    return argument(
        r"In such a motion $v_2$ is a triangle wave of slopes $\pm b/m_2$, and $x_1$ a sinusoid $a\sin\omega t+c\cos\omega t$ and the response to the square wave of friction. $\dot z=0$ at the turn fixes $a$; there slip of sign 1 goes on only if $\Lambda\geqslant b$, "
        r"which is $-c\geqslant-c_*>0$ with $c_*$ where $\Lambda=b$. As $U^2G^2=a^2+c^2$, such a $c<0$ exists exactly if $U\geqslant U_{**}$. From $U_{**}$ on $\dot z$ gains $(c_*-c)\,\omega\sin\omega t\geqslant 0$, so it stays positive up to the next turn if it is at $U_{**}$, and then it is a motion by symmetry. With $a_1>0$ the response is the only "
        r"one and attracts all.",
        square_wave(),
        load_positive(),
        identity(r"$v_1=v_2$ at the turn", speed, lowest),
        identity(
            r"$\Lambda=b$ there",
            m1 * omega**2 * out_of_phase,
            a2 * b * response.square_place + a1 * b * response.square_speed - b * total_mass() / m2,
        ),
        one_response(),
        strict_rule(),
    )


@cache
def below_non_stop() -> Evidence:
    """Whatever slips for ever with the period of the force makes a motion that is its own negative half a period later."""
    return argument(
        r"Let a motion of the period $T=2\pi/\omega$ have $\dot z>0$ for half a period and $\dot z<0$ for the other. Its friction is the square wave, so half of the difference between it and itself half a period later "
        r"has the same friction and, as $u(t+T/2)=-u(t)$, the same force; its relative velocity keeps the sign, and it is its own negative half a period later. At its turn $\Lambda\geqslant b$, which needs "
        r"$U\geqslant U_{**}$ whatever $\dot z$ does at $U_{**}$.",
        square_wave(),
        non_stop(),
    )


@cache
def over_damped() -> Evidence:
    """The closed forms hold for a body 1 that does not oscillate."""
    nu = sp.Symbol("nu", positive=True)
    return argument(
        r"The steps are identities in $\lambda$ and $\omega_d$, so they hold for $\omega_d=i\nu$, where $\cos$ and $\frac{1}{\omega_d}\sin$ become $\cosh$ and $\frac1\nu\sinh$: real, and all terms of "
        r"$1-\delta^2+2\delta\frac\lambda\nu\sinh\frac{\pi\nu}{\omega}$ and $1+2\delta\cosh\frac{\pi\nu}{\omega}+\delta^2$ positive. At $\omega_d=0$ they have limits, to which the conditions tend.",
        identity(
            r"$\cos(i\nu)=\cosh\nu$ and $\sin(i\nu)/(i\nu)=\sinh(\nu)/\nu$",
            sp.Matrix([sp.cos(sp.I * nu) - sp.cosh(nu), sp.sin(sp.I * nu) / (sp.I * nu) - sp.sinh(nu) / nu]),
            sp.zeros(2, 1),
        ),
        non_stop(),
        below_non_stop(),
    )


@cache
def undamped_non_stop() -> Evidence:
    """The square wave's response without a damper."""
    place, speed = (one.subs(decayed, 1).subs(decline, 0) for one in response.square_wave())
    turn = sp.tan(sp.pi * swing / (2 * omega))
    return identity(
        r"for $a_1=0$ ($\lambda=0$, $\delta=1$, $\omega_d=\omega_1$): $k=0$ and $k'=-\tan(\pi\omega_1/2\omega)/(m_1\omega_1)$",
        sp.Matrix([place, sp.cancel(speed.rewrite(sp.tan) + turn / (m1 * swing))]),
        sp.zeros(2, 1),
    )


@cache
def keeps_its_sign() -> Evidence:
    """Without a damper and above omega_1 the relative velocity is positive between the turns at U**."""
    rho, psi = sp.Symbol("rho", positive=True), sp.Symbol("psi", positive=True)
    above, below = sp.sin(rho * psi) + rho * sp.sin(psi), sp.cos(rho * psi) - sp.cos(psi)
    slope = sp.diff(above, psi) * below - above * sp.diff(below, psi)
    in_phase, out_of_phase = (one.subs({a1: 0, response.square_place: 0}) for one in response.non_stop_parts())
    return argument(
        r"Let $\rho=\omega_1/\omega<1$ and $\varphi=\omega t-\pi/2$. Then $\frac{m_1\omega}{b}\dot z$ is $\cos\varphi-\frac{\sin\rho\varphi-\sin(\pi\rho/2)\sin\varphi}{\rho\cos(\pi\rho/2)}$ and $\frac{m_1}{m_2}$ times $\cos\varphi+\frac\pi2\sin\varphi-\varphi$. "
        r"With $\psi=\pi/2-|\varphi|$ the second is at least $\sin\psi-\psi+\frac\pi2(1-\cos\psi)$ for one sign, and more for the other; it is positive as $(\psi-\sin\psi)/(1-\cos\psi)\leqslant\frac\pi2-1$. The first is positive if "
        r"$\tan(\pi\rho/2)<R$, $R=\frac{\sin\rho\psi+\rho\sin\psi}{\cos\rho\psi-\cos\psi}$; $R$ falls to $\tan(\pi\rho/2)+\rho/\cos(\pi\rho/2)$ at $\psi=\pi/2$.",
        identity(
            r"the slope of $R$ has the numerator $-(1-\rho^2)\sin\rho\psi\sin\psi<0$",
            slope,
            -(1 - rho**2) * sp.sin(rho * psi) * sp.sin(psi),
        ),
        identity(
            r"the parts of $x_1$ are $a\omega=bk'-\pi b/2m_2\omega$ and $-c\,m_1\omega^2=bM/m_2$",
            sp.Matrix([in_phase * omega, -out_of_phase * m1 * omega**2]),
            sp.Matrix([b * response.square_speed - sp.pi * b / (2 * m2 * omega), b * total_mass() / m2]),
        ),
        undamped_non_stop(),
    )


@cache
def two_stops() -> Evidence:
    """The linear conditions of a slip and a stick in half a period."""
    return argument(
        r"The flows of slip and stick are linear in the state and in $U_{\sin}$, $U_{\cos}$, so the conditions are. A solution with $\dot z>0$ in the slip and $|\Lambda|\leqslant b$ in the stick obeys the mode rule over half a period, and by symmetry for ever; without one of them it does not.",
        tie_rule(),
        strict_rule(),
    )


@cache
def two_ends() -> Evidence:
    """Both ends of the branch of two stops."""
    first, second = response.short_slip()
    load_rate = sp.Symbol(r"\dot{\Lambda}", real=True)
    return argument(
        r"At $t_s=\pi/\omega$ the end is the next turn, $v_1=-v_0$. As $t_s\to 0$, $\dot z(t_s)/t_s^2\to\dddot z(0)/2=0$: the load is $b$ and turns there, as on the stuck response of amplitude $U_*$.",
        identity(
            r"where $\Lambda=b$, $\ddot z=0$ and $\dddot z=\kappa\dot\Lambda$",
            sp.Matrix([first, second]),
            sp.Matrix([0, forced.coupling() * load_rate]),
        ),
        identity(
            r"at $t_s=\pi/\omega$ the end gives $v_0=-\pi b/(2m_2\omega)$",
            response.two_stop_conditions()[2],
            -2 * (response.exit_speed + sp.pi * b / (2 * m2 * omega)),
        ),
        non_stop(),
    )
