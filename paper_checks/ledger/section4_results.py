"""Section IV-B: numerical results."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import sympy as sp

from paper_checks.engines.deciders import Decide, decimal, equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.points import START_AT_6MM
from paper_checks.ledger.section3_sliding import width
from theory.energy import critical_energy, energy
from theory.filippov import half_width
from theory.model import CASE_STUDY, slip
from theory.symbols import a2, b, free, m2, total_mass

if TYPE_CHECKING:
    from flint import arb

SECTION = "IV"


def _event(scene: str, number: int) -> Callable[[], arb]:
    """Return how the time of an event of a shipped scene is enclosed, s."""

    def time() -> arb:
        from numerics.scene.file import load_scene
        from paper_checks.engines.enclosure import solved

        found: arb = solved(load_scene(scene)).events[number].t
        return found

    return time


def _relative_speed() -> arb:
    """Return |z'| at 4.7 s in Fig. 5 (a), mm/s."""
    from fractions import Fraction

    from numerics.scene.file import load_scene
    from paper_checks.engines.enclosure import solved

    run = solved(load_scene("velocities"))
    state = run.sol(Fraction(47, 10))
    with run.arithmetic.context():
        return 1000 * abs(state[1] - state[3])


def _decrement(place: int) -> Callable[[], arb]:
    """Return how a decrement of the positive peaks of v1 in Fig. 5 (a) is enclosed, mm/s."""

    def lost() -> arb:
        from paper_checks.engines.enclosure import solved
        from paper_checks.steps.velocity_peaks import decrements, velocities_scene

        run = solved(velocities_scene())
        with run.arithmetic.context():
            return 1000 * decrements(run)[1][place]

    return lost


def _later_speed() -> arb:
    """Return a bound of |z'| from the first exit on in Fig. 5 (a), mm/s."""
    from paper_checks.engines.enclosure import solved
    from paper_checks.steps.perpetual_slips import first_exit, relative_speed_bound
    from paper_checks.steps.velocity_peaks import velocities_scene

    run = solved(velocities_scene())
    with run.arithmetic.context():
        return 1000 * relative_speed_bound(run, first_exit(run))


def _in_mm(speed: Callable[[], sp.Expr]) -> Decide:
    """Decide a speed of Fig. 5 (a), in mm/s."""
    return equals(lambda: 1000 * speed().subs(CASE_STUDY).subs(b, sp.Rational(1, 20)))


def _time(letter: str, digits: str, scene: str, number: int) -> Formula:
    return Formula(letter, "=...", sp.Rational(digits), decimal(_event(scene, number)))


def _slope(sign: int) -> Formula:
    return Formula(r"\ddot{x}_2", "=", sign * b / m2, equals(lambda: free(slip(sign).acceleration2)))


