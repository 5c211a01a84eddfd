"""Section IV: when the example sticks, when it slips, and how its oscillation decays."""

from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.section_3.filippov import (
    bracket_is_off_in_slip,
    spurious_branches_leave,
)
from paper_checks.claims.words import *
from theory.closed_forms import rate, rates


def _level() -> tuple[Expr, str, Expr]:
    """Return the condition E <= E_cr on S for the example, in x1 and the common velocity, with v^2 by itself."""
    speed = Symbol("v_1", real=True)
    return expand(on_surface().subs(CASE_STUDY).subs(v1, speed)), "<=", critical_energy().subs(CASE_STUDY)


def subcritical_level() -> Basic:
    """Return E <= E_cr on S (a1 = 0), cleared of its denominator."""
    return signed(on_surface() - critical_energy(), "<=")


HALF_WIDTH = Symbol("L", positive=True)


def _pull_ratio() -> Expr:
    """Return x1'' over b/m2 in the stick of the example."""
    return case_study_mode(0)[0] / b


@claim(
    "example-stiction-never-violated",
    "IV",
    "after eq. (12)",
    REFUTED,
    clause(
        "bound",
        r"Equation (12) does not include the acceleration-dependent switching since the system ensures that «bound».",
        bound=Formula(
            Abs(PULL),
            "<",
            b / m2,
            fails_at(START_AT_6MM, lambda: {PULL: case_study_mode(0)[0]}),
            false=True,
        ),
    ),
    correction=(
        clause("slip", r"Where $\dot z\neq 0$ the acceleration-dependent switching of (4) has no effect."),
        clause(
            "stick",
            r"Where $\dot z=0$ it acts exactly if $|x_1|\geqslant L$, «width», as there «ratio»;",
            width=equal("L", b / 100, lambda: half_width().subs(CASE_STUDY)),
            ratio=equal(PULL / b, -x1 / HALF_WIDTH, _pull_ratio, lambda: {HALF_WIDTH: half_width().subs(CASE_STUDY)}),
        ),
        clause(
            "below",
            r"""
            but for isolated instants with $|\ddot x_1|=b/m_2$, at which $v_1=0\neq\dot v_1$, it does not act if
            $E\leqslant E_{cr}$, «level»,
            """,
            level=equal("E_{cr}", b**2 / 100, lambda: critical_energy().subs(CASE_STUDY)),
        ),
        clause(
            "lasting",
            r"nor in a stick phase of (3)–(4), $\dot z=0$ on an interval of time, but at isolated instants.",
            kernel="edges-isolated switching-iff filippov-iff",
        ),
    ),
)
def example_stiction_never_violated() -> Case:
    """Evaluate |x1''| against b/m2 in both modes of the example."""
    literal = case_study_mode(0)[0]
    pull = undamped(free(stick().acceleration1))
    return because(
        (
            "The paper's own start of Fig. 4 (a) violates the inequality: $\\dot z=0$ and "
            f"$|\\ddot x_1|={value_at(abs(literal), START_AT_6MM)}$ m/s², more than $b/m_2={value_at(b / m2, START_AT_6MM)}$ m/s². Nothing in (11), (12) bounds "
            "$|\\ddot x_1|$, so the dropped switching would act there; (12) makes the pair stick all the same. In slip the bound "
            "fails as well, already at the start of Fig. 4 (b), but there the first bracket of (4) is 0 and nothing follows. What "
            "is true: up to the critical energy $|\\ddot x_1|\\leqslant b/m_2$ whenever $\\dot z=0$."
        ),
        counterexample(
            (
                "$b=0.5$, $x_1=0.006$, both bodies at rest, the start of Fig. 4 (a): $|\\ddot x_1|="
                f"{value_at(abs(literal), START_AT_6MM)}>{value_at(b / m2, START_AT_6MM)}=b/m_2$."
            ),
            exhibit(
                "at the start of Fig. 4 (a), $\\dot z=0$ and $|\\ddot x_1|>b/m_2$ by (11)",
                START_AT_6MM,
                (Abs(literal), ">", b / m2),
            ),
            compare(
                "in Fig. 5 (a), at the first contact, $100\\,|x_1|>b/m_2=0.05$",
                100 * abs(solved(load_scene("velocities")).events[0].y[0]),
                ">",
                arb("0.05"),
            ),
        ),
        carried("slip", bracket_is_off_in_slip),
        carried("stick"),
        carried(
            "below",
            prove(
                "with $a_1=u=0$ and $\\dot z=0$, $E\\leqslant E_{cr}$ implies $|\\ddot x_1|\\leqslant b/m_2$",
                [subcritical_level()],
                signed(pull**2 - (b / m2) ** 2, "<="),
            ),
            prove(
                r"and with $|\ddot x_1|\geqslant b/m_2$ it implies $v_1=0$ and $\ddot x_1\neq 0$",
                [subcritical_level(), signed(pull**2 - (b / m2) ** 2, ">=")],
                And(signed(v1, "="), signed(pull, "!=")),
            ),
        ),
        correction(
            reading("it acts", r"$|\ddot x_1|\geqslant b/m_2$ at $\dot z=0$, where the factor of (4) is not $1$"),
        ),
        carried("lasting", argument("Where $\\dot z=0$ lasts, $\\ddot z=0$.", spurious_branches_leave)),
    )


