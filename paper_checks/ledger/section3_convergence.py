"""Section III, second half: where the trajectories go, and how fast."""

import sympy as sp

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.letters import guard_rate
from paper_checks.ledger.section3_sliding import width
from theory.energy import critical_energy
from theory.filippov import half_width, phi, transversality
from theory.near_critical import critical_limits, rate_constant
from theory.symbols import a2, b, m1, m2, x1

SECTION = "III"
AFTER_FIGURE = "after Fig. 3"
HALF_PERIOD = sp.pi * sp.sqrt((m1 + m2) / a2)
ECR = sp.Symbol("E_{cr}", positive=True)
RATE = ECR * 4 * sp.pi / 9 * m1 / m2 * sp.sqrt((m1 + m2) / a2)


def sharp_limit() -> Formula:
    """Return the limit of t (E - E_cr)."""
    return Formula(
        r"t\,(E(t)-E_{cr})", "->", RATE, equals(lambda: sp.simplify(rate_constant() / critical_energy()) * ECR)
    )


def _acceleration(sign: int) -> Formula:
    return Formula(r"\dot{v}_2", "=", sign * b / m2, equals(lambda: phi(sign)[2]))


ALTERNATIVES = (
    Claim(
        "infinitely-many-crossings",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "crossings",
                r"Since «minus» in $\Omega_-$ and «plus» in $\Omega_+$, (8) implies that every trajectory has infinitely many "
                r"intersections with the switching plane $S$.",
                minus=_acceleration(-1),
                plus=_acceleration(1),
                kernel=("contact",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "return-alternatives",
        SECTION,
        AFTER_FIGURE,
        r"Any trajectory from $\Omega_-$ either enters the sliding region $S_0$ or intersects $S$ at a "
        r"point $p\in S_-$ transversally and proceeds to $\Omega_+$; any trajectory from $\Omega_+$ either "
        r"enters $S_0$ or proceeds to $\Omega_-$ transversally through $S_+$.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "alternatives",
                r"Any trajectory from $\Omega_-$ that meets $S$ enters $S_0$ and stays in it for some time, or crosses $S$ at an "
                r"isolated instant into $\Omega_+$, at a point of $S_-$ or of $\ell_-$, or touches $S$ at a point of $\ell_+$ and goes "
                r"on in $\Omega_-$; the same holds from $\Omega_+$ with all signs exchanged.",
                kernel=("return-alternatives", "return-alternatives-mirror", "sticks-inside", "slips-on-ray"),
            ),
            clause(
                "transversal",
                r"On $S_-$ the crossing is transversal: both fields have the sign of $-x_1$ across $S$.",
                kernel=("transversal-beyond",),
            ),
            clause(
                "tangent",
                r"On $\ell_-$ it is not, in Filippov's sense: «tangent» there, and the slip begins with $\ddot w>0$, $w=v_1-v_2$.",
                tangent=Formula(
                    guard_rate(1), "=", sp.Integer(0), equals(lambda: transversality(1).subs(x1, -half_width()))
                ),
            ),
        ),
    ),
    Claim(
        "dichotomy",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "dichotomy",
                r"Any trajectory of (5)–(7) either merges with one of the elliptic periodic trajectories "
                r"$\{E=E_0\}\cap S_0$, $E_0\leqslant E_{cr}$, in finite time or converges to the largest of them, "
                r"$\{E=E_{cr}\}\cap S_0$, asymptotically.",
                kernel=("dichotomy",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "stick-durations",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "sticks",
                r"In the latter scenario there are times $t_1<\tau_1<t_2<\tau_2<\cdots$ such that the trajectory "
                r"belongs to $S_0$ during each $[t_k,\tau_k]$ and «limit» as $k\to\infty$.",
                limit=Formula(r"\tau_k-t_k", "->", HALF_PERIOD, equals(lambda: critical_limits().stick_duration)),
                kernel=("exit-and-entry-times",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "slip-durations",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "slips",
                r"For the same times, «limit» as $k\to\infty$: the trajectory leaves $S_0$ only for short intervals of time.",
                limit=Formula(r"t_{k+1}-\tau_k", "->", sp.Integer(0), equals(lambda: critical_limits().slip_duration)),
                kernel=("exit-and-entry-times",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "exits-near-endpoints",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "all",
                r"All the exit points from $S_0$ and entry points to $S_0$ are located near the end points $(\pm L,\,0,\,0)$, "
                r"«width», of the rays $\ell_\pm$.",
                width=width(),
            ),
        ),
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "eventually",
                r"The exit points and the entry points of a trajectory that never merges tend to the end points "
                r"$(\pm L,\,0,\,0)$: «entry» and «speed» at the entries. So all but finitely many are near them; finitely many "
                r"entries may lie anywhere in $S_0$.",
                entry=Formula(
                    r"|x_1|", "->", b * (m1 + m2) / (a2 * m2), equals(lambda: critical_limits().entry_position)
                ),
                speed=Formula(r"|v_1|", "->", sp.Integer(0), equals(lambda: critical_limits().entry_velocity)),
                kernel=("exits-near-endpoints",),
            ),
        ),
    ),
)

CONVERGENCE = (
    Claim(
        "relative-displacement-limit",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "limit",
                r"Equation (8) implies that $x_1-x_2\to\mathrm{const}$ for any trajectory.",
                kernel=("displacement-limit",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "global-stability",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "stable",
                r"The set of periodic trajectories $\{E=E_0\}\cap S_0$ with $E_0\leqslant E_{cr}$, including the "
                r"equilibrium at the origin, is globally asymptotically stable.",
                kernel=("ellipse-stable", "convergence"),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "no-merging-near-critical",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "creeps",
                r"Any trajectory starting from $S_0$ with energy $E_0$ slightly higher than $E_{cr}$ converges to "
                r"the periodic trajectory $\{E=E_{cr}\}\cap S_0$ without merging with it.",
                kernel=("no-merging-from-S0",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "slower-than-exponential",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "slow",
                r"This convergence is slow, slower than exponential.",
                kernel=("slower-than-exponential",),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "rate-one-over-t",
        SECTION,
        AFTER_FIGURE,
        (
            clause(
                "bounds",
                r"The energy of such solutions satisfies $c_1(E(0))/t\leqslant E(t)-E_{cr}\leqslant c_2(E(0))/t$ with "
                r"$0<c_1(E(0))<c_2(E(0))$.",
            ),
        ),
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "two-sided",
                r"For every such solution, which starts on $S_0$ slightly above $E_{cr}$, and every $t_0>0$ there are "
                r"$0<c_1<c_2$, which depend on $E(0)$ and $t_0$ alone, with $c_1/t\leqslant E(t)-E_{cr}\leqslant c_2/t$ for "
                r"$t\geqslant t_0$;",
                kernel=("one-over-t",),
            ),
            clause(
                "limit",
                r"and «limit» as $t\to\infty$, whatever $E(0)$ is.",
                limit=sharp_limit(),
                kernel=("sharp-law",),
            ),
        ),
    ),
)