NUMERICAL_RESULTS = (
    Claim(
        "start-at-6mm-sticks",
        SECTION,
        "Fig. 4 (a)",
        r"With $x_1(t_0)=0.006$, the other initial values zero and $b=0.5$, the system (11), (12) starts in "
        r"the stiction mode (13) and remains in this mode at all times, featuring undamped harmonic "
        r"oscillations with the synchronized orbits $(x_1,\dot{x}_1)$ and $(x_2,\dot{x}_2)$.",
        Verdict.REFUTED,
        correction=(
            clause(
                "from-rest",
                r"From rest the pair sticks for ever exactly if $|x_1(0)|\leqslant L$, «width»; here «here».",
                width=width(),
                here=Formula(
                    "L",
                    "=",
                    sp.Rational(1, 200),
                    equals(lambda: half_width().subs(CASE_STUDY).subs(b, sp.Rational(1, 2))),
                ),
                kernel=("sticks-from-rest", "slips-beyond"),
            ),
            clause(
                "slips",
                r"At $x_1(0)=0.006$ m it slips at once; as it starts on $S$ with «energy» J above «level» J and $m_1/m_2=1>\mu^*$ (critical-mass-ratio), its energy stays above $E_{cr}$, and it slips "
                r"infinitely often.",
                energy=Formula("E(0)", "=", sp.Rational(9, 2500), equals(lambda: energy().subs(START_AT_6MM))),
                level=Formula("E_{cr}", "=", sp.Rational(1, 400), equals(lambda: critical_energy().subs(START_AT_6MM))),
                kernel=(
                    "slips-from-6-mm",
                    "turning-point",
                    "critical-mass-ratio-digits",
                    "heavy-never-merges",
                    "sticks-iff",
                    "contact",
                ),
            ),
            clause(
                "literal",
                r"(3)–(4) have this motion only. (11)–(12) as printed, without the bracket of (4), have at least two solutions from there: the stuck $x_1=0.006\cos 10t$ that the paper shows, and that slip.",
            ),
        ),
    ),
    Claim(
        "start-with-speed-synchronises",
        SECTION,
        "Fig. 4 (b)",
        r"With $\dot{x}_1(t_0)=0.15$, the other initial values zero and $b=0.5$, the system (11), (12) "
        r"starts in the mode (14), in a relative motion subject to the frictional damping; further, after a "
        r"period of time the motion of both bodies synchronizes as $\dot{z}$ converges to zero.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "adheres",
                r"The pair starts in the mode (14), crosses $S$ once and adheres first from «from_» s to «to» s;",
                from_=_time("t", "0.2763", "start-with-speed", 1),
                to=_time("t", "0.3353", "start-with-speed", 2),
            ),
            clause(
                "for-ever",
                r"from then on it sticks and slips in turn for ever; $\dot z\to 0$ as $t\to\infty$, in infinitely many slips, each "
                r"slower than the one before.",
            ),
        ),
    ),
    Claim(
        "constant-damping-rate",
        SECTION,
        "Fig. 5 (a)",
        r"With $\dot{x}_1(t_0)=0.15$, the other initial values zero and $b=0.05$, one can recognize a "
        r"constant damping rate of the $\dot{x}_1(t)$ oscillations due to the Coulomb type energy "
        r"dissipation.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "linear",
                r"Up to the first adhesion, at «adhesion» s, the positive peaks of $v_1$ fall almost linearly: by «first» mm/s in the first "
                r"cycle, by less in each, by «last» mm/s in the last, and for seven cycles by $4b/\sqrt{a_2m_1}$ within 1 %. After it the decay "
                r"slows down like $1/t$ towards the peak speed «peak» mm/s of the critical orbit.",
                adhesion=_time("t", "4.5497", "velocities", 20),
                first=Formula(r"\Delta_1", "=...", sp.Rational("14.128"), decimal(_decrement(0))),
                last=Formula(r"\Delta_9", "=...", sp.Rational("13.160"), decimal(_decrement(-1))),
                peak=Formula(r"L\Omega", "=", sp.Integer(5), _in_mm(lambda: half_width() * sp.sqrt(a2 / total_mass()))),
            ),
        ),
    ),
    Claim(
        "saw-tooth",
        SECTION,
        "Fig. 5 (a)",
        (
            clause(
                "slopes",
                r"The $\dot{x}_2(t)$ trajectory proceeds as a saw-shaped oscillation, owing to the constant acceleration «up» for "
                r"$\dot z>0$, «down» for $\dot z<0$ until both bodies synchronize.",
                up=_slope(1),
                down=_slope(-1),
            ),
        ),
        Verdict.HOLDS,
    ),
    Claim(
        "synchronisation-time",
        SECTION,
        "Fig. 5 (a)",
        r"Both bodies synchronize as $\dot{z}$ approaches zero at the time $t\approx 4.7$ sec.",
        Verdict.REFUTED,
        correction=(
            clause(
                "slipping",
                r"At 4.7 s the bodies slip, «speed» mm/s.",
                speed=Formula(r"|\dot z(4.7)|", "=...", sp.Rational("2.3139"), decimal(_relative_speed)),
            ),
            clause(
                "adheres",
                r"They adhere first from «from_» s to «to» s, and again from «again» s;",
                from_=_time("t", "4.5497", "velocities", 20),
                to=_time("t", "4.5795", "velocities", 21),
                again=_time("t", "4.7717", "velocities", 22),
                kernel=("first-adhesion",),
            ),
            clause(
                "for-ever",
                r"they stick and slip in turn for ever, with $|\dot z|\leqslant\beta$, «bound» mm/s, falling from slip to slip to 0 as $t\to\infty$.",
                bound=Formula(r"\beta", "=...", sp.Rational("2.320"), decimal(_later_speed)),
            ),
        ),
    ),
    Claim(
        "relative-motion-converges",
        SECTION,
        "Fig. 5 (b)",
        r"The $(z,\dot{z})$ state converges towards the invariant set $\dot{z}=0$ for the three values "
        r"$b=0.05,\,0.2,\,0.5$ of the Coulomb friction coefficient, from $\dot{x}_1(t_0)=0.15$ and the "
        r"other initial values zero.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "limit",
                r"From every start, for every $b$, $\dot z\to 0$ and $z$ has a limit: $(z,\dot z)$ tends to one point of the line $\dot z=0$.",
                kernel=("synchronisation", "displacement-limit"),
            ),
            clause(
                "invariant",
                r"That line is not invariant: a pair with $\dot z=0$ keeps $\dot z=0$ from then on exactly if $E\leqslant E_{cr}$.",
                kernel=("sticks-iff",),
            ),
            clause(
                "again",
                r"For each of the three values of $b$ the pair comes to $\dot z=0$ and leaves it again without end, each slip slower than the one before.",
            ),
        ),
    ),
    Claim(
        "euler-reproduces-figures",
        SECTION,
        "IV-B, first sentence",
        r"The numerical results (both figures) were obtained for system (11), (12) with the first-order "
        r"forward Euler solver; no step size is given.",
        Verdict.HOLDS_CORRECTED,
    ),
)
