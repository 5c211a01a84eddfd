"""Every slip from $S$: where it ends, in closed form, and what grows with its angle."""

from paper_checks.claims.beyond.excursions import vanishes
from paper_checks.claims.letters import C, H, R, in_angle
from paper_checks.claims.words import *
from paper_checks.decide.roots import enclosed_root
from theory.excursion import h, half_tangent_form
from theory.return_map import (
    contact_condition,
    contact_slope_residual,
    depth,
    depth_slope_residual,
    gap,
    in_trigonometry,
    landing,
    landing_residuals,
    push,
)
from theory.scaling import to_si


@cache
def one_contact() -> Steps:
    """What ends a slip rises."""
    rises = vanishes(
        r"it rises: its derivative is $h'+\frac{d}{1-\cos\theta}$, $d\geqslant 0$", contact_slope_residual()
    )
    return (rises,)


@cache
def landings() -> Steps:
    """Where a slip ends, from the solution of the slip's differential equation."""
    names = "d' = -(d+c)", "u' = u-\\theta", "w'-w = -q\\,r\\,c\\,(c+2d)"
    return tuple(
        vanishes(f"at the end ${name}$", residual) for name, residual in zip(names, landing_residuals(), strict=True)
    )


@cache
def depth_grows() -> Steps:
    """c' = h > 0."""
    return (vanishes("$c'=h>0$", depth_slope_residual()),)


def _crossing_depth() -> Expr:
    """Return the depth at which a slip from a ray ends at the other edge, X' = -1."""
    return root(1 + q * landing().gap.subs({gap: 0, depth(): C}) + 1, C)


def _turning_angle() -> arb:
    """Return theta_v in (pi, 2 pi) with tan theta = theta, enclosed."""
    with precision():
        return enclosed_root(lambda x: x.sin() - x * x.cos(), 4, 5)


@theorem(
    "excursion-closed-form",
    clause(
        "contact",
        r"""
        Every slip that starts on $S$, mirrored to $x_1=L(1+q\,d)$, $v_1=v_2=L\Omega\sqrt q\,\nu$ with $d\geqslant 0$,
        $v_1<v_2$ (and $\nu>0$ if $d=0$), ends at the one angle $\theta=\sqrt{a/m_1}\,t\in(0,2\pi)$ with «contact»,
        «rise».
        """,
        contact=in_angle(r"\nu", H - gap * sp.cot(theta / 2), lambda: root(contact_condition(), push)),
        rise=equal("h", (theta - sin(theta)) / (1 - cos(theta)), h),
        kernel="one-contact",
    ),
    clause(
        "landing",
        r"A slip with that $\nu$ for an angle $\theta$ ends there with «gap», «push» and «loss», where «depth», «share», «rest», $M=m_1+m_2$, $w=E/E_{cr}-1$.",
        share=equal(q, m1 / (m1 + m2), lambda: to_si(q)),
        rest=equal("r", m2 / (m1 + m2), lambda: to_si(r)),
        gap=in_angle("d'", -(gap + C), lambda: landing().gap),
        push=in_angle(r"\nu'", push - theta, lambda: landing().push),
        loss=in_angle("w'-w", -q * R * C * (C + 2 * gap), lambda: landing().excess_change),
        depth=equal("c", 2 - theta * sp.cot(theta / 2), depth),
        kernel="gap-slip",
    ),
    clause(
        "stays",
        r"From a ray a slip of the angle $\theta$ re-enters $S_0$ if $c(\theta)\leqslant c^*$, «edge», and crosses $S$ otherwise;",
        edge=equal("c^*", 2 / q, _crossing_depth),
        kernel="re-entry ray-crossing",
    ),
    clause(
        "leaves",
        r"""
        having re-entered with $w'>0$ the pair leaves by the opposite ray if $\theta<\theta_v$,
        $\tan\theta_v=\theta_v$, «turn», and by the same ray if $\theta>\theta_v$.
        """,
        turn=decimal(r"\theta_v", "4.4934", _turning_angle),
        kernel="turning-angle leaves-by",
    ),
)
def excursion_closed_form() -> Case:
    """The end of every slip from S, whether it stays, and the ray that the pair leaves by next."""
    return because(
        r"""
        Every slip from $S$ ends at the root of one monotone equation, and its result is an elementary function of its
        angle. With the root at its start divided out, the guard of a slip from $S$ is a monotone function of the slip
        angle, so the slip has exactly one end, where the state is an elementary function of the angle. On $S_0$ above
        $E_{cr}$ the velocity keeps its sign up to the ray, so the sign of $V'=\sqrt q\,(h-\theta)$ determines the ray;
        $V'=0$ inside $S_0$ is below $E_{cr}$.
        """,
        landings,
    )


@theorem(
    "excursion-monotone",
    clause(
        "rise",
        r"""
        «rise» increases from $0$ to $\infty$ on $(0,2\pi)$ and is convex; the condition that ends a slip is monotone
        in $\theta$ for every start on $S$;
        """,
        rise=equal("h", (theta - sin(theta)) / (1 - cos(theta)), h),
        kernel="excursion-rise",
    ),
    clause(
        "depth",
        r"""
        the depth $c$, «slope», increases from $0$ to $\infty$ and is concave as a function of $y=h^2$. Exit speed,
        duration, depth and energy lost of an excursion from a ray increase together.
        """,
        slope=equal(
            "c'",
            H,
            lambda: half_tangent_form(diff(in_trigonometry(depth()), theta)),
            lambda: {H: half_tangent_form(h())},
        ),
        kernel="excursion-depth excursions-grow",
    ),
)
def excursion_monotone() -> Case:
    """h rises and is convex, c rises and is concave in h^2."""
    return because(
        r"""
        Speed, duration, depth and loss of an excursion grow together: $h$ rises and is convex. $h'$ is
        $(\sin\varphi-\varphi\cos\varphi)/\sin^3\varphi$ with $\varphi=\theta/2$, whose numerator grows from $0$;
        $h''>0$ is the inequality of Cusa and Huygens; $c'=h$. The exit speed is $\sqrt q\,h$, the duration $\sqrt
        q\,\theta$, the depth $q\,c$ and the excess lost $q\,r\,c^2$ (units of the reduced coordinates): each
        increases with $\theta$.
        """,
        depth_grows,
    )
