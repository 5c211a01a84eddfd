"""The theorems on who merges: the first slip, crossings, re-entry, and the critical mass ratio."""

from __future__ import annotations

MERGING: dict[str, tuple[str, str]] = {
    "merges-iff": (
        "Merge.merges_iff",
        r"From $S_0$ with slip angle up to $\pi$: $E>E_{cr}$ for ever exactly if $r\,c^2<h^2$.",
    ),
    "turning-point": ("Turning.root", r"The turning function has one zero $\varphi^*$ in $(0,\pi]$."),
    "merging-threshold": (
        "Turning.threshold",
        r"Every excursion from a ray ends above $E_{cr}$ exactly if $m_1/m_2>-\cos 2\varphi^*$.",
    ),
    "critical-mass-ratio-digits": ("Critical.decimals", r"14 decimals of the critical mass ratio $-\cos 2\varphi^*$."),
    "gap-slip": ("Gap.gap_slip", "Every slip from $S$ with a gap and a push, in closed form up to its one end."),
    "crossing": (
        "Gap.crossing",
        "A slip that ends beyond the other end of $S_0$ is followed by one of the other sign.",
    ),
    "re-entry": (
        "Cross.reentry",
        "A slip that lands in $S_0$ sticks there for ever exactly if its level is not above $E_{cr}$.",
    ),
    "first-slip": (
        "Cross.first_slip",
        r"From $S_0$ above $E_{cr}$: stick, one slip, and merging there exactly if $h^2\leqslant r\,c^2$.",
    ),
    "ray-crossing": (
        "Cross.ray_crossing",
        "From a ray with depth above $2/q$ the pair crosses $S$ and slips on with the other sign.",
    ),
    "no-first-merging": (
        "Alternation.no_first_merging",
        r"If $m_1/m_2>-\cos 2\varphi^*$, nothing on $S_0$ merges after its first slip.",
    ),
    "alternation": ("Alternation.alternation", "After a crossing long and short slips alternate."),
    "margin": ("Margin.margin", "The one numerical inequality of the merging set, enclosed in balls by the kernel."),
    "kappa-large": (
        "Kappa.kappa_large",
        r"Where merging is possible, the longest slip that lands in $S_0$ is longer than the angle $4\pi/3$.",
    ),
    "first-re-entry": (
        "Return.returns",
        "From beyond $S_0$, or from an exit ray, a solution comes back to $S_0$ after finitely many slips, for "
        "every mass ratio.",
    ),
    "merging-set": (
        "Merging.merging_set",
        r"For $m_1/m_2\leqslant-\cos 2\varphi^*$ the equation $h=\sqrt r\,c$ has two roots, which are one at equality; the "
        "energies on $S_0$ between those of both roots, and no others, merge at the first contact and at the first re-entry, "
        "after any number of crossings.",
    ),
    "no-low-level": (
        "Levels.no_low_level",
        r"For $m_1/m_2>-\cos 2\varphi^*$: no slip from $S$, whatever its gap and push, ends at or below $E_{cr}$.",
    ),
    "heavy-never-merges": (
        "Heavy.heavy_never_merges",
        r"For $m_1/m_2>-\cos 2\varphi^*$: no solution that has touched $S$ above $E_{cr}$ ever merges, after "
        "whatever number of slips.",
    ),
}
