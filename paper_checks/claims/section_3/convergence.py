"""Every free motion merges with a stuck one in finite time, or tends to the critical one."""

from paper_checks.claims.section_3 import capture, filippov
from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.words import *
from theory.turned_back import claimed_rates, rates


@cache
def converges() -> Evidence:
    """The state tends to a rotation of the pair as one body."""
    return argument(
        r"""
        The pair tends to a rotation: $b\int_0^\infty|v_1-v_2|\,dt\leqslant E(0)$, so $A$ and $B$, whose rates it
        bounds, have limits; and $v_1-v_2$, a Lipschitz function whose integral is finite, tends to 0. So
        $(x_1,P/(M\Omega))$ approaches a rotation of one radius $R$ with the angular frequency $\Omega$, and
        $E\to\frac{1}{2}a R^2$.
        """,
        identity(
            r"""
            with $P=m_1v_1+m_2v_2$, the point $(x_1,P/(M\Omega))$ turned back by $\Omega t$ moves at the rate
            $\frac{m_2}{M}(v_1-v_2)\,(\cos\Omega t,\sin\Omega t)$ for every value of friction
            """,
            rates(),
            claimed_rates(),
        ),
    )


@cache
def merges_or_creeps() -> Evidence:
    """Merging in finite time, or the critical orbit: beyond L each turn would cost a fixed energy."""
    return argument(
        r"""
        If $E\leqslant E_{cr}$ at some time, the next contact with $S$, within a bounded time, is in $S_0$, and the pair
        sticks from then on: it merges. Otherwise the limit of $E$ is $\frac{1}{2}aR^2\geqslant E_{cr}=\frac{1}{2}aL^2$; and
        $R>L$ is impossible, as each of infinitely many turns beyond $L$ would cost a fixed energy. So $R=L$:
        the trajectory tends to one motion on the critical ellipse.
        """,
        converges,
        capture.stays_below_critical,
    )


@cache
def contact_again() -> Evidence:
    """S is met in every window of a bounded length."""
    return argument(
        r"""
        The switching surface is met again and again: a stay in one half-space lasts at most $2\sqrt{2Em_2}/b$, as
        $v_2$ changes there at a constant rate and is bounded by the energy.
        """,
        capture.meets_surface,
    )


def _acceleration(sign: int) -> Formula:
    return equal(r"\dot{v}_2", sign * b / m2, lambda: phi(sign)[2])


@claim(
    "infinitely-many-crossings",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "crossings",
        r"""
        Since «minus» in $\Omega_-$ and «plus» in $\Omega_+$, (8) implies that every trajectory has infinitely many
        intersections with the switching plane $S$.
        """,
        minus=_acceleration(-1),
        plus=_acceleration(1),
        kernel="contact",
    ),
)
def infinitely_many_crossings() -> Case:
    """Every stay off S is finite."""
    return because(
        r"""
        Solutions exist for all time (the set-valued field is bounded on the level sets of $E$, which never grows). A
        stay in $\Omega_+$ or $\Omega_-$ lasts at most $2\sqrt{2Em_2}/b$, since there $v_2$ changes at a constant rate
        and is bounded by the energy. So there is no last time at which a trajectory is on $S$; one that sticks is on
        $S$ at every instant.
        """,
        carried("crossings", contact_again),
    )


@claim(
    "dichotomy",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "dichotomy",
        r"""
        Any trajectory of (5)–(7) either merges with one of the elliptic periodic trajectories $\{E=E_0\}\cap S_0$,
        $E_0\leqslant E_{cr}$, in finite time or converges to the largest of them, $\{E=E_{cr}\}\cap S_0$,
        asymptotically.
        """,
        kernel="dichotomy",
    ),
)
def dichotomy() -> Case:
    """Either E reaches E_cr, and the pair sticks for ever, or the limit set is the critical orbit."""
    return because(
        r"""
        If $E\leqslant E_{cr}$ at some time, the next contact with $S$, which comes within a bounded time, is in $S_0$
        and is never left: the trajectory merges. Otherwise the pair, turned back by the angle $\Omega t$ of stick,
        converges, as only slip moves it and slip costs energy: it tends to one rotation of a radius $R$. Beyond $L$
        each turn would dissipate a fixed energy, so $R=L$: it tends to one motion on the critical ellipse.
        """,
        carried("dichotomy", merges_or_creeps),
    )


@claim(
    "relative-displacement-limit",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "limit",
        r"Equation (8) implies that $x_1-x_2\to\mathrm{const}$ for any trajectory.",
        kernel="displacement-limit",
    ),
)
def relative_displacement_limit() -> Case:
    """The path length of x1 - x2 is at most E(0)/b."""
    return because(
        r"""
        $b\int_0^\infty|v_1-v_2|\,dt=E(0)-E_\infty\leqslant E(0)$: the path of $x_1-x_2$ has finite length, so it
        converges. The bodies slide by exactly $(E(0)-E_\infty)/b$ in all.
        """,
        dissipation.energy_rate,
    )


@claim(
    "global-stability",
    "III",
    "after Fig. 3",
    HOLDS,
    clause(
        "stable",
        r"""
        The set of periodic trajectories $\{E=E_0\}\cap S_0$ with $E_0\leqslant E_{cr}$, including the equilibrium at
        the origin, is globally asymptotically stable.
        """,
        kernel="ellipse-stable convergence",
    ),
)
def global_stability() -> Case:
    """Stability by contraction, attraction by the dichotomy."""
    return because(
        """
        As the flow is non-expansive in the energy norm, the distance of a trajectory to it never grows (stability), and
        by the dichotomy it tends to 0 (attraction). The same shows that every single periodic orbit is stable; none is
        attracting by itself. The statement is about $(x_1,v_1,v_2)$: $x_2$ drifts to a limit.
        """,
        filippov.never_apart,
        merges_or_creeps,
    )
