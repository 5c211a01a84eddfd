"""Section IV, Fig. 4: the two starts of the example, and where their relative motion goes."""

from fractions import Fraction

from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.section_3.itineraries import (
    starts_below,
)
from paper_checks.claims.section_3.sliding import width
from paper_checks.claims.words import *


def _event(scene: str, number: int) -> Callable[[], arb]:
    """Return how the time of an event of a shipped scene is enclosed, s."""

    def time() -> arb:

        found: arb = solved(load_scene(scene)).events[number].t
        return found

    return time


def time(letter: str, digits: str, scene: str, number: int) -> Formula:
    """Return the time of an event of a scene, s."""
    return decimal(letter, digits, _event(scene, number))


ALTERNATION = (Mode.STICK, Mode.SLIP_PLUS, Mode.STICK, Mode.SLIP_MINUS)


SLOWER = reading(
    "each slip slower than the one before",
    r"$|\dot z(\tau_{n+1}+u)|<|\dot z(\tau_n+u)|$ at each time $u$ of the later slip, the slips beginning at $\tau_1<\tau_2<\cdots$",
)


def literally(scene: Scene) -> Scene:
    """Return the scene under eqs (11), (12) read with the three-valued signum."""
    return replace(scene, law=Law.THREE_VALUED_SGN)


@claim(
    "start-at-6mm-sticks",
    "IV",
    "Fig. 4 (a)",
    CORRECTED,
    r"""
    With $x_1(t_0)=0.006$, the other initial values zero and $b=0.5$, the system (11), (12) starts in the stiction
    mode (13) and remains in this mode at all times, featuring undamped harmonic oscillations with the synchronized
    orbits $(x_1,\dot{x}_1)$ and $(x_2,\dot{x}_2)$.
    """,
    correction=(
        clause(
            "literal",
            r"Of (11)–(12) as printed that is true, and of one of their solutions only. Without the bracket of (4) they have at least two from this start: the stuck $x_1=0.006\cos 10t$ that the paper shows, and one that slips at once. (3)–(4) and Coulomb's law have the second only:",
            kernel="two-solutions-from-6-mm",
        ),
        clause(
            "from-rest",
            r"under them the pair sticks from rest permanently exactly if $|x_1(0)|\leqslant L$, «width»; here «here».",
            width=width(),
            here=equal(
                "L",
                Rational(1, 200),
                lambda: half_width().subs(CASE_STUDY).subs(b, Rational(1, 2)),
            ),
            kernel="sticks-from-rest slips-beyond switching-iff filippov-iff",
        ),
        clause(
            "slips",
            r"""
            At $x_1(0)=0.006$ m it slips at once; as it starts on $S$ with «energy» J above «level» J and
            $m_1/m_2=1>\mu^*$ (critical-mass-ratio), its energy stays above $E_{cr}$, and it slips infinitely often.
            """,
            energy=equal("E(0)", Rational(9, 2500), lambda: energy().subs(START_AT_6MM)),
            level=equal("E_{cr}", Rational(1, 400), lambda: critical_energy().subs(START_AT_6MM)),
            kernel="slips-from-6-mm turning-point critical-mass-ratio-digits heavy-never-merges sticks-iff contact switching-iff filippov-iff",
        ),
    ),
)
def permanent_stiction(start: Fraction = Fraction(6, 1000)) -> Case:
    """Start from rest at `start` m: inside or outside S0 decides."""
    scene = replace(load_scene("start-at-6mm"), initial=State(x1=start))
    place, slipping = at_rest(str(start)), solved(scene)
    witnesses = (
        exhibit(
            "at the start both fields point into $\\Omega_-$, $\\Phi_+\\cdot n_S<0$ and $\\Phi_-\\cdot n_S<0$: no solution stays on $S$",
            place,
            *((transversality(sign), "<", 0) for sign in (1, -1)),
        ),
        *starts_below(slipping, "Fig. 4 (a)"),
    )
    return because(
        (
            f"True of (11)–(12) as printed, which have another solution too; false of (3)–(4) and of Coulomb's law. The start $x_1={value_at(x1, place)}$ m is outside the sliding region, whose half width is $L={value_at(half_width(), place)}$ m. Sticking would take a force of "
            f"{value_at(Abs(m2 * free(stick().acceleration1)), place)} N through an interface that carries {value_at(b, place)} N. Under (3)–(4) and in "
            f"Filippov's sense the pair slips at once, sticks first at {rounded(slipping.events[0].t, 4)} s, and then sticks and slips in turn without end. Only (11)–(12) read literally, with sgn(0) = 0 and without "
            "the stiction bracket of (4), have the solution that the paper shows; it is not their only one, since the slipping "
            "solution meets (11)–(12) at all but isolated times too. Forward Euler picks the stuck one, as it starts at $\\dot z=0$ "
            "exactly and gives both bodies the same increments."
        ),
        counterexample(
            "The paper's own: $m_1=m_2=1$, $a_2=200$, $b=0.5$, $x_1(0)=0.006$, the other initial values zero. The motion that slips at once solves (11)–(12) too, and it is the only one of (3)–(4).",
            kernel.step("two-solutions-from-6-mm"),
            witnesses,
        ),
        carried("from-rest"),
        carried("slips"),
        figure="start-at-6mm",
    )


