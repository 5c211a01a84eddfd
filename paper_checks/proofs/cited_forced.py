"""The theorems on the pair under a force that rows may cite; as in `cited.py`.

"Motion" is the absolutely continuous solution under the force; its impulse may be any continuous function.
"""

from __future__ import annotations

FORCED: dict[str, tuple[str, str]] = {
    "free-case": ("Forced.free_case", "Without a force the forced system is the free one."),
    "forced-well-posed": (
        "ForcedExistence.forced_well_posed",
        "Under any force with a continuous impulse: one solution from every start.",
    ),
    "forced-contraction": (
        "Forced.forced_contraction",
        "Under one force the energy distance of two solutions never grows.",
    ),
    "varying-contraction": (
        "Varying.varying_contraction",
        "The same where the friction changes in time, by pieces.",
    ),
    "varying-well-posed": (
        "Varying.varying_well_posed",
        "With a friction by pieces in time, too: one motion from every start.",
    ),
    "varying-energy-rate": (
        "Pieces.varying_energy_rate",
        "The energy has the same rate, with the friction of the time.",
    ),
    "varying-input-to-state": (
        "Pieces.varying_input_to_state",
        "So has the energy distance under two forces the same bound.",
    ),
    "mode-stick": (
        "Mode.sticks_at",
        "At a contact with the load within b the pair sticks for a while, whatever the force does later.",
    ),
    "mode-slip": (
        "Mode.slips_at",
        "At a contact with the load beyond b it slips at once, with the sign of the load.",
    ),
    "mode-tie": (
        "Mode.tie_rule",
        "At a contact with the load b or -b the first derivative that is not 0 of what the force asks beyond b decides.",
    ),
    "mode-marginal": (
        "Rule.marginal",
        "Where all these derivatives are 0 and the force is analytic, the pair sticks at the load b, with the acceleration of the slip.",
    ),
    "slip-rate": (
        "Rule.slip_rate",
        "In slip the relative velocity has the rate that the load beyond b gives it.",
    ),
    "stuck-load": (
        "Rule.stuck_load",
        "While stuck body 2 has the acceleration load/m2, and the load is within b.",
    ),
    "jump-moves-strip": (
        "Rule.jump_moves_strip",
        "The state is continuous whatever the force does; a jump of it moves the strip |load| <= b.",
    ),
    "damper-breaks": (
        "Rule.damper_breaks",
        "A free pair, stuck at x1 = 0 with v1 > 0, slips at once if a1 > b (m1 + m2)/(m2 v1).",
    ),
    "no-zeno": (
        "Zeno.no_zeno",
        "Under a force that is analytic by pieces every bounded time holds finitely many changes of mode.",
    ),
    "no-zeno-varying": (
        "Zeno.no_zeno_varying",
        "The same holds with a friction that is constant by pieces: finitely many changes of mode in every bounded time.",
    ),
    "scenes-analytic": (
        "Analytic.scenes_are_analytic",
        "Polynomials plus sinusoids by pieces are analytic by pieces.",
    ),
    "forced-energy-rate": ("Forced.forced_energy_rate", "dE/dt = u v1 - a1 v1^2 - b |v1 - v2|."),
    "input-to-state": (
        "Forced.input_to_state_integral",
        "The energy distance grows at most by the integral of the forces' difference over sqrt m1.",
    ),
    "must-stick": ("Forced.must_stick", "Where body 2 accelerates by less than b/m2 the pair sticks."),
    "trackable": (
        "Forced.trackable_iff",
        "From some start of body 1, some force makes body 2 follow a velocity exactly if that is b/m2-Lipschitz.",
    ),
    "reach": ("Forced.reach", "Where body 2 can be at a time, whatever the force."),
    "least-time": ("Forced.least_time", "From rest to rest over D takes at least 2 sqrt(m2 D/b), whatever the force."),
    "least-time-attained": (
        "Forced.least_time_attained",
        "The least time 2 sqrt(m2 D/b) from rest to rest over D is attained.",
    ),
    "entrained-iff": (
        "Entrain.entrained_iff",
        "The stuck response to a sinusoidal force is a solution exactly if its amplitude is at most U*.",
    ),
    "stuck-iff": (
        "Entrain.stuck_iff",
        "With a1 > 0 some solution sticks for ever under a sinusoidal force exactly if its amplitude is at most U*.",
    ),
    "third-harmonic": ("Entrain.third_harmonic", "With a1 = 0 and Omega = 3 omega a stuck motion exists above U*."),
    "forced-bounded": ("Bounded.bounded", "With a1 > 0 every motion under a bounded force is bounded."),
    "forced-approach": ("Bounded.approach", "With a1 > 0 any two motions under one bounded force approach each other."),
    "periodic-response": (
        "Periodic.response",
        "With a1 > 0 a periodic bounded force has exactly one periodic motion, and it attracts all.",
    ),
    "drift": ("Drift.drift", "The place of body 2 changes by the integral of its velocity."),
    "no-drift": (
        "Drift.no_drift",
        "With a1 > 0, if the force changes its sign after half a period, so does the periodic response, and body 2 comes back.",
    ),
    "entrains": (
        "Sync.entrains",
        "With a1 > 0 every motion tends to the stuck response to a sinusoidal force of amplitude up to U*.",
    ),
    "synchronises": (
        "Sync.synchronises",
        "With a1 > 0 every motion under a sinusoidal force of amplitude below U* sticks for ever after a finite time.",
    ),
    "arc-begins": (
        "Arcs.arc_begins",
        "A smooth arc that obeys the law of friction under a force is the beginning of a motion under it.",
    ),
    "follow-forced-arc": (
        "Arcs.follow_arc",
        "A motion under a force that meets the start of such an arc, at any time, runs along it.",
    ),
    "antiperiodic": (
        "Arcs.antiperiodic",
        "Under a force that repeats with the opposite sign, a motion whose state does so once does so for ever.",
    ),
    "nonstop-iff": (
        "Nonstop.nonstop_iff",
        "a1 >= 0: a motion that slips one way for half a period and then the other way exists exactly from U** on, if its "
        "relative velocity keeps its sign at U**.",
    ),
    "nonstop-undamped": (
        "Undamped.undamped_iff",
        "a1 = 0: the same with U** in closed form, off the resonances of body 1.",
    ),
    "nonstop-above-resonance": (
        "Undamped.above_resonance",
        "a1 = 0 and omega above body 1's own frequency: that motion exists exactly from U** on, without a condition.",
    ),
    "nonstop-damped": (
        "Damped.damped_iff",
        "a1 > 0, a1^2 < 4 m1 a2: the same with U** in closed form.",
    ),
    "nonstop-attracts": (
        "Damped.nonstop_attracts",
        "With a1 > 0 a motion that slips for ever attracts every motion under its force.",
    ),
    "two-stop-exists": (
        "TwoStop.two_stop_exists",
        "A slip and a stick whose ends meet, and meet with the opposite sign after half a period, are a periodic motion if "
        "v1 > v2 in the slip and the load stays within b in the stick.",
    ),
    "two-stop-needs": (
        "TwoStop.two_stop_needs",
        "A motion that slips and sticks once in each half period leaves contact at the load b, and is such a pair of arcs.",
    ),
    "stuck-transfer-amplitude": (
        "Transfer.stuck_amplitude",
        "The amplitude of the force of the fastest stuck transfer over D.",
    ),
    "arrival-needs": (
        "Transfer.arrival_needs",
        "To bring body 2 to rest at D in the least time a force needs b + beta tau/g(tau), g body 1's impulse response, "
        "g' >= 0 up to tau.",
    ),
    "least-amplitude": (
        "Arrival.least_amplitude",
        "That takes exactly b + beta tau/g(tau), g' >= 0 up to tau.",
    ),
    "least-amplitude-undamped": (
        "Arrival.least_amplitude_undamped",
        "a1 = 0, theta = omega1 tau <= pi/2: exactly b + m1 beta theta/sin theta.",
    ),
    "rest-to-rest": (
        "Arrival.rest_to_rest",
        "With that amplitude both bodies can be at rest then, if the stuck pair may brake with it in the second half.",
    ),
    "ring-factor": (
        "Relative.ring_factor",
        "|v1 - v2| <= sqrt kappa N, kappa = (m1 + m2)/(m1 m2), and no smaller factor will do.",
    ),
    "displacement-unseen": (
        "Relative.displacement_unseen",
        "Another place of body 2 at the start moves the relative motion by as much, for ever.",
    ),
    "tolerance-ring": (
        "Ring.ring",
        "With a1 > 0 a tube around a motion has one entry time for every other motion, and its ring of relative velocities "
        "is not left after it.",
    ),
}
