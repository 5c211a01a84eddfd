"""Steps on moving body 2 by a force on body 1: friction is all that it feels."""

from paper_checks.claims.words import *
from theory import forced_control as control


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
