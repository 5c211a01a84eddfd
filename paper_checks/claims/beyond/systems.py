"""One theorem for friction in any number of directions: the pair under a force, chains, a surface."""

from paper_checks.claims.section_3 import filippov
from paper_checks.claims.words import *


@theorem(
    "friction-in-any-direction",
    clause(
        "contraction",
        r"""
        In any real space with an inner product let $M>0$, with an inverse, and $K\geqslant 0$ be symmetric, $C$ a
        damper with $(C(v)-C(w))\cdot(v-w)\geqslant 0$, and $f\in\partial\psi(B\dot q)$ a friction that stays bounded,
        with any function $\psi$. The flow of $M\ddot q+C(\dot q)+Kq+B^{T}f=u$ is non-expansive in $N$, $N^2=q\cdot
        Kq+\dot q\cdot M\dot q$ of their difference.
        """,
        kernel="system-contraction",
    ),
    clause(
        "forces",
        r"Under two forces two motions separate by at most the integral of $\sqrt{(u-\tilde u)\cdot M^{-1}(u-\tilde u)}$.",
        kernel="system-defects",
    ),
    clause(
        "brakes",
        r"""
        For $u=0$ and $C(v)\cdot v\geqslant 0$ let any bounded force $f$ brake, $f\cdot B\dot q\geqslant\beta|B\dot q|$ with
        $\beta>0$. Then $\beta\int_0^\infty|B\dot q|\,dt\leqslant E(0)$; what moves by no more than $\int|B\dot q|\,dt$
        has a limit, and is at most $E(t)/\beta$ away from it; and where $|B\dot q|$ is Lipschitz in time it tends to
        $0$.
        """,
        kernel="system-synchronises",
    ),
    clause(
        "falls",
        r"""
        Where $(C(v)-C(w))\cdot(v-w)\geqslant-c\,(v-w)\cdot M(v-w)$ only, $c\geqslant 0$, as with a friction that falls
        with speed at a bounded slope, two motions have $N(t)\leqslant e^{ct}N(0)$.
        """,
        kernel="system-parts",
    ),
    clause(
        "pair",
        r"Motions of the pair under a force are motions of this inclusion with one direction.",
        kernel="pair-inclusion",
    ),
    clause(
        "grows",
        r"""
        Where the friction of the pair falls with speed, no damper of body 1 restores non-expansiveness: by a slope
        $f'<0$, for every $a_1\geqslant 0$, the linear equations of the difference of two slips have a solution in
        proportion to $e^{\lambda t}$, $\lambda>0$.
        """,
        kernel="falling-parts",
    ),
    assuming="Any number of masses, springs and directions, with friction as each part states; the pair only where it is named.",
)
def friction_in_any_direction() -> Case:
    """Friction is a subgradient, and what is left is monotone."""
    return because(
        "With a friction that is a subgradient the flow is non-expansive in the energy norm, in any number of directions. The power of the difference of two friction forces on the difference of two slips is never negative, as both are subgradients of one function; nor is that of dampers and springs. Where friction only brakes, the energy bounds the path of the slip. The pair is the special case of one direction.",
        filippov.never_apart,
    )
