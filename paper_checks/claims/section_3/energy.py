"""The energy: its rate, where it is dissipated, and what sliding costs."""

from paper_checks.claims.words import *

SYNCHRONISATION = (
    r"""
    In every mode $\dot E=-b|\dot z|-a_1v_1^2\leqslant 0$, so $E$ has a limit $E_\infty\geqslant 0$, and
    $b\int_t^\infty|\dot z|\,ds\leqslant E(t)-E_\infty$. In particular $x_1-x_2$ has a limit.
    """,
    r"""
    On $\{E\leqslant E(0)\}$ the state is bounded, hence $|\ddot z|\leqslant K$ in every mode: $\dot z$ is Lipschitz
    continuous with the constant $K$.
    """,
    r"""
    If $|\dot z(t)|=\eta$, then $|\dot z|\geqslant\eta-Ks$ at the time $t+s$: the triangle below has the area
    $\eta^2/(2K)$. Hence $$|\dot z(t)|^2\leqslant\frac{2K}{b}\,\bigl(E(t)-E_\infty\bigr)\to 0.$$
    """,
)


@cache
def energy_rate() -> Evidence:
    """dE/dt for every value of set-valued friction, stick among them."""
    return identity(
        r"""
        $\dot E=-b\,\sigma\,(v_1-v_2)-a_1v_1^2$ for every $\sigma$ that set-valued friction may take, and
        $\sigma(v_1-v_2)=|v_1-v_2|$
        """,
        derivative_along(free_system(sigma), energy()),
        -b * sigma * (v1 - v2) - a1 * v1**2,
    )


@cache
def energy_never_grows() -> Evidence:
    """The right side is never positive; negative wherever z' != 0."""
    velocity, damper = Symbol("w", positive=True), Symbol("a1", nonnegative=True)
    rate = slip_rate(1).subs({a1: damper, v2: v1 - velocity})
    return prove("that rate is negative for $\\dot z=w>0$", [], signed(rate, "<"))


REST = (
    r"""
    With $a_1>0$ also $\int v_1^2\,dt<\infty$, and $v_1$ is Lipschitz continuous, so $v_1\to 0$; with $\dot z\to 0$
    also $v_2\to 0$. As $E$ converges, $|x_1|$ does, and so $x_1$ (it is continuous).
    """,
    r"""
    In every mode the total momentum obeys $\frac{d}{dt}(m_1v_1+m_2v_2)=-a_2x_1-a_1v_1$. It tends to 0, so the limit
    of $x_1$ can only be 0: $E\to 0$ along every trajectory.
    """,
    r"""
    From some time on $E$ is below the captive level. A slip ends in finite time on $S$, where the level lies in the
    strip $|a_2x_1+a_1v_1|\leqslant b(m_1+m_2)/m_2$; the pair sticks there and, as $E$ does not grow, permanently.
    """,
)


@cache
def captive_margin() -> Evidence:
    """On S, 2 E (a2 + a1^2/M) exceeds the squared load by a square; at the captive level it is the threshold's."""
    steepness = a2 + a1**2 / total_mass()
    return identity(
        "on $S$, $2E\\,(a_2+a_1^2/M)-(a_2x_1+a_1v_1)^2=\\frac{a_2}{M}(Mv_1-a_1x_1)^2$ with $M=m_1+m_2$",
        2 * steepness * on_surface() - load(damped=True) ** 2,
        a2 / total_mass() * (total_mass() * v1 - a1 * x1) ** 2,
    )


@cache
def synchronises() -> Evidence:
    """z' tends to 0 along every trajectory."""
    return argument(" ".join(SYNCHRONISATION), energy_rate)


@cache
def comes_to_rest() -> Evidence:
    """With a1 > 0 the origin attracts every trajectory, and is stable."""
    return argument(f"{REST[0]} {REST[1]} As $E$ never grows, the origin is stable.", synchronises)


@cache
def captured() -> Evidence:
    """With a1 > 0 every trajectory sticks for ever from a finite time on."""
    return argument(REST[2], comes_to_rest, captive_margin)


@claim(
    "energy-rate",
    "III",
    "(8)",
    HOLDS,
    clause(
        "rate",
        r"With «energy», «rate» along every trajectory of (5)–(7),",
        energy=equal("E", a2 * x1**2 / 2 + m1 * v1**2 / 2 + m2 * v2**2 / 2, energy),
        rate=equal(
            r"\dot E",
            -b * Abs(v1 - v2),
            lambda: derivative_along(undamped(free_system(Abs(v1 - v2) / (v1 - v2))), energy()),
        ),
        kernel="energy-rate",
    ),
    clause(
        "sign",
        r"and «sign».",
        sign=Formula(-b * Abs(v1 - v2), "<=", 0, implied()),
        kernel="energy-decreases",
    ),
)
def rate_of_energy() -> Case:
    """Derive dE/dt along the fields of both half-spaces and of the sliding region."""
    return because(
        r"""
        Along every value that set-valued friction can take, the chain rule gives $-b\sigma(v_1-v_2)$, and
        $\sigma(v_1-v_2)=|v_1-v_2|$. As the right side is continuous, $E$ is continuously differentiable along every
        trajectory, events included.
        """,
        energy_rate,
        carried("sign"),
    )


@claim(
    "energy-dissipation-places",
    "III",
    "after (8)",
    HOLDS,
    clause(
        "dissipated",
        r"""
        The energy is dissipated on those parts of a trajectory which belong to $\Omega_-\cup\Omega_+$: «above» in
        $\Omega_+$, «below» in $\Omega_-$;
        """,
        above=Formula(
            -b * (v1 - v2),
            "<",
            0,
            implied(lambda: [v1 > v2]),
        ),
        below=Formula(b * (v1 - v2), "<", 0, implied(lambda: [v1 < v2])),
        kernel="energy-rate",
    ),
    clause(
        "conserved",
        r"it is conserved on the parts which belong to $S$: «conserved».",
        conserved=equal(r"\dot E", 0, lambda: undamped(slip_rate(1)).subs(v2, v1)),
        kernel="energy-rate",
    ),
)
def energy_dissipation_places() -> Case:
    """Strict decrease off S, conservation on S."""
    return because(
        "The rate $-b|v_1-v_2|$ is negative exactly where the velocities differ.",
        carried("dissipated", energy_rate),
        carried("conserved"),
    )
