"""Section V: discussion."""

from functools import partial

import sympy as sp

from paper_checks.engines.deciders import Decide, equals, implied
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.letters import S, either_sign
from paper_checks.ledger.section2 import under_a_force
from theory import forced
from theory.energy import captive_energy, sigma, sigma_other
from theory.filippov import load, load_threshold, sliding_field
from theory.model import branch_named, slip
from theory.symbols import a1, a2, b, free, m1, m2, u, v1, v1_other, v2, v2_other, x1

SECTION = "V"

DRIVEN, DRIVING = sp.symbols(r"\ddot{x}_2 \ddot{x}_1", real=True)


def _half() -> sp.Expr:
    """Return x2'' where (4) is at its equality, by x1''."""
    found = branch_named("half adhesion")
    return sp.cancel(found.acceleration2 / found.acceleration1) * DRIVING


def _stick_bound() -> Decide:
    """Return how the bound of x2'' in stick is decided, for a1 >= 0 and the load p = a2 x1 + a1 v1 on S0."""
    force = sp.Symbol("p", real=True)
    pull = sp.solve(load(damped=True) - force, x1)[0]

    def loaded() -> list[sp.Basic]:
        threshold, width = sp.fraction(load_threshold())
        return [sp.Le(sp.Abs(force) * width, threshold, evaluate=False)]

    def decide(formula: Formula) -> Evidence:
        acceleration = sp.simplify(sliding_field(damped=True)[2].subs(x1, pull))
        places = [{sp.Abs(DRIVEN): side * acceleration} for side in (1, -1)]
        sides = [implied(loaded, partial(dict, place))(formula) for place in places]
        return min(sides, key=lambda item: (item.passed is True, item.passed is None))

    return decide


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
                r"A pair that starts on $S$ with $E\leqslant E_{cr}$ is synchronised in one mode, stick, for ever; so no alternation follows once it moves on a synchronised "
                r"orbit $\{E=E_0\}\cap S_0$, $E_0\leqslant E_{cr}$.",
                kernel=("sticks-iff", "capture"),
            ),
            clause(
                "alternates",
                r"For every pair some motion sticks and slips in turn for ever;",
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
                r"The place $x_2$ does not: a motion with another $x_2(0)$ keeps the difference for ever,",
                kernel=("displacement-unseen",),
            ),
            clause(
                "offset",
                r"and one that starts with the place and the velocity of the reference, but with another motion of body 1, is left with an offset.",
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
                r"(2)–(4) with $u=0$ have the same solutions as (5)–(7) in Filippov's sense, one from each start.",
            ),
            clause(
                "example",
                r"These solutions also satisfy (11)–(12), which have others besides: (11)–(12) with a stick that is kept wherever $\dot z=0$ agree with the Filippov law up to the first "
                r"contact with $S$ outside $S_0$ or the first exit from $S_0$, and not beyond.",
            ),
            *under_a_force(),
        ),
    ),
    Claim(
        "acceleration-bound",
        SECTION,
        "sixth bullet",
        r"The switched motion system (2)–(4) is underactuated as well as upper-bounded by "
        r"$\ddot{x}_1=\ddot{x}_2$, as for the control efforts, cf. (13).",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "bound",
                r"Under Coulomb's law body 2 changes its velocity by at most $b/m_2$ times the time, whatever the driving body does:",
                kernel=("driven-acceleration",),
            ),
            clause(
                "modes",
                r"in slip «slip», and in stick, on $S_0$, $\ddot x_2=\ddot x_1$ with «stick».",
                slip=Formula(sp.Abs(DRIVEN), "=", b / m2, equals(lambda: sp.Abs(free(slip(1).acceleration2)))),
                stick=Formula(sp.Abs(DRIVEN), "<=", b / m2, _stick_bound()),
            ),
            clause(
                "equality",
                r"(3)–(4) have no other motions; at an instant with $\dot z=0$ and $|\ddot x_1|=b/m_2$ (4) itself hands on «half», and none of it beyond.",
                half=Formula(DRIVEN, "=", DRIVING / 2, equals(_half)),
            ),
        ),
    ),
    Claim(
        "varying-interface",
        SECTION,
        "sixth bullet",
        r"The effect of the time- and state-varying behaviour of the frictional interface, i.e. $b(\cdot)$, on the motion dynamics poses an "
        r"interesting open problem.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "time",
                r"For $b(t)>0$ that is constant on each of finitely many pieces of time there is one solution from every start, and two never move apart;",
                kernel=("varying-contraction", "varying-well-posed"),
            ),
            clause(
                "rate",
                r"so it is with pieces without end, finitely many in every bounded time, «contraction»;",
                contraction=Formula(
                    r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                    "=",
                    -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (v1 - v2 - v1_other + v2_other),
                    equals(forced.contraction_rate),
                ),
            ),
            clause("rule", r"the mode rule stays as it is, with the values of $b$ from the right."),
            clause(
                "state",
                r"For $b$ that depends on the place the contraction is lost: for two slips of one sign $s$ under $b$ and $\tilde b$, $a_1=0$, it becomes «rate», "
                r"which can be positive. That case stays open.",
                rate=Formula(
                    r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                    "=",
                    -(b - forced.b_other) * S * (v1 - v2 - v1_other + v2_other),
                    either_sign(forced.place_dependent_rate),
                ),
            ),
        ),
    ),
)
