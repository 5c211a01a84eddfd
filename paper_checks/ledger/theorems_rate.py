"""Past the paper: how fast a trajectory that never merges tends to the critical energy."""

from __future__ import annotations

import sympy as sp

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence
from paper_checks.ledger.section3_convergence import sharp_limit
from paper_checks.ledger.theorem import R, of_share, theorem
from theory.long_time import balanced_share, leading_coefficient, logarithm_weight, map_coefficients
from theory.rate_bounds import (
    cycle_times,
    elapsed,
    excess_bounds,
    first_angle,
    first_depth,
    first_excess,
    gains,
)
from theory.return_map import depth
from theory.symbols import q, tau, theta, w
from theory.symbols import r as share_of_q
from theory.uniform_rate import (
    crossing_loss,
    crossings,
    crossings_bound,
    first_contact_bound,
    gain,
    late,
    upper_bound,
)

RHO, LATE_TIME, CONTACT, LOSS = sp.symbols("rho tau^* tau_1 l", positive=True)
DEPTH = sp.Function("c")


def _of_error(formula: Formula) -> Evidence:
    from paper_checks.steps.rate_with_error import bounds_error

    return bounds_error(formula)


def _depths() -> dict[sp.Basic, sp.Basic]:
    """Return what the letters r and c(...) of the least loss stand for."""
    angle = 2 * sp.acot(q * (sp.sqrt(first_excess) + sp.pi / 2))
    return {R: share_of_q, DEPTH(angle): depth().subs(theta, angle)}


RATES = (
    theorem(
        "sharp-rate-constant",
        clause(
            "limit",
            r"Along every trajectory that never merges «limit» as $t\to\infty$: a limit, the same for every $E(0)$.",
            limit=sharp_limit(),
            kernel=("sharp-law",),
        ),
    ),
    theorem(
        "rate-bounds-explicit",
        clause(
            "bounds",
            r"Let the pair leave $S_0$ by a ray at $t_0$ with $w_0=q\,y_0$, $y_0\leqslant(\pi/2-1)^2$, $h(\theta_0)^2=y_0$, "
            r"$c_0=c(\theta_0)$. Then for all $t\geqslant t_0$, with $s=\Omega(t-t_0)$, $w=E/E_{cr}-1$ lies between «lower» and «upper»,",
            lower=Formula(
                r"w_-",
                "=",
                q / (1 / first_excess + sp.Symbol("A") * (elapsed / sp.Symbol("T_-") + 1)),
                equals(
                    lambda: excess_bounds()[0],
                    lambda: {sp.Symbol("A"): gains()[1], sp.Symbol("T_-"): cycle_times()[0]},
                ),
            ),
            upper=Formula(
                r"w_+",
                "=",
                q / (1 / first_excess + sp.Symbol("a'") * (elapsed / sp.Symbol("T_+") - 1)),
                equals(
                    lambda: excess_bounds()[1],
                    lambda: {sp.Symbol("a'"): gains()[0], sp.Symbol("T_+"): cycle_times()[1]},
                ),
            ),
        ),
        clause(
            "constants",
            r"where «slowest», «fastest», «longest», «shortest».",
            slowest=of_share("a'", R * first_depth**2 / first_excess**2, lambda: gains()[0]),
            fastest=of_share("A", 9 * R / 4 / (1 - R * first_depth**2 / first_excess), lambda: gains()[1]),
            longest=Formula("T_+", "=", sp.pi + sp.sqrt(q) * first_angle, equals(lambda: cycle_times()[1])),
            shortest=Formula(
                "T_-",
                "=",
                sp.pi - sp.sqrt(q) * (first_angle - sp.sqrt(first_excess)) * q * first_depth / (1 - q * first_depth),
                equals(lambda: cycle_times()[0]),
            ),
        ),
    ),
)

