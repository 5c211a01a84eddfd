"""Which energies merge at the first landing, and which after crossings."""

from paper_checks.claims.beyond.critical_ratio import threshold
from paper_checks.claims.letters import C, H, R, in_angle
from paper_checks.claims.words import *
from theory.return_map import return_map_of_angle


@theorem(
    "merging-set",
    clause(
        "interval",
        r"""
        Let $r=m_2/M$ exceed $r^*$ of critical-mass-ratio. There are $0<w_a<w_b$ such that a trajectory from $S_0$
        with $w=E/E_{cr}-1>0$ merges where it first meets $S$ after it left $S_0$ exactly if $w_a\leqslant w\leqslant
        w_b$.
        """,
        kernel="merging-set",
    ),
    clause(
        "roots",
        r"They are $w_{a,b}=w(\theta_{a,b})$ with the two roots $\theta_a<\theta_b$ in $(0,2\pi)$ of $h(\theta)=\sqrt r\,c(\theta)$, which has no others:",
        kernel="merging-set",
    ),
    clause(
        "leads",
        """
        a slip from a ray leads from «before» to «after».
        """,
        before=in_angle("w", q * H**2, lambda: q * return_map_of_angle()[0]),
        after=in_angle("w'", q * (H**2 - R * C**2), lambda: q * return_map_of_angle()[1]),
        kernel="ray-energy first-landing",
    ),
    clause(
        "crossings",
        r"At the first re-entry of $S_0$, after any number of crossings of $S$, exactly the energies of one interval merge, too;",
        kernel="merging-set",
    ),
    clause(
        "same",
        r"and it is the same one: where a trajectory crosses $S$, once or more often, its first re-entry is above $E_{cr}$.",
        kernel="merging-set sticks-iff",
    ),
    clause("below", r"Below $w_a$ it never merges.", kernel="merging-set"),
    clause(
        "none",
        r"For $r<r^*$, so as $m_1/m_2\to\infty$, nothing that has touched $S$ above $E_{cr}$ ever merges.",
        kernel="heavy-never-merges",
    ),
    clause(
        "limits",
        r"As $m_1/m_2\to 0$ both ends of $[w_a,w_b]/q$ tend to the two values of $h^2$ where $h(\theta)=c(\theta)$, those of $r=1$.",
        kernel="light-driver",
    ),
)
def merging_set() -> Case:
    """R falls and rises once, so the excursions that merge form one interval of angles."""
    return because(
        r"""
        If body 2 is heavy enough, the energies on $S_0$ that merge at the first re-entry form one interval, whether the
        pair crosses $S$ before it or not; below it the pair never merges. $w'/q=c^2(R^2-r)$ with $R=h/c$, which falls
        from $\infty$ to $\sqrt{r^*}$ and rises to $\infty$: $R^2\leqslant r$ is one interval $[\theta_a,\theta_b]$,
        empty for $r<r^*$, and $w=q\,h^2$ rises with $\theta$. Below it $0<w'<w$ repeats without end. As $R$ is strictly
        monotone on both sides the roots are continuous in $r$ up to $r=1$. A pair that crosses $S$ does so in long and
        short slips in turn, and its re-entry, at the end of a short one, is above $E_{cr}$.
        """,
        threshold,
        figure="merging-interval",
    )
