"""Steps on the pair in the plane: friction by components, and friction in the direction of the slip. For a1 >= 0."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.engines.exhibit import exhibit
from paper_checks.evidence.evidence import Evidence, argument
from theory import plane
from theory.plane import FIRST, OTHER, SECOND, SHARE, SHARE_OTHER, SLIP
from theory.symbols import a1, b

AXIS, DIAGONAL = sp.ImmutableMatrix([1, 0]), sp.ImmutableMatrix([1, 1])
"""Slips, m/s: nearly along the first axis, where the second sign is 0, and along the diagonal."""


@cache
def depends_on_axes() -> Evidence:
    """By components the friction has another size along the diagonal than Coulomb's b, and so another law there."""
    friction = plane.by_components(DIAGONAL)
    return exhibit(
        r"a signum for each component with $b=1$ on both: for $\mathbf w=(1,1)$ friction has $|\mathbf f|^2=2$, which is more than $b^2$",
        {b: 1},
        (friction.dot(friction), "=", 2),
        (friction.dot(friction), ">", b**2),
    )


@cache
def one_size() -> Evidence:
    """In the direction of the slip it has the size b, along it, for every slip."""
    friction = plane.by_direction(SLIP)
    return identity(
        r"$b\,\mathbf w/|\mathbf w|$ has the size $b$ and takes the power $b|\mathbf w|$",
        sp.Matrix([friction.dot(friction), friction.dot(SLIP) ** 2]),
        sp.Matrix([b**2, b**2 * SLIP.dot(SLIP)]),
    )


@cache
def against_the_slip() -> Evidence:
    """By components, at an angle to the axes."""
    return identity(
        r"by components the friction against a slip at the angle $\alpha$ is $b(|\cos\alpha|+|\sin\alpha|)$",
        plane.against_slip(plane.direction),
        b * (sp.Abs(sp.cos(plane.direction)) + sp.Abs(sp.sin(plane.direction))),
    )


@cache
def energy_rate() -> Evidence:
    """The chain rule with vectors."""
    return identity(
        r"$\dot E=-b\,\mathbf p\cdot\mathbf w-a_1|\mathbf v_1|^2$ for the friction $b\mathbf p$",
        plane.energy_rate(),
        -b * SHARE.dot(FIRST - SECOND) - a1 * FIRST.dot(FIRST),
    )


@cache
def never_apart() -> Evidence:
    """Two motions in the plane, each with its own friction."""
    p_k, q_w = SHARE.dot(OTHER), SHARE_OTHER.dot(SLIP)
    turned = SHARE[0] * OTHER[1] - SHARE[1] * OTHER[0]
    return argument(
        r"Where $|\mathbf p|\leqslant 1$ and $\mathbf p\cdot\mathbf w=|\mathbf w|$, and so with tildes, $(\mathbf p-\tilde{\mathbf p})\cdot(\mathbf w-\tilde{\mathbf w})$ is "
        r"$|\mathbf w|-\tilde{\mathbf p}\cdot\mathbf w+|\tilde{\mathbf w}|-\mathbf p\cdot\tilde{\mathbf w}$, and neither product is larger than the size of its second factor. So $N$ does not grow; and motions exist, as the "
        r"set of frictions is convex and closed.",
        identity(
            r"friction adds $-b(\mathbf p-\tilde{\mathbf p})\cdot(\mathbf w-\tilde{\mathbf w})$ to $\frac12\frac{d}{dt}N^2$, in these four products",
            plane.contraction_by_friction(),
            -b * (SHARE.dot(SLIP) - q_w + SHARE_OTHER.dot(OTHER) - p_k),
        ),
        identity(
            r"$|\mathbf p|^2|\tilde{\mathbf w}|^2-(\mathbf p\cdot\tilde{\mathbf w})^2$ is a square",
            SHARE.dot(SHARE) * OTHER.dot(OTHER) - p_k**2,
            turned**2,
        ),
        one_size(),
        cites=("Filippov's theorem on existence",),
    )


@cache
def on_a_line() -> Evidence:
    """A motion along one direction has its friction in it."""
    speed = sp.Symbol("w", positive=True)
    line = plane.along(plane.direction)
    return argument(
        r"With scalar masses, spring and damper all forces on a motion along a line are in it, and friction is $b\,\mathrm{sgn}(w)$ along it: the equations are those of the pair, and there is one motion from each start.",
        identity(
            r"for $\mathbf w=\pm w\,\mathbf e$ friction is $\pm b\,\mathbf e$",
            sp.Matrix([*plane.by_direction(line * speed), *plane.by_direction(-line * speed)]),
            sp.Matrix([*(b * line), *(-b * line)]),
        ),
        never_apart(),
    )