LATE = (
    theorem(
        "long-time-expansion",
        clause(
            "expansion",
            r"With $\tau=\Omega t$, at the exits of a trajectory that never merges, $w=\frac{C}{\tau}\Bigl(1-\frac{\pi "
            r"B\ln(\alpha\tau/\pi)+K}{\tau}+O(\tau^{-3/2})\Bigr)$ with «leading», «alpha», «weight» and one number $K$ that alone "
            r"depends on the start. At other times the time to the next exit is added to $K$ during stick.",
            leading=of_share("C", 4 * sp.pi * q / (9 * R), leading_coefficient),
            alpha=of_share(r"\alpha", sp.Rational(9, 4) * R, lambda: map_coefficients()[0]),
            weight=of_share("B", 1 - 2 / (5 * R), logarithm_weight),
        ),
        clause(
            "balanced",
            r"The logarithm vanishes for «ratio».",
            ratio=Formula("m_1/m_2", "=", sp.Rational(3, 2), equals(lambda: 1 / balanced_share() - 1)),
        ),
    ),
)

UNIFORM = (
    theorem(
        "rate-with-error",
        clause(
            "error",
            r"Let the pair leave $S_0$ by a ray at $\tau=\Omega t=0$ with $w_0=q\,y_0$, $y_0\leqslant(\pi/2-1)^2$. With «leading» and «weight», "
            r"at the $n$-th exit after it, at $\tau_n$, $\frac{C}{w_n}+\pi B\ln\frac{w_n}{w_0}=\frac{C}{w_0}+\tau_n+R_n$ with «lower» and "
            r"«upper» for all $n$.",
            leading=of_share("C", 4 * sp.pi * q / (9 * R), leading_coefficient),
            weight=of_share("B", 1 - 2 / (5 * R), logarithm_weight),
            lower=Formula("R_n", ">=", -sp.Rational(9, 20) * (first_excess + sp.sqrt(first_excess)) / R, _of_error),
            upper=Formula("R_n", "<=", (5 * first_excess + sp.sqrt(first_excess) / 10) / R, _of_error),
        ),
        open=(
            "Whether the factor $1/r$ of these bounds is needed: in the numbers that were tried $R_n$ stays small for small $r$, too.",
        ),
    ),
    theorem(
        "uniform-rate",
        clause(
            "one",
            r"Some $c_2$ that $E(0)$ alone fixes has $E(t)/E_{cr}-1\leqslant c_2/t$ for all $t>0$ along every trajectory that never merges.",
            kernel=("uniform-upper-rate",),
        ),
        clause(
            "upper",
            r"Along every trajectory that starts with $w_0=q\,y_0>0$ and never merges, $w(\tau)\leqslant w_+$, «bound», with «gain», «late», "
            r"«contact» and «loss», where $h(\theta_0)^2=y_0$, $c_0=c(\theta_0)$ and «count»: an upper bound that $E(0)$ alone "
            r"fixes.",
            bound=Formula(
                "w_+",
                "=",
                q / (1 / first_excess + RHO * sp.Max(0, (tau - LATE_TIME) / (sp.pi * (1 + 2 * sp.sqrt(q))) - 2)),
                equals(upper_bound, lambda: {RHO: gain(), LATE_TIME: late()}),
            ),
            gain=of_share(r"\rho", R * (first_depth / first_excess) ** 2, gain),
            late=Formula(
                r"\tau^*",
                "=",
                CONTACT + 2 * sp.pi * sp.sqrt(q) * crossings,
                equals(late, lambda: {CONTACT: first_contact_bound().subs(w, q * first_excess)}),
            ),
            contact=of_share(r"\tau_1", 2 * sp.sqrt((1 + w) / R), first_contact_bound),
            count=Formula(
                crossings,
                "=",
                sp.ceiling(first_excess / LOSS),
                equals(crossings_bound, lambda: {LOSS: crossing_loss()}),
            ),
            loss=Formula(
                LOSS,
                "=",
                2 * R / q * sp.Min(DEPTH(2 * sp.acot(q * (sp.sqrt(first_excess) + sp.pi / 2))), 1 / q),
                equals(crossing_loss, _depths),
            ),
        ),
        clause(
            "lower",
            r"No lower bound is fixed by $E(0)$: for every $w_0>0$ and $\delta>0$ there is a trajectory with $w(0)=w_0$ that never merges "
            r"and has $w\leqslant\delta$ from $\tau_1$ on.",
            kernel=("no-uniform-lower-rate",),
        ),
    ),
)
