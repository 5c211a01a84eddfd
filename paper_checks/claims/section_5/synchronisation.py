"""Section V: whether, when and how the pair synchronises."""

from paper_checks.claims.beyond import damping
from paper_checks.claims.beyond.excursions import creeps_for_ever
from paper_checks.claims.beyond.tolerance import sticks_for_ever_below
from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.section_3 import itineraries
from paper_checks.claims.section_3.capture import meets_surface
from paper_checks.claims.words import *
from theory.energy import captive_energy


@claim(
    "synchronisation-all-parameters",
    "V",
    "V, first bullet",
    HOLDS,
    clause(
        "synchronises",
        r"""
        For any initial conditions of the free system (2)–(4) with $u=0$, the global asymptotic convergence
        $\dot{z}(t)\to 0$ for $t\to\infty$ is warranted for all the admissible (i.e. physical) system parameters
        $m_1,m_2,a_2,b>0$ and $a_1\geqslant 0$.
        """,
        kernel="synchronisation switching-iff filippov-iff",
    ),
)
def synchronisation_all_parameters() -> Case:
    """Prove z' -> 0 step by step, for all parameters and all initial states."""
    return because(
        r"""
        Under the Filippov law, whose solutions are those of (3)–(4), friction dissipates $b|\dot z|$ of a finite
        energy, so $\int|\dot z|\,dt\leqslant E(0)/b$, and $|\ddot z|$ is bounded in every mode: an integrable function
        with a bounded rate tends to 0. Each step is checked for all $m_1,m_2,a_2,b>0$, $a_1\geqslant 0$. (11)–(12) read
        literally with a stick that never ends reach $\dot z=0$ at the first contact.
        """,
        carried("synchronises", dissipation.synchronises),
    )


@claim(
    "finite-time-then-alternation",
    "V",
    "V, second bullet",
    CORRECTED,
    r"""
    Zero convergence of $\dot{z}(t)$ does not take place in a single dynamic mode. A finite time convergence towards a
    synchronized orbit can precede the following long-term alternation of the stiction and slipping modes.
    """,
    correction=(
        clause(
            "both-modes",
            r"No slip is permanent: from every initial state with $\dot z\neq 0$ the pair meets $S$ after a finite time.",
            kernel="contact",
        ),
        clause(
            "one-mode",
            r"""
            Without a damper, $a_1=0$, a pair that starts on $S$ with $E\leqslant E_{cr}$ is synchronised in one mode,
            stick, permanently; so no alternation follows once it moves on a synchronised orbit $\{E=E_0\}\cap S_0$,
            $E_0\leqslant E_{cr}$.
            """,
            kernel="sticks-iff capture",
        ),
        clause(
            "alternates",
            r"For every such pair, $a_1=0$, some motion sticks and slips in turn without end;",
            kernel="stick-slip-for-ever",
        ),
        clause(
            "precedes",
            r"and that can follow on an adhesion in finite time, on an arc of $S_0$ above $E_{cr}$.",
            kernel="well-posed first-adhesion sticks-iff turning-point critical-mass-ratio-digits heavy-never-merges exit-and-entry-times",
        ),
    ),
)
def finite_time_then_alternation() -> Case:
    """Exhibit a trajectory that meets z' = 0 in finite time and then alternates without end."""
    name = "itinerary-that-creeps"
    return because(
        r"""
        On a synchronised orbit, $E\leqslant E_{cr}$, the pair is permanently in one mode. From a slip both modes are
        needed; once a trajectory moves on such an orbit, no alternation follows. What can precede an endless
        alternation is an adhesion in finite time, on an arc of $S_0$ with an energy above $E_{cr}$: the scene
        itinerary-that-creeps ($m_1=m_2=1$, $a_2=200$, $b=0.5$, $\dot x_1(0)=0.21$) adheres after a finite, enclosed
        time and then sticks and slips in turn without end, which is proved and not extrapolated.
        """,
        counterexample(
            "The pair of Section IV with $b=0.5$, both bodies at rest at $x_1=0.004$: $\\dot z=0$ permanently in the one mode of stick, and no alternation follows.",
            exhibit(
                "at $x_1=0.004$, at rest, $b=0.5$: $\\dot z=0$ and $E<E_{cr}$",
                AT_4MM,
                (v1, "=", 0),
                (on_surface(), "<", critical_energy()),
            ),
            stuck_for_ever("from there the pair sticks permanently", solved(scene_at(AT_4MM, "1000"))),
        ),
        carried(
            "both-modes",
            argument("A stay in one half-space is bounded by the time that friction takes.", meets_surface),
        ),
        carried("one-mode", sticks_for_ever_below),
        carried("alternates", creeps_for_ever),
        carried(
            "precedes",
            argument(" ".join(itineraries.ARGUMENT), itineraries.never_merges(solved(load_scene(name)), name)),
        ),
    )


