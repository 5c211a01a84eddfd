"""Motions on a surface: friction in a plane."""

from paper_checks.claims.words import *
from theory import plane
from theory.plane import FIRST, OTHER, SECOND, SHARE, SHARE_OTHER, SLIP

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
        r"$b\,\mathbf w/|\mathbf w|$ has the magnitude $b$ and dissipates the power $b|\mathbf w|$",
        [friction.dot(friction), friction.dot(SLIP) ** 2],
        [b**2, b**2 * SLIP.dot(SLIP)],
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
        r"""
        Where $|\mathbf p|\leqslant 1$ and $\mathbf p\cdot\mathbf w=|\mathbf w|$, and so with tildes, $(\mathbf
        p-\tilde{\mathbf p})\cdot(\mathbf w-\tilde{\mathbf w})$ is $|\mathbf w|-\tilde{\mathbf p}\cdot\mathbf
        w+|\tilde{\mathbf w}|-\mathbf p\cdot\tilde{\mathbf w}$, and neither product is larger than the magnitude of its
        second factor. So $N$ does not grow; and motions exist, as the set of friction forces is convex and closed.
        """,
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
        one_size,
        cites=("Filippov's theorem on existence",),
    )


@cache
def on_a_line() -> Evidence:
    """A motion along one direction has its friction in it."""
    speed = Symbol("w", positive=True)
    line = plane.along(plane.direction)
    return argument(
        r"With scalar masses, spring and damper all forces on a motion along a line act along it, and friction is $b\,\mathrm{sgn}(w)$: the equations are those of the pair, and there is one motion from each initial state.",
        identity(
            r"for $\mathbf w=\pm w\,\mathbf e$ friction is $\pm b\,\mathbf e$",
            [*plane.by_direction(line * speed), *plane.by_direction(-line * speed)],
            [*(b * line), *(-b * line)],
        ),
        never_apart,
    )


@claim(
    "motions-on-a-surface",
    "V",
    "V, fifth bullet; II, after Fig. 2",
    CORRECTED,
    r"""
    The framework can be further extended to motions on a surface, that is with two translational and one rotational
    degrees of freedom, $(x,y)$ and $\varphi$: the multidimensional case can be equally elaborated, with an
    appropriate vector of Coulomb friction coefficients, $\mathbf b_{x,y,\varphi}$.
    """,
    correction=(
        clause(
            "components",
            r"""
            With a signum for each component, as (2)–(4) and a vector of coefficients suggest, friction depends on the
            choice of the axes: for equal coefficients, at an angle $\alpha$ to them, the friction against a slip is
            «size», so along the diagonal it is «diagonal» of that along an axis.
            """,
            size=equal(
                "f",
                b * (Abs(cos(plane.direction)) + Abs(sin(plane.direction))),
                lambda: plane.against_slip(plane.direction),
            ),
            diagonal=equal(
                r"f(\pi/4)/f(0)",
                sqrt(2),
                lambda: plane.against_slip(pi / 4) / b,
            ),
        ),
        clause(
            "direction",
            r"""
            What carries over is the friction in the direction of the slip, $\mathbf f=b\,\mathbf w/|\mathbf w|$,
            $\mathbf w=\mathbf v_1-\mathbf v_2$, and any $|\mathbf f|\leqslant b$ in stick, which is not (4) by
            components: with scalar masses, spring and damper $\dot E=-b|\mathbf w|-a_1|\mathbf v_1|^2$ for $u=0$,
            """,
        ),
        clause("apart", r"the flow is non-expansive,", kernel="system-contraction"),
        clause("one", r"and there is one motion from every initial state."),
        clause("line", r"Along a line it is exactly the pair with Coulomb's law, and so for $u=0$ that of (2)–(4)."),
    ),
    open=(
        "Which forces and moments a rotating contact patch can transmit, and so which vector of coefficients is appropriate for a rotation, is not derived here.",
        "Which slipping motions in the plane merge, and how fast the others converge, is not decided here; which stuck motions remain stuck is (stuck-ellipses).",
    ),
)
def motions_on_a_surface() -> Case:
    """What of (2)-(4) carries over to two translations, and in which form."""
    return because(
        r"""
        Defined by components, friction would depend on the axes. Defined by the direction of slip it does not: then
        energy falls, each initial state has one motion, and the flow is non-expansive, as on a line. A signum for each
        component gives friction that is $\sqrt2$ times as strong along the diagonal as along an axis. The paper itself
        asks for care with the coupling terms.
        """,
        counterexample(
            r"""
            $b=1$ N for $x$ and for $y$, a slip with $\mathbf w=(1,1)$ m/s: by components $\mathbf f=(1,1)$ N, of
            magnitude $\sqrt2>b$. Rotated by 45° the same contact has $\mathbf w=(\sqrt2,0)$ and $|\mathbf f|=b$: the
            law depends on how the axes are drawn.
            """,
            depends_on_axes,
        ),
        carried("components"),
        carried("direction", one_size, energy_rate),
        carried("one", never_apart),
        carried("line", on_a_line),
    )
