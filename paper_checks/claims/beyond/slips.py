"""Every slip from $S$: where it ends, in closed form, and what grows with its angle."""

from itertools import islice

from numerics.arithmetic.ball import Ball
from numerics.free.excursions import excursions
from numerics.free.frame import Frame
from paper_checks.claims.beyond.excursions import angle_of_excursion, vanishes
from paper_checks.claims.letters import C, H, R, in_angle
from paper_checks.claims.words import *
from paper_checks.decide.balls import shown
from paper_checks.decide.roots import enclosed_root
from theory.excursion import guard_factors, h, half_tangent_form
from theory.linear import root
from theory.return_map import (
    contact_condition,
    contact_slope,
    contact_slope_residual,
    depth,
    depth_slope_residual,
    gap,
    guard_residual,
    in_trigonometry,
    landing,
    landing_residuals,
    push,
    return_map_of_angle,
    return_map_residuals,
)
from theory.scaling import to_si


@cache
def contact() -> Evidence:
    """The guard with its root at the start divided out."""
    return stating(
        vanishes(
            r"""
            the guard is $\sqrt q\,(1-\cos\theta)\,(h(\theta)-d\cot(\theta/2)-\nu)$: its root at the start is divided
            out, and the slip ends at the first zero of the last factor
            """,
            guard_residual(),
        ),
        form("0", contact_condition()),
        form("h", h()),
    )


@cache
def one_contact() -> Steps:
    """The last factor rises from below zero to infinity."""
    push_slope, gap_slope = contact_slope()
    at_zero = sp.limit(contact_condition().subs(gap, 1), theta, 0, "+")
    at_turn = sp.limit(contact_condition().subs({gap: 1, push: 0}), theta, 2 * pi, "-")
    return (
        stating(
            vanishes(
                r"it rises: its derivative is $h'+\frac{d}{1-\cos\theta}$, $d\geqslant 0$", contact_slope_residual()
            ),
            form("derivative", push_slope + gap_slope),
        ),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"from $-\infty$ (from $-\nu<0$, if $d=0$) at $\theta=0$ to $\infty$ at $\theta=2\pi$: one zero, and there only the guard ends",
            (at_zero, at_turn) == (-oo, oo),
            2,
            "both limits at d = 1 are unbounded with these signs"
            if (at_zero, at_turn) == (-oo, oo)
            else "other limits",
        ),
    )


@cache
def landings() -> Steps:
    """Where a slip ends, from the solution of the slip's differential equation."""
    claimed, (before, after) = landing(), return_map_of_angle()
    names = ("d' = -(d+c)", "u' = u-\\theta", "w'-w = -q\\,r\\,c\\,(c+2d)")
    forms = (("d'", claimed.gap), ("u'", claimed.push), ("w' - w", claimed.excess_change))
    ends = [
        stating(vanishes(f"at the end ${name}$", residual), form(*closed))
        for name, residual, closed in zip(names, landing_residuals(), forms, strict=True)
    ]
    start, end = return_map_residuals()
    return (
        *ends,
        stating(vanishes("from a ray, with $y=w/q$: $y=h^2$", start), form("y", before)),
        stating(vanishes("and $y'=h^2-r\\,c^2$", end), form("y'", after)),
    )


def cusa_huygens() -> Expr:
    """Return theta (2 + cos theta) - 3 sin theta, which the inequality of Cusa and Huygens says is positive."""
    return theta * (2 + cos(theta)) - 3 * sin(theta)


@cache
def rise_is_convex() -> Steps:
    """h'' > 0 by the inequality of Cusa and Huygens, itself proved here."""
    slope = 4 * sin(theta / 2) * (sin(theta / 2) - theta / 2 * cos(theta / 2))
    difference = (diff(cusa_huygens(), theta) - slope).subs(theta, 2 * theta)
    return (
        vanishes(
            r"$h''=\frac{\theta(2+\cos\theta)-3\sin\theta}{(1-\cos\theta)^2}$",
            diff(h(), theta, 2) - cusa_huygens() / (1 - cos(theta)) ** 2,
        ),
        vanishes(
            r"""
            Cusa–Huygens, $\theta(2+\cos\theta)-3\sin\theta>0$: its derivative is
            $4\sin\frac{\theta}{2}\,(\sin\frac{\theta}{2}-\frac{\theta}{2}\cos\frac{\theta}{2})>0$ on $(0,2\pi)$
            """,
            difference,
        ),
        identity("and it is $0$ at $\\theta=0$", cusa_huygens().subs(theta, 0)),
    )


@cache
def depth_grows() -> Steps:
    """c' = h > 0 from 0 to infinity; c is concave in y = h^2."""
    limits = taylor(in_trigonometry(depth()), theta, 1), sp.limit(depth(), theta, 2 * pi, "-")
    slope = half_tangent_form(diff(in_trigonometry(depth()), theta) / diff(h() ** 2, theta))
    return (
        stating(vanishes("$c'=h>0$", depth_slope_residual()), form("c", depth())),
        Evidence(
            EvidenceKind.EXACT,
            "sympy",
            r"$c\to 0$ as $\theta\to 0$ and $c\to\infty$ as $\theta\to 2\pi$",
            limits == (0, oo),
            2,
            "0 and unbounded" if limits == (0, oo) else "other limits",
        ),
        vanishes(
            r"$\frac{dc}{dy}=\frac{1}{2h'}$ with $y=h^2$, which falls as $h'$ rises: $c$ is concave in $y$, and $c/y$ falls, as $c(0)=0$",
            slope - half_tangent_form(1 / (2 * diff(h(), theta))),
        ),
    )


