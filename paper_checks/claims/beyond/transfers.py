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
