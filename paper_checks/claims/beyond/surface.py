"""The pair on a surface under round friction: what sticks for ever, how a slip ends, a force that goes round."""

from paper_checks.claims.words import *
from theory.forced_response import omega


@cache
def load_and_place() -> Evidence:
    """The load of a stuck pair is in proportion to its place, and L is where it is b."""
    return argument(
        r"""
        Stuck, $(m_1+m_2)\ddot{\mathbf q}=-a_2\mathbf q$ moves body 1 on an ellipse with the frequency $\Omega$, and the
        force on body 2 is $m_2\ddot{\mathbf q}$, of the magnitude $m_2a_2|\mathbf q|/(m_1+m_2)$. With $\mathbf
        p=\dot{\mathbf q}/\Omega$ the energy is $\frac{a_2}2(|\mathbf q|^2+|\mathbf p|^2)$.
        """,
        identity(r"this magnitude at $|\mathbf q|=L$ is $b$", m2 * a2 * half_width() / (m1 + m2), b),
        identity(r"$\frac{a_2}2L^2=E_{cr}$", a2 * half_width() ** 2 / 2, critical_energy()),
    )


@theorem(
    "stuck-ellipses",
    clause(
        "load",
        r"""
        With isotropic friction $|\mathbf f|\leqslant b$, scalar masses and spring, no damper and no force, a stuck pair
        moves on $\mathbf q\cos\Omega t+\mathbf p\sin\Omega t$, its load stays within $b$ exactly while this is within
        $L$ of the origin, and its energy is $\frac{a_2}2(|\mathbf q|^2+|\mathbf p|^2)$, $\frac{a_2}2L^2=E_{cr}$.
        """,
        kernel="plane-stuck-load",
    ),
    clause(
        "axis",
        r"It stays there permanently exactly if the semi-major axis of this ellipse is at most $L$:",
        kernel="plane-stuck-iff",
    ),
    clause(
        "energies",
        r"""
        for $E\leqslant E_{cr}$ always, for $E>2E_{cr}$ never; on a line exactly for $E\leqslant E_{cr}$, on a circle
        exactly for $E\leqslant 2E_{cr}$. There is no single critical energy.
        """,
        kernel="plane-stuck-energies",
    ),
    clause(
        "lands",
        r"""
        In a slip $\mathbf s$ with $\dot{\mathbf s}=\kappa(\Lambda-b\,\mathbf s/|\mathbf s|)$ the function
        $G=b|\mathbf s|+\Lambda\cdot\mathbf s$ has the rate
        $-\kappa(b^2-|\Lambda|^2)+\dot\Lambda\cdot\mathbf s$, which is negative near the slip's end if $|\Lambda|<b$
        there.
        """,
        kernel="plane-landing",
    ),
    assuming="On a surface, with scalar masses and springs, and friction against the slip of at most $b$ in every direction; no damper and no force.",
)
def stuck_ellipses() -> Case:
    """The load turns with the place."""
    return because(
        "On a surface a stuck pair sticks permanently exactly if its ellipse fits into the disc of radius $L$: while stuck, the load is proportional to the displacement. At a given energy, the rounder the ellipse, the better it fits.",
        carried("load", load_and_place),
        figure="stuck-ellipses",
    )


@cache
def one_quadratic() -> Evidence:
    """In the frame of the friction the force is D_M + i p D in units of f/(m2 omega^2)."""
    p = Symbol("p", nonnegative=True)
    alone, both = (a2 - m * omega**2 for m in (m1, m1 + m2))
    return identity(
        r"$|D_M+ipD|^2=|D_M|^2+2a_1m_2\omega^3p+|D|^2p^2$, $p=m_2\omega\rho/f$",
        (both - p * a1 * omega) ** 2 + (a1 * omega + p * alone) ** 2,
        both**2 + (a1 * omega) ** 2 + 2 * a1 * m2 * omega**3 * p + (alone**2 + (a1 * omega) ** 2) * p**2,
    )


@theorem(
    "rotating-force",
    clause(
        "motion",
        r"""
        Under the force $U(\cos\omega t,\sin\omega t)$ on body 1, $U>0$, with scalar masses, spring and damper, there is
        a motion with a friction of the constant magnitude $f>0$, along a slip of the constant speed $\rho\geqslant 0$,
        wherever $(m_2\omega^2U)^2=f^2|D_M|^2+2a_1m_2^2\omega^4f\rho+m_2^2\omega^2|D|^2\rho^2$,
        $D=a_2-m_1\omega^2+ia_1\omega$, $D_M=a_2-(m_1+m_2)\omega^2+ia_1\omega$.
        """,
        kernel="rotating-motion",
    ),
    clause(
        "threshold",
        r"""
        Let $D\neq 0$ and $U_*=b|D_M|/(m_2\omega^2)$. Up to $U_*$ this holds with $\rho=0$ and a friction $f=bU/U_*$
        that sticking can give; with $f=b$ it holds for a speed $\rho>0$ exactly if $U>U_*$, and for only one: for these
        motions both thresholds coincide.
        """,
        kernel="rotating-threshold",
    ),
    clause(
        "falling",
        r"""
        Where friction $b(\rho)$ depends on the speed, the $U$ of that equation with $f=b(\rho)$ has
        $\frac{d(U^2)}{d\rho}=\frac{2\rho|D|^2}{\omega^2}X(0)$,
        $X(0)=(1+b'g_s)(1+\frac b\rho g_s)+b'\frac b\rho g_a^2$, with $g_s=a_1\omega^2/|D|^2$ and
        $g_a=\omega(a_2-m_1\omega^2)/|D|^2-1/(m_2\omega)$.
        """,
        kernel="rotating-characteristic",
    ),
    clause(
        "unstable",
        r"""
        Where $X(0)<0$, the equations linearised about that motion, in axes that rotate with the force, have a solution
        that grows like $e^{\lambda t}$ with a $\lambda>0$.
        """,
        kernel="rotating-unstable",
    ),
    assuming="On a surface, with scalar masses and springs, and friction against the slip of at most $b$ in every direction; a damper $a_1\\geqslant 0$, a rotating force of constant magnitude.",
)
def rotating_force() -> Case:
    """A force that goes round meets a friction that goes round with it."""
    return because(
        "Under a rotating force a motion that rotates with it sticks up to one threshold and, unless body 1 resonates without a damper, slips at one speed above it: in axes that rotate with the force it is at rest, and its equations reduce to one quadratic for that speed. From the amplitude on at which sticking needs more than $b$ that speed is positive. With a damper every motion tends to this one: see forced-periodic-response.",
        one_quadratic,
    )