@claim(
    "start-with-speed-synchronises",
    "IV",
    "Fig. 4 (b)",
    CORRECTED,
    r"""
    With $\dot{x}_1(t_0)=0.15$, the other initial values zero and $b=0.5$, the system (11), (12) starts in the mode
    (14), in a relative motion subject to the frictional damping; further, after a period of time the motion of both
    bodies synchronizes as $\dot{z}$ converges to zero.
    """,
    correction=(
        clause(
            "adheres",
            r"The pair starts in the mode (14), crosses $S$ once and adheres first from «from_» s to «to» s;",
            from_=time("t", "0.27630", "start-with-speed", 1),
            to=time("t", "0.33539", "start-with-speed", 2),
        ),
        clause(
            "for-ever",
            r"""
            from then on it sticks and slips in turn without end; $\dot z\to 0$ as $t\to\infty$, in infinitely many
            slips, each slower than the one before.
            """,
            kernel="creeps-b-0.5 synchronisation",
        ),
    ),
)
def synchronises(speed: Fraction = Fraction(15, 100)) -> Case:
    """Start with v1 = `speed` m/s, b = 0.5."""
    scene = replace(load_scene("start-with-speed"), initial=State(v1=speed))
    found, literal = solved(scene), solved(literally(scene))
    contact = literal.events[0]
    witnesses = (
        itinerary(
            "crosses $S$ once, then sticks and slips in turn",
            found,
            (Mode.SLIP_PLUS, Mode.SLIP_MINUS, *2 * ALTERNATION),
        ),
        *starts_below(found, "Fig. 4 (b)"),
    )
    return because(
        (
            "The bodies start in relative motion, as the paper says, but no period of time ends it. They stick first from "
            f"{rounded(found.events[1].t, 4)} s to {rounded(found.events[2].t, 4)} s, and then slip again and again, without end; $\\dot z$ tends to zero only as $t\\to\\infty$. Under (11)–(12) read literally they would stick permanently from their first contact on, at {rounded(contact.t, 4)} s, by a force beyond $b$."
        ),
        counterexample(
            r"""
            The paper's own: $m_1=m_2=1$, $a_2=200$, $b=0.5$, $\dot x_1(0)=0.15$; the excess energy $w=E/E_{cr}-1$ is
            positive after every slip.
            """,
            witnesses,
            kernel.step("creeps-b-0.5"),
        ),
        carried("adheres", witnesses[0]),
        SLOWER,
        figure="start-with-speed",
    )


@claim(
    "relative-motion-converges",
    "IV",
    "Fig. 5 (b)",
    CORRECTED,
    r"""
    The $(z,\dot{z})$ state converges towards the invariant set $\dot{z}=0$ for the three values $b=0.05,\,0.2,\,0.5$
    of the Coulomb friction coefficient, from $\dot{x}_1(t_0)=0.15$ and the other initial values zero.
    """,
    correction=(
        clause(
            "limit",
            r"From every initial state, for every $b$, $\dot z\to 0$ and $z$ has a limit: $(z,\dot z)$ tends to one point of the line $\dot z=0$.",
            kernel="synchronisation displacement-limit",
        ),
        clause(
            "invariant",
            r"That line is not invariant: a pair with $\dot z=0$ keeps $\dot z=0$ from then on exactly if $E\leqslant E_{cr}$.",
            kernel="sticks-iff",
        ),
        clause(
            "again",
            r"For each of the three values of $b$ the pair comes to $\dot z=0$ and leaves it again without end, each slip after its first adhesion, from the second on, slower than the one before.",
            kernel="creeps-b-0.05 creeps-b-0.2 creeps-b-0.5",
        ),
    ),
)
def convergence(speed: Fraction = Fraction(15, 100)) -> Case:
    """Start with v1 = `speed` m/s, b = 0.05: the kernel has all three values of b."""
    run = solved(replace(load_scene("relative-motion-b005"), initial=State(v1=speed), until=Fraction(8)))
    entry, leaves = next((one, two) for one, two in pairwise(run.events) if two.kind is EventKind.EXIT)
    return because(
        r"""
        $\dot z\to 0$ and $z$ has a limit, but $\dot z=0$ is not invariant. All three motions leave it again and again.
        Friction dissipates $b|\dot z|$ of a finite energy, so the integral of $|\dot z|$ is finite; as $\dot z$ is
        Lipschitz continuous, $\dot z\to 0$. For all three values of $b$ convergence takes infinitely long: after the
        first exit from $S_0$ the pair sticks and slips in turn without end, each slip slower than the one before. The
        state tends to the part $E=E_{cr}$ of $S_0$. Under (11)–(12) read literally $\dot z=0$ from the first contact
        on.
        """,
        counterexample(
            (
                "$b=0.05$, $\\dot x_1(0)=0.15$: the pair is at $\\dot z=0$ from "
                f"{rounded(entry.t, 4)} s on, with an energy above $E_{{cr}}$, and slips again from {rounded(leaves.t, 4)} s on."
            ),
            compare("with an energy above $E_{cr}$: $w=E/E_{cr}-1$", entry.reduced.w, ">", point(0)),
        ),
        correction(dissipation.energy_rate, *starts_below(run, "b = 0.05")),
        SLOWER,
        figure="relative-motion",
    )
