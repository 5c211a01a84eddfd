"""Motions with two stops in a period next to both thresholds, and whether there is only one."""

from paper_checks.claims.beyond.response import undamped_attraction
from paper_checks.claims.beyond.stuck import tends_to_stuck
from paper_checks.claims.words import *
from theory import forced_response as response


@cache
def only_one() -> Evidence:
    """Without a damper two motions with the same forces differ by a free oscillation that both slip and stick must close."""
    return argument(
        r"""
        A limit $\zeta$ of another motion has equal loads at the exit, so equal $x_1$, and both velocities differ by one
        $\beta$; in the slip $v_1-\tilde v_1=\beta\cos\omega_1t$, and $\beta(\cos\omega_1t_s-1)=0$ at its end. If
        $\beta\neq 0$, again only the velocities differ there, by $\beta$, and $\zeta$ sticks while the other does. At the next
        exit the loads agree again, so the places do: $\frac\beta\Omega\sin\Omega t=0$ after the stick.
        """,
        undamped_attraction,
    )


@cache
def near_first() -> Evidence:
    """Short slips: their conditions tend to those of U*, and what has to be positive is."""
    return argument(
        r"""
        With the condition at the end divided by $t_s^2$ the four conditions are analytic in $t_s$ from $0$ on, where they ask
        for a stuck response with $\Lambda=b$, $\dot\Lambda=0$: they have one solution, so they do for small $t_s$, and it is
        continuous. In the slip $\dot z$ has a double zero at the exit and one at $t_s$, so $\dot z=s^2(t_s-s)Q$ with $6Q$
        a mean of $-\ddddot z$, which tends to $\kappa\omega^2b$: as $\dot\Lambda\to 0$ at the exit, slip and stick have one
        $\ddot\Lambda$ there in the limit. So $\dot z>0$; $\dot\Lambda>0$ at the exit; and $\Lambda<b$ and $\dot\Lambda<0$, of
        the order $t_s$, at the end, where $\dot v_1$ jumps by the order $t_s^2$ only. In the stick $\Lambda$ is near
        $b\cos\omega t$: inside $\pm b$ but near both ends, where $\ddot\Lambda$ is near $\mp\omega^2b$, so that it falls from
        below $b$ at the one and comes down to $-b$ at the other, its rate there being minus that at the exit. So it is
        a motion. Its $U$ exceeds $U_*$, since up to $U_*$ no motion that slips comes back; so all $U$ slightly above $U_*$
        are taken.
        """,
        identity(r"where $\Lambda=b$, $\ddot z=0$ and $\dddot z=\kappa\dot\Lambda$", response.short_slip()[0]),
        same_load_rate,
        tends_to_stuck,
        kernel.step("entrains"),
        kernel.step("two-stop-exists"),
    )


@cache
def same_load_rate() -> Evidence:
    """Slip and stick have one rate of the load where one goes over into the other with the load b."""
    gap = slip(1).acceleration1 - stick().acceleration1
    return identity(
        r"$\dot v_1$ in slip exceeds that in stick by $(\Lambda-b)/m_1$: with $\Lambda=b$ the load has one rate at an exit",
        gap,
        (forced.load() - b) / m1,
    )


@cache
def near_last() -> Evidence:
    """Short sticks: their conditions tend to those of U**, where the slip is positive with simple ends."""
    return argument(
        r"""
        At $t_s=\pi/\omega$ the conditions are those of $U_{**}$, with one solution; so they have one for $t_s$ near it, and it
        is continuous. At $U_{**}$ the slip has $\dot z=\ddot z=0$, $\dddot z=\kappa\dot\Lambda>0$ at its start,
        $\ddot z=-2\kappa b$ at its end, where $\Lambda=-b$, and $\dot z>0$ between: $\dot z/(s^2(t_s-s))$ is positive on the
        closed slip, and remains so. The stick ends with $\Lambda=-b$ and a $\dot\Lambda$ near minus that at the exit, so
        negative: in a short stick $-b\leqslant\Lambda<b$. So it is a motion. Its $U$ is below $U_{**}$, since from
        $U_{**}$ on there is a motion without a stop, and the one with two stops, whose $\omega_1t_s$ is no multiple of
        $2\pi$ for $t_s$ near $\pi/\omega$, would attract it. So all $U$ slightly below $U_{**}$ are taken.
        """,
        identity(
            r"in slip $\ddot z=\kappa(\Lambda-b)$, so $-2\kappa b$ where $\Lambda=-b$",
            forced.relative_rate(1),
            forced.coupling() * (forced.load() - b),
        ),
        same_load_rate,
        only_one,
        kernel.step("two-stop-exists"),
        kernel.step("periodic-response"),
    )
