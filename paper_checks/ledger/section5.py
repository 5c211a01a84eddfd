"""Section V: discussion."""

from paper_checks.finding import Verdict
from paper_checks.ledger.claim import Claim

SECTION = "V"

SECTION_5 = (
    Claim(
        "synchronisation-all-parameters",
        SECTION,
        "first bullet",
        r"For any initial conditions of the free system (2)–(4) with $u=0$, the global asymptotic "
        r"convergence $\dot{z}(t)\to 0$ for $t\to\infty$ is warranted for all the admissible (i.e. "
        r"physical) system parameters $m_1,m_2,a_2,b>0$ and $a_1\geqslant 0$.",
        Verdict.HOLDS,
    ),
    Claim(
        "finite-time-then-alternation",
        SECTION,
        "second bullet",
        r"Zero convergence of $\dot{z}(t)$ does not take place in a single dynamic mode. A finite time "
        r"convergence towards a synchronized orbit can precede the following long-term alternation of the "
        r"stiction and slipping modes.",
        Verdict.HOLDS,
    ),
    Claim(
        "viscous-accelerates",
        SECTION,
        "third bullet",
        r"The viscous damping of the driving body influences the trajectories, but has no principal impact "
        r"on the synchronization mechanism; a purposefully controlled viscous damping of the active body "
        r"can accelerate the synchronization.",
        Verdict.HOLDS_CORRECTED,
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
    ),
    Claim(
        "acceleration-bound",
        SECTION,
        "sixth bullet",
        r"The switched motion system (2)–(4) is underactuated as well as upper-bounded by "
        r"$\ddot{x}_1=\ddot{x}_2$, as for the control efforts, cf. (7).",
        Verdict.HOLDS_CORRECTED,
    ),
)
