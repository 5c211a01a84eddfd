"""Steps of the written-out arguments about all trajectories, each a checked identity or inequality.

Rows of the ledger name them. They hold for all m1, m2, a2, b > 0 and, where a1 appears, for all a1 >= 0.
"""

from __future__ import annotations

import sympy as sp

from paper_checks.evidence import Evidence
from paper_checks.exact import identity
from paper_checks.polynomial import cleared
from paper_checks.smt import prove
from theory.energy import (
    contraction_rate,
    contraction_terms,
    critical_energy,
    dwell_time_bound,
    energy,
    on_surface,
    sigma,
    sigma_other,
)
from theory.filippov import derivative_along, half_width, phi, transversality
from theory.model import free_system
from theory.symbols import E0, a1, a2, b, m1, m2, v1, v1_other, v2, v2_other, x1


def energy_decreases() -> list[Evidence]:
    """dE/dt = -b sigma (v1 - v2) - a1 v1^2 for every value of set-valued friction, and that is never positive."""
    rate = derivative_along(free_system(sigma), energy())
    return [
        identity(
            r"$\dot E=-b\,\sigma\,(v_1-v_2)-a_1v_1^2$ for every $\sigma$ that set-valued friction may take, so "
            r"$\dot E=-b|v_1-v_2|-a_1v_1^2$",
            rate,
            -b * sigma * (v1 - v2) - a1 * v1**2,
        ),
        prove(
            r"$\sigma(v_1-v_2)=|v_1-v_2|\geqslant 0$ with $\sigma\in\mathrm{Sign}(v_1-v_2)$",
            _set_valued_sign(sigma, v1 - v2),
            sp.Ge(sigma * (v1 - v2), 0, evaluate=False),
        ),
    ]


def _set_valued_sign(value: sp.Symbol, relative: sp.Expr) -> list[sp.Basic]:
    """Return the conditions for `value` in Sign(relative)."""
    return [
        sp.Le(value, 1),
        sp.Ge(value, -1),
        sp.Or(sp.Le(relative, 0), sp.Ge(value, 1)),
        sp.Or(sp.Ge(relative, 0), sp.Le(value, -1)),
    ]


def contraction() -> list[Evidence]:
    """Two solutions never move apart in the energy norm: forward uniqueness, continuity, stability of every orbit."""
    relative, relative_other = v1 - v2, v1_other - v2_other
    viscous, friction = contraction_terms()
    value, value_other, first, second = sp.symbols("sigma sigma_other z_rate z_rate_other", real=True)
    return [
        identity(
            r"half the squared energy distance of two solutions changes at the rate $-a_1(v_1-\tilde v_1)^2"
            r"-b(\sigma-\tilde\sigma)((v_1-v_2)-(\tilde v_1-\tilde v_2))$",
            contraction_rate(),
            -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (relative - relative_other),
        ),
        identity("the two terms are the whole rate", contraction_rate(), viscous + friction),
        prove(
            r"the set-valued sign is monotone: $(\sigma-\tilde\sigma)((v_1-v_2)-(\tilde v_1-\tilde v_2))\geqslant 0$",
            [*_set_valued_sign(value, first), *_set_valued_sign(value_other, second)],
            sp.Ge((value - value_other) * (first - second), 0, evaluate=False),
        ),
    ]


def meets_surface() -> list[Evidence]:
    """A stay in one half-space lasts at most 2 sqrt(2 E m2)/b: body 2 accelerates steadily, its energy is bounded."""
    gained = sp.Symbol("k", nonnegative=True)  # v2 gained during the stay
    bound = [sp.Le(m2 * speed**2, 2 * E0) for speed in (v2, v2 + gained)]
    return [
        identity(r"$\dot v_2=b/m_2$ in $\Omega_+$", phi(1)[2], b / m2),
        identity(r"$\dot v_2=-b/m_2$ in $\Omega_-$", phi(-1)[2], -b / m2),
        prove(
            r"$m_2v_2^2\leqslant 2E$",
            [sp.Le(2 * energy(), 2 * E0)],
            sp.Le(m2 * v2**2, 2 * E0),
        ),
        prove(
            r"$m_2v_2^2\leqslant 2E$ before and after lets $v_2$ gain at most $\sqrt{8E/m_2}$",
            bound,
            sp.Le(m2 * gained**2, 8 * E0),
        ),
        identity(
            r"so a stay in $\Omega_\pm$ lasts at most $2\sqrt{2Em_2}/b$",
            dwell_time_bound(),
            2 * sp.sqrt(2 * E0 * m2) / b,
        ),
    ]


def stays_below_critical() -> Evidence:
    """On S, E <= E_cr implies |x1| <= L: the pair can only stick, for ever, as E never increases."""
    level = sp.Le(cleared(on_surface() - critical_energy()), 0, evaluate=False)
    return prove(
        r"on $S$, $E\leqslant E_{cr}$ implies $|x_1|\leqslant L$",
        [level],
        sp.Le(cleared(x1**2 - half_width() ** 2), 0, evaluate=False),
    )


def leaves_above_critical() -> list[Evidence]:
    """No trajectory stays on S with E > E_cr: outside S0 both fields leave, in S0 the level reaches an exit ray."""
    above = sp.Gt(cleared(on_surface() - critical_energy()), 0, evaluate=False)
    within = [sp.Le(cleared(side * x1 - half_width()), 0, evaluate=False) for side in (1, -1)]
    outside = sp.Gt(cleared(x1 - half_width()), 0, evaluate=False)
    return [
        prove(
            r"in $S_0$ with $E>E_{cr}$: $v_1\neq 0$, so $x_1$ runs monotonically to an edge",
            [above, *within],
            sp.Ne(v1, 0, evaluate=False),
        ),
        prove(
            r"$\Phi_\pm\cdot n_S<0$ on $S_+$ (on $S_-$ by the mirror image): no stay on $S$ outside $S_0$",
            [outside],
            sp.And(*(sp.Lt(cleared(transversality(sign)), 0, evaluate=False) for sign in (1, -1))),
        ),
    ]


def acceleration_bound() -> list[Evidence]:
    """|z''| is bounded on {E <= E0}, so |z'| is Lipschitz: with a finite integral it tends to 0 (Barbalat)."""
    rate = derivative_along(free_system(sigma), v1 - v2)
    level = [sp.Le(2 * energy(), 2 * E0)]
    return [
        identity(
            r"$\ddot z=-(a_2x_1+a_1v_1)/m_1-b\,\sigma\,(m_1+m_2)/(m_1m_2)$ with $|\sigma|\leqslant 1$",
            rate,
            -(a2 * x1 + a1 * v1) / m1 - b * sigma * (m1 + m2) / (m1 * m2),
        ),
        prove(r"$a_2x_1^2\leqslant 2E_0$", level, sp.Le(a2 * x1**2, 2 * E0)),
        prove(r"$m_1v_1^2\leqslant 2E_0$", level, sp.Le(m1 * v1**2, 2 * E0)),
    ]
