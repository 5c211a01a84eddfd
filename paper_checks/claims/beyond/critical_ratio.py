"""The mass ratio from which on no motion merges slightly above the critical energy."""

from paper_checks.claims.words import *
from paper_checks.decide.roots import enclosed_root
from theory.excursion import angle
from theory.merging import (
    critical_mass_ratio,
    turning_function,
)


def rise(theta: arb) -> arb:
    """Return h(theta) = (theta - sin theta)/(1 - cos theta)."""
    return (theta - theta.sin()) / (2 * (theta / 2).sin() ** 2)


def depth(theta: arb) -> arb:
    """Return c(theta) = 2 - theta cot(theta/2)."""
    return 2 - theta * (theta / 2).cot()


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
def threshold() -> Evidence:
    """r* and the mass ratio in closed form at the root, to 50 digits."""
    with precision():
        value, theta = critical_value(), 2 * half_angle()
        ratio = (1 - value) / value
        agree = value.overlaps((rise(theta) / depth(theta)) ** 2) and ratio.overlaps(-theta.cos())
        numbers = {"theta*": theta, "r* = 1/(2*sin(phi*)**2)": value, "m1/m2 = -cos(theta*)": ratio, "m2/m1": 1 / ratio}
    return enclosed(
        r"$\theta^*$, $r^*$ and both mass ratios at the threshold; $R(\theta^*)^2$ and $-\cos\theta^*$ agree with them",
        agree,
        "; ".join(f"{name} = {text(one, 50)}" for name, one in numbers.items()),
        2,
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
        threshold,
        figure="merging-interval",
    )
