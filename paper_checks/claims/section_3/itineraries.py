"""Section III: an itinerary that merges, and one that creeps."""

from numerics.trajectory.events import Event
from paper_checks.claims.words import *
from theory.excursion import (
    h,
    half_tangent_form,
    next_excess,
)

LARGEST = pi**2 / 4
"""w/q of the excursion of slip angle pi: proved by `largest_excess`, used by `starts_below`."""


ARGUMENT = (
    r"""
    On an exit ray the state is one number, the excess energy $w=E/E_{cr}-1>0$. With $\nu=\sqrt{w/q}$ the slip that
    starts there ends at the angle $\theta=\sqrt{a_2/m_1}\,t$ for which $h(\theta)=\nu$, where
    $$h(\theta)=\frac{\theta-\sin\theta}{1-\cos\theta}$$ increases from $0$; so $\theta<\pi$ while
    $w<q\,h(\pi)^2=q\pi^2/4$.
    """,
    r"""
    The excess $w'$ after the slip increases with $\theta$ from $0$ if $m_2\leqslant m_1$: $w'>0$, and $w'<w$ as a
    slip dissipates. For $\theta\leqslant\pi$ the slip ends inside $S_0$, since $0<1-X<2q<2$ there.
    """,
    r"""
    With $w'>0$ the pair sticks along an arc of $E=E_0>E_{cr}$ until it reaches a ray, after less than half a period,
    and leaves by it with $w'<w<q\pi^2/4$; this repeats without end.
    """,
    r"""
    During a slip $|V_1-V_2|=\sqrt q\,\bigl(\nu(1-\cos\theta)-(\theta-\sin\theta)\bigr)$, largest where
    $\tan(\theta/2)=\nu$: $$\max|\dot z|=2\sqrt q\,(\nu-\arctan\nu)\,L\Omega,\qquad
    L\Omega=\frac{b\,(m_1+m_2)}{a_2m_2}\sqrt{\frac{a_2}{m_1+m_2}},$$ which falls from slip to slip with $w$.
    """,
)


@cache
def excess_after() -> Evidence:
    """dw'/dtheta in factors, and w' at theta = 0."""
    slope = 2 * q * h() * diff(h(), theta) * (1 - r * (1 - cos(theta)))
    return identity(
        r"$w'=0$ at $\theta=0$ and $\frac{dw'}{d\theta}=2q\,h\,h'\,\bigl(1-r(1-\cos\theta)\bigr)$, $r=m_2/(m_1+m_2)$",
        [taylor(next_excess(), theta, 1), half_tangent_form(diff(next_excess(), theta))],
        [0, half_tangent_form(slope)],
    )


@cache
def last_factor_is_positive() -> Evidence:
    """1 - r(1 - cos theta) > 0 for m2 <= m1, 0 < theta < pi."""
    cosine = Symbol("c", real=True)
    return prove(
        r"$1-r(1-\cos\theta)>0$ for $m_2\leqslant m_1$ and $0\leqslant\theta<\pi$ ($c=\cos\theta$, $q=1-r$)",
        [sp.Ge(2 * q, 1, evaluate=False), q < 1, cosine > -1, cosine <= 1],
        signed(1 - r * (1 - cosine), ">"),
    )


def first_exit(trajectory: Trajectory) -> Event:
    """Return the first exit of a trajectory; raises ValueError where it has none."""
    for event in trajectory.events:
        if event.kind is EventKind.EXIT:
            return event
    raise ValueError("the trajectory has no exit from S0; solve further")


def relative_speed_bound(trajectory: Trajectory, after: Event) -> arb:
    """Return 2 sqrt(q) (u - arctan u) L Omega, m/s, for an exit: |z'| is never larger after it."""
    frame = trajectory.frame
    with trajectory.arithmetic.context():
        u = (after.reduced.w / frame.q).sqrt()
        return 2 * frame.sqrt_q * (u - u.atan()) * frame.speed


def every_excursion() -> Steps:
    """Return the steps of `ARGUMENT` that hold for every pair with m2 <= m1."""
    return excess_after(), last_factor_is_positive()


