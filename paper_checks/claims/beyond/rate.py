"""The $1/t$ law as a limit, and with explicit bounds from a stated time on."""

from paper_checks.claims.beyond.excursions import sharp_limit
from paper_checks.claims.letters import R, limit_of_energy, of_share
from paper_checks.claims.words import *
from theory.rate_bounds import cycle_times, elapsed, excess_bounds, first_angle, first_depth, first_excess, gains


@cache
def one_step() -> Evidence:
    """What a loss of at least a' y^2 makes of 1/y."""
    before, after, low = symbols("y z a'", positive=True)
    return prove(
        r"$a'y^2\leqslant y-y'$ gives $\frac{1}{y'}-\frac{1}{y}\geqslant a'$ (here $z=y'$)",
        [after < before, before - after >= low * before**2],
        sp.Ge(before - after, low * before * after, evaluate=False),
    )


HALF, MOST = Fraction(1, 2), Fraction(9, 10)


@theorem(
    "sharp-rate-constant",
    clause(
        "limit",
        r"Along every trajectory that never merges «limit» as $t\to\infty$: a limit, the same for every $E(0)$.",
        limit=limit_of_energy(),
        kernel="sharp-law",
    ),
)
def sharp_rate_constant() -> Case:
    """1/w gains 9r/(4q) per excursion and an excursion takes pi, in the limit."""
    return because(
        r"""
        $t\,(E-E_{cr})$ has one limit for all starts that never merge,
        $E_{cr}\,\frac{4\pi}{9}\,\frac{m_1}{m_2}\sqrt{M/a_2}$. A trajectory that never merges tends to $E_{cr}$
        (dichotomy) and from some time on sticks and slips in turn, from ray to ray. There $1/w$ gains $9r/(4q)$ per
        excursion and an excursion with its stick takes $\pi/\Omega$, both in the limit $w\to 0$, so by Stolz and
        Cesàro $1/(\Omega t\,w)\to\frac{9r}{4\pi q}$ along the exits, and as $w_{k+1}/w_k$ and $t_{k+1}/t_k$ tend to
        1, in $t$.
        """,
        sharp_limit,
        figure="sharp-rate",
    )


@theorem(
    "rate-bounds-explicit",
    clause(
        "bounds",
        r"""
        Let the pair leave $S_0$ by a ray at $t_0$ with $w_0=q\,y_0$, $y_0\leqslant\tfrac{4}{9}$, $h(\theta_0)^2=y_0$,
        $c_0=c(\theta_0)$. Then for all $t\geqslant t_0$, with $s=\Omega(t-t_0)$, $w=E/E_{cr}-1$ lies between «lower»
        and «upper»,
        """,
        lower=equal(
            r"w_-",
            q / (1 / first_excess + Symbol("A") * (elapsed / Symbol("T_-") + 1)),
            lambda: excess_bounds()[0],
            lambda: {Symbol("A"): gains()[1], Symbol("T_-"): cycle_times()[0]},
        ),
        upper=equal(
            r"w_+",
            q / (1 / first_excess + Symbol("a'") * (elapsed / Symbol("T_+") - 1)),
            lambda: excess_bounds()[1],
            lambda: {Symbol("a'"): gains()[0], Symbol("T_+"): cycle_times()[1]},
        ),
        kernel="rate-bounds",
    ),
    clause(
        "constants",
        r"where «slowest», «fastest», «longest», «shortest».",
        slowest=of_share("a'", R * first_depth**2 / first_excess**2, lambda: gains()[0]),
        fastest=of_share("A", 9 * R / 4 / (1 - R * first_depth**2 / first_excess), lambda: gains()[1]),
        longest=equal("T_+", pi + sqrt(q) * first_angle, lambda: cycle_times()[1]),
        shortest=equal(
            "T_-",
            pi - sqrt(q) * (first_angle - sqrt(first_excess)) * q * first_depth / (1 - q * first_depth),
            lambda: cycle_times()[0],
        ),
        kernel="rate-bounds",
    ),
)
def rate_bounds_explicit() -> Case:
    """Bounds of one step and of one cycle, valid for all later ones, summed."""
    return because(
        r"""
        From an exit with $w_0\leqslant\tfrac{4}{9}q$ on, $E-E_{cr}$ lies between two explicit functions of time: $c/y$
        falls with $y$ from $\tfrac{3}{2}$ and $c^2/y$ rises, so $1/y$ gains between $a'$ and $A$ per excursion; a cycle
        lasts between $T_-$ and $T_+$; and between two exits $w$ lies between its values there.
        """,
        one_step,
    )