def stays_together() -> Evidence:
    """With v1 = v2 and E <= E_cr the pair sticks for ever (a1 = 0)."""
    inside = signed(x1**2 - half_width() ** 2, "<=")
    return prove("with $\\dot z=0$, $E\\leqslant E_{cr}$ implies $|x_1|\\leqslant L$", [subcritical_level()], inside)


@claim(
    "example-onset",
    "IV",
    "after eq. (12)",
    REFUTED,
    r"""
    An initial condition $x_1\vee\dot{x}_1\neq 0$ ensures a finite energy storage at $t=t_0=0$ and, therefore, the
    onset of the relative motion of the free oscillator.
    """,
    correction=(
        clause(
            "ever",
            r"""
            Under (3)–(4) the bodies move relative to each other at some time exactly if $\dot x_1(0)\neq\dot x_2(0)$ or
            $E(0)>E_{cr}$; in the example a pair with $\dot x_1(0)=\dot x_2(0)$ stays together permanently exactly
            if «together» at the start.
            """,
            together=sharp(100 * x1**2 + Symbol("v_1", real=True) ** 2, "<=", b**2 / 100, _level),
            kernel="sticks-iff switching-iff filippov-iff",
        ),
        clause(
            "at-once",
            r"""
            They do so at once exactly if $\dot x_1(0)\neq\dot x_2(0)$, or $|x_1(0)|>L$, or the start is on an exit
            ray, $x_1(0)=\pm L$ with $\pm v>0$.
            """,
            kernel="slips-beyond slips-on-ray sticks-inside switching-iff filippov-iff",
        ),
    ),
)
def example_onset() -> Case:
    """Exhibit starts with energy that stick for ever, and say which starts come apart."""
    resting = solved(scene_at(AT_4MM, "1000"))
    return because(
        r"""
        Stored energy does not ensure relative motion: from rest inside $S_0$ the pair oscillates as one body
        permanently, under the Filippov law, under (3)–(4) and under (11)–(12). Adhesion breaks only if the spring can
        pull with more than friction holds. Read literally, (11)–(12) with $\dot x_1=\dot x_2$ never need to leave $\dot
        z=0$.
        """,
        counterexample(
            (
                "$b=0.5$, $x_1=0.004$, both bodies at rest: $E=$ "
                f"${value_at(energy(), AT_4MM)}<{value_at(critical_energy(), AT_4MM)}=E_{{cr}}$. The motion is "
                "$x_1=0.004\\cos 10t$, $x_1-x_2$ constant, at all times; friction has to give at most "
                f"${value_at(abs(case_study_mode(0)[1]), AT_4MM)}<0.5$ N."
            ),
            exhibit(
                "at $x_1=0.004$, at rest, $b=0.5$: energy is stored, but less than $E_{cr}$",
                AT_4MM,
                (energy(), ">", 0),
                (energy(), "<", critical_energy()),
            ),
            stuck_for_ever("from there the pair sticks permanently", resting),
        ),
        correction(stays_together),
    )


