"""Section III: slightly above the critical energy: durations, exits, and how slowly the energy falls."""

from paper_checks.claims.beyond.excursions import (
    EVENTUALLY,
    creeps_for_ever,
    sharp_limit,
    two_sided,
)
from paper_checks.claims.letters import limit_of_energy
from paper_checks.claims.section_3.sliding import WIDTH, width
from paper_checks.claims.words import *
from theory.near_critical import critical_limits, excess_ratio_limit

HALF_PERIOD = pi * sqrt((m1 + m2) / a2)
LATE = "Read as of late times, $k\\to\\infty$, as the limits of the same sentence are."
"""How all parts of that sentence are read."""


@claim(
    "stick-durations",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "sticks",
        r"""
        In the latter scenario there are times $t_1<\tau_1<t_2<\tau_2<\cdots$ such that the trajectory belongs to
        $S_0$ during each $[t_k,\tau_k]$ and «limit» as $k\to\infty$.
        """,
        limit=tends(r"\tau_k-t_k", HALF_PERIOD, lambda: critical_limits().stick_duration),
        kernel="exit-and-entry-times",
    ),
)
def stick_durations() -> Case:
    """The stick time is a rotation by pi less what the re-entry point and the ray take off."""
    return because(
        EVENTUALLY + " The stick time is that of a rotation from a point near one end point to the other.",
        creeps_for_ever,
    )


@claim(
    "slip-durations",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "slips",
        r"For the same times, «limit» as $k\to\infty$: the trajectory leaves $S_0$ only for short intervals of time.",
        limit=tends(r"t_{k+1}-\tau_k", 0, lambda: critical_limits().slip_duration),
        kernel="exit-and-entry-times",
    ),
)
def slip_durations() -> Case:
    """The slip time is sqrt(q) times the angle with h(theta) = u, which tends to 0."""
    events = solved(load_scene("velocities")).events
    first_slip = next(entry.t - leaves.t for leaves, entry in pairwise(events) if leaves.kind is EventKind.EXIT)
    return because(
        f"{LATE} {EVENTUALLY} The slip time is $3\\sqrt w/\\Omega$ to leading order. The first slips are not short: that "
        "after the first adhesion of Fig. 5 (a) lasts 0.192 s, after 0.030 s in $S_0$.",
        decimal("t_2-\\tau_1", "0.192", lambda: first_slip).evidence().as_support(),
        creeps_for_ever,
    )


@claim(
    "exits-near-endpoints",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "all",
        r"""
        All the exit points from $S_0$ and entry points to $S_0$ are located near the end points $(\pm L,\,0,\,0)$,
        «width», of the rays $\ell_\pm$: «entry» and «speed» at the entries as $k\to\infty$.
        """,
        width=width(),
        entry=tends(r"|x_1|", WIDTH, lambda: critical_limits().entry_position),
        speed=tends(r"|v_1|", 0, lambda: critical_limits().entry_velocity),
        kernel="exits-near-endpoints",
    ),
)
def exits_near_endpoints() -> Case:
    """Exit and entry points tend to the corner."""
    first_entry = next(one for one in solved(load_scene("velocities")).events if one.kind is EventKind.ENTRY)
    return because(
        (
            f"{LATE} {EVENTUALLY} Exits are at $x_1=\\pm L$ with $|v_1|=L\\Omega\\sqrt w$; entries at "
            "$|x_1|=L(1-\\tfrac32w+\\dots)$ with $|v_1|=2L\\Omega\\sqrt w+\\dots$. The first entries may lie elsewhere in "
            "$S_0$: that of Fig. 5 (a) is at $x_1=0.706\\,L$."
        ),
        decimal("x_1/L", "0.7056", lambda: first_entry.reduced.X).evidence().as_support(),
        creeps_for_ever,
    )


