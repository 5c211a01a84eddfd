"""Section IV, Fig. 5: when the pair first sticks, and that it slips for ever again."""

from fractions import Fraction

from paper_checks.claims.section_3.itineraries import (
    first_exit,
    relative_speed_bound,
    starts_below,
)
from paper_checks.claims.section_4.starts import time
from paper_checks.claims.section_4.velocities import SLIPS, first_contact, velocities_scene
from paper_checks.claims.words import *
from paper_checks.decide.euler_in_balls import run as run_euler


def _relative_speed() -> arb:
    """Return |z'| at 4.7 s in Fig. 5 (a), mm/s."""

    run = solved(load_scene("velocities"))
    state = run.sol(Fraction(47, 10))
    with run.arithmetic.context():
        return 1000 * abs(state[1] - state[3])


def _later_speed() -> arb:
    """Return a bound of |z'| from the first exit on in Fig. 5 (a), mm/s."""

    run = solved(velocities_scene())
    with run.arithmetic.context():
        return 1000 * relative_speed_bound(run, first_exit(run))


@claim(
    "synchronisation-time",
    "IV",
    "Fig. 5 (a)",
    REFUTED,
    r"Both bodies synchronize as $\dot{z}$ approaches zero at the time $t\approx 4.7$ sec.",
    correction=(
        clause(
            "slipping",
            r"At 4.7 s the bodies slip, «speed» mm/s.",
            speed=decimal(r"|\dot z(4.7)|", "2.3139", _relative_speed),
        ),
        clause(
            "adheres",
            r"They adhere first from «from_» s to «to» s, and again from «again» s;",
            from_=time("t", "4.5497", "velocities", 20),
            to=time("t", "4.5795", "velocities", 21),
            again=time("t", "4.7717", "velocities", 22),
            kernel="first-adhesion",
        ),
        clause(
            "for-ever",
            r"they stick and slip in turn without end, with $|\dot z|\leqslant\beta$, «bound» mm/s, falling from slip to slip to 0 as $t\to\infty$.",
            kernel="creeps-b-0.05 synchronisation",
            bound=decimal(r"\beta", "2.320", _later_speed),
        ),
    ),
)
def synchronisation_time(
    friction: Fraction | None = None,
    time: Fraction = Fraction(47, 10),
) -> Case:
    """Look at the pair at t = `time` s, and at its adhesions before and after."""
    run = solved(velocities_scene(friction))
    entries = [event for event in run.events if event.kind is EventKind.ENTRY]
    y = run.sol(time)
    begins, ends, again = (rounded(one.t, 4) for one in (entries[0], first_exit(run), entries[1]))
    slipping = rounded(1000 * abs(y[1] - y[3]), 2)
    late = {h: run_euler("velocities", h).adhesion_time for h in (Fraction("1e-4"), Fraction("2e-4"))}
    euler = " and ".join(sorted({f"{float(one):.4g}" for one in late.values() if one is not None}))
    witnesses = (
        _mode_at(run, time),
        itinerary("twenty crossings, then stick", run, (*SLIPS, Mode.STICK)),
        *starts_below(run, "Fig. 5 (a)"),
        kernel.step("creeps-b-0.05"),
    )
    return because(
        (
            f"At $t={float(time):g}$ s the bodies slip at {slipping} mm/s, almost the fastest that they ever slip after {ends} s. They stick first "
            f"from {begins} s to {ends} s, again from {again} s, and so on without end: no time of lasting synchronisation exists, and "
            f"$\\dot z\\to 0$ only as $t\\to\\infty$. Under (11)–(12) read literally they stick permanently, but from {first_contact(friction)} s on. "
            f"Forward Euler with steps of $10^{{-4}}$ s or $2\\cdot 10^{{-4}}$ s misses the first adhesion and first sticks at {euler} s "
            "(see euler-reproduces-figures): the printed 4.7 s may come from such a step."
        ),
        counterexample(
            (
                "The paper's own: $m_1=m_2=1$, $a_2=200$, $b=0.05$, $\\dot x_1(0)=0.15$; "
                f"$|\\dot z({float(time):g})|={slipping}$ mm/s."
            ),
            witnesses,
        ),
        carried("slipping"),
        carried("adheres"),
        carried("for-ever"),
        reading(
            "synchronize at the time $t\\approx 4.7$ sec",
            r"$\dot z(t)=0$ at $t=4.7$ s or at all times $t$ from about 4.7 s on",
        ),
        reading(
            "falling from slip to slip",
            r"$|\dot z(\tau_{n+1}+u)|<|\dot z(\tau_n+u)|$ at each time $u$ of the later slip, the slips beginning at $\tau_1<\tau_2<\cdots$",
        ),
        figure="velocities",
    )


def _mode_at(trajectory: Trajectory, time: Fraction) -> Evidence:
    mode = trajectory.mode_at(time)
    statement = f"at $t={float(time):g}$ s the bodies slip"
    return enclosed(statement, mode is not Mode.STICK, mode.value)
