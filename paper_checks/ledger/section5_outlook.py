"""Section V, the outlook: motions on a surface, what the interface can pass on, and an interface that varies."""

from functools import partial

import sympy as sp

from paper_checks.engines.deciders import Decide, equals, implied
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.evidence import Evidence
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from paper_checks.ledger.letters import S, either_sign
from theory import forced, plane
from theory.energy import sigma, sigma_other
from theory.filippov import load, load_threshold, sliding_field
from theory.model import branch_named, slip
from theory.symbols import a1, a2, b, free, m1, m2, v1, v1_other, v2, v2_other, x1

SECTION = "V"
LIPSCHITZ = sp.Symbol("ell", positive=True)

DRIVEN, DRIVING = sp.symbols(r"\ddot{x}_2 \ddot{x}_1", real=True)


def _half() -> sp.Expr:
    """Return x2'' where (4) is at its equality, by x1''."""
    found = branch_named("half adhesion")
    return sp.cancel(found.acceleration2 / found.acceleration1) * DRIVING


def _stick_bound() -> Decide:
    """Return how the bound of x2'' in stick is decided, for a1 >= 0 and the load p = a2 x1 + a1 v1 on S0."""
    force = sp.Symbol("p", real=True)
    pull = sp.solve(load(damped=True) - force, x1)[0]

    def loaded() -> list[sp.Basic]:
        threshold, width = sp.fraction(load_threshold())
        return [sp.Le(sp.Abs(force) * width, threshold, evaluate=False)]

    def decide(formula: Formula) -> Evidence:
        acceleration = sp.simplify(sliding_field(damped=True)[2].subs(x1, pull))
        places = [{sp.Abs(DRIVEN): side * acceleration} for side in (1, -1)]
        sides = [implied(loaded, partial(dict, place))(formula) for place in places]
        return min(sides, key=lambda item: (item.passed is True, item.passed is None))

    return decide


