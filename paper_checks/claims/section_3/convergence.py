"""Every free motion merges with a stuck one in finite time, or tends to the critical one."""

from paper_checks.claims.section_3 import capture
from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.words import *
from paper_checks.decide.samples import dichotomy_samples
from theory.energy import energy
from theory.turned_back import claimed_rates, energy_parts, rates, relative_rate


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
        capture.energy_decreases,
        identity(
            r"""
            with $P=m_1v_1+m_2v_2$, the point $(x_1,P/(M\Omega))$ turned back by $\Omega t$ moves at the rate
            $\frac{m_2}{M}(v_1-v_2)\,(\cos\Omega t,\sin\Omega t)$ for every value of friction
            """,
            rates(),
            claimed_rates(),
        ),
        identity(
            r"$2E=a(A^2+B^2)+\frac{m_1m_2}{M}(v_1-v_2)^2$: the pair as one body, and the relative motion",
            energy_parts(),
            2 * energy(),
        ),
        dissipation.price_of_relative_speed,
    )


@cache
def each_turn_has_a_cost() -> Evidence:
    """R > L is impossible."""
    beyond = [
        signed(x1 - half_width() - distance, ">="),
        sigma >= -1,
        sigma <= 1,
        distance > 0,
    ]
    falls = signed(relative_rate() + a2 * distance / m1, "<=")
    return argument(
        r"""
        $R\leqslant L$: otherwise $x_1$ exceeds $L+\delta$ for a fixed time in every turn, from some time on. There
        $v_1-v_2$ falls at least at the rate $a\delta/m_1$, so $|v_1-v_2|$ is above a fixed value for a fixed part of
        that time: each of infinitely many turns costs a fixed energy, and there is only $E(0)$.
        """,
        converges,
        prove(
            r"where $x_1\geqslant L+d$, $\dot v_1-\dot v_2\leqslant-a\,d/m_1$ for every value of friction in $[-1,1]$",
            beyond,
            falls,
        ),
        capture.mirror_image,
    )


@cache
def merges_or_creeps() -> Evidence:
    """Merging in finite time, or the critical orbit."""
    return argument(
        r"""
        If $E\leqslant E_{cr}$ at some time, the next contact with $S$, within a bounded time, is in $S_0$, and the pair
        sticks from then on: it merges. Otherwise $\frac{1}{2}aR^2=\lim E\geqslant E_{cr}=\frac{1}{2}aL^2$, so $R=L$:
        the trajectory tends to one motion on the critical ellipse.
        """,
        each_turn_has_a_cost,
        contact_again,
        capture.stays_below_critical,
        stays_stuck,
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
        capture.energy_decreases,
    )


@cache
def stays_stuck() -> Evidence:
    """On S with E <= E_cr sticking for ever is a solution, and the only one."""
    return argument(
        """
        Sticking on the ellipse is a solution, as it needs no more force than friction gives; no other one starts there,
        as the flow is non-expansive.
        """,
        capture.stays_below_critical,
        capture.stick_is_a_motion,
        capture.contraction,
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
def dichotomy(seed: int) -> Case:
    """Either E reaches E_cr, and the pair sticks for ever, or the limit set is the critical orbit."""
    return because(
        r"""
        If $E\leqslant E_{cr}$ at some time, the next contact with $S$, which comes within a bounded time, is in $S_0$
        and is never left: the trajectory merges. Otherwise the pair, turned back by the angle $\Omega t$ of stick,
        converges, as only slip moves it and slip costs energy: it tends to one rotation of a radius $R$. Beyond $L$
        each turn would dissipate a fixed energy, so $R=L$: it tends to one motion on the critical ellipse.
        """,
        carried("dichotomy", merges_or_creeps),
        identity(r"on $S_0$, $\dot E=0$: the level sets there are orbits", undamped(stick_rate())),
        capture.leaves_above_critical,
        dichotomy_samples(seed),
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
        carried(
            "limit",
            argument(
                "The path of $x_1-x_2$ has the length $\\int|v_1-v_2|\\,dt\\leqslant E(0)/b$: a path of finite length converges.",
                capture.energy_decreases,
            ),
        ),
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
        carried(
            "stable",
            argument(
                """
                The distance to the set never grows, as each of its orbits is a solution and the flow is non-expansive;
                and it tends to 0, as every trajectory merges with one of these orbits or tends to the critical one.
                """,
                capture.contraction,
                capture.stick_is_a_motion,
                merges_or_creeps,
            ),
        ),
    )
