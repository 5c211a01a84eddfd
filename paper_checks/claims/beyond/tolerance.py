"""The ring of tolerance: entered once and for good; and damping that breaks adhesion."""

from paper_checks.claims.letters import DISTANCE, MASS
from paper_checks.claims.section_3 import capture, filippov
from paper_checks.claims.words import *
from theory import forced_control as control
from theory.forced_control import ring_ratio


@cache
def ring_contains() -> Evidence:
    """(dw)^2 <= kappa N^2, attained where both momenta cancel."""
    return prove(
        r"$m_1m_2(v_1-v_2)^2\leqslant M(a_2x_1^2+m_1v_1^2+m_2v_2^2)$",
        [],
        sp.Le(m1 * m2 * (v1 - v2) ** 2, total_mass() * (a2 * x1**2 + m1 * v1**2 + m2 * v2**2), evaluate=False),
    )


@cache
def blind_to_x2() -> Evidence:
    """No acceleration depends on x2."""
    return identity(
        r"no acceleration depends on $x_2$: an initial shift of $x_2$ by $c$ is permanent",
        [diff(entry, x2) for entry in forced.forced_system(sigma)],
    )


@cache
def sticks_for_ever_below() -> Evidence:
    """On S with E <= E_cr the free pair is captured."""
    return argument(
        r"On $S$ with $E\leqslant E_{cr}$ the pair is in $S_0$; stuck it keeps its energy, so it sticks permanently.",
        capture.stays_below_critical,
    )


REST, ENERGY, LAST_ENERGY = symbols(r"z_{\infty} E E_{\infty}", real=True)
KAPPA = Symbol("kappa", positive=True)


@claim(
    "ring-of-tolerance",
    "I",
    "Fig. 1 and the sentence before it",
    CORRECTED,
    """
    In controlled motion with a frictional interface a trajectory of the relative motion should reach some region of
    control tolerance, surrounding a steady-state periodic orbit (in the relative coordinates), and stay there.
    """,
    correction=(
        clause(
            "response",
            r"""
            Under a bounded periodic force and with $a_1>0$, $(x_1,v_1,v_2)$ has one periodic orbit; every motion enters
            each tube $N\leqslant\varepsilon$ around it once, and stays;
            """,
            kernel="periodic-response forced-contraction",
        ),
        clause(
            "velocity",
            r"in the tube the relative velocity is within $\sqrt\kappa\,\varepsilon$ of the orbit's, «kappa»;",
            kappa=equal(r"\kappa", (m1 + m2) / (m1 * m2), ring_ratio),
            kernel="ring-factor",
        ),
        clause(
            "displacement",
            """
            nothing attracts the relative displacement: a difference in $x_2(0)$ is permanent. So a ring in it can only
            be centred on a limit of the motion itself, and without a force there is one.
            """,
            kernel="displacement-unseen displacement-limit",
        ),
    ),
)
def ring_of_tolerance() -> Case:
    """What the contraction gives of Fig. 1, and the coordinate that it does not see."""
    return because(
        """
        With a damper the motion enters the ring of Fig. 1 and stays, in the relative velocity and around the one
        response. In the relative displacement no orbit attracts: nothing acts on it, so each initial value keeps its
        own.
        """,
        counterexample(
            r"""
            The pair of Section IV with $b=0.5$, at rest at $x_1=0.004$, once with $x_2(0)=0$ and once with
            $x_2(0)=0.001$: both stick permanently, and the relative motions $(x_1-x_2,\dot x_1-\dot x_2)$ rest at
            $(0.004,0)$ and at $(0.003,0)$. No region narrower than 1 mm in $x_1-x_2$ is ever reached by both.
            """,
            exhibit(
                "both starts are on $S$ with $E\\leqslant E_{cr}$",
                AT_4MM,
                (on_surface(), "<=", critical_energy()),
                (v1, "=", 0),
            ),
            kernel.step("ring-missed"),
        ),
        carried("response", argument("$N$ never grows, and tends to $0$.", filippov.never_apart)),
        carried("velocity", ring_contains),
        carried("displacement", blind_to_x2),
    )


