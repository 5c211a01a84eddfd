"""Section IV, Fig. 5 (a): the velocities, and what each cycle takes from their peaks."""

from numerics.trajectory.events import Segment
from paper_checks.claims.section_4.starts import time
from paper_checks.claims.words import *

SLIPS = (Mode.SLIP_PLUS, Mode.SLIP_MINUS) * 10 + (Mode.SLIP_PLUS,)
"""The itinerary up to the first adhesion: twenty crossings."""


def velocities_scene(friction: Fraction | None = None) -> Scene:
    """Return the scene of Fig. 5 (a) up to 8 s, with another b (N) where one is given."""
    scene = replace(load_scene("velocities"), until=Fraction(8))
    pair = scene.pair
    return scene if friction is None else replace(scene, pair=Pair(m1=pair.m1, m2=pair.m2, a2=pair.a2, b=friction))


def positive_peaks(trajectory: Trajectory) -> list[arb]:
    """Return the positive peaks of v1 (m/s) before the first adhesion, each proved to lie in a slip+ segment.

    There x1 turns about -b/a2, so v1 peaks where x1 passes that centre upwards, at the speed that the circle gives.
    Raises ValueError where a passage is not proved.
    """
    frame, pair = trajectory.frame, trajectory.scene.pair
    found = []
    with trajectory.arithmetic.context():
        centre = frame.arithmetic.number(-pair.b / pair.a2)
        square = frame.arithmetic.number(pair.a2 / pair.m1)
        for segment in trajectory.segments[1 : _slips(trajectory)]:
            if segment.mode is Mode.SLIP_PLUS:
                (x, v), (end, _) = _ends(trajectory, segment)
                if not (x < centre < end):
                    raise ValueError("x1 is not proved to pass the centre of its oscillation in this slip")
                found.append((v * v + square * (x - centre) ** 2).sqrt())
    return found


def _slips(trajectory: Trajectory) -> int:
    return next(n for n, segment in enumerate(trajectory.segments) if segment.mode is Mode.STICK)


def _ends(trajectory: Trajectory, segment: Segment) -> tuple[tuple[arb, arb], tuple[arb, arb]]:
    """Return (x1, v1) at both ends of a segment, SI."""
    first, last = (segment.state(since)[:2] for since in (trajectory.arithmetic.number(0), segment.length))
    return first, last


def decrements(trajectory: Trajectory) -> tuple[list[arb], list[arb]]:
    """Return the positive peaks of v1 before the first adhesion, and what each cycle takes from them, m/s."""
    peaks = positive_peaks(trajectory)
    with trajectory.arithmetic.context():
        return peaks, [before - after for before, after in pairwise(peaks)]


def _decrement(place: int) -> Callable[[], arb]:
    """Return how a decrement of the positive peaks of v1 in Fig. 5 (a) is enclosed, mm/s."""

    def lost() -> arb:

        run = solved(velocities_scene())
        with run.arithmetic.context():
            return 1000 * decrements(run)[1][place]

    return lost


def _in_mm(speed: Callable[[], Expr]) -> Decide:
    """Decide a speed of Fig. 5 (a), in mm/s."""
    return equals(lambda: 1000 * speed().subs(CASE_STUDY).subs(b, Rational(1, 20)))


def _slope(sign: int) -> Formula:
    return equal(r"\ddot{x}_2", sign * b / m2, lambda: free(slip(sign).acceleration2))


