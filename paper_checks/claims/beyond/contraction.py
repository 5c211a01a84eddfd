"""Two motions under one force never move apart: uniqueness, other forces, a friction that changes with time."""

from paper_checks.claims.letters import DISTANCE
from paper_checks.claims.section_3 import filippov
from paper_checks.claims.words import *


def _quotable() -> dict[Basic, Basic]:
    """Return what N stands for, and letters without a tilde for the second solution."""
    letters = {one: Symbol(f"{one.name[-4]}_k{one.name[-1]}", real=True) for one in (x1_other, v1_other, v2_other)}
    return {DISTANCE: sqrt(forced.distance_squared().subs(letters)), **letters}


@theorem(
    "forced-contraction",
    clause(
        "energy",
        r"Under a force «rate», where $\sigma$ is the value of $\mathrm{sign}(\dot z)$, in $[-1,1]$ where $\dot z=0$.",
        rate=equal(r"\dot E", u * v1 - a1 * v1**2 - b * sigma * (v1 - v2), forced.energy_rate),
        kernel="forced-energy-rate",
    ),
    clause(
        "rate",
        r"Two solutions under one force, the second with tildes, have «squared» and «rate» $\leqslant 0$,",
        squared=equal(
            DISTANCE**2,
            a2 * (x1 - x1_other) ** 2 + m1 * (v1 - v1_other) ** 2 + m2 * (v2 - v2_other) ** 2,
            forced.distance_squared,
        ),
        rate=equal(
            r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
            -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (v1 - v2 - v1_other + v2_other),
            forced.contraction_rate,
        ),
    ),
    clause("distance", r"so their distance $N$ never grows.", kernel="forced-contraction"),
    clause(
        "unique",
        r"For every force with a continuous impulse $\int u\,dt$ there is exactly one solution from every initial state.",
        kernel="forced-well-posed",
    ),
    clause(
        "forces",
        r"Under two forces that are continuous except for jumps $N(t)\leqslant N(0)+m_1^{-1/2}\int_0^t|u-\tilde u|\,ds$, as «speed».",
        speed=Formula(
            m1 * (v1 - v1_other) ** 2,
            "<=",
            DISTANCE**2,
            implied(where=_quotable),
        ),
        kernel="interface-input-to-state interface-one-strength",
    ),
    clause(
        "interface",
        r"""
        With a friction of at most $b(t)\geqslant 0$ that is the right derivative of a continuous function, for example
        constant on pieces of time, finitely many in every bounded time interval, there is exactly one solution from every
        initial state, too, and the distance of two never grows.
        """,
        kernel="interface-well-posed interface-contraction interface-one-strength",
    ),
    clause(
        "interface-rates",
        r"""
        The rates of the energy and of $N^2$ hold with $b(t)$ in place of $b$, and the bound under two forces holds as it is.
        """,
        kernel="interface-energy-rate interface-distance-rate interface-input-to-state",
    ),
    assuming=UNDER_A_FORCE,
)
def forced_contraction() -> Case:
    """The force cancels in the distance of two solutions."""
    return because(
        "Under any force the flow is non-expansive in the energy norm: the force cancels in the difference of two motions. Friction that depends on position would not cancel: the friction of one solution is then not a monotone function of its own relative velocity alone.",
        carried("rate", filippov.never_apart),
    )
