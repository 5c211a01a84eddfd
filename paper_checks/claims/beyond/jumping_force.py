"""A continuum of periodic motions under one force that jumps, without a damper."""

from paper_checks.claims.words import *
from theory import jumping_force as jump

HALF_PI = pi / 2


@cache
def slips() -> Evidence:
    """Every member slips with sign 1 through the whole of its slip."""
    relative = jump.relative_velocity()
    slowest, fastest = jump.slowest_and_fastest()
    ends = [relative.subs(t, 0), relative.subs(t, jump.SLIP_TIME)]
    slopes = [diff(relative, t).subs(t, at) for at in (0, jump.SLIP_TIME)]
    return argument(
        r"""
        $\dot z$ is $0$ at both ends of the slip, leaves $0$ upwards, as $v>1-\pi/2$, and $\ddot z$ is positive as
        long as $(\pi/2+v)\tan t<-v$ and negative after that. So $\dot z$ is convex and rising, then concave with $0$
        at its end: positive in between.
        """,
        identity(
            r"$\dot z$ vanishes at $0$ and $\pi/2$, has the slopes $v-1+\pi/2$ and $-1-v$ there and $\ddot z=-v\cos t-(\pi/2+v)\sin t$",
            [*ends, *slopes, diff(relative, t, 2)],
            [
                *(0, 0, jump.speed - 1 + HALF_PI, -1 - jump.speed),
                -jump.speed * cos(t) - (HALF_PI + jump.speed) * sin(t),
            ],
        ),
        compare(r"every $v$ of the family is negative: the largest is", ball(fastest), "<", point(0)),
        compare(r"and every $\pi/2+v$ is positive: the smallest is", ball(HALF_PI + slowest), ">", point(0)),
    )


@cache
def sticks() -> Evidence:
    """Every member can stick through its stick, and slips at once after the jump that ends it."""
    before, after, first = jump.loads()
    slowest, _ = jump.slowest_and_fastest()
    contact = jump.contact_state()
    return argument(
        r"""
        The stick is less than half a turn of the stuck pair, which has $v_1>0$ at both of its ends, so $x_1$ rises
        and the load $-x_1/2$ falls from one end to the other: $|\Lambda|<b$ all the way. At the jump the load leaves
        the strip.
        """,
        identity(
            r"the load is $(\pi/4-v)/2$ where the stick begins, of size $(v+3\pi/4)/2$ where it ends, $(v+1+\pi/2)/2$ after the jump",
            [first, before, after],
            Matrix([pi / 4 - jump.speed, jump.speed + 3 * pi / 4, jump.speed + 1 + HALF_PI]) / 2,
        ),
        identity(
            r"the stick begins with $v_1=v+\pi/2$ and ends with $v_1=-v$",
            [contact[1], jump.after_half_period()[1]],
            [jump.speed + HALF_PI, -jump.speed],
        ),
        compare(
            "the largest load where a stick begins is below $b=1$",
            ball(first.subs(jump.speed, slowest)),
            "<",
            point(1),
        ),
        compare(r"the stick turns by less than $\pi$", ball(2 * sp.atan(sqrt(2))), "<", ball(pi)),
        slips,
        kernel.step("mode-stick"),
        kernel.step("mode-slip"),
    )


@cache
def returns() -> Evidence:
    """After half a period the state is minus what it was, for every member."""
    return identity(
        r"after slip and stick $(x_1,v_1,v_2)$ is minus what it was at the exit, for every $v$",
        jump.after_half_period(),
        -Matrix(jump.exit_state()),
    )


@cache
def keeps_apart() -> Evidence:
    """Two members keep their distance for ever, so none attracts another."""
    return argument(
        r"Under a force with $u(t+H)=-u(t)$ the state after $H$ is always minus the state before, so each member has the period $2H$. Two of them have the same distance after each period, which is not $0$.",
        returns,
        sticks,
    )