# A slip of the example that lasts for more than a period of body 1.
LONG_SLIP = {**EXAMPLE_PAIR, x1: 0, v1: Rational("0.1"), v2: -1}


def amplitude_squared(sign: int) -> Expr:
    """Return the squared amplitude of body 1 about its rest position in slip, m^2."""
    rest = root(case_study_mode(sign)[0], x1)
    stiffness = -diff(case_study_mode(sign)[0], x1)
    return (x1 - rest) ** 2 + v1**2 / stiffness


def amplitude_is_constant() -> Evidence:
    """In (14) with one sign body 1 is an undamped oscillator."""
    rates = [derivative_along(slip(sign).field.subs(CASE_STUDY), amplitude_squared(sign)) for sign in (1, -1)]
    return identity("in (14) with either sign the amplitude of $x_1$ about its rest position is constant", rates)


@claim(
    "example-damped-oscillations",
    "IV",
    "after eq. (14)",
    CORRECTED,
    r"""
    The piecewise linear dynamics (14) leads to the damped oscillations of $(x_1,\dot{x}_1)$ and, thus, to a
    synchronization of the orbits of both inertial bodies, $x_1(t)-x_2(t)\to\mathrm{const}$ and $\dot{z}\to 0$.
    """,
    correction=(
        clause(
            "undamped",
            r"With a constant sign (14) is an undamped oscillation of $(x_1,\dot x_1)$ about $x_1=\mp b/200$; it is the total energy that falls, at the rate $b|\dot z|$.",
        ),
        clause(
            "synchronises",
            r"For every initial state $\dot z\to 0$ and $x_1-x_2\to\mathrm{const}$.",
            kernel="synchronisation displacement-limit",
        ),
    ),
)
def example_damped_oscillations() -> Case:
    """Show which part of (14) damps what, and prove that z' -> 0."""
    trajectory = solved(scene_at(LONG_SLIP, "10"))
    with trajectory.arithmetic.context():
        period = ball(2 * pi / rates("slip+", DampingRegime.UNDAMPED)[rate].subs(CASE_STUDY))
    return because(
        r"""
        As long as $\dot z$ keeps its sign, (14) is an undamped oscillation of body 1 about $\mp b/200$ and a steady
        acceleration of body 2: no oscillation of $(x_1,\dot x_1)$ is damped, and while body 1 moves the way in which
        friction pushes it, it gains energy. It is the total energy that falls, by $b|\dot z|$, and this synchronises
        the bodies: $\dot z\to 0$ and $x_1-x_2\to\mathrm{const}$ hold for every initial state (Filippov law; see
        synchronisation-all-parameters and relative-displacement-limit).
        """,
        counterexample(
            (
                "$b=0.5$, $x_1=0$, $\\dot x_1=0.1$, $\\dot x_2=-1$: body 1 oscillates for "
                f"{text(trajectory.events[0].t)} s, more than its period {text(period)} s, with an unchanged amplitude."
            ),
            amplitude_is_constant,
            compare(
                "the pair slips for longer than the period $2\\pi/\\sqrt{200}$ s of body 1, which so returns to its start undamped",
                trajectory.events[0].t,
                ">",
                period,
            ),
        ),
        carried("undamped", amplitude_is_constant, dissipation.energy_rate),
        carried("synchronises", dissipation.synchronises),
    )
