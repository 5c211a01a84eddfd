"""The theorems on which motions merge: the first slip, crossings, re-entry, and the critical mass ratio."""

from __future__ import annotations

MERGING: dict[str, tuple[str, str]] = {
    "merges-iff": (
        "FirstLanding.merges_iff",
        r"From $S_0$ with slip angle up to $\pi$: $E>E_{cr}$ at all later times exactly if $r\,c^2<h^2$.",
    ),
    "turning-point": ("TurningFunction.root", r"The turning function has one zero $\varphi^*$ in $(0,\pi]$."),
    "merging-threshold": (
        "TurningFunction.threshold",
        r"$h^2>r\,c^2$ at all slip angles below $2\pi$ exactly if $m_1/m_2>-\cos 2\varphi^*$; else not at $2\varphi^*$.",
    ),
    "critical-mass-ratio-digits": (
        "CriticalRatioDigits.decimals",
        r"The critical mass ratio $-\cos 2\varphi^*$ up to $2\cdot 10^{-14}$, and $\varphi^*$ up to $10^{-15}$.",
    ),
    "gap-slip": (
        "SlipFromGap.gap_slip",
        "A slip from $S$ with a gap and the initial speed of an angle, in closed form up to that angle, where it ends.",
    ),
    "crossing": (
        "SlipFromGap.crossing",
        "A slip that ends beyond the other end of $S_0$ is followed by one of the other sign.",
    ),
    "re-entry": (
        "AfterOneSlip.reentry",
        "A slip from $S$ with a gap and the initial speed of an angle that ends in $S_0$ sticks there permanently exactly if its energy is not above $E_{cr}$.",
    ),
    "first-slip": (
        "AfterOneSlip.first_slip",
        r"From $S_0$ above $E_{cr}$: stick, one slip, and merging there exactly if $h^2\leqslant r\,c^2$.",
    ),
    "ray-crossing": (
        "AfterOneSlip.ray_crossing",
        "From a ray with the exit speed of an angle whose depth is above $2/q$ the pair crosses $S$ and slips on with the other sign.",
    ),
    "no-first-merging": (
        "AlternatingSlips.no_first_merging",
        r"If $m_1/m_2>-\cos 2\varphi^*$, nothing on $S_0$ above $E_{cr}$ merges at the end of its first slip.",
    ),
    "alternation": (
        "AlternatingSlips.alternation",
        r"Where the longest slip from a ray that ends in $S_0$ has an angle $2\varphi_c\geqslant 4\pi/3$: a crossing slip at least that long is followed by one of at most $2\pi-2\varphi_c$, and a crossing slip of at most that by one at least as long as the longest.",
    ),
    "margin": (
        "ShortSlipMargin.margin",
        "The one numerical inequality of the merging set, enclosed in balls by the kernel.",
    ),
    "kappa-large": (
        "KappaBound.kappa_large",
        r"Where merging is possible, the longest slip that ends in $S_0$ is longer than the angle $4\pi/3$.",
    ),
    "first-re-entry": (
        "ReturnToS0.returns",
        "From beyond $S_0$, or from an exit ray, a solution returns to $S_0$ after finitely many slips, for "
        "every mass ratio.",
    ),
    "ray-energy": ("ExitOrbit.ray_energy", r"On an exit ray with the exit speed $h$ the energy is $E_{cr}(1+q\,h^2)$."),
    "first-landing": (
        "AfterOneSlip.merges_at_first_landing",
        r"From a ray with the exit speed of an angle: one slip up to that angle, to the energy $E_{cr}(1+q(h^2-r\,c^2))$, and merging there exactly if $h^2\leqslant r\,c^2$.",
    ),
    "light-driver": (
        "MergingAngles.light_driver",
        r"As $m_1/m_2\to 0$ the values of $h^2$ at both roots of $h=\sqrt r\,c$ tend to those at the two roots of $h=c$.",
    ),
    "merging-set": (
        "MergingEnergies.merging_set",
        r"For $m_1/m_2\leqslant-\cos 2\varphi^*$ the equation $h=\sqrt r\,c$ has two roots, which are one at equality; the "
        "energies on $S_0$ above $E_{cr}$ from the one root to the other, and no others, merge at the first contact, and they, and no others, "
        "at the first re-entry, after any number of crossings; those below never merge.",
    ),
    "no-low-level": (
        "LevelAfterSlip.no_low_level",
        r"For $m_1/m_2>-\cos 2\varphi^*$: no slip from $S$, whatever its gap and initial speed, ends at or below $E_{cr}$.",
    ),
    "heavy-never-merges": (
        "MergingByMassRatio.heavy_never_merges",
        r"For $m_1/m_2>-\cos 2\varphi^*$: no solution that has touched $S$ above $E_{cr}$ ever merges, after "
        "whatever number of slips.",
    ),
}
