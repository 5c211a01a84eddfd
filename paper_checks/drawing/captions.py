"""What each figure is called, and what a reader should see in it."""

from __future__ import annotations

CAPTIONS: dict[str, tuple[str, str]] = {
    "two-bodies": (
        "The two bodies",
        "Body 1 hangs on a spring; body 2 rests on body 1 and touches nothing else. The only force between them is dry friction: "
        "it holds them together up to $b$, and is $b$ against the motion when they slip.",
    ),
    "force-needed": (
        "Fig. 4 (a): what sticking needs",
        "The curve is the force that would keep the bodies together, the dashed line what friction can give. Where the curve is "
        "above the line, in red, they cannot stick. The start is there.",
    ),
    "relative-velocity": (
        "Fig. 5 (a) about 4.7 s",
        "At the dotted line, where the paper sees both bodies synchronise, the exact relative velocity is close to its largest "
        "value between two phases of stick (grey). Forward Euler misses the first of them.",
    ),
    "sharp-rate": (
        "The energy approaches its limit like 1/t",
        "Left: $E-E_{cr}$ falls by one power of ten when $t$ grows by one. Right: $t(E-E_{cr})$, divided by the limit of the "
        "theorem, tends to 1 from each start.",
    ),
    "start-at-6mm": (
        "Fig. 4 (a), solved exactly and by forward Euler",
        "Exactly (left) both bodies slip at once: the start lies outside the grey sliding region. Forward Euler on (11), (12) "
        "(right) keeps them stuck, as the paper prints it.",
    ),
    "start-with-speed": (
        "Fig. 4 (b), solved exactly and by forward Euler",
        "Exactly (left) the bodies stick and slip in turn for ever. Forward Euler (right) shows the same orbit, but its stick is a "
        "rapid change of sign.",
    ),
    "velocities": (
        "Fig. 5 (a), solved exactly and by forward Euler",
        "The oscillation of body 1 decays almost linearly, and $\\dot x_2$ is a saw tooth. The close-up shows that the bodies slip "
        "at the printed 4.7 s.",
    ),
    "relative-motion": (
        "Fig. 5 (b), solved exactly and by forward Euler",
        "For each friction the relative motion ends near $\\dot z=0$; the close-up shows the many short slips on which the exact "
        "solution and forward Euler differ.",
    ),
    "itinerary-that-merges": (
        "Fig. 3 (a), a trajectory that merges",
        "From $O$ the pair slips once, enters the sliding region at $A$ and stays on an ellipse inside it for ever.",
    ),
    "itinerary-that-creeps": (
        "Fig. 3 (b), a trajectory that never merges",
        "The points follow the paper's itinerary. After $A_2$ the pair leaves the sliding region by a ray again and again, and "
        "tends to the dotted critical ellipse.",
    ),
    "euler-convergence": (
        "What the step of forward Euler does",
        "Left: the error of the first time of stick shrinks with the step; too coarse a step never sticks. Right: the energy of a "
        "stuck pair, a constant, grows.",
    ),
}
"""Title and caption by the figure's name, prose with LaTeX between dollars."""


def caption(name: str) -> tuple[str, str]:
    """Return the title and the caption of a figure; one without has its name as title."""
    return CAPTIONS.get(name, (name.replace("-", " ").capitalize(), ""))
