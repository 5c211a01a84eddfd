"""Section IV-B, Fig. 5 (a): when both bodies synchronise for b = 0.05, and when they do not."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from numerics.linear.modes import EventKind, Mode
from numerics.trajectory.trajectory import Trajectory
from paper_checks.checks.registry import Context, check
from paper_checks.checks.section4_velocities import first_contact, literal_reading
from paper_checks.engines.enclosure import compare, itinerary, rounded, solved, within
from paper_checks.engines.euler_in_balls import run as run_euler
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.ledger import claim_named
from paper_checks.steps.perpetual_slips import (
    ARGUMENT,
    first_exit,
    largest_relative_speed,
    never_merges,
    relative_speed_bound,
)
from paper_checks.steps.turned_back import merges_or_creeps
from paper_checks.steps.velocity_peaks import SLIPS, velocities_scene

_AFTER = (Mode.STICK, Mode.SLIP_MINUS, Mode.STICK, Mode.SLIP_PLUS)


@check("synchronisation-time")
def synchronisation_time(
    context: Context,  # noqa: ARG001
    friction: Fraction | None = None,
    time: Fraction = Fraction(47, 10),
) -> Finding:
    """Look at the pair at t = `time` s, and at its adhesions before and after."""
    run = solved(velocities_scene(friction))
    entries = [event for event in run.events if event.kind is EventKind.ENTRY]
    bound = relative_speed_bound(run, first_exit(run))
    y, literal = run.sol(time), literal_reading(friction)
    begins, ends, again = (rounded(one.t, 4) for one in (entries[0], first_exit(run), entries[1]))
    slipping = rounded(1000 * abs(y[1] - y[3]), 2)
    late = {h: run_euler("velocities", h).adhesion_time for h in (Fraction("1e-4"), Fraction("2e-4"))}
    euler = " and ".join(sorted({f"{float(one):.4g}" for one in late.values() if one is not None}))
    counterexample = (
        _mode_at(run, time),
        compare("$|\\dot z(4.7)|$ (m/s)", abs(y[1] - y[3]), ">", arb("0.0023")),
        itinerary("twenty crossings, then stick, slip-, stick, slip+", run, (*SLIPS, *_AFTER)),
        within("first adhesion (s)", entries[0].t, "4.549769", "4.549770"),
        within("its end (s)", first_exit(run).t, "4.579537", "4.579538"),
        within("second adhesion (s)", entries[1].t, "4.771754", "4.771755"),
        *never_merges(run, "Fig. 5 (a)"),
        *literal,
    )
    return conclude(
        Verdict.REFUTED,
        f"Read as: no slip after about that time. At $t={float(time):g}$ s the bodies slip at {slipping} mm/s, almost the fastest that they ever slip after {ends} s. They stick first "
        f"from {begins} s to {ends} s, again from {again} s, and so on for ever: no time of lasting synchronisation exists, and "
        f"$\\dot z\\to 0$ only as $t\\to\\infty$. Under (11)–(12) read literally they stick for ever, but from {first_contact(friction)} s on. "
        f"Forward Euler with steps of $10^{{-4}}$ s or $2\\cdot 10^{{-4}}$ s misses the first adhesion and first sticks at {euler} s "
        "(see euler-reproduces-figures): the printed 4.7 s may come from such a step.",
        *(item.as_counterexample() for item in counterexample),
        carried("slipping", compare("$|\\dot z(4.7)|$ (m/s)", abs(y[1] - y[3]), ">", arb("0.0023")).as_correction()),
        carried(
            "adheres",
            within("first adhesion (s)", entries[0].t, "4.549769", "4.549770").as_correction(),
            within("its end (s)", first_exit(run).t, "4.579537", "4.579538").as_correction(),
            within("second adhesion (s)", entries[1].t, "4.771754", "4.771755").as_correction(),
        ),
        carried(
            "for-ever",
            argument(
                "No later slip merges, and each is slower than the one before, within the bound from the first exit on.",
                *never_merges(run, "Fig. 5 (a)"),
                largest_relative_speed(),
                within("bound of $|\\dot z|$ from the first exit on (m/s)", bound, "0.002320", "0.002321"),
                merges_or_creeps(),
            ).as_correction(),
        ),
        corrected=claim_named("synchronisation-time").corrected,
        counterexample="The paper's own: $m_1=m_2=1$, $a_2=200$, $b=0.05$, $\\dot x_1(0)=0.15$; "
        f"$|\\dot z({float(time):g})|={slipping}$ mm/s.",
        derivation=ARGUMENT,
        figure="velocities",
    )


def _mode_at(trajectory: Trajectory, time: Fraction) -> Evidence:
    mode = trajectory.mode_at(time)
    statement = f"at $t={float(time):g}$ s the bodies slip"
    return Evidence(EvidenceKind.ENCLOSURE, "python-flint", statement, mode is not Mode.STICK, 1, mode.value)
