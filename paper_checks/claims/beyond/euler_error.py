"""How far forward Euler is from the motion, whatever it takes for the sign at rest."""

from paper_checks.claims.beyond.static_friction import slip_rate
from paper_checks.claims.words import *


@theorem(
    "euler-error",
    clause(
        "law",
        r"""
        Let $u=0$ and $a_1\geqslant 0$, and let forward Euler take steps of $h$ with a friction in $[-b,b]$ that is
        $b\,\mathrm{sgn}(\dot z)$ where $\dot z\neq 0$. Its distance $N$ in the energy norm from a motion,
        $N^2=a_2\Delta x_1^2+m_1\Delta v_1^2+m_2\Delta v_2^2$, satisfies at the time $t$ of a step
        $N(t)^2\leqslant N(0)^2+h\,t\,C\,(C+C')$, where $C$ is the largest speed of its steps in this norm, and the motion
        moves at most at the speed $C'$ in it.
        """,
        kernel="euler-law",
    ),
    assuming=f"{POSITIVE} No force, $u=0$, $b$ constant; with or without a damper, $a_1\\geqslant 0$.",
)
def euler_error() -> Case:
    """The error of a step does not add up linearly, and is not forgotten."""
    return because(
        r"""
        The error of forward Euler is of the order $\sqrt{ht}$ at most: it converges, but slowly. Friction never enlarges
        the distance of two motions, but a step of Euler uses the friction and the forces at its beginning. Near $\dot z=0$
        that friction is off by up to $2b$, however small the step.
        """,
        slip_rate(),
    )