def starts_below(trajectory: Trajectory, name: str) -> Steps:
    """Return that a scene in balls meets the assumption at its first exit; `name` says which scene.

    Raises ValueError where m2 > m1, or the trajectory has no exit.
    """
    if trajectory.scene.pair.m2 > trajectory.scene.pair.m1:
        raise ValueError("the argument needs m2 <= m1")
    excess = first_exit(trajectory).reduced.w
    with trajectory.arithmetic.context():
        largest = trajectory.frame.q * ball(LARGEST)
    return (
        compare(f"{name}: $w>0$ at the first exit", excess, ">", point(0)),
        compare(f"{name}: $w<q\\pi^2/4$ at the first exit", excess, "<", largest),
    )


def never_merges(trajectory: Trajectory, name: str) -> Steps:
    """Return all steps of `ARGUMENT` for a scene in balls. Raises as `starts_below`."""
    return (*every_excursion(), *starts_below(trajectory, name))


PLUS, MINUS, STICK = Mode.SLIP_PLUS, Mode.SLIP_MINUS, Mode.STICK


@claim(
    "itinerary-that-merges",
    "III",
    "Fig. 3 (a)",
    HOLDS,
    """
    A trajectory enters the sliding region $S_0$ of $S$ and merges with one of the elliptic closed trajectories
    located in $S_0$; its energy satisfies $E<E_{cr}$.
    """,
)
def itinerary_that_merges(scene: Scene | None = None) -> Case:
    """A slip that ends in S0 below E_cr."""
    trajectory = solved(scene or load_scene("itinerary-that-merges"))
    return because(
        """
        The paper gives no numbers; the scene itinerary-that-merges is one such trajectory. It slips once, enters $S_0$
        and sticks permanently on an ellipse below the critical one.
        """,
        carried(
            "statement",
            itinerary("slip in $\\Omega_+$, then stick", trajectory, (PLUS, STICK)),
            stuck_for_ever("and the stick phase never ends", trajectory),
            compare("after it, $w=E/E_{cr}-1<0$", trajectory.reduced.final.w, "<", point(0)),
        ),
        figure="itinerary-that-merges",
    )


@claim(
    "itinerary-that-creeps",
    "III",
    "Fig. 3 (b)",
    HOLDS,
    clause(
        "points",
        r"""
        A trajectory that starts at $O_1\in\Omega_+$ crosses $S$ at $A_1\in S_+$ into $\Omega_-$ and at $B_1\in S_-$
        back into $\Omega_+$, enters $S_0$ at $A_2$, exits through $C_1\in\ell_+$ into $\Omega_-$, re-enters $S_0$ at
        $B_2$, exits through $D_1\in\ell_-$ into $\Omega_+$, re-enters $S_0$ at $A_3$ and proceeds inside $S_0$ to
        $O_2$.
        """,
    ),
    clause(
        "creeps",
        r"Continued, it converges asymptotically to the elliptic trajectory of energy $E_{cr}$.",
        kernel="itinerary-creeps",
    ),
)
def itinerary_that_creeps(scene: Scene | None = None) -> Case:
    """The itinerary of nine named points, then the proof that it never merges."""
    trajectory = solved(scene or load_scene("itinerary-that-creeps"))
    return because(
        """
        The paper gives no numbers; the scene itinerary-that-creeps passes all the named points in their order, with
        $O_2$ in the stick phase after $A_3$. At its first contact its energy is above $E_{cr}$, and as $m_1=m_2$ it stays so: by
        the dichotomy it tends to the critical orbit.
        """,
        carried(
            "points",
            itinerary(
                r"""
                $O_1A_1$ in $\Omega_+$, $A_1B_1$ in $\Omega_-$, $B_1A_2$ in $\Omega_+$, stick $A_2C_1$, $C_1B_2$ in
                $\Omega_-$, stick $B_2D_1$, $D_1A_3$ in $\Omega_+$, stick $A_3O_2$
                """,
                trajectory,
                (PLUS, MINUS, PLUS, STICK, MINUS, STICK, PLUS, STICK),
            ),
            compare("$A_1\\in S_+$: $X>1$", trajectory.events[0].reduced.X, ">", point(1)),
            compare("$B_1\\in S_-$: $X<-1$", trajectory.events[1].reduced.X, "<", point(-1)),
            compare("$C_1\\in\\ell_+$: $V>0$", trajectory.events[3].reduced.V1, ">", point(0)),
            compare("$D_1\\in\\ell_-$: $V<0$", trajectory.events[5].reduced.V1, "<", point(0)),
        ),
        carried("creeps", *starts_below(trajectory, "itinerary-that-creeps")),
        figure="itinerary-that-creeps",
    )
