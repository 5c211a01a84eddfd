"""Section III, second half: where the trajectories go, and how fast; the figure of both itineraries."""

from paper_checks.evidence import Verdict
from paper_checks.ledger.claim import Claim

SECTION = "III"
AFTER_FIGURE = "after the figure of both itineraries"

CONVERGENCE = (
    Claim(
        "infinitely-many-crossings",
        SECTION,
        AFTER_FIGURE,
        r"Since $\dot{v}_2=-b/m_2<0$ in $\Omega_-$ and $\dot{v}_2=b/m_2>0$ in $\Omega_+$, (edot) implies "
        r"that every trajectory has infinitely many intersections with the switching plane $S$.",
        Verdict.HOLDS,
    ),
    Claim(
        "return-alternatives",
        SECTION,
        AFTER_FIGURE,
        r"Any trajectory from $\Omega_-$ either enters the sliding region $S_0$ or intersects $S$ at a "
        r"point $p\in S_-$ transversally and proceeds to $\Omega_+$; any trajectory from $\Omega_+$ either "
        r"enters $S_0$ or proceeds to $\Omega_-$ transversally through $S_+$.",
        Verdict.HOLDS,
    ),
    Claim(
        "dichotomy",
        SECTION,
        AFTER_FIGURE,
        r"Any trajectory of (e1)–(e3) either merges with one of the elliptic periodic trajectories "
        r"$\{E=E_0\}\cap S_0$, $E_0\leqslant E_{cr}$, in finite time or converges to the largest of them, "
        r"$\{E=E_{cr}\}\cap S_0$, asymptotically.",
        Verdict.HOLDS,
    ),
    Claim(
        "stick-durations",
        SECTION,
        AFTER_FIGURE,
        r"In the latter scenario there are times $t_1<\tau_1<t_2<\tau_2<\cdots$ such that the trajectory "
        r"belongs to $S_0$ during each $[t_k,\tau_k]$ and $\tau_k-t_k\to\pi\sqrt{(m_1+m_2)/a}$ as "
        r"$k\to\infty$.",
        Verdict.HOLDS,
    ),
    Claim(
        "slip-durations",
        SECTION,
        AFTER_FIGURE,
        r"For the same times, $t_{k+1}-\tau_k\to 0$ as $k\to\infty$: the trajectory leaves $S_0$ only for "
        r"short intervals of time.",
        Verdict.HOLDS,
    ),
    Claim(
        "exits-near-endpoints",
        SECTION,
        AFTER_FIGURE,
        r"All the exit points from $S_0$ and entry points to $S_0$ are located near the end points $(\pm "
        r"b(m_1+m_2)/(a m_2),\,0,\,0)$ of the rays $\ell_\pm$.",
        Verdict.HOLDS,
    ),
    Claim(
        "relative-displacement-limit",
        SECTION,
        AFTER_FIGURE,
        r"Equation (edot) implies that $x_1-x_2\to\mathrm{const}$ for any trajectory.",
        Verdict.HOLDS,
    ),
    Claim(
        "global-stability",
        SECTION,
        AFTER_FIGURE,
        r"The set of periodic trajectories $\{E=E_0\}\cap S_0$ with $E_0\leqslant E_{cr}$, including the "
        r"equilibrium at the origin, is globally asymptotically stable.",
        Verdict.HOLDS,
    ),
    Claim(
        "no-merging-near-critical",
        SECTION,
        AFTER_FIGURE,
        r"Any trajectory starting from $S_0$ with energy $E_0$ slightly higher than $E_{cr}$ converges to "
        r"the periodic trajectory $\{E=E_{cr}\}\cap S_0$ without merging with it.",
        Verdict.HOLDS,
    ),
    Claim(
        "slower-than-exponential",
        SECTION,
        AFTER_FIGURE,
        r"This convergence is slow, slower than exponential.",
        Verdict.HOLDS,
    ),
    Claim(
        "rate-one-over-t",
        SECTION,
        AFTER_FIGURE,
        r"The energy of such solutions satisfies $c_1(E(0))/t\leqslant E(t)-E_{cr}\leqslant c_2(E(0))/t$ "
        r"with $0<c_1(E(0))<c_2(E(0))$.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "viscous-energy-rate",
        SECTION,
        "last paragraph",
        r"With viscous friction, the counterpart of (edot) reads $\dot{E}=-b\,|v_1-v_2|-a_1 v_1^2$.",
        Verdict.HOLDS,
    ),
    Claim(
        "viscous-origin-stable",
        SECTION,
        "last paragraph",
        r"When a relatively small viscous friction is present, the switching dynamics is similar but the "
        r"trajectories inside the sliding region spiral towards the equilibrium at the origin, which is "
        r"globally stable in this case.",
        Verdict.HOLDS,
    ),
    Claim(
        "itinerary-that-merges",
        SECTION,
        "figure of both itineraries, (a)",
        r"A trajectory enters the sliding region $S_0$ of $S$ and merges with one of the elliptic closed "
        r"trajectories located in $S_0$; its energy satisfies $E<E_{cr}$.",
        Verdict.HOLDS,
    ),
    Claim(
        "itinerary-that-creeps",
        SECTION,
        "figure of both itineraries, (b)",
        r"A trajectory that starts at $O_1\in\Omega_+$ crosses $S$ at $A_1\in S_+$ into $\Omega_-$ and at "
        r"$B_1\in S_-$ back into $\Omega_+$, enters $S_0$ at $A_2$, exits through $C_1\in\ell_+$ into "
        r"$\Omega_-$, re-enters $S_0$ at $B_2$, exits through $D_1\in\ell_-$ into $\Omega_+$, re-enters "
        r"$S_0$ at $A_3$ and proceeds inside $S_0$ to $O_2$. Continued, it converges asymptotically to the "
        r"elliptic trajectory of energy $E_{cr}$.",
        Verdict.HOLDS,
    ),
)
