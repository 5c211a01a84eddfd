"""The mass ratio from which on no motion merges slightly above the critical energy."""

from paper_checks.claims.beyond.excursions import vanishes
from paper_checks.claims.words import *
from paper_checks.decide.balls import shown
from paper_checks.decide.roots import enclosed_root
from theory.excursion import angle
from theory.merging import (
    critical_mass_ratio,
    critical_mass_ratio_residual,
    critical_share,
    ratio,
    ratio_slope_residual,
    turning_function,
    turning_residual,
    turning_slope,
    turning_slope_residual,
)


def rise(theta: arb) -> arb:
    """Return h(theta) = (theta - sin theta)/(1 - cos theta)."""
    return (theta - theta.sin()) / (2 * (theta / 2).sin() ** 2)


def depth(theta: arb) -> arb:
    """Return c(theta) = 2 - theta cot(theta/2)."""
    return 2 - theta * (theta / 2).cot()


@cache
def one_turning_point() -> Steps:
    """R = h/c falls from infinity to its one minimum sqrt(r*) and rises to infinity."""
    first, second = turning_slope()
    return (
        stating(
            vanishes(
                r"with $R=h/c$: $\frac{dR}{d\varphi}=\sin^{-2}\varphi-2R^2$",
                ratio_slope_residual(),
            ),
            form("R", ratio()),
        ),
        vanishes(
            r"""
            $2R^2\sin^2\varphi=\frac{A^2}{2B^2}$, $A=\varphi-\sin\varphi\cos\varphi$,
            $B=\sin\varphi-\varphi\cos\varphi$, both positive: $R$ falls exactly where $K=A-\sqrt2B>0$
            """,
            turning_residual(),
        ),
        identity(
            r"$K'=\sin\varphi\,(2\sin\varphi-\sqrt2\,\varphi)$",
            [turning_slope_residual(), first * second - sin(angle) * (2 * sin(angle) - sqrt(2) * angle)],
            [0, 0],
        ),
        identity(
            r"""
            $\sin\varphi/\varphi$ falls, with derivative $-B/\varphi^2$, so $K$ rises from $0$ and then falls to
            $\pi(1-\sqrt2)<0$: one zero $\varphi^*$ in $(0,\pi)$
            """,
            [
                diff(sin(angle) / angle, angle) * angle**2,
                turning_function().subs(angle, 0),
                turning_function().subs(angle, pi),
            ],
            [angle * cos(angle) - sin(angle), 0, pi * (1 - sqrt(2))],
        ),
    )


def half_angle() -> arb:
    """Return phi*, the zero of K in (0, pi), enclosed; call inside `precision`."""
    root_two = arb(2).sqrt()
    return enclosed_root(
        lambda x: x - x.sin() * x.cos() - root_two * (x.sin() - x * x.cos()), Fraction(3, 2), Fraction(5, 2)
    )


def critical_value() -> arb:
    """Return r* = 1/(2 sin^2 phi*), enclosed; call inside `precision`."""
    return 1 / (2 * half_angle().sin() ** 2)


@cache
def threshold() -> Steps:
    """r* and both mass ratios in closed form at the root, to 50 digits."""
    with precision():
        root, value = half_angle(), critical_value()
        theta = 2 * root
        ratios = (value, (1 - value) / value, value / (1 - value))
        agree = all(
            one.overlaps(other)
            for one, other in zip(
                ratios, ((rise(theta) / depth(theta)) ** 2, -theta.cos(), -1 / theta.cos()), strict=True
            )
        )
        names = ("r* = 1/(2*sin(phi*)**2)", "m1/m2 = -cos(theta*)", "m2/m1 = -1/cos(theta*)")
        texts = [
            f"theta* = {shown(theta)}",
            *(f"{name} = {shown(one)}" for name, one in zip(names, ratios, strict=True)),
        ]
        beyond = root > arb.pi() / 2 and value < point(Fraction(3, 5)) and value > point(Fraction(1, 2))
    return (
        identity(
            r"at $\varphi^*$, where $A=\sqrt2B$: $r^*=R^2=\frac{1}{2\sin^2\varphi^*}$, which is $r(1-\cos\theta^*)=1$",
            2 * critical_share() * sin(angle) ** 2,
            1,
        ),
        stating(
            vanishes(r"so $m_1/m_2=(1-r^*)/r^*=2\sin^2\varphi^*-1=-\cos\theta^*$", critical_mass_ratio_residual()),
            form("m1/m2", critical_mass_ratio()),
        ),
        enclosed(
            r"$\theta^*$, $r^*$ and both mass ratios at the threshold; $R(\theta^*)^2$, $-\cos\theta^*$ and $-1/\cos\theta^*$ agree with them",
            agree,
            "; ".join(texts),
            3,
        ),
        enclosed(
            r"$\varphi^*>\pi/2$, so $\varphi^*$ is the upper end of $2r^*\sin^2\varphi>1$; $1/2<r^*<3/5$",
            bool(beyond),
            shown(value, 12),
            2,
        ),
    )


ANGLE = Symbol("varphi", positive=True)


def _critical_ratio() -> arb:

    with precision():
        return (1 - critical_value()) / critical_value()


@theorem(
    "critical-mass-ratio",
    clause(
        "root",
        r"Let $\varphi^*$ be the one root in $(0,\pi)$ of «turning», and «ratio» at $\varphi=\varphi^*$: «digits».",
        turning=equal(
            "K",
            ANGLE - sin(ANGLE) * cos(ANGLE) - sqrt(2) * (sin(ANGLE) - ANGLE * cos(ANGLE)),
            turning_function,
            lambda: {ANGLE: angle},
        ),
        ratio=equal(r"\mu^*", -cos(2 * ANGLE), critical_mass_ratio, lambda: {ANGLE: angle}),
        digits=decimal(r"\mu^*", "0.79263", _critical_ratio),
        kernel="turning-point critical-mass-ratio-digits",
    ),
    clause(
        "heavier",
        r"""
        If $m_1/m_2>\mu^*$, no slip that starts on $S$ above $E_{cr}$, from a ray or beyond an edge, ends with
        $E\leqslant E_{cr}$: whether a trajectory merges is decided by its energy at its first contact with $S$.
        """,
        kernel="no-low-level heavy-never-merges",
    ),
    clause(
        "lighter",
        r"""
        If $m_1/m_2<\mu^*$, there is an interval of energies such that a pair that leaves $S_0$ with one of them merges where
        it next meets $S$;
        """,
        kernel="merging-set",
    ),
    clause("equal", r"if $m_1/m_2=\mu^*$, there is exactly one such energy.", kernel="merging-set"),
)
def mass_ratio() -> Case:
    """The least excess after any slip from S touches zero at one slip from the ray, for one share."""
    return because(
        r"""
        Slips from $S$ above $E_{cr}$ can merge only if $m_1/m_2\leqslant-\cos\theta^*$, which is $0.79263\ldots$: pairs
        with a heavier driving body never merge after their first contact. For $r=r^*$ the least excess after a slip
        from $S$ is that on the ray for angles up to $\theta_1$ and from $\theta^*$ on, where
        $2r^*\sin^2\varphi\leqslant 1$; there $y'$ rises from $0$ at $\theta=0$, and from $c^2(R^2-r^*)=0$ at
        $\theta^*$. In between it is $\min_T w'$, which falls to the same $0$ at $\theta^*$. So $w'\geqslant 0$, with
        equality at one slip from the ray. As $w'$ falls with $r$, it is positive after every slip from $S$ for $r<r^*$,
        and negative after that one for $r>r^*$.
        """,
        one_turning_point,
        figure="merging-window",
    )
