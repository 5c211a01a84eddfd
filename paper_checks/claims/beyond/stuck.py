"""A pair that sticks for ever under a periodic force, without a damper."""

from paper_checks.claims.words import *
from theory import forced_response as response
from theory.forced_response import multiple


@cache
def harmonic_curve() -> Evidence:
    """cos(phi) - share cos(n phi) is largest at pi/(2 n)."""
    phi = Symbol("phi", real=True)
    share = sin(pi / (2 * multiple)) / multiple
    curve = cos(phi) - share * cos(multiple * phi)
    quotient = multiple * cos(multiple * phi) * sin(phi) - sin(multiple * phi) * cos(phi)
    return argument(
        r"""
        On $(0,\pi/2n)$ the quotient $\sin n\varphi/\sin\varphi$ falls, to $1/\sin(\pi/2n)$; beyond, $\sin
        n\varphi\leqslant 1<\sin\varphi/\sin(\pi/2n)$ up to $\pi/2$. So $\cos\varphi-\frac{1}{n}\sin(\pi/2n)\cos
        n\varphi$ rises up to $\pi/2n$, falls from there to $0$ at $\pi/2$ ($n$ odd), and is even in $\varphi$ and odd
        beside $\pi/2$: its largest size is $\cos(\pi/2n)$.
        """,
        identity(r"its slope is $\sin(\pi/2n)\sin n\varphi-\sin\varphi$", diff(curve, phi), response.harmonic_slope()),
        identity(
            r"the numerator of the quotient's rate starts at $0$ and has the rate $(1-n^2)\sin n\varphi\sin\varphi<0$",
            [quotient.subs(phi, 0), diff(quotient, phi)],
            [0, (1 - multiple**2) * sin(multiple * phi) * sin(phi)],
        ),
    )


@cache
def undamped_stuck() -> Evidence:
    """Without a damper: the response with any free oscillation."""
    return argument(
        r"""
        A motion that sticks permanently has $\ddot x_1=-\omega^2X\sin\omega t$ and a free oscillation of frequency
        $\Omega$. Take the values at $\omega t=\pi/2+\pi k$ with the signs $(-1)^k$ and their mean over $k$: the first
        part gives $\omega^2X$, the second one a geometric mean that tends to $0$, unless $\Omega/\omega$ is odd. So
        $\omega^2X\leqslant b/m_2$ is needed. If $\Omega=n\omega$, $n\geqslant 3$ odd, take $\omega t=\pi/2\pm\pi/2n$:
        the mean is $\omega^2X\cos(\pi/2n)$ whatever is added, and a free oscillation attains it. If $\Omega=\omega$ the
        stuck motion grows like $t$.
        """,
        harmonic_curve,
    )


@cache
def tends_to_stuck() -> Evidence:
    """What sticks permanently with less than b at almost all times is approached by all that slips."""
    force = Symbol("f", real=True)
    return argument(
        r"""
        Let $\eta$ be a stuck motion of the force's period with $|\Lambda_\eta|\leqslant b$, the response or, for
        $\Omega=n\omega$, the one that is flattened. Its load is a sum of sinusoids, so $|\Lambda_\eta|=b$ at isolated
        instants only, and a motion that slips comes closer to it: in particular none of the force's period slips. For any motion
        $N$ has a limit, and limits of its shifts by periods keep their distance from $\eta$: they have $\dot z=0$, and
        stick permanently. So from some time on the motion is arbitrarily close to motions of the stuck pair that need at
        most $b$ from then on, and so at all times, as sums of sinusoids come back to what they were. It does not move away from
        any of them, and two of them keep their distance, so they converge, to one such motion to which it tends.
        """,
        identity(
            r"$\frac12\frac{d}{dt}N^2=-(b\sigma-\Lambda_\eta)\,\dot z$, which is $-(b-\sigma\Lambda_\eta)|\dot z|$",
            put(forced.contraction_rate().subs(a1, 0), {sigma_other: force / b, v2_other: v1_other}),
            -(b * sigma - force) * (v1 - v2),
        ),
        undamped_stuck,
        kernel.step("forced-contraction"),
    )