# The scene of Fig. 5 (a) with a damper of 5 N s/m on the driving body.
DAMPED = {**EXAMPLE_PAIR, a1: 5, b: Rational("0.05"), v1: Rational("0.15")}


@claim(
    "viscous-accelerates",
    "V",
    "V, third bullet",
    CORRECTED,
    """
    The viscous damping of the driving body influences the trajectories, but has no principal impact on the
    synchronization mechanism; a purposefully controlled viscous damping of the active body can accelerate the
    synchronization.
    """,
    correction=(
        clause(
            "ends",
            r"For every $a_1>0$ every trajectory sticks permanently from a finite time on, and tends to the origin;",
            kernel="viscous-decay viscous-rest",
        ),
        clause(
            "captive",
            r"it sticks permanently at the latest from its first contact with $S$ below the level «level» on;",
            level=equal(
                "E_c",
                b**2 * (m1 + m2) ** 3 / (2 * m2**2 * (a2 * (m1 + m2) + a1**2)),
                captive_energy,
            ),
            kernel="captive-sticks contact",
        ),
        clause(
            "alternates",
            """
            for $a_1=0$ it may alternate without end and then tends to the orbit $E=E_{cr}$. So damping the driving body
            can accelerate the synchronisation, and it replaces the endless alternation by a finite one.
            """,
            kernel="no-merging-from-S0 exit-and-entry-times viscous-rest",
        ),
        clause(
            "time",
            r"""
            Less damping may do it sooner: in Fig. 5 (a) the pair sticks permanently from $t=T(a_1)$ s on, and «sooner»,
            «later», $a_1$ in N s/m. How $T$ depends on $a_1$ is said by synchronisation-against-damping.
            """,
            sooner=damping.lasts("0.56", "3.2046"),
            later=damping.lasts("0.63", "3.2378"),
        ),
    ),
)
def viscous_accelerates() -> Case:
    """Compare Fig. 5 (a) with and without a damper, and prove that a damper ends every alternation."""
    undamped_run, damped_run = solved(load_scene("velocities")), solved(scene_at(DAMPED, "8"))
    return because(
        r"""
        A damper can accelerate the synchronisation, but it changes the mechanism, too: with $a_1=0$ whole families of
        trajectories converge to $E_{cr}$ by endless stick and slip, with $a_1>0$ every trajectory sticks permanently
        from a finite time on and comes to rest. The trajectory of Fig. 5 (a) never stops slipping without a damper;
        with $a_1=5$ N s/m it merges within a second. The sliding region is tilted: $|a_2x_1+a_1v_1|\leqslant
        b(m_1+m_2)/m_2$.
        """,
        counterexample(
            (
                "$m_1=m_2=1$, $a_2=200$, $b=0.05$, $\\dot x_1(0)=0.15$: with $a_1=0$ the pair never merges, from its "
                f"first exit at $t=$ {text(itineraries.first_exit(undamped_run).t)} s on it sticks and slips in turn without end; with $a_1=5$ it sticks permanently from $t=$ {text(damped_run.events[-1].t)} s on."
            ),
            *itineraries.starts_below(undamped_run, "velocities"),
            stuck_for_ever("Fig. 5 (a) with $a_1=5$ N s/m sticks permanently", damped_run),
        ),
        carried("ends", dissipation.captured),
        carried(
            "captive",
            argument(
                "Below the level, $S$ is met inside the strip, where the pair sticks and, as $E$ does not grow, permanently.",
                dissipation.captive_margin,
            ),
        ),
        carried("alternates", creeps_for_ever),
        carried("time"),
    )
