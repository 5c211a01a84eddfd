"""The level sets of the energy on the switching surface: the critical one, and the arcs above it."""

from paper_checks.claims.letters import in_strip
from paper_checks.claims.section_3 import capture
from paper_checks.claims.words import *
from theory.energy import level_semi_axis

LEVEL = b**2 * (m1 + m2) ** 2 / (2 * a2 * m2**2)


@claim(
    "critical-energy",
    "III",
    "after (10)",
    HOLDS,
    clause(
        "closed",
        r"For $E_0\leqslant E_{cr}$, «level», the intersection $\{E=E_0\}\cap S_0$ is a closed elliptic trajectory;",
        level=equal("E_{cr}", LEVEL, critical_energy),
        kernel="ellipse-iff",
    ),
    clause("above", r"for $E_0>E_{cr}$ it is not.", kernel="ellipse-iff"),
)
def critical_energy_claim() -> Case:
    """Prove the condition and its converse."""
    return because(
        r"""
        The ellipse $\{E=E_0\}\cap S$ has the semi-axis $\sqrt{2E_0/a_2}$ along $x_1$; it lies in $S_0$ exactly if that
        is at most $L$. At $E_0=0$ the ellipse is the equilibrium, which the paper counts among the periodic
        trajectories.
        """,
        capture.stays_below_critical,
        carried(
            "above",
            prove(
                "conversely $E_0>E_{cr}$ puts the end of the semi-axis beyond $L$",
                [signed(E0 - critical_energy(), ">")],
                signed(level_semi_axis() ** 2 - half_width() ** 2, ">"),
            ),
        ),
        figure="ellipse-in-strip",
    )


@claim(
    "supercritical-arcs",
    "III",
    "after (10)",
    HOLDS,
    clause(
        "arcs",
        r"""
        For $E_0>E_{cr}$ the intersection $\{E=E_0\}\cap S_0$ consists of two disjoint elliptic arcs, each being a
        part of a trajectory.
        """,
        kernel="two-arcs",
    ),
    clause(
        "exits",
        r"One of these trajectories exits $S_0$ through the ray $\ell_-$ into $\Omega_+$,",
        kernel="two-arcs arc-to-left-ray slips-on-ray",
    ),
    clause("other", r"the other through the ray $\ell_+$ into $\Omega_-$.", kernel="two-arcs"),
)
def supercritical_arcs() -> Case:
    """Two arcs, each left by its ray into the half-space that the paper names."""
    above = signed(on_surface() - critical_energy(), ">")
    return because(
        r"""
        Above $E_{cr}$ no point of the level in $S_0$ has $v_1=0$, so it falls into an arc with $v_1>0$, which runs to
        $\ell_+$, and one with $v_1<0$, which runs to $\ell_-$. On $\ell_+$ the field $\Phi_-$ touches $S$ and curves
        into $\Omega_-$, while $\Phi_+$ points into $\Omega_-$ too: the exit is the only motion.
        """,
        prove("on $S_0$ with $E>E_{cr}$: $v_1\\neq 0$", [above, *in_strip()], sp.Ne(v1, 0, evaluate=False)),
    )
