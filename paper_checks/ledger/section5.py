"""Section V: discussion."""

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.section2 import under_a_force
from theory import forced
from theory.energy import captive_energy, sigma
from theory.symbols import a1, a2, b, m1, m2, u, v1, v2

SECTION = "V"

SECTION_5 = (
    Claim(
        "driven-body-steered",
        SECTION,
        "first paragraph",
        (
            clause(
                "unbounded",
                r"The moved passive body has an unbounded motion space, and with it such an underactuated system could be controlled, the motion "
                r"variables of interest being $(x_2,\dot x_2)$,",
            ),
            clause(
                "source",
                r"when the active body appears as a single (external) energy source: «rate».",
                rate=Formula(
                    r"\dot E",
                    "=",
                    u * v1 - a1 * v1**2 - b * sigma * (v1 - v2),
                    equals(forced.energy_rate),
                ),
                kernel=("forced-energy-rate",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "synchronisation-all-parameters",
        SECTION,
        "first bullet",
        (
            clause(
                "synchronises",
                r"For any initial conditions of the free system (2)–(4) with $u=0$, the global asymptotic "
                r"convergence $\dot{z}(t)\to 0$ for $t\to\infty$ is warranted for all the admissible (i.e. "
                r"physical) system parameters $m_1,m_2,a_2,b>0$ and $a_1\geqslant 0$.",
                kernel=("synchronisation",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "finite-time-then-alternation",
        SECTION,
        "second bullet",
        r"Zero convergence of $\dot{z}(t)$ does not take place in a single dynamic mode. A finite time "
        r"convergence towards a synchronized orbit can precede the following long-term alternation of the "
        r"stiction and slipping modes.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "both-modes",
                r"No slip lasts for ever: from every start with $\dot z\neq 0$ the pair meets $S$ after a finite time.",
                kernel=("contact",),
            ),
            clause(
                "one-mode",
                r"Without a damper, $a_1=0$, a pair that starts on $S$ with $E\leqslant E_{cr}$ is synchronised in one mode, stick, for ever; so no alternation follows once it moves on a synchronised "
                r"orbit $\{E=E_0\}\cap S_0$, $E_0\leqslant E_{cr}$.",
                kernel=("sticks-iff", "capture"),
            ),
            clause(
                "alternates",
                r"For every such pair, $a_1=0$, some motion sticks and slips in turn for ever;",
                kernel=("stick-slip-for-ever",),
            ),
            clause(
                "precedes",
                r"and that can follow on an adhesion in finite time, on an arc of $S_0$ above $E_{cr}$.",
            ),
        ),
    ),
    Claim(
        "viscous-accelerates",
        SECTION,
        "third bullet",
        r"The viscous damping of the driving body influences the trajectories, but has no principal impact "
        r"on the synchronization mechanism; a purposefully controlled viscous damping of the active body "
        r"can accelerate the synchronization.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "ends",
                r"For every $a_1>0$ every trajectory sticks for ever from a finite time on, and tends to the origin;",
                kernel=("viscous-decay", "viscous-rest"),
            ),
            clause(
                "captive",
                r"that is at the latest at its first contact with $S$ below the level «level»;",
                level=Formula(
                    "E_c",
                    "=",
                    b**2 * (m1 + m2) ** 3 / (2 * m2**2 * (a2 * (m1 + m2) + a1**2)),
                    equals(captive_energy),
                ),
                kernel=("captive-merges",),
            ),
            clause(
                "alternates",
                r"for $a_1=0$ it may alternate for ever and then tends to the orbit $E=E_{cr}$. So damping the driving body can "
                r"accelerate the synchronisation, and it replaces the endless alternation by a finite one.",
                kernel=("no-merging-from-S0",),
            ),
        ),
    ),
    Claim(
        "damping-for-tracking",
        SECTION,
        "third bullet",
        r"A purposefully controlled viscous damping of the active body can be purposefully used for trajectory tracking, cf. Fig. 1.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "approach",
                r"With a constant $a_1>0$ and a force that is bounded any two motions approach each other in $(x_1,v_1,v_2)$:",
                kernel=("forced-approach",),
            ),
            clause(
                "velocity",
                r"so under the force of trackable-references, if bounded, every motion takes on the velocity of the reference in the end: $x_1$, $v_1$ and $v_2$ track it.",
            ),
            clause(
                "place",
                r"The place $x_2$ does not: a motion that differs in $x_2(0)$ only keeps that difference for ever,",
                kernel=("displacement-unseen", "forced-well-posed"),
            ),
            clause(
                "offset",
                r"and one that starts with the place and the velocity of the reference, but with another motion of body 1, can be left with an offset.",
            ),
        ),
        open=(
            "A damper that is itself controlled, $a_1(t)$ or $a_1$ by the state, is not treated: here $a_1$ is constant and the force does not depend on the motion.",
        ),
    ),
    Claim(
        "two-descriptions",
        SECTION,
        "fourth bullet",
        r"The switched system (2)–(4) with the signum (1) allows for zero velocity solutions in $\dot{z}$, "
        r"i.e. adhesion; the global asymptotic convergence was shown for the switched system in Filippov's "
        r"sense. Both interpretations of the system switching are possible for the Coulomb friction with a "
        r"discontinuity; in particular (1) interprets the adhesion in a proper physical sense of zero "
        r"relative velocity.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "same",
                r"(2)–(4) with $a_1=u=0$ have the same solutions as (5)–(7) in Filippov's sense, one from each start.",
            ),
            clause(
                "example",
                r"These solutions also satisfy (11)–(12), which have others besides: (11)–(12) with a stick that is kept wherever $\dot z=0$ agree with the Filippov law up to the first "
                r"contact with $S$ outside $S_0$ or the first exit from $S_0$, and not beyond.",
            ),
            *under_a_force(),
        ),
    ),
)