@claim(
    "no-merging-near-critical",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "creeps",
        r"""
        Any trajectory starting from $S_0$ with energy $E_0$ slightly higher than $E_{cr}$ converges to the periodic
        trajectory $\{E=E_{cr}\}\cap S_0$ without merging with it.
        """,
        kernel="no-merging-from-S0",
    ),
)
def no_merging_near_critical() -> Case:
    """Every excursion from a ray with w <= q (pi/2 - 1)^2 ends in S0 with 0 < w' < w."""
    return because(
        r"""
        From $S_0$ above $E_{cr}$ the pair reaches a ray with its energy unchanged. If $w=E_0/E_{cr}-1\leqslant
        q(\pi/2-1)^2$, $q=m_1/(m_1+m_2)$, the excursion ends inside $S_0$ with $0<w'<w$, and so do all that follow:
        the energy never reaches $E_{cr}$, so by the dichotomy the trajectory tends to the critical orbit without
        merging. "Slightly" may thus be read as this explicit level; for $m_2\leqslant m_1$ an excursion that
        re-enters $S_0$ never merges at any energy.
        """,
        creeps_for_ever,
    )


@claim(
    "slower-than-exponential",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "slow",
        r"This convergence is slow, slower than exponential.",
        kernel="slower-than-exponential",
    ),
)
def slower_than_exponential() -> Case:
    """w'/w tends to 1 while an excursion and its stick take a time that tends to pi/Omega."""
    return because(
        r"""
        The excess after one excursion over that before tends to 1, and the time of a cycle tends to $\pi/\Omega$, so
        $w\,e^{\lambda t}\to\infty$ for every $\lambda>0$.
        """,
        carried(
            "slow",
            argument(
                r"""
                $w$ is multiplied by a factor that tends to 1 in a time that tends to $\pi/\Omega$: more slowly than
                by any $e^{-\lambda t}$.
                """,
                identity("$w'/w\\to 1$ as $w\\to 0$", excess_ratio_limit(), 1),
            ),
        ),
    )


@claim(
    "rate-one-over-t",
    "III",
    "after Fig. 3",
    CORRECTED,
    clause(
        "bounds",
        r"""
        The energy of such solutions satisfies $c_1(E(0))/t\leqslant E(t)-E_{cr}\leqslant c_2(E(0))/t$ with
        $0<c_1(E(0))<c_2(E(0))$.
        """,
    ),
    correction=(
        clause(
            "two-sided",
            r"""
            Away from $t=0$ it holds as written: for every such solution, which starts on $S_0$ slightly above $E_{cr}$,
            and every $t_0>0$ there are $0<c_1<c_2$, which depend on $E(0)$ and $t_0$ alone, with $c_1/t\leqslant E(t)-E_{cr}\leqslant c_2/t$ for
            $t\geqslant t_0$;
            """,
            kernel="one-over-t",
        ),
        clause(
            "limit",
            r"and «limit» as $t\to\infty$, whatever $E(0)$ is.",
            limit=limit_of_energy(),
            kernel="sharp-law",
        ),
    ),
)
def rate_one_over_t() -> Case:
    """The bound cannot hold as t -> 0; from any positive time on it does, with one limit for all starts."""
    c1, above, now = symbols("c_1 e_0 e", positive=True)
    t = Symbol("t", positive=True)
    return because(
        r"""
        Corrected near $t=0$ only: from any $t_0>0$ on the bounds hold as written. As $t\to 0$, $c_1/t$ is unbounded
        while $E(t)-E_{cr}\leqslant E(0)-E_{cr}$. More is true: $1/w$ gains $9r/(4q)$ per excursion in the limit, and an
        excursion takes $\pi/\Omega$ in the limit, so $t(E-E_{cr})$ has a limit, which does not depend on $E(0)$. That
        $E(0)$ alone fixes the constants is right for such solutions, which start on $S_0$; over all solutions of one
        $E(0)$ that never merge there is an upper constant and no lower one (uniform-rate).
        """,
        counterexample(
            r"""
            Any solution with $E(0)>E_{cr}$ and any $c_1>0$: at $t=c_1/(2(E(0)-E_{cr}))$ the lower bound requires
            $E(t)-E_{cr}\geqslant 2(E(0)-E_{cr})$, but energy never increases.
            """,
            prove(
                "$c_1/t\\leqslant E(t)-E_{cr}\\leqslant E(0)-E_{cr}=:e_0$ fails at $t=c_1/(2e_0)$, whatever $c_1>0$",
                [sp.Eq(2 * above * t, c1), now <= above],
                sp.Gt(c1, now * t, evaluate=False),
            ),
        ),
        carried("two-sided", two_sided),
        carried("limit", sharp_limit),
    )
