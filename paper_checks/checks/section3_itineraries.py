"""Section III, Fig. 3: one scene for each, its events proved in balls."""

from __future__ import annotations

from numerics.linear.modes import EventKind, Mode
from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory
from paper_checks.checks.registry import Context, check
from paper_checks.engines.enclosure import compare, exact, itinerary, solved, text
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps.perpetual_slips import ARGUMENT, never_merges
from paper_checks.steps.turned_back import merges_or_creeps

PLUS, MINUS, STICK = Mode.SLIP_PLUS, Mode.SLIP_MINUS, Mode.STICK


def _points(trajectory: Trajectory, names: tuple[str, ...]) -> str:
    """Return the named events as a line of the derivation: time and position on S."""
    places = [
        f"${name}$: $t={event.t.mid().str(6, radius=False)}$ s, $x_1={event.y[0].mid().str(5, radius=False)}$ m, "
        f"$v={event.y[1].mid().str(5, radius=False)}$ m/s"
        for name, event in zip(names, trajectory.events, strict=False)
    ]
    return "; ".join(places) + "."


@check("itinerary-that-merges")
def itinerary_that_merges(context: Context, scene: Scene | None = None) -> Finding:  # noqa: ARG001
    """A slip that ends in S0 below E_cr."""
    trajectory = solved(scene or load_scene("itinerary-that-merges"))
    for_ever = trajectory.status is Status.STUCK_FOR_EVER
    return conclude(
        Verdict.HOLDS,
        "The paper gives no numbers; the scene itinerary-that-merges is one such trajectory. It slips once, enters $S_0$ and sticks "
        "for ever on an ellipse below the critical one.",
        carried(
            "statement",
            itinerary("slip in $\\Omega_+$, then stick", trajectory, (PLUS, STICK)),
            Evidence(
                EvidenceKind.ENCLOSURE,
                "numerics, balls",
                "there is no later event: the stick phase never ends",
                for_ever and len(trajectory.events) == 1,
                1,
                trajectory.message,
            ),
            compare("after it, $w=E/E_{cr}-1<0$", trajectory.final.w, "<", exact(0)),
        ),
        derivation=(_points(trajectory, ("A",)), f"$w={trajectory.final.w.mid().str(10, radius=False)}$ on the orbit."),
        figure="itinerary-that-merges",
    )


@check("itinerary-that-creeps")
def itinerary_that_creeps(context: Context, scene: Scene | None = None) -> Finding:  # noqa: ARG001
    """The itinerary of nine named points, then the proof that it never merges."""
    trajectory = solved(scene or load_scene("itinerary-that-creeps"))
    kinds = tuple(event.kind for event in trajectory.events)
    crossing, entry, leave = EventKind.CROSSING, EventKind.ENTRY, EventKind.EXIT
    return conclude(
        Verdict.HOLDS,
        "The paper gives no numbers; the scene itinerary-that-creeps passes all the named points in their order, with $O_2$ in the stick "
        "phase after $A_3$. At its first exit the excess is small enough for the argument that no later slip merges, so by the "
        "dichotomy it tends to the critical orbit.",
        carried(
            "points",
            itinerary(
                "$O_1A_1$ in $\\Omega_+$, $A_1B_1$ in $\\Omega_-$, $B_1A_2$ in $\\Omega_+$, stick $A_2C_1$, $C_1B_2$ in $\\Omega_-$, "
                "stick $B_2D_1$, $D_1A_3$ in $\\Omega_+$, stick $A_3O_2$",
                trajectory,
                (PLUS, MINUS, PLUS, STICK, MINUS, STICK, PLUS, STICK),
            ),
            Evidence(
                EvidenceKind.ENCLOSURE,
                "numerics, balls",
                "the events are crossing, crossing, entry, exit, entry, exit, entry",
                kinds == (crossing, crossing, entry, leave, entry, leave, entry),
                len(kinds),
                ", ".join(kind.value for kind in kinds),
            ),
            compare("$A_1\\in S_+$: $X>1$", trajectory.events[0].reduced.X, ">", exact(1)),
            compare("$B_1\\in S_-$: $X<-1$", trajectory.events[1].reduced.X, "<", exact(-1)),
            compare("$C_1\\in\\ell_+$: $V>0$", trajectory.events[3].reduced.V1, ">", exact(0)),
            compare("$D_1\\in\\ell_-$: $V<0$", trajectory.events[5].reduced.V1, "<", exact(0)),
        ),
        carried(
            "creeps",
            argument(
                "No later slip merges, so $E>E_{cr}$ for ever, and the trajectory tends to the critical orbit.",
                *never_merges(trajectory, "itinerary-that-creeps"),
                merges_or_creeps(),
            ),
        ),
        derivation=(
            _points(trajectory, ("A_1", "B_1", "A_2", "C_1", "B_2", "D_1", "A_3")),
            f"$w={text(trajectory.events[3].reduced.w)}$ at $C_1$.",
            *ARGUMENT,
        ),
        figure="itinerary-that-creeps",
    )
