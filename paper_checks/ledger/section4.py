"""Section IV: illustrative case study. Unit masses, a1 = 0, a2 = 200, SI units."""

from paper_checks.finding import Verdict
from paper_checks.ledger.claim import Claim

SECTION = "IV"

EXAMPLE_SYSTEM = (
    Claim(
        "example-eigenfrequency",
        SECTION,
        "IV-A, before eq. (5)",
        r"With unit masses, $a_1=0$ and $a_2=200$ the first moving body is a harmonic oscillator, which "
        r"has the eigenfrequency of $10$ rad/s when the second body is not sliding and rests upon the "
        r"first one.",
        Verdict.HOLDS,
    ),
    Claim(
        "example-reduction",
        SECTION,
        "eqs. (5), (6)",
        r"For $u=0$ the dynamics (3)–(4) reduces to the autonomous system "
        r"$\ddot{x}_1=-\bigl(2-|\mathrm{sgn}(\dot{z})|\bigr)^{-1}"
        r"\bigl(200\,x_1+b\,\mathrm{sgn}(\dot{z})\bigr)$, "
        r"$\ddot{x}_2=\bigl(1-|\mathrm{sgn}(\dot{z})|\bigr)\ddot{x}_1+b\,\mathrm{sgn}(\dot{z})$.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "example-stiction-never-violated",
        SECTION,
        "after eq. (6)",
        r"Equation (6) does not include the acceleration-dependent switching since the system ensures that "
        r"$|\ddot{x}_1|<b\,m_2^{-1}$.",
        Verdict.REFUTED,
    ),
    Claim(
        "example-onset",
        SECTION,
        "after eq. (6)",
        r"An initial condition $x_1\vee\dot{x}_1\neq 0$ ensures a finite energy storage at $t=t_0=0$ and, "
        r"therefore, the onset of the relative motion of the free oscillator.",
        Verdict.REFUTED,
    ),
    Claim(
        "example-two-modes",
        SECTION,
        "eqs. (7), (8)",
        r"The two modes of the relative motion are $2\ddot{x}_1+200\,x_1=0$, $\ddot{x}_2=\ddot{x}_1$ if "
        r"$\mathrm{sgn}(\dot{z})=0$, and $\ddot{x}_1+200\,x_1=\mp b$, $\ddot{x}_2=\pm b$ if "
        r"$\mathrm{sgn}(\dot{z})\neq 0$. In the first the system behaves as a pair of synchronized "
        r"undamped harmonic oscillators with $x_1-x_2=\mathrm{const}$ and $\dot{x}_1=\dot{x}_2$.",
        Verdict.HOLDS,
    ),
    Claim(
        "example-damped-oscillations",
        SECTION,
        "after eq. (8)",
        r"The piecewise linear dynamics (8) leads to the damped oscillations of $(x_1,\dot{x}_1)$ and, "
        r"thus, to a synchronization of the orbits of both inertial bodies, "
        r"$x_1(t)-x_2(t)\to\mathrm{const}$ and $\dot{z}\to 0$.",
        Verdict.HOLDS_CORRECTED,
    ),
)

NUMERICAL_RESULTS = (
    Claim(
        "start-at-6mm-sticks",
        SECTION,
        "IV-B, first figure (a)",
        r"With $x_1(t_0)=0.006$, the other initial values zero and $b=0.5$, the system (5), (6) starts in "
        r"the stiction mode (7) and remains in this mode at all times, featuring undamped harmonic "
        r"oscillations with the synchronized orbits $(x_1,\dot{x}_1)$ and $(x_2,\dot{x}_2)$.",
        Verdict.REFUTED,
    ),
    Claim(
        "start-with-speed-synchronises",
        SECTION,
        "IV-B, first figure (b)",
        r"With $\dot{x}_1(t_0)=0.15$, the other initial values zero and $b=0.5$, the system (5), (6) "
        r"starts in the mode (8), in a relative motion subject to the frictional damping; further, after a "
        r"period of time the motion of both bodies synchronizes as $\dot{z}$ converges to zero.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "constant-damping-rate",
        SECTION,
        "IV-B, second figure (a)",
        r"With $\dot{x}_1(t_0)=0.15$, the other initial values zero and $b=0.05$, one can recognize a "
        r"constant damping rate of the $\dot{x}_1(t)$ oscillations due to the Coulomb type energy "
        r"dissipation.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "saw-tooth",
        SECTION,
        "IV-B, second figure (a)",
        r"The $\dot{x}_2(t)$ trajectory proceeds as a saw-shaped oscillation, owing to the constant "
        r"acceleration $\ddot{x}_2=\pm b$ until both bodies synchronize.",
        Verdict.HOLDS,
    ),
    Claim(
        "synchronisation-time",
        SECTION,
        "IV-B, second figure (a)",
        r"Both bodies synchronize as $\dot{z}$ approaches zero at the time $t\approx 4.7$ sec.",
        Verdict.REFUTED,
    ),
    Claim(
        "relative-motion-converges",
        SECTION,
        "IV-B, second figure (b)",
        r"The $(z,\dot{z})$ state converges towards the invariant set $\dot{z}=0$ for the three values "
        r"$b=0.05,\,0.2,\,0.5$ of the Coulomb friction coefficient, from $\dot{x}_1(t_0)=0.15$ and the "
        r"other initial values zero.",
        Verdict.HOLDS,
    ),
    Claim(
        "euler-reproduces-figures",
        SECTION,
        "IV-B, first sentence",
        r"The numerical results (both figures) were obtained for system (5), (6) with the first-order "
        r"forward Euler solver; no step size is given.",
        Verdict.HOLDS_CORRECTED,
    ),
)

SECTION_4 = EXAMPLE_SYSTEM + NUMERICAL_RESULTS
