"""Section V: the two descriptions of the system, and the bound of what friction hands on."""

from paper_checks.claims.beyond import transfers
from paper_checks.claims.section_2.signum import under_a_force
from paper_checks.claims.section_3 import filippov as solutions
from paper_checks.claims.words import *

DRIVEN, DRIVING = symbols(r"\ddot{x}_2 \ddot{x}_1", real=True)


def _share(name: str) -> Expr:
    """Return x2'' by x1'' in a branch of (4)."""
    found = branch_named(name)
    return sp.cancel(found.acceleration2 / found.acceleration1) * DRIVING


LOAD = Symbol("p", nonnegative=True)
"""|a2 x1 + a1 v1|."""


def _by_load() -> dict[Basic, Expr]:
    """Return |x2''| in stick by the load, for a1 >= 0."""
    return {Abs(DRIVEN): -LOAD * sp.cancel(sliding_field(damped=True)[2] / load(damped=True))}


@claim(
    "two-descriptions",
    "V",
    "V, fourth bullet",
    CORRECTED,
    r"""
    The switched system (2)–(4) with the signum (1) allows for zero velocity solutions in $\dot{z}$, i.e. adhesion;
    the global asymptotic convergence was shown for the switched system in Filippov's sense. Both interpretations of
    the system switching are possible for the Coulomb friction with a discontinuity; in particular (1) interprets the
    adhesion in a proper physical sense of zero relative velocity.
    """,
    correction=(
        clause(
            "same",
            r"(2)–(4) with $a_1=u=0$ have the same solutions as (5)–(7) in Filippov's sense, one from each initial state.",
            kernel="switching-iff filippov-well-posed",
        ),
        clause(
            "example",
            r"""
            In the case study these solutions also satisfy (11)–(12) at almost every time, which have others besides, as
            with $b=0.5$ from 6 mm. One that keeps its
            stick wherever $\dot z=0$ agrees with the Filippov law as long as it is not stuck outside $S_0$, that is up
            to the first contact with $S$ outside $S_0$ or the first exit from $S_0$, and not beyond.
            """,
            kernel="law-satisfies-case-study two-solutions-from-6-mm case-study-agrees-until",
        ),
        *under_a_force(),
    ),
)
def two_descriptions() -> Case:
    """Compare the solutions of (3)-(4), of (11)-(12) and of (5)-(7)."""
    literal, filippov = (
        solved(load_scene(name)).sol(Fraction(1, 5))[2] for name in ("start-at-6mm-literal", "start-at-6mm")
    )
    return because(
        """
        The two readings describe the same motion for (2)–(4) with $u=0$, where the stiction bracket makes them agree,
        and not beyond. Under a force that holds the load of a stuck pair at the limit $b$, (3)–(4) have no solution;
        and for (11)–(12), where the bracket is dropped, the readings differ. There the three-valued signum (1) lets the
        bodies stick beyond $S_0$, where friction cannot hold them: that is a different law, and the convergence shown
        for the Filippov system says nothing about such solutions. Both agree until the pair first meets $S$ outside
        $S_0$, or leaves $S_0$ by a ray.
        """,
        counterexample(
            (
                "Fig. 4 (a), $x_1(0)=0.006$, $b=0.5$, at rest: read literally, (11)–(12) stick permanently and give "
                f"$x_2(0.2)=$ {text(literal)} m; the Filippov law, and (3)–(4), slip at once and give {text(filippov)} m."
            ),
            compare(
                "at $t=0.2$ s the values of $x_2$ are more than 0.4 mm apart",
                abs(literal - filippov),
                ">",
                arb("0.0004"),
            ),
        ),
        carried("same", solutions.one_solution),
        figure="start-at-6mm",
    )


@claim(
    "acceleration-bound",
    "V",
    "V, sixth bullet",
    CORRECTED,
    r"""
    The switched motion system (2)–(4) is underactuated as well as upper-bounded by $\ddot{x}_1=\ddot{x}_2$, as for
    the control efforts, cf. (13).
    """,
    correction=(
        clause(
            "bound",
            r"Under Coulomb's law body 2 changes its velocity by at most $b/m_2$ times the time, whatever the driving body does:",
            kernel="driven-acceleration",
        ),
        clause(
            "modes",
            r"in slip «slip», and in stick, on $S_0$, $\ddot x_2=\ddot x_1$ with «stick».",
            slip=equal(Abs(DRIVEN), b / m2, lambda: Abs(free(slip(1).acceleration2))),
            stick=Formula(
                Abs(DRIVEN), "<=", b / m2, implied(lambda: [signed(LOAD - load_threshold(), "<=")], _by_load)
            ),
        ),
        clause(
            "literal",
            r"Under an integrable force (3)–(4) have no other motions.",
            kernel="forced-switching-iff filippov-forced",
        ),
        clause(
            "equality",
            r"At an instant with $\dot z=0$ (4) itself gives «half» where $|\ddot x_1|=b/m_2$, and «none» beyond.",
            half=equal(DRIVEN, DRIVING / 2, lambda: _share("half adhesion")),
            none=equal(DRIVEN, 0, lambda: _share("broken adhesion")),
        ),
    ),
)
def acceleration_bound() -> Case:
    """Bound x2'' in every mode, and read the sentence literally."""
    slipping, literal = case_study_mode(1), case_study_mode(0)
    unloaded = {**EXAMPLE_PAIR, x1: root(slipping[0], x1).subs(EXAMPLE_PAIR)}
    return because(
        r"""
        What a control can achieve on body 2 is bounded by friction: $|\ddot x_2|\leqslant b/m_2$ in every mode under
        the Filippov law and (3)–(4), attained throughout slip. The equation $\ddot x_1=\ddot x_2$ of (13) is not that
        bound: in slip $|\ddot x_2|$ exceeds $|\ddot x_1|$ when the driving body passes its rest position. Under
        (11)–(12) read literally nothing bounds $|\ddot x_2|=100\,|x_1|$ in stick.
        """,
        counterexample(
            (
                "$m_1=m_2=1$, $a_1=0$, $a_2=200$, $b=0.5$. In slip with $\\dot z>0$ at "
                f"$x_1={value_at(x1, unloaded)}$: $\\ddot x_1={value_at(slipping[0], unloaded)}$, "
                f"$\\ddot x_2={value_at(slipping[1], unloaded)}$. Under (11)–(12) at $x_1=0.006$, $\\dot z=0$: "
                f"$|\\ddot x_2|={value_at(Abs(literal[1]), START_AT_6MM)}>{value_at(b / m2, START_AT_6MM)}=b/m_2$."
            ),
            exhibit(
                "in slip with $\\dot z>0$ at $x_1=-b/200$, $\\ddot x_1=0$ and $|\\ddot x_2|>|\\ddot x_1|$",
                unloaded,
                (slipping[0], "=", 0),
                (Abs(slipping[1]), ">", Abs(slipping[0])),
            ),
            exhibit(
                "under (11)–(12) the start of Fig. 4 (a) has $|\\ddot x_2|>b/m_2$",
                START_AT_6MM,
                (Abs(literal[1]), ">", b / m2),
            ),
        ),
        carried("bound", transfers.gentle),
        carried("modes"),
        carried("equality"),
    )
