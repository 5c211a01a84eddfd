"""Section III, where trajectories go: the statements about all of them, by written-out capture."""

from __future__ import annotations

from paper_checks.evidence import Finding, Verdict, conclude
from paper_checks.exact import identity
from paper_checks.registry import Context, check
from paper_checks.samples import dichotomy_samples
from paper_checks.steps import capture
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
        *capture.energy_decreases(),
        *capture.meets_surface(),
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
        "is never left: the trajectory merges. Otherwise $E$ decreases to a limit $E_\\infty\\geqslant E_{cr}$. The limit set "
        "is compact and, as solutions depend continuously on their start, invariant; $E=E_\\infty$ on it, so it lies in $S$, "
        "and no trajectory stays on $S$ above $E_{cr}$. Hence $E_\\infty=E_{cr}$, and the limit set is the critical ellipse.",
        *capture.energy_decreases(),
        *capture.contraction(),
        *capture.meets_surface(),
        capture.stays_below_critical(),
        *capture.leaves_above_critical(),
        identity(
            r"on $S_0$, $\dot E=0$: the level sets there are orbits", undamped(stick_rate()), 0, seed=context.seed
        ),
        dichotomy_samples(context.seed),
        derivation=(
            "Step 1 (energy): $E$ never increases. Step 2 (contraction): two solutions never move apart in the energy norm, so "
            "solutions are unique forwards and depend continuously on their start. Step 3 (return): $S$ is met within "
            "$2\\sqrt{2E(0)m_2}/b$.",
            "Step 4 (capture): on $S$ with $E\\leqslant E_{cr}$ the pair sticks for ever. Step 5 (LaSalle): the limit set is "
            "invariant with constant energy, so it lies in $S$; step 6: above $E_{cr}$ nothing stays on $S$.",
        ),
    )


@check("relative-displacement-limit")
def relative_displacement_limit(context: Context) -> Finding:  # noqa: ARG001
    """The path length of x1 - x2 is at most E(0)/b."""
    return conclude(
        Verdict.HOLDS,
        "$b\\int_0^\\infty|v_1-v_2|\\,dt=E(0)-E_\\infty\\leqslant E(0)$: the path of $x_1-x_2$ has finite length, so it "
        "converges. The bodies slide by exactly $(E(0)-E_\\infty)/b$ in all.",
        *capture.energy_decreases(),
        derivation=("$$\\int_0^\\infty|\\dot x_1-\\dot x_2|\\,dt=\\frac{E(0)-E_\\infty}{b}<\\infty$$",),
    )


@check("global-stability")
def global_stability(context: Context) -> Finding:  # noqa: ARG001
    """Stability by contraction, attraction by the dichotomy."""
    return conclude(
        Verdict.HOLDS,
        "The set is compact and invariant. As no two solutions move apart in the energy norm, the distance of a trajectory "
        "to it never grows (stability), and by the dichotomy it tends to 0 (attraction). The same shows that every single "
        "periodic orbit is stable; none attracts on its own. The statement is about $(x_1,v_1,v_2)$: $x_2$ drifts to a limit.",
        *capture.energy_decreases(),
        *capture.contraction(),
        *capture.meets_surface(),
        capture.stays_below_critical(),
        *capture.leaves_above_critical(),
        derivation=(
            "$$\\frac{d}{dt}\\tfrac12\\|y-\\tilde y\\|_E^2=-a_1(v_1-\\tilde v_1)^2-b(\\sigma-\\tilde\\sigma)"
            "\\bigl((v_1-v_2)-(\\tilde v_1-\\tilde v_2)\\bigr)\\leqslant 0$$",
        ),
    )