@theorem(
    "tolerance-ring",
    clause(
        "tube",
        r"""
        Let $N$ be the energy distance of forced-contraction to some motion under the same force. The tube
        $N\leqslant\varepsilon$ around that motion is entered at most once, and never left. With $a_1>0$,
        $\varepsilon>0$ and a bounded force every motion enters it.
        """,
        kernel="forced-contraction tolerance-ring",
    ),
    clause(
        "ring",
        r"In the tube the relative velocities differ by at most «radius», «kappa»: «within», and no smaller factor suffices.",
        radius=equal(
            r"r_\varepsilon",
            sqrt(KAPPA) * control.tolerance,
            control.ring_radius,
            lambda: {KAPPA: control.ring_ratio()},
        ),
        kappa=equal(KAPPA, MASS / (m1 * m2), control.ring_ratio),
        within=Formula(
            (v1 - v2) ** 2,
            "<=",
            KAPPA * DISTANCE**2,
            implied(
                where=lambda: {
                    KAPPA: control.ring_ratio(),
                    DISTANCE: sqrt(a2 * x1**2 + m1 * v1**2 + m2 * v2**2),
                }
            ),
        ),
        kernel="ring-factor",
    ),
    clause(
        "blind",
        """
        $N$ does not contain $x_1-x_2$: a shift of $x_2(0)$ shifts the relative motion by as much permanently. So a ring
        in the plane of $x_1-x_2$ and its rate can only be centred on a limit of the motion itself.
        """,
        kernel="displacement-unseen",
    ),
    clause(
        "centre",
        r"Without a force $x_1-x_2$ has a limit $z_\infty$, and with the energy $E$ at a time there is «near» then, $E_\infty=\lim E$.",
        near=sharp(
            Abs(x1 - x2 - REST),
            "<=",
            (ENERGY - LAST_ENERGY) / b,
            lambda: (Abs(x1 - x2 - REST), "<=", (ENERGY - LAST_ENERGY) * control.path_per_energy()),
        ),
        kernel="displacement-limit displacement-paid",
    ),
    assuming=UNDER_A_FORCE,
)
def tolerance_ring() -> Case:
    """The distance never grows; its image in the relative plane."""
    return because(
        "A ring that contains the image of the tube is entered no later than the tube, and not left once the tube is entered. The energy distance does not contain the relative displacement, so the ring is centred on its limit, if it has one: under a force body 2 may drift away.",
        ring_contains,
    )


@theorem(
    "damping-can-desynchronise",
    clause(
        "sticks",
        r"Let a free pair be stuck at $x_1=0$ with the velocity $v_1>0$. Without a damper it sticks permanently if «captive».",
        captive=sharp(
            v1**2,
            "<=",
            b**2 * MASS / (a2 * m2**2),
            lambda: (v1**2, "<=", critical_energy() / on_surface().subs({x1: 0, v1: 1})),
        ),
        kernel="capture",
    ),
    clause(
        "breaks",
        r"With a damper it slips at once if «strong».",
        strong=sharp(a1, ">", b * MASS / (m2 * v1), lambda: (a1, ">", forced.breaking_damping())),
        kernel="damper-breaks",
    ),
    clause(
        "heavy",
        r"""
        As $a_1\to\infty$ body 1 moves slowly, with «creeps» in slip of sign $\sigma$ and the velocity of body 1 of
        order $1/a_1$, and «time» for the time $T$ after which the pair sticks permanently, with the $v_2$ of
        the initial state, whatever that is.
        """,
        creeps=tends(r"a_2x_1+a_1v_1", -b * sigma, forced.creeping_load),
        time=tends("T", m2 * Abs(v2) / b, lambda: Abs(v2) / control.strongest()),
        kernel="heavy-damping",
    ),
    assuming=f"{POSITIVE} No force, $u=0$; with and without a damper.",
)
def damping_can_desynchronise() -> Case:
    """A damper pulls at body 1 only."""
    load = forced.load().subs({u: 0, x1: (forced.creeping_load() - a1 * v1) / a2}, simultaneous=True)
    return because(
        "A damper acts on body 1 alone, so a strong one breaks the adhesion of a moving pair that would have stuck permanently without it: more damping does not always synchronise faster.",
        identity(r"where body 1 creeps, the load is $m_2b\sigma/M$", load, m2 * b * sigma / total_mass()),
    )
