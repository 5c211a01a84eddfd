"""Section III, its end: the pair with a damper, and the itineraries of Fig. 3."""

import sympy as sp

from paper_checks.engines.deciders import condition, equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from theory.closed_forms import discriminant
from theory.energy import energy
from theory.filippov import derivative_along
from theory.model import free_system
from theory.symbols import a1, a2, b, m1, m2, v1, v2

SECTION = "III"


def _underdamped() -> Formula:
    """Return the condition under which stick is a decaying oscillation."""
    return Formula(
        a1**2, "<", 4 * a2 * (m1 + m2), condition(lambda: sp.Lt(a1**2, a1**2 - discriminant("stick"))), sharp=True
    )


VISCOUS = (
    Claim(
        "viscous-energy-rate",
        SECTION,
        "last paragraph",
        (
            clause(
                "rate",
                r"With viscous friction, the counterpart of (8) reads «rate».",
                rate=Formula(
                    r"\dot{E}",
                    "=",
                    -b * sp.Abs(v1 - v2) - a1 * v1**2,
                    equals(lambda: derivative_along(free_system(sp.Abs(v1 - v2) / (v1 - v2)), energy())),
                ),
                kernel=("energy-rate",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "viscous-origin-stable",
        SECTION,
        "last paragraph",
        r"When a relatively small viscous friction is present, the switching dynamics is similar but the "
        r"trajectories inside the sliding region spiral towards the equilibrium at the origin, which is "
        r"globally stable in this case.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "origin",
                r"For every $a_1>0$ the origin is globally asymptotically stable;",
                kernel=("viscous-decay", "viscous-rest"),
            ),
            clause(
                "ends",
                r"the switching does not go on: every trajectory sticks for ever from a finite time on, while without a damper "
                r"whole families stick and slip in turn for ever;",
                kernel=("viscous-rest", "no-merging-from-S0"),
            ),
            clause(
                "spiral",
                r"inside the sliding region the motion is a spiral towards the origin exactly if «small».",
                small=_underdamped(),
            ),
        ),
    ),
)

ITINERARIES = (
    Claim(
        "itinerary-that-merges",
        SECTION,
        "Fig. 3 (a)",
        r"A trajectory enters the sliding region $S_0$ of $S$ and merges with one of the elliptic closed "
        r"trajectories located in $S_0$; its energy satisfies $E<E_{cr}$.",
        Verdict.HOLDS,
    ),
    Claim(
        "itinerary-that-creeps",
        SECTION,
        "Fig. 3 (b)",
        (
            clause(
                "points",
                r"A trajectory that starts at $O_1\in\Omega_+$ crosses $S$ at $A_1\in S_+$ into $\Omega_-$ and at "
                r"$B_1\in S_-$ back into $\Omega_+$, enters $S_0$ at $A_2$, exits through $C_1\in\ell_+$ into "
                r"$\Omega_-$, re-enters $S_0$ at $B_2$, exits through $D_1\in\ell_-$ into $\Omega_+$, re-enters "
                r"$S_0$ at $A_3$ and proceeds inside $S_0$ to $O_2$.",
            ),
            clause("creeps", r"Continued, it converges asymptotically to the elliptic trajectory of energy $E_{cr}$."),
        ),
        Verdict.HOLDS,
    ),
)