def turning_angle() -> arb:
    """Return theta_v in (pi, 2 pi) with tan theta = theta, enclosed; call inside `precision`."""
    return enclosed_root(lambda x: x.sin() - x * x.cos(), 4, 5)


@cache
def turns_back() -> Steps:
    """V' = sqrt(q)(h - theta) changes its sign once, at theta_v."""
    velocity = sin(theta) - theta * cos(theta)
    with precision():
        root = turning_angle()
        share = 2 / (1 + (1 + root * root).sqrt())
        inside = root > arb.pi() and root < 3 * arb.pi() / 2
    return (
        vanishes(
            r"at re-entry $V'=\sqrt q\,(h-\theta)=-\sqrt q\,\frac{\sin\theta-\theta\cos\theta}{1-\cos\theta}$",
            (landing().push.subs(push, h()) * (1 - cos(theta)) + velocity),
        ),
        identity(
            r"""
            $\sin\theta-\theta\cos\theta$, with the derivative $\theta\sin\theta$, rises from $0$ on $(0,\pi)$ and
            falls to $-2\pi$ on $(\pi,2\pi)$: one zero, $\tan\theta_v=\theta_v$
            """,
            [diff(velocity, theta), velocity.subs(theta, 0), velocity.subs(theta, 2 * pi)],
            [theta * sin(theta), 0, -2 * pi],
        ),
        enclosed(r"$\theta_v\in(\pi,3\pi/2)$", bool(inside), f"theta_v = {shown(root)}"),
        enclosed(
            r"$c(\theta_v)=1+\sqrt{1+\theta_v^2}$, so $\theta_v<\theta_c(q)$, $c(\theta_c)=2/q$, exactly for $q<2/(1+\sqrt{1+\theta_v^2})$",
            bool(share > 0 and share < 1),
            f"q_v = 2/(1 + sqrt(1 + theta_v**2)) = {shown(share)}",
        ),
    )


@cache
def stays_or_crosses() -> Steps:
    """X' = 1 - q c meets -1 at one angle beyond pi; inside S0 above E_cr the velocity keeps its sign."""
    position, velocity = symbols("X V", real=True)
    return (
        identity(
            r"$c(\pi)=2$ and $X'=1-q\,c$: with $c$ rising to $\infty$, $X'=-1$ at one angle $\theta_c(q)\in(\pi,2\pi)$",
            depth().subs(theta, pi),
            2,
        ),
        prove(
            r"on $S_0$ above $E_{cr}$, $X^2+V^2>1$ with $|X|\leqslant 1$: $V\neq 0$, so the stick moves on to the edge that $V'$ points to",
            [position**2 + velocity**2 > 1, position**2 <= 1],
            sp.Ne(velocity, 0),
        ),
    )


def first_factor_positive() -> Evidence:
    """The factor divided out has no zero inside (0, 2 pi)."""
    return identity(
        r"the factor divided out is $\sqrt q\,(1-\cos\theta)>0$", guard_factors()[0], sqrt(q) * (1 - cos(theta))
    )


def _crossing_depth() -> Expr:
    """Return the depth at which a slip from a ray ends at the other edge, X' = -1."""
    return root(1 + q * landing().gap.subs({gap: 0, depth(): C}) + 1, C)


def _turning_angle() -> arb:

    with precision():
        return turning_angle()


def exits_twice_by(share: Fraction, excess: Fraction, same: bool) -> Evidence:
    """Solve two excursions of the pair q = share from the ray with this excess: by the same ray or by the other one?"""
    arithmetic = Ball(40)
    with arithmetic.context():
        frame = Frame(arithmetic, Pair(m1=share, m2=1 - share, a2=1, b=1))
        sides = [one.side for one in islice(excursions(frame, arithmetic.number(excess)), 2)]
    return enclosed(
        f"solved with $q={share}$ from a ray with $w={excess}$: the next exit is by the {'same' if same else 'opposite'} ray",
        len(sides) == 2 and (sides[0] == sides[1]) is same,
        f"sides {sides}",
        engine="numerics, balls",
        supports=True,
    )


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
        contact,
        first_factor_positive,
        angle_of_excursion,
        one_contact,
        landings,
        *depth_grows()[:2],
        stays_or_crosses,
        turns_back,
        exits_twice_by(Fraction(1, 5), Fraction(1, 10), same=False),
        exits_twice_by(Fraction(1, 5), Fraction(15), same=True),
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
        angle_of_excursion,
        rise_is_convex,
        depth_grows,
        one_contact,
        *landings()[3:],
    )
