"""The switching surface: where it is crossed, and where it is slid on."""

from paper_checks.claims.letters import guard_rate, in_strip, past_edge
from paper_checks.claims.words import *
from theory.filippov import edge_contact, normal, sliding_weight

WIDTH = b * (m1 + m2) / (a2 * m2)


def width() -> Formula:
    """Return the half width of S0 as printed."""
    return equal("L", WIDTH, half_width)


def _at_guard(sign: int, relation: str, side: int) -> Formula:
    """Return what is printed of a field's product with n_S on S_+ (side 1), S_- (side -1) or S_0 (side 0)."""
    product = guard_rate(sign)
    given = implied(lambda: [past_edge(side)] if side else in_strip(), lambda: {product: transversality(sign)})
    return Formula(product, relation, 0, given)


@claim(
    "transversality-outside",
    "III",
    "(9)",
    HOLDS,
    clause(
        "signs",
        r"""
        With the normal «normal», which points from $\Omega_-$ to $\Omega_+$, «plus_above», «minus_above» on $S_+$ and
        «plus_below», «minus_below» on $S_-$, where $S_\pm$ are the parts of $S$ with $\pm x_1>L$, «width».
        """,
        plus_above=_at_guard(1, "<", 1),
        minus_above=_at_guard(-1, "<", 1),
        plus_below=_at_guard(1, ">", -1),
        minus_below=_at_guard(-1, ">", -1),
        width=width(),
        normal=equal("n_S", Matrix([0, 1, -1]), lambda: Matrix(normal())),
        kernel="rate-above rate-below transversal-beyond",
    ),
)
def transversality_outside() -> Case:
    """Prove (9) for all parameters."""
    return because(
        "Both products are $-(a_2m_2x_1\\pm b(m_1+m_2))/(m_1m_2)$: beyond either edge the spring term outweighs friction.",
        carried("signs"),
    )


@claim(
    "transversality-strip",
    "III",
    "(10)",
    HOLDS,
    clause(
        "signs",
        r"«minus» and «plus» on $S_0$, the part of $S$ with $|x_1|\leqslant L$, «width».",
        minus=_at_guard(-1, ">=", 0),
        plus=_at_guard(1, "<=", 0),
        width=width(),
        kernel="rate-above rate-below transversal-inside",
    ),
)
def transversality_strip() -> Case:
    """Prove (10) for all parameters."""
    return because(
        "The two products differ by $2b(m_1+m_2)/(m_1m_2)>0$; each vanishes at one edge of the strip only.",
        carried("signs"),
    )


@claim(
    "sliding-region",
    "III",
    "after (10)",
    HOLDS,
    clause("region", r"$S_0$ is the sliding region;", kernel="transversal-inside sticks-inside slips-beyond"),
    clause(
        "modes",
        """
        it consists of trajectories and parts thereof known as sliding modes, each in the intersection of $S_0$ with
        an ellipsoid $E=E_0$ of constant energy.
        """,
        kernel="sticks-inside energy-rate",
    ),
)
def sliding_region() -> Case:
    """Filippov's weight lies in [0, 1] exactly on S0, and the sliding field conserves energy."""
    weight = sliding_weight()
    inside = signed(weight * (1 - weight), ">=")
    return because(
        """
        A convex combination of both fields is tangent to $S$ exactly on $S_0$. It is unique, as the two products
        always differ; its motion is that of one mass $m_1+m_2$ on the spring and keeps $E$, a positive definite
        quadratic form.
        """,
        prove("on $S_0$ the weight lies in $[0,1]$", in_strip(), inside),
    )