OUTLOOK = (
    Claim(
        "motions-on-a-surface",
        SECTION,
        "fifth bullet, and Section II after Fig. 2",
        r"The framework can be further extended to motions on a surface, that is with two translational and one rotational degrees of freedom, $(x,y)$ and $\varphi$: "
        r"the multidimensional case can be equally elaborated, with an appropriate vector of Coulomb friction coefficients, $\mathbf b_{x,y,\varphi}$.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "components",
                r"With a signum for each component, as (2)–(4) and a vector of coefficients suggest, friction depends on the choice of the axes: for equal coefficients, at an angle $\alpha$ to "
                r"them, the friction against a slip is «size», so along the diagonal it is «diagonal» of that along an axis.",
                size=Formula(
                    "f",
                    "=",
                    b * (sp.Abs(sp.cos(plane.direction)) + sp.Abs(sp.sin(plane.direction))),
                    equals(lambda: plane.against_slip(plane.direction)),
                ),
                diagonal=Formula(
                    r"f(\pi/4)/f(0)",
                    "=",
                    sp.sqrt(2),
                    equals(lambda: plane.against_slip(sp.pi / 4) / b),
                ),
            ),
            clause(
                "direction",
                r"What carries over is the friction in the direction of the slip, $\mathbf f=b\,\mathbf w/|\mathbf w|$, $\mathbf w=\mathbf v_1-\mathbf v_2$, and any $|\mathbf f|\leqslant b$ in stick, which is not "
                r"(4) by components: with scalar masses, spring and damper $\dot E=-b|\mathbf w|-a_1|\mathbf v_1|^2$ for $u=0$, there is one motion from every start, and two never move apart.",
            ),
            clause(
                "line", r"Along a line it is the pair with Coulomb's law exactly, and so for $u=0$ that of (2)–(4)."
            ),
        ),
        open=(
            "What set of forces and moments a contact patch that turns can give, and with it which vector of coefficients is appropriate for a rotation, is not derived here.",
            "Which motions in the plane merge, and how fast the others settle, is not decided here.",
        ),
    ),
    Claim(
        "acceleration-bound",
        SECTION,
        "sixth bullet",
        r"The switched motion system (2)–(4) is underactuated as well as upper-bounded by "
        r"$\ddot{x}_1=\ddot{x}_2$, as for the control efforts, cf. (13).",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "bound",
                r"Under Coulomb's law body 2 changes its velocity by at most $b/m_2$ times the time, whatever the driving body does:",
                kernel=("driven-acceleration",),
            ),
            clause(
                "modes",
                r"in slip «slip», and in stick, on $S_0$, $\ddot x_2=\ddot x_1$ with «stick».",
                slip=Formula(sp.Abs(DRIVEN), "=", b / m2, equals(lambda: sp.Abs(free(slip(1).acceleration2)))),
                stick=Formula(sp.Abs(DRIVEN), "<=", b / m2, _stick_bound()),
            ),
            clause(
                "equality",
                r"(3)–(4) have no other motions; at an instant with $\dot z=0$ and $|\ddot x_1|=b/m_2$ (4) itself hands on «half», and none of it beyond.",
                half=Formula(DRIVEN, "=", DRIVING / 2, equals(_half)),
            ),
        ),
    ),
    Claim(
        "varying-interface",
        SECTION,
        "sixth bullet",
        r"The effect of the time- and state-varying behaviour of the frictional interface, i.e. $b(\cdot)$, on the motion dynamics poses an "
        r"interesting open problem.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "time",
                r"For $b(t)>0$ that is constant on each of finitely many pieces of time there is one solution from every start, and two never move apart;",
                kernel=("varying-contraction", "varying-well-posed"),
            ),
            clause(
                "rate",
                r"so it is with pieces without end, finitely many in every bounded time, with «contraction»;",
                contraction=Formula(
                    r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                    "=",
                    -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (v1 - v2 - v1_other + v2_other),
                    equals(forced.contraction_rate),
                ),
            ),
            clause("rule", r"the mode rule stays as it is, with the values of $b$ from the right."),
            clause(
                "state",
                r"Where $b$ depends on the place the contraction is lost: for two slips of one sign $s$ under $b$ and $\tilde b$, $a_1=0$, it becomes «rate», "
                r"which can be positive.",
                rate=Formula(
                    r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                    "=",
                    -(b - forced.b_other) * S * (v1 - v2 - v1_other + v2_other),
                    either_sign(forced.place_dependent_rate),
                ),
            ),
            clause(
                "unique",
                r"One motion from every start there is all the same: if $|b-\tilde b|\leqslant\ell\,|x_1-\tilde x_1|$, $N(t)\leqslant e^{\gamma t}N(0)$ with «place». For $b$ that depends on $z$ so it is with "
                r"$(z-\tilde z)^2$ added to $N^2$ and another $\gamma$, and for $b(|\dot z|)$ that falls by at most $\ell$ times the increase of the speed with «speed»: where $b$ does not fall with the speed, $\ell=0$, $N$ never grows.",
                place=Formula(
                    r"\gamma",
                    "=",
                    LIPSCHITZ * sp.sqrt((m1 + m2) / (m1 * m2 * a2)),
                    equals(lambda: forced.growth_by_place(LIPSCHITZ)),
                ),
                speed=Formula(
                    r"\gamma",
                    "=",
                    LIPSCHITZ * (m1 + m2) / (m1 * m2),
                    equals(lambda: forced.growth_by_speed(LIPSCHITZ)),
                ),
            ),
            clause(
                "synchronises",
                r"And as long as $b$ stays between some $b_{\min}>0$ and some $b_{\max}$, whatever it depends on, $\dot E\leqslant-b_{\min}|\dot z|$ for $u=0$: $\dot z\to 0$, and $z$ has a limit.",
            ),
        ),
        open=(
            "What the long-run motion is for a friction that depends on the state (who merges, how fast the others settle) is not decided here.",
            "For a friction that jumps down where a stick ends (static above kinetic) there is not one motion from a start, stick and slip both are: which of them is meant is not decided here.",
        ),
    ),
)
