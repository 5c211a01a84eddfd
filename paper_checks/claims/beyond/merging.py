"""Which energies merge at the first landing, and which after crossings."""

from fractions import Fraction
from functools import cache

import sympy as sp
from flint import arb

from paper_checks.claims.beyond.critical_ratio import (
    depth,
    half_angle,
    rise,
    threshold,
)
from paper_checks.claims.beyond.excursions import vanishes
from paper_checks.claims.beyond.slips import depth_grows
from paper_checks.claims.letters import C, H, R, in_angle
from paper_checks.claims.words import *
from paper_checks.decide import kernel
from paper_checks.decide.balls import point, precision, shown
from paper_checks.decide.roots import enclosed_root
from theory.excursion import angle
from theory.merging import half_angle_form, ratio, ray_excess, share
from theory.return_map import return_map_of_angle

SHARES = (Fraction(3, 5), Fraction(7, 10), Fraction(4, 5), Fraction(9, 10), Fraction(99, 100), Fraction(1))
DIGITS = 30


@cache
def sign_of_excess() -> Steps:
    """w' on the ray has the sign of R^2 - r; where it is not positive the pair is on S0."""
    position, velocity = symbols("X V", real=True)
    deep = 2 * (1 - angle * cos(angle) / sin(angle))
    return (
        vanishes(
            r"$w'/q=c^2\,(R^2-r)$: the pair merges at this re-entry exactly if $R^2\leqslant r$, that is on one closed interval of angles",
            half_angle_form(ray_excess() - deep**2 * (ratio() ** 2 - share)),
        ),
        prove(
            r"$w'\leqslant 0$ on $S$, $X^2+V^2\leqslant 1$, is on $S_0$: the pair sticks there permanently",
            [position**2 + velocity**2 <= 1],
            position**2 <= 1,
        ),
    )


@cache
def never_from_below() -> Steps:
    """Below the window 0 < y' < y: the same holds again after every excursion."""
    rise_value, deep, y_a = symbols("h c y_a", positive=True)
    return (
        prove(
            r"""
            for $\theta<\theta_a$, where $R^2>r$: $0<y'=h^2-r\,c^2<y=h^2<y_a$, and so on: each slip re-enters $S_0$, as
            $c$ rises with $\theta$ and $w'=0$ at $\theta_a$ puts its end into $|X'|\leqslant 1$
            """,
            [share < 1, rise_value**2 > share * deep**2, rise_value**2 < y_a],
            And(
                signed(rise_value**2 - share * deep**2, ">"),
                sp.Lt(rise_value**2 - share * deep**2, y_a, evaluate=False),
            ),
        ),
    )


def window(value: arb) -> tuple[arb, arb]:
    """Return (theta_a, theta_b) for a share above r*, the roots of h = sqrt(r) c; call inside `precision`."""
    turning = Fraction(379727574, 10**8)

    def excess(theta: arb) -> arb:
        return rise(theta) - value.sqrt() * depth(theta)

    return (
        enclosed_root(excess, Fraction(1, 2), turning, DIGITS),
        enclosed_root(excess, turning, Fraction(628, 100), DIGITS),
    )


@cache
def windows() -> Evidence:
    """Both roots and the interval of y = w/q for some shares, and in the limit r = 1, m1/m2 -> 0."""
    texts = []
    with precision(DIGITS):
        straddled = True
        for one in SHARES:
            low, high = window(point(one))
            straddled = straddled and bool(low < 2 * half_angle() and high > 2 * half_angle())
            levels = ", ".join(shown(rise(theta) ** 2, 25) for theta in (low, high))
            texts.append(f"r = {one}: w/q from and to {levels}")
    return enclosed(
        r"""
        $\theta_a<\theta^*<\theta_b$ and the interval of $w/q$ that merges at the first re-entry, for some shares $r$
        and in the limit $r=1$ ($m_1/m_2\to 0$)
        """,
        straddled,
        "; ".join(texts),
        len(SHARES),
    )


@cache
def first_landing() -> Evidence:
    """Where the first slip after S0 ends at or below E_cr: one interval of energies."""
    return argument(
        r"""
        On $S_0$ above $E_{cr}$ the pair sticks up to a ray with the same $w$, and slips. It merges at the end of that
        slip exactly if $w'\leqslant 0$ there, which is $R^2\leqslant r$: one closed interval of angles, and of
        $w=q\,h^2$, which rises with the angle.
        """,
        kernel.step("gap-slip"),
        kernel.step("first-slip"),
        kernel.step("merging-set"),
        *sign_of_excess(),
    )


def below_the_interval() -> Evidence:
    """Below the interval the pair creeps for ever."""
    return argument(
        "Below $\\theta_a$ every slip from a ray ends in $S_0$ with $0<w'<w$, so below $\\theta_a$ again, by induction without end.",
        first_landing(),
        *depth_grows()[:2],
        *never_from_below(),
    )


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
    clause("below", r"Below $w_a$ it never merges."),
    clause(
        "none",
        r"For $r<r^*$ no energy on $S_0$ above $E_{cr}$ merges where the trajectory first meets $S$.",
        kernel="heavy-never-merges",
    ),
    clause(
        "limits",
        r"""
        As $m_1/m_2\to 0$ the interval $[w_a,w_b]/q$ tends to that of $r=1$; as $m_1/m_2\to\infty$ nothing merges
        after its first contact with $S$.
        """,
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
        carried("leads", first_landing()),
        carried("below", below_the_interval()),
        carried(
            "limits",
            argument(
                "$R$ is strictly monotone on both sides of $\\varphi^*$, so both roots are continuous in $r$ up to $r=1$.",
                first_landing(),
                windows(),
                *threshold(),
            ),
        ),
        derivation=(
            r"""
            $$\text{merges at the first re-entry}\iff q\,h(\theta_a)^2\leqslant w\leqslant q\,h(\theta_b)^2,\qquad
            h(\theta_{a,b})=\sqrt r\,c(\theta_{a,b}).$$
            """,
            '"Slightly higher than $E_{cr}$" is thus sharp: below $w_a=q\\,h(\\theta_a)^2$ nothing on $S_0$ merges, at $w_a$ it does.',
            r"""
            At the ends $E=E_{cr}$: the landing is in $S_0$, so $\theta_b\leqslant\theta_c$. Between $\theta_b$ and
            $\theta_c$ the pair leaves $S_0$ again with a smaller $w$; beyond $\theta_c$ it slips on from $S$, and its
            first re-entry is above $E_{cr}$.
            """,
            r"""
            With $k=\cot(\theta/2)$, $D=d+c$, $e=D-2/q$: $$\nu'=h+kD,\qquad
            \nu'-\kappa_ce=(h+2k/q)+(k-\kappa_c)\,e,\qquad w'/q=h^2-2(1-hk)D+(k^2+q)D^2.$$
            """,
            "For $m_1/m_2\\to 0$ all of $[w_a,w_b]$ shrinks to $0$ like $q$; for $m_1/m_2>-\\cos\\theta^*$ it is empty.",
        ),
        figure="merging-interval",
    )
