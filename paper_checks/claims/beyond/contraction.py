"""Two motions under one force never move apart: uniqueness, other forces, a friction that changes with time."""

from paper_checks.claims.section_3 import filippov
from paper_checks.claims.words import *
from theory.energy import contraction_rate


@cache
def same_modes() -> Evidence:
    """The set-valued field under a force is the slip of (3), (4) for sigma = 1 and -1, and stick for sigma = load/b."""
    slips = [one.acceleration1 for one in (slip(1), slip(-1))] + [one.acceleration2 for one in (slip(1), slip(-1))]
    field = [forced.forced_system(Integer(sign))[place] for place in (1, 2) for sign in (1, -1)]
    stuck = forced.forced_system(forced.load() / b).subs(v2, v1)
    return identity(
        r"$m_1\dot v_1=u-a_2x_1-a_1v_1-b\sigma$, $m_2\dot v_2=b\sigma$ is slip of (3), (4) for $\sigma=\pm 1$, and stick for $\sigma=\Lambda/b$",
        [*field, stuck[1], stuck[2]],
        [*slips, stick().acceleration1.subs(v2, v1), stick().acceleration2.subs(v2, v1)],
    )


@cache
def energy_rate() -> Evidence:
    """The chain rule along the set-valued field."""
    return identity(
        r"$\dot E=u\,v_1-a_1v_1^2-b\sigma\dot z$, where $\sigma\dot z=|\dot z|$",
        forced.energy_rate(),
        u * v1 - a1 * v1**2 - b * sigma * (v1 - v2),
    )


@cache
def force_cancels() -> Evidence:
    """Under one force the rate of the distance is the free one."""
    return identity(
        r"$\tfrac12\frac{d}{dt}N^2$ is the same with a force as without: $u$ cancels",
        forced.contraction_rate(),
        contraction_rate(),
    )


@cache
def never_apart() -> Evidence:
    """The distance of two solutions never grows."""
    return argument(
        r"The damper's term is minus a square and the friction's is never positive, so $N$ does not grow.",
        force_cancels,
        filippov.contraction,
        filippov.never_apart,
    )


@cache
def one_solution() -> Evidence:
    """Existence by Filippov, uniqueness by the distance."""
    return argument(
        r"The set-valued right side is bounded on bounded sets, convex and closed, and measurable in time: there is a solution. Two from the same initial state have the distance $0$ at all later times.",
        same_modes,
        never_apart,
        cites=("Filippov's theorem on existence",),
    )


@cache
def forces_apart() -> Evidence:
    """Two forces: the distance grows at most as their difference."""
    work = forced.distance_rate() - forced.contraction_rate()
    letters = {one: Symbol(f"k{n}", real=True) for n, one in enumerate((x1_other, v1_other, v2_other))}
    squared = forced.distance_squared().subs(letters)
    return argument(
        r"$N\dot N\leqslant(u-\tilde u)(v_1-\tilde v_1)\leqslant|u-\tilde u|\,N/\sqrt{m_1}$; integrate.",
        never_apart,
        identity(
            r"two forces add the work of their difference to $\tfrac12\frac{d}{dt}N^2$",
            work.subs(forced.u_other, 0).subs(u, Symbol("f", real=True)),
            Symbol("f", real=True) * (v1 - v1_other),
        ),
        prove(
            r"$m_1(v_1-\tilde v_1)^2\leqslant N^2$ (here $k$ for the second solution)",
            [],
            sp.Le(m1 * (v1 - letters[v1_other]) ** 2, squared, evaluate=False),
        ),
    )


DISTANCE = Symbol("N", nonnegative=True)


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
