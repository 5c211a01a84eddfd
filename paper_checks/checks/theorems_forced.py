"""Past the paper, under a force u(t): the mode rule, events, the distance of two motions, periodic responses."""

from __future__ import annotations

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps import entrainment, forced_distance, forced_response, forced_rule, jumping_force, solutions


@check("forced-mode-rule")
def forced_mode_rule(context: Context) -> Finding:  # noqa: ARG001
    """Both modes beside the motion that they share at a tie."""
    return conclude(
        Verdict.HOLDS,
        "The force that sticking needs decides. Where it is just the friction that there is, slip and stick agree to second order, and the first derivative in which "
        "the force leaves their common motion decides.",
        carried("modes", forced_rule.slip_rates(), forced_distance.same_modes()),
        carried("strict", forced_rule.strict_rule()),
        carried("tie", forced_rule.tie_rule()),
        carried("marginal", forced_rule.marginal_rule()),
        carried("jump", forced_rule.jump_moves_the_strip()),
        derivation=(
            r"$$I\ddot\eta+a_1\dot\eta+a_2\eta=p(t),\qquad \Lambda-sb=\frac{m_2}{M}\,(p-a_1\dot\eta-a_2\eta).$$",
        ),
    )


@check("forced-no-zeno")
def forced_no_zeno(context: Context) -> Finding:  # noqa: ARG001
    """The load beside the edge has one sign before a time of accumulation."""
    return conclude(
        Verdict.HOLDS,
        "What decides a tie for the time after it decides it for the time before it too: next to any instant the load keeps one side of each edge, so modes cannot alternate without end.",
        carried("deviation", forced_rule.deviation(), forced_rule.excess()),
        carried("finite", forced_rule.finitely_many_events()),
        carried("finite-friction", forced_rule.finitely_many_events()),
    )


@check("forced-contraction")
def forced_contraction(context: Context) -> Finding:  # noqa: ARG001
    """The force cancels in the distance of two solutions."""
    return conclude(
        Verdict.HOLDS,
        "A force common to both cancels in their distance. A friction that depends on the place would not: the friction of one solution is then not a monotone function of its own relative velocity alone.",
        carried("energy", forced_distance.energy_rate()),
        carried("rate", forced_distance.force_cancels(), solutions.contraction(), solutions.never_apart()),
        carried("distance", forced_distance.never_apart()),
        carried("unique", forced_distance.one_solution()),
        carried("forces", forced_distance.forces_apart()),
        carried("interface", forced_distance.friction_in_time()),
        carried("interface-rates", forced_distance.friction_in_time()),
        carried("interface-contraction", forced_distance.friction_in_time()),
        carried("interface-for-ever", forced_distance.pieces_without_end()),
    )


@check("forced-periodic-response")
def forced_periodic_response(context: Context) -> Finding:  # noqa: ARG001
    """One response, what moves body 2 on, and when the same holds without a damper."""
    return conclude(
        Verdict.HOLDS,
        "With a damper a periodic force has one response. Without one, a single exit from stick has the same effect if the slip after it has the right length and the force does not jump at that exit. "
        "With a jump there whole families of periodic motions may lie beside one another.",
        carried("one", forced_response.one_response()),
        carried("drift", forced_response.drift()),
        carried("undamped", forced_response.undamped_attraction()),
        carried("jump", jumping_force.keeps_apart()),
    )


@check("forced-resonance-bound")
def forced_resonance_bound(context: Context) -> Finding:  # noqa: ARG001
    """What friction can take out of a resonant oscillation at most."""
    return conclude(
        Verdict.HOLDS,
        r"Friction of size $b$ takes at most the mean of $b|\cos|$ out of an oscillation: a force with more than that at resonance is stronger than the interface.",
        carried("rate", forced_response.resonant_rate()),
        carried("grows", forced_response.grows()),
        carried("bounded", forced_response.stays_bounded()),
        carried("sine", forced_response.sine_at_resonance()),
        derivation=(
            r"$$\Bigl|\int_0^Te^{-i\omega_1t}b\sigma\,dt\Bigr|\leqslant b\int_0^T|\cos(\omega_1t-\gamma)|\,dt=\frac{2b}{\pi}\,T.$$",
        ),
    )


@check("entrainment-threshold")
def entrainment_threshold(context: Context) -> Finding:  # noqa: ARG001
    """Stuck, two stops, and no stop."""
    return conclude(
        Verdict.HOLDS,
        "Both thresholds are closed forms. Without a damper a stuck motion above the first one exists exactly where the stuck pair's own frequency is an odd multiple of the force's, from the third on.",
        carried("stuck", entrainment.sticks_for_ever()),
        carried("undamped", entrainment.undamped_stuck()),
        carried("letters", entrainment.square_wave()),
        carried("non-stop", entrainment.non_stop()),
        carried("below", entrainment.below_non_stop()),
        carried("over-damped", entrainment.over_damped()),
        carried("non-stop-undamped", entrainment.keeps_its_sign(), entrainment.non_stop()),
        carried("two-stops", entrainment.two_stops()),
        carried("two-ends", entrainment.two_ends()),
        derivation=(
            r"$$\ddot x_1\propto\cos\varphi-\tfrac1n\sin\tfrac{\pi}{2n}\cos n\varphi,\qquad\max=\cos\tfrac{\pi}{2n}\ \text{at}\ \varphi=\pm\tfrac{\pi}{2n}.$$",
        ),
    )
