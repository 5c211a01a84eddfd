"""Steps about a pair that crosses S before it re-enters S0: long and short slips in turn, and w > 0 at the re-entry (a1 = 0)."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import pairwise

import sympy as sp
from flint import arb

from paper_checks.engines.balls import point, precision, shown
from paper_checks.engines.exact import identity
from paper_checks.engines.roots import enclosed_root
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.steps.critical_share import ENGINE, critical_value
from paper_checks.steps.excursions import vanishes
from paper_checks.steps.excursions_in_balls import depth, rise
from paper_checks.steps.monotone_slips import contact, cusa_huygens, depth_grows, landings, one_contact, rise_is_convex
from theory.alternation import (
    falling_part_residual,
    landing_excess_residual,
    long_margin_residual,
    long_to_short_slope_residual,
    margin_in_supplement,
    margin_in_supplement_residual,
    next_push_residual,
    push_residual,
    short_margin_residual,
    spread_residual,
    supplement,
)
from theory.excursion import h
from theory.symbols import theta

FROM = Fraction(195, 100)
PIECES = 400


def critical_angle(share: arb) -> arb:
    """Return theta_c of a share r = m2/M, where c = 2/(1 - r); call inside `precision`."""
    return enclosed_root(lambda x: depth(x) - 2 / (1 - share), Fraction(314, 100), Fraction(628, 100), 20)


def margin_at(angle: arb) -> arb:
    """Return q h^2 - 1 + 2 h k at the least q for which a short slip reaches this angle, 2/c(2 pi - theta)."""
    height = rise(angle)
    return 2 * height * height / depth(2 * arb.pi() - angle) - 1 + 2 * height * (angle / 2).cot()


@cache
def push_after() -> tuple[Evidence, ...]:
    """What a slip that crosses hands on to the next one."""
    return (
        identity(r"with $k=\cot(\theta/2)$, $D=d+c$ the slip ends with $\nu'=\theta-\nu=h+k\,D$", next_push_residual()),
        identity(r"$(h+2k/q)'=(c-2/q)(1+k^2)/2$", falling_part_residual()),
    )


@cache
def critical_margin() -> tuple[Evidence, ...]:
    """P >= 0 from r* on."""
    with precision(20):
        angle = critical_angle(critical_value())
        kappa = -(angle / 2).cot()
        enough = kappa > point(Fraction(597, 1000)) and 3 * kappa * kappa > 1
    return (
        identity(
            r"$P=\pi(1+\kappa_c^2)-\theta_c$ is $\pi\sin^{-2}\psi-2\pi+2\psi$ with $\theta_c=2(\pi-\psi)$, $\kappa_c=\cot\psi$; it is 0 at "
            r"$\psi=\pi/3$ and falls for $\psi\leqslant\pi/3$, as $\cos\psi\geqslant\frac{1}{2}$ and $\pi>2$",
            sp.Matrix(
                [
                    margin_in_supplement_residual(),
                    margin_in_supplement().subs(supplement, sp.pi / 3),
                    sp.diff(margin_in_supplement(), supplement)
                    - 2
                    + 2 * sp.pi * sp.cos(supplement) / sp.sin(supplement) ** 3,
                ]
            ),
            sp.zeros(3, 1),
        ),
        Evidence(
            EvidenceKind.ENCLOSURE,
            ENGINE,
            r"at $r=r^*$, $\kappa_c>0.597>1/\sqrt3$; $\theta_c$ rises with $r$, and $\kappa_c$ with it: $P\geqslant 0$ for "
            r"$r\geqslant r^*$",
            bool(enough),
            1,
            f"kappa_c = {shown(kappa, 12)}, theta_c = {shown(angle, 12)}",
        ),
    )


@cache
def alternate() -> Evidence:
    """Long slips cross, and the next one is short; a short one that crosses is followed by a long one."""
    return argument(
        "Long slips, $\\theta\\geqslant\\theta_c$, and short ones, $\\theta\\leqslant 2\\pi-\\theta_c$, alternate. A long one crosses, as "
        "$D\\geqslant c\\geqslant 2/q$; the contact function of the next one is at $2\\pi-\\theta_c$ at least what it is for $D=c$, which "
        "rises with $\\theta$ from $P\\geqslant 0$ at $\\theta_c$: as it rises in its own angle, that slip has ended. After a short one that "
        "crosses, $k\\geqslant\\kappa_c$ and $h+2k/q$, which falls for $\\theta<\\theta_c$, is at least $h(\\theta_c)+P$: the contact function "
        "of the next slip is at most $-P\\leqslant 0$ at $\\theta_c$, so that one is long. The first slip from a ray is long if it crosses.",
        contact(),
        *one_contact(),
        *landings(),
        *depth_grows(),
        *push_after(),
        *critical_margin(),
        identity(
            r"the next contact function at $2\pi-\theta_c$ exceeds that for $D=c$ by $(-k-\kappa_c)(D-c)\geqslant 0$",
            spread_residual(),
        ),
        identity(r"which rises with $\theta$ at the rate $h\,(-k-\kappa_c)$", long_to_short_slope_residual()),
        identity(r"from $P$ at $\theta=\theta_c$", long_margin_residual()),
        identity(r"$\nu'-\kappa_c e=(h+2k/q)+(k-\kappa_c)\,e$ with the gap $e=D-2/q$", push_residual()),
        identity(r"$h+2k/q$ is $h(\theta_c)+P$ at $2\pi-\theta_c$", short_margin_residual()),
    )


@cache
def short_slip_stays_above() -> Evidence:
    """A short slip that ends in S0 ends with w > 0."""
    with precision(20):
        end = 2 * arb.pi() - critical_angle(critical_value())
        start = point(FROM)
        early = 2 * rise(start) * (start / 2).cot() > 1
        width = (end - start) / PIECES
        pieces = [start + width * n for n in range(PIECES + 1)]
        least = [margin_at(low.union(high)) for low, high in pairwise(pieces)]
        enough = early and all(value > point(Fraction(1, 5)) for value in least)
        text = f"at 1.95: 2hk = {shown(2 * rise(start) * (start / 2).cot(), 8)}; up to {shown(end, 8)}: at least 0.2"
    return argument(
        "$w'/q$ is a quadratic in $D$, convex, and positive for $D>0$ if $1-2hk<q\\,h^2$ (its discriminant), or if $hk\\geqslant 1$. As "
        "$hk$ falls, $2hk>1$ up to $\\theta=1.95$; beyond, the least $q$ for which a short slip is as long as $\\theta$ is $2/c(2\\pi-\\theta)$.",
        identity(r"$w'/q=h^2-2(1-hk)D+(k^2+q)D^2$ at the end of a slip in $S_0$", landing_excess_residual()),
        vanishes(
            r"$(hk)'=-\frac{\theta(2+\cos\theta)-3\sin\theta}{(1-\cos\theta)^2}$, negative by the inequality of Cusa and Huygens",
            sp.diff(h() * sp.sin(theta) / (1 - sp.cos(theta)), theta) + cusa_huygens() / (1 - sp.cos(theta)) ** 2,
        ),
        *rise_is_convex(),
        *depth_grows(),
        Evidence(
            EvidenceKind.ENCLOSURE,
            ENGINE,
            r"$2hk>1$ at $\theta=1.95$, and $\frac{2h^2}{c(2\pi-\theta)}-1+2hk>0.2$ on $[1.95,\,2\pi-\theta_c(r^*)]$",
            bool(enough),
            PIECES,
            text,
        ),
    )


@cache
def reentry_above_critical() -> Evidence:
    """After one or more crossings the first re-entry exists and has w > 0."""
    return argument(
        "A long slip loses at least $q\\,r\\,c^2\\geqslant 4r/q$ of $w$, and of two slips in turn one is long, so there are finitely many "
        "crossings. Long slips cross; the first that does not is short, and ends with $w>0$.",
        alternate(),
        short_slip_stays_above(),
    )
