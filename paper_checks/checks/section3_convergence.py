"""Section III, where trajectories go: the statements about all of them, by written-out capture."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.engines.samples import dichotomy_samples
from paper_checks.evidence.evidence import argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps import capture
from paper_checks.steps.turned_back import contact_again, merges_or_creeps
from theory.energy import stick_rate
from theory.symbols import undamped


@check("infinitely-many-crossings")
def infinitely_many_crossings(context: Context) -> Finding:  # noqa: ARG001
    """Every stay off S is finite."""
    return conclude(
        Verdict.HOLDS,
        "Solutions exist for all time (the set-valued field is bounded on the level sets of $E$, which never grows). A stay "
        "in $\\Omega_+$ or $\\Omega_-$ lasts at most $2\\sqrt{2Em_2}/b$, since there $v_2$ changes at a constant rate and is "
        "bounded by the energy. So the times at which a trajectory is on $S$ have no last one; one that sticks is on $S$ at "
        "every instant.",
        carried("crossings", contact_again()),
        derivation=(
            "$$m_2v_2^2\\leqslant 2E(0),\\quad |\\dot v_2|=b/m_2\\ \\Rightarrow\\ T\\leqslant\\frac{2\\sqrt{2E(0)m_2}}{b}$$",
        ),
    )


@check("dichotomy")
def dichotomy(context: Context) -> Finding:
    """Either E reaches E_cr, and the pair sticks for ever, or the limit set is the critical orbit."""
    return conclude(
        Verdict.HOLDS,
        "If $E\\leqslant E_{cr}$ at some time, the next contact with $S$, which comes within a bounded time, is in $S_0$ and "
        "is never left: the trajectory merges. Otherwise the pair, turned back by the angle $\\Omega t$ of stick, converges, as only "
        "slip moves it and slip costs energy: it tends to one rotation of a radius $R$. Beyond $L$ each turn would cost a fixed "
        "energy, so $R=L$: it tends to one motion on the critical ellipse.",
        carried("dichotomy", merges_or_creeps()),
        identity(
            r"on $S_0$, $\dot E=0$: the level sets there are orbits", undamped(stick_rate()), 0, seed=context.seed
        ),
        *capture.leaves_above_critical(),
        dichotomy_samples(context.seed),
        derivation=(
            "Step 1 (energy): $E$ never increases, and $b\\int|v_1-v_2|\\,dt\\leqslant E(0)$. Step 2 (turned back): with "
            "$P=m_1v_1+m_2v_2$ the point $(x_1,P/(M\\Omega))$ turned back by $\\Omega t$ moves at the rate $\\frac{m_2}{M}|v_1-v_2|$, so "
            "it converges. Step 3 (cost): where $|x_1|\\geqslant L+\\delta$, $|\\dot v_1-\\dot v_2|\\geqslant a\\delta/m_1$; a rotation of "
            "a radius beyond $L$ would slip a fixed path in every turn.",
            "Step 4 (capture): on $S$ with $E\\leqslant E_{cr}$ the pair sticks for ever; two solutions never move apart, so this "
            "is the only one. No limit sets, no compactness: the motion itself converges.",
        ),
    )


@check("relative-displacement-limit")
def relative_displacement_limit(context: Context) -> Finding:  # noqa: ARG001
    """The path length of x1 - x2 is at most E(0)/b."""
    return conclude(
        Verdict.HOLDS,
        "$b\\int_0^\\infty|v_1-v_2|\\,dt=E(0)-E_\\infty\\leqslant E(0)$: the path of $x_1-x_2$ has finite length, so it "
        "converges. The bodies slide by exactly $(E(0)-E_\\infty)/b$ in all.",
        carried(
            "limit",
            argument(
                "The path of $x_1-x_2$ has the length $\\int|v_1-v_2|\\,dt\\leqslant E(0)/b$: a path of finite length has an end.",
                *capture.energy_decreases(),
            ),
        ),
        derivation=("$$\\int_0^\\infty|\\dot x_1-\\dot x_2|\\,dt=\\frac{E(0)-E_\\infty}{b}<\\infty$$",),
    )


@check("global-stability")
def global_stability(context: Context) -> Finding:  # noqa: ARG001
    """Stability by contraction, attraction by the dichotomy."""
    return conclude(
        Verdict.HOLDS,
        "As no two solutions move apart in the energy norm, the distance of a trajectory "
        "to it never grows (stability), and by the dichotomy it tends to 0 (attraction). The same shows that every single "
        "periodic orbit is stable; none attracts on its own. The statement is about $(x_1,v_1,v_2)$: $x_2$ drifts to a limit.",
        carried(
            "stable",
            argument(
                "The distance to the set never grows, as each of its orbits is a solution and no two solutions move apart; and it "
                "tends to 0, as every trajectory merges with one of these orbits or tends to the critical one.",
                *capture.contraction(),
                capture.stick_is_a_motion(),
                merges_or_creeps(),
            ),
        ),
        derivation=(
            "$$\\frac{d}{dt}\\tfrac12\\|y-\\tilde y\\|_E^2=-a_1(v_1-\\tilde v_1)^2-b(\\sigma-\\tilde\\sigma)"
            "\\bigl((v_1-v_2)-(\\tilde v_1-\\tilde v_2)\\bigr)\\leqslant 0$$",
        ),
    )
