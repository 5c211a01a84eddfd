"""Steps towards the dichotomy: the pair turned back by the angle of stick converges, and above E_cr each turn has a cost."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.polynomial import cleared
from paper_checks.solvers.smt import prove
from paper_checks.steps import capture, dissipation
from theory.energy import energy, sigma
from theory.filippov import half_width
from theory.symbols import a2, distance, m1, x1
from theory.turned_back import claimed_rates, energy_parts, rates, relative_rate


@cache
def converges() -> Evidence:
    """The state tends to a rotation of the pair as one body."""
    return argument(
        "The pair tends to a rotation: $b\\int_0^\\infty|v_1-v_2|\\,dt\\leqslant E(0)$, so $A$ and $B$, whose rates it bounds, have "
        "limits; and $v_1-v_2$, a Lipschitz function whose integral is finite, tends to 0. So $(x_1,P/(M\\Omega))$ approaches a "
        "rotation of one radius $R$ with the angular frequency $\\Omega$, and $E\\to\\frac{1}{2}a R^2$.",
        *capture.energy_decreases(),
        identity(
            r"with $P=m_1v_1+m_2v_2$, the point $(x_1,P/(M\Omega))$ turned back by $\Omega t$ moves at the rate "
            r"$\frac{m_2}{M}(v_1-v_2)\,(\cos\Omega t,\sin\Omega t)$ for every value of friction",
            sp.Matrix(rates()),
            sp.Matrix(claimed_rates()),
        ),
        identity(
            r"$2E=a(A^2+B^2)+\frac{m_1m_2}{M}(v_1-v_2)^2$: the pair as one body, and the relative motion",
            energy_parts(),
            2 * energy(),
        ),
        dissipation.price_of_relative_speed(),
    )


@cache
def each_turn_has_a_cost() -> Evidence:
    """R > L is impossible."""
    beyond = [
        sp.Ge(cleared(x1 - half_width() - distance), 0, evaluate=False),
        sp.Ge(sigma, -1),
        sp.Le(sigma, 1),
        sp.Gt(distance, 0),
    ]
    falls = sp.Le(cleared(relative_rate() + a2 * distance / m1), 0, evaluate=False)
    return argument(
        "$R\\leqslant L$: otherwise $x_1$ exceeds $L+\\delta$ for a fixed time in every turn, from some time on. There $v_1-v_2$ "
        "falls at least at the rate $a\\delta/m_1$, so $|v_1-v_2|$ is above a fixed value for a fixed part of that time: each of "
        "infinitely many turns costs a fixed energy, and there is only $E(0)$.",
        converges(),
        prove(
            r"where $x_1\geqslant L+d$, $\dot v_1-\dot v_2\leqslant-a\,d/m_1$ for every value of friction in $[-1,1]$",
            beyond,
            falls,
        ),
        capture.mirror_image(),
    )


@cache
def merges_or_creeps() -> Evidence:
    """Merging in finite time, or the critical orbit."""
    return argument(
        "If $E\\leqslant E_{cr}$ at some time, the next contact with $S$, within a bounded time, is in $S_0$, and the pair sticks "
        "from there on for ever: it merges. Otherwise $\\frac{1}{2}aR^2=\\lim E\\geqslant E_{cr}=\\frac{1}{2}aL^2$, so $R=L$: the "
        "trajectory tends to one motion on the critical ellipse.",
        each_turn_has_a_cost(),
        contact_again(),
        capture.stays_below_critical(),
        stays_stuck(),
    )


@cache
def contact_again() -> Evidence:
    """S is met in every window of a bounded length."""
    return argument(
        "The switching surface is met again and again: a stay in one half-space lasts at most $2\\sqrt{2Em_2}/b$, as $v_2$ changes "
        "there at a constant rate and is bounded by the energy.",
        *capture.meets_surface(),
        *capture.energy_decreases(),
    )


@cache
def stays_stuck() -> Evidence:
    """On S with E <= E_cr sticking for ever is a solution, and the only one."""
    return argument(
        "Sticking on the ellipse is a solution, as it needs no more force than friction gives; no other one starts there, as two "
        "solutions never move apart.",
        capture.stays_below_critical(),
        capture.stick_is_a_motion(),
        *capture.contraction(),
    )