@claim(
    "return-alternatives",
    "III",
    "after Fig. 3",
    CORRECTED,
    r"""
    Any trajectory from $\Omega_-$ either enters the sliding region $S_0$ or intersects $S$ at a point $p\in S_-$
    transversally and proceeds to $\Omega_+$; any trajectory from $\Omega_+$ either enters $S_0$ or proceeds to
    $\Omega_-$ transversally through $S_+$.
    """,
    correction=(
        clause(
            "alternatives",
            r"""
            Any trajectory from $\Omega_-$ that meets $S$ enters $S_0$ and stays in it for some time, or crosses $S$ at
            an isolated instant into $\Omega_+$, at a point of $S_-$ or of $\ell_-$, or touches $S$ at a point of
            $\ell_+$ and continues in $\Omega_-$; the same holds from $\Omega_+$ with all signs exchanged.
            """,
            kernel="return-alternatives return-alternatives-mirror sticks-inside slips-on-ray",
        ),
        clause(
            "transversal",
            r"On $S_-$ the crossing is transversal: both fields have the sign of $-x_1$ across $S$.",
            kernel="transversal-beyond",
        ),
        clause(
            "tangent",
            r"On $\ell_-$ it is not, in Filippov's sense: «tangent» there, and the slip begins with $\ddot w>0$, $w=v_1-v_2$.",
            tangent=equal(guard_rate(1), 0, lambda: transversality(1).subs(x1, -half_width())),
        ),
    ),
)
def return_alternatives() -> Case:
    """From Omega_- a trajectory can only arrive where Phi_-.n >= 0; at the ends of that strip it need not enter S0."""
    return because(
        r"""
        The sentence misses two cases, both at the edges of $S_0$: a trajectory may touch $S$ and continue as before, or
        cross $S$ at a point that is not in $S_\pm$. In $\Omega_-$ the guard $v_1-v_2$ is negative, so where it reaches
        0 its rate $\Phi_-\cdot n_S$ is not negative: the point has $x_1\leqslant L$. On $S_-$ both products are
        positive and the crossing is transversal; the rest is $S_0$. At a point of $\ell_+$ the trajectory touches $S$
        and continues in $\Omega_-$, and through $\ell_-$ it crosses into $\Omega_+$, at a point that is not in $S_-$.
        Only starts on surfaces lead there; for all others the sentence holds as it stands.
        """,
        counterexample(
            r"""
            For every pair and every $v>0$ the slip with $\dot z<0$ through $x_1=L$, $v_1=v_2=v$ comes from $\Omega_-$,
            touches $S$ there and continues in $\Omega_-$: it neither enters $S_0$ nor crosses $S_-$.
            """,
            identity(
                "there the guard $v_1-v_2$ has the rate 0, and a negative second derivative along $\\Phi_-$",
                [edge_contact(1).first, edge_contact(1).second],
                [0, -a2 * v1 / m1],
            ),
        ),
        carried(
            "alternatives",
            argument(
                r"""
                A guard that is negative arrives at 0 with a rate that is not negative, so at $x_1\leqslant L$. With
                $x_1<-L$ both rates are positive: it crosses. With $|x_1|<L$ both fields push to $S$: it stays. At
                $x_1=L$ the rate is 0 and the guard has a maximum if $v_1>0$, where it touches; with $v_1\leqslant 0$
                the stick continues inside. At $x_1=-L$ with $v_1<0$ the pair leaves by $\ell_-$ at once, and with
                $v_1\geqslant 0$ it sticks.
                """,
                prove(
                    "arrival from $\\Omega_-$, $\\Phi_-\\cdot n_S\\geqslant 0$, implies $x_1\\leqslant L$: $p\\in S_-\\cup S_0$",
                    [signed(transversality(-1), ">=")],
                    in_strip()[0],
                ),
            ),
        ),
        carried(
            "transversal",
            prove(
                r"$\Phi_\pm\cdot n_S>0$ on $S_-$",
                [past_edge(-1)],
                And(*(signed(transversality(sign), ">") for sign in (1, -1))),
            ),
        ),
        carried(
            "tangent",
            prove(
                "on $\\ell_-$ the second derivative of $v_1-v_2$ along $\\Phi_+$ is positive",
                [v1 < 0],
                signed(edge_contact(-1).second, ">"),
            ),
        ),
    )
