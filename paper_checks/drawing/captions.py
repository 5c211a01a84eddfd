"""Title and caption of each figure."""

from __future__ import annotations

CAPTIONS: dict[str, tuple[str, str]] = {
    "two-bodies": (
        "The two bodies",
        "Body 1 is held by a spring and, where $a_1>0$, a damper; body 2 rests on body 1 and touches nothing else. The only force between them is dry friction: "
        "at most $b$ while they stick, and $b$ against the relative motion while they slip.",
    ),
    "ellipse-in-strip": (
        "An ellipse in a strip",
        "Levels of the energy on $S$, where both bodies move as one; motion runs clockwise. Up to $E_{cr}$ the ellipse lies within the strip $S_0$ (grey), and the pair "
        "sticks at all later times. Above $E_{cr}$ the edges cut it into two arcs; the pair leaves by the rays $\\ell_+$ and $\\ell_-$.",
    ),
    "force-needed": (
        "Fig. 4 (a): the friction that stick requires",
        "The curve is the absolute value of the force that would keep the bodies together, the dashed line the maximum friction force. Where the curve is "
        "above the line, in red, they cannot stick. The start is there.",
    ),
    "relative-velocity": (
        "Fig. 5 (a) about 4.7 s",
        "At the thick line, where the paper sees both bodies synchronise, the exact relative velocity is close to its largest "
        "value between two phases of stick (grey). Forward Euler misses the first of them.",
    ),
    "sharp-rate": (
        "The energy approaches its limit like 1/t",
        "$t(E-E_{cr})$, divided by the limit that the theorem gives each pair, tends to 1.",
    ),
    "start-at-6mm": (
        "Fig. 4 (a), solved exactly and by forward Euler",
        "Exact solution (left): both bodies slip at once, as the start lies outside the grey sliding region. Forward Euler on (11), (12) "
        "(right) keeps them stuck, as in the printed figure.",
    ),
    "start-with-speed": (
        "Fig. 4 (b), solved exactly and by forward Euler",
        "Exact solution (left): stick and slip alternate permanently. Forward Euler (right) shows the same orbit, but its stick is a "
        "rapid change of sign.",
    ),
    "velocities": (
        "Fig. 5 (a), solved exactly and by forward Euler",
        "The oscillation of body 1 decays almost linearly, and $\\dot x_2$ is a saw tooth. The close-up shows that the bodies slip "
        "at the printed 4.7 s.",
    ),
    "relative-motion": (
        "Fig. 5 (b), solved exactly and by forward Euler",
        "For each friction the relative motion ends near $\\dot z=0$; the close-up shows the many short slips there, on which the exact "
        "solution and forward Euler (pale) differ.",
    ),
    "itinerary-that-merges": (
        "Fig. 3 (a), a trajectory that merges",
        "From $O$ the pair slips once, enters the sliding region at $A$ and stays on an ellipse inside it permanently.",
    ),
    "itinerary-that-creeps": (
        "Fig. 3 (b), a trajectory that never merges",
        "The points follow the paper's itinerary. After $A_2$ the pair leaves the sliding region through a ray repeatedly, and "
        "tends to the dotted critical ellipse.",
    ),
    "excursion-curves": (
        "Every slip from a ray on two curves",
        "Left: the angle of a slip fixes its exit speed $h$ and its depth $c$, for every pair alike; both grow with the angle. Right: "
        "where the slip ends. The larger $m_2$ is, the longer a slip may last before it crosses the whole sliding region.",
    ),
    "return-map": (
        "From one exit to the next",
        "Left: the exact depth and its first Taylor polynomials. Right: the return map for a pair below, at and above the critical "
        "mass share. A value below 0, in the grey, lies inside $E_{cr}$: there the pair merges.",
    ),
    "merging-window": (
        "Which slips from a ray merge",
        "A slip of angle $\\theta$ merges where the line of its mass share $r$ lies above the curve. The lowest line touches nothing, the "
        "dashed one, at the critical mass ratio, touches the curve in one point; the highest one has a whole interval.",
    ),
    "merging-interval": (
        "Which energies merge at the first landing",
        "Each point is a pair and an energy on the sliding region. Left of the dashed line nothing ever merges. In the coloured region the "
        "pair merges where it first meets $S$ after it left $S_0$; below it, it never merges; above it a later slip may merge.",
    ),
    "merging-share": (
        "How many states merge",
        "For pairs up to the critical share $r^*$: just above $E_{cr}$ nearly all states merge; as the energy grows their share falls like $1/E$.",
    ),
    "rate-bounds": (
        "The 1/t law between two explicit bounds",
        "The excess energy at each exit, times the time and divided by the limit, stays in the blue band that theory gives.",
    ),
    "uniform-rate": (
        "What the energy at the start fixes",
        "Three motions with the same $E(0)$ stay below one bound. They differ from one another at first: no lower bound is fixed by $E(0)$.",
    ),
    "euler-convergence": (
        "What the step of forward Euler does",
        "Left: the error of the first time of stick shrinks with the step; too coarse a step never sticks. Right: the energy of a "
        "stuck pair, a constant, grows.",
    ),
    "thresholds-over-frequency": (
        "Three regimes under a sinusoidal force",
        "Below $U_*$ some motion sticks permanently, above the upper full line one never stops; with a damper every motion tends to it. In between, with a "
        "damper, it slips, and sticks or reverses more than twice in each period. Below the dashed $U_{**}$ no motion of the force's period slips permanently with two reversals a period; where the upper line leaves it, the bodies would meet once more. That line is computed on a grid, not proved. "
        "Left without a damper, right with one. Dotted: the stuck pair's own frequency, and that of body 1 alone.",
    ),
    "resonance": (
        "At the resonance of body 1",
        "Left: a force just below $4b/\\pi$, and the velocities stay bounded. Middle: just above, and body 1 grows at least as the dotted "
        "lines do. Body 2 does not follow. Right: at $4b/\\pi$ a sine alone leaves the amplitude bounded; with a part at half the frequency it tends "
        "to the dotted lines, which grow as $t^{1/3}$.",
    ),
    "tracked-reference": (
        "A reference that body 2 follows",
        "Top: the reference. Middle: the friction required, inside the green band of the friction available. Bottom: the force on body 1 "
        "under which body 2 follows.",
    ),
    "cheapest-transfer": (
        "One centimetre in 0.4 s with the least energy of the force",
        "Positions, velocities, the force on body 1, and the friction that it asks for, which is at its limit at the end. No transfer that "
        "sticks and takes this time has less $\\int u^2\\,dt$.",
    ),
    "fastest-transfer": (
        "One millimetre in the least time",
        "In the first half body 1 slips ahead, so friction is at its limit; at half time both velocities are equal. In the second half both "
        "stick at the limit. No force arrives before the line.",
    ),
    "tolerance-ring-of-a-scene": (
        "Fig. 1, drawn for the scene of Fig. 5 (a)",
        "Left: the relative motion about its limit; from the point on, in black, it stays inside the dashed ring. Right: its distance "
        "from the limit over time.",
    ),
    "drift-against-asymmetry": (
        "An asymmetric force makes body 2 drift",
        "The mean velocity of body 2 as a second harmonic is added to the force. Without it the force is symmetric and there is no drift. "
        "Each point is a periodic motion that is proved.",
    ),
    "static-friction": (
        "The $1/t$ law under other frictions",
        "At the exits from $S_0$, for equal masses and a friction in slip of $b\\,(1-k|V_1-V_2|)$, $V_i=v_i/(L\\Omega)$: a finite slope keeps "
        "the limit 1 and changes how it is approached, at the rate $1/\\sqrt t$. Friction that jumps from rest to slip, however "
        "little, with sticks that are kept, ends creeping: the pair merges.",
    ),
    "two-motions": (
        "Two motions of one force",
        "With a constant friction their distance never grows. Where friction falls with the speed it can grow.",
    ),
    "stuck-ellipses": (
        "Permanent stick on a surface",
        "A stuck path that leaves the disc of the radius $L$ does not last. On a line the critical energy is the largest that fits, on a "
        "circle it is twice that; the red path has more energy than one that fits and less than another.",
    ),
    "rotating-force": (
        "The slip speed under a rotating force",
        "Up to the threshold (dot) the pair sticks and rotates; above it a motion slips at one constant speed; there is no stick-slip.",
    ),
}
"""Title and caption by the figure's name, prose with LaTeX between dollars."""


def caption(name: str) -> tuple[str, str]:
    """Return the title and the caption of a figure; one without has its name as title."""
    return CAPTIONS.get(name, (name.replace("-", " ").capitalize(), ""))