@claim(
    "constant-damping-rate",
    "IV",
    "Fig. 5 (a)",
    CORRECTED,
    r"""
    With $\dot{x}_1(t_0)=0.15$, the other initial values zero and $b=0.05$, one can recognize a constant damping rate
    of the $\dot{x}_1(t)$ oscillations due to the Coulomb type energy dissipation.
    """,
    correction=(
        clause(
            "linear",
            r"""
            Up to the first adhesion, at «adhesion» s, the positive peaks of $v_1$ fall almost linearly: by «first»
            mm/s in the first cycle, by less in each, by «last» mm/s in the last, and for seven cycles by
            $4b/\sqrt{a_2m_1}$ within 1 %.
            """,
            adhesion=time("t", "4.5497", "velocities", 20),
            first=decimal(r"\Delta_1", "14.128", _decrement(0)),
            last=decimal(r"\Delta_9", "13.160", _decrement(-1)),
        ),
        clause(
            "after",
            r"Later the peaks tend like $1/t$ to the peak speed «peak» mm/s of the critical orbit.",
            peak=Formula(r"L\Omega", "=", 5, _in_mm(lambda: half_width() * sqrt(a2 / total_mass()))),
            kernel="creeps-b-0.05 peaks-fall",
        ),
    ),
)
def damping_rate(friction: Fraction | None = None) -> Case:
    """Enclose the positive peaks of v1 and what each cycle takes from them."""
    scene = velocities_scene(friction)
    run = solved(scene)
    peaks, lost = decrements(run)
    with run.arithmetic.context():
        linear = 4 * run.arithmetic.number(scene.pair.b) / run.arithmetic.number(scene.pair.a2 * scene.pair.m1).sqrt()
        off = [abs(one / linear - 1) for one in lost[:7]]
    falling = replace(
        compare("the decrements fall from cycle to cycle; the last is below the first", lost[-1], "<", lost[0]),
        passed=all(after < before for before, after in pairwise(lost)),
        cases=len(lost),
    )
    return because(
        (
            f"The loss per cycle is nearly constant, not exactly, and only while the pair slips. The {len(peaks)} positive peaks of $v_1$ before the first adhesion fall "
            f"by {_milli(lost[0])}, {_milli(lost[1])}, ..., {_milli(lost[-2])}, {_milli(lost[-1])} mm/s: never twice by the same, each "
            f"time by less. The first seven decrements are within 1 % of $4b/\\sqrt{{a_2m_1}}={_milli(linear)}$ mm/s per cycle, which Coulomb friction takes from an oscillator; the nine vary by 7 %. From the first adhesion on the peaks approach $L\\Omega=5$ mm/s slowly, and no rate is constant. (Under (11)–(12) read literally nothing is damped after the first contact, at {first_contact(friction)} s.)"
        ),
        counterexample(
            r"""
            The paper's own: $m_1=m_2=1$, $a_2=200$, $b=0.05$, $\dot x_1(0)=0.15$; the enclosures of the first and the
            last decrement are disjoint.
            """,
            falling,
        ),
        carried(
            "linear",
            itinerary("twenty crossings, then stick", run, (*SLIPS, Mode.STICK)),
            falling,
            enclosed(
                "each of the first seven decrements is within 1 % of $4b/\\sqrt{a_2m_1}$; the largest relative distance",
                all(one < arb("0.01") for one in off),
                text(max(off, key=lambda one: one.mid())),
                len(off),
            ),
        ),
        figure="velocities",
    )


def _milli(value: arb) -> str:
    """Return a speed in mm/s, as text of the digits that are right."""
    return str((1000 * value).str(6, radius=False))


@claim(
    "saw-tooth",
    "IV",
    "Fig. 5 (a)",
    HOLDS,
    clause(
        "slopes",
        r"""
        The $\dot{x}_2(t)$ trajectory proceeds as a saw-shaped oscillation, owing to the constant acceleration «up»
        for $\dot z>0$, «down» for $\dot z<0$ until both bodies synchronize.
        """,
        up=_slope(1),
        down=_slope(-1),
    ),
)
def saw_tooth(friction: Fraction | None = None) -> Case:
    """Show that v2 has the slopes +b and -b in turn up to the first adhesion."""
    run = solved(velocities_scene(friction))
    return because(
        (
            f"Up to the first adhesion, at {rounded(run.events[len(SLIPS) - 1].t, 4)} s, $v_2$ consists of 21 straight pieces of slopes exactly $+b$ and $-b$ in turn: ten "
            "teeth and a last rise. After it the teeth go on, rounded where the bodies stick and straight where they slip. (Under "
            f"(11)–(12) read literally there is one rise only, up to the first contact at {first_contact(friction)} s.)"
        ),
        carried(
            "slopes",
            itinerary("slip+ and slip- in turn, 21 pieces, then stick", run, (*SLIPS, Mode.STICK)),
        ),
        figure="velocities",
    )


def first_contact(friction: Fraction | None) -> str:
    """Return the time of the first contact under (11), (12) read literally, s, as a decimal."""
    return rounded(solved(replace(velocities_scene(friction), law=Law.THREE_VALUED_SGN)).events[0].t, 4)
