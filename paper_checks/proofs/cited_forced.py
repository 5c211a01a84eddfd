"""The theorems on the pair under a force that rows may cite; as in `cited.py`.

"Motion" is the absolutely continuous solution under the force; its impulse may be any continuous function.
"""

from __future__ import annotations

FORCED: dict[str, tuple[str, str]] = {
    "free-case": ("Forced.free_case", "Without a force the forced system is the free system."),
    "forced-well-posed": (
        "ForcedExistence.forced_well_posed",
        "Under any force with a continuous impulse there is exactly one solution from every initial state.",
    ),
    "forced-contraction": (
        "Forced.forced_contraction",
        "Under any force the flow is non-expansive in the energy norm.",
    ),
    "varying-contraction": (
        "VaryingFriction.varying_contraction",
        "With friction constant on each of finitely many pieces of time the flow under a force is non-expansive in the energy norm.",
    ),
    "varying-well-posed": (
        "VaryingFriction.varying_well_posed",
        "With friction constant on each of finitely many pieces of time there is exactly one motion from every initial state.",
    ),
    "varying-energy-rate": (
        "PiecewiseFriction.varying_energy_rate",
        "With friction constant on each of finitely many pieces of time $\\dot E=u\\,v_1-a_1v_1^2-b(t)|v_1-v_2|$.",
    ),
    "varying-input-to-state": (
        "PiecewiseFriction.varying_input_to_state",
        r"With friction constant on each of finitely many pieces of time, under two forces: $N(t)\leqslant N(r)+m_1^{-1/2}\int_r^t|u-\tilde u|$, $\frac12N^2$ the energy of the difference.",
    ),
    "mode-stick": (
        "ModeAtContact.sticks_at",
        r"At a contact with $|\Lambda|<b$, where $u$ is continuous from the right, the pair sticks for a while.",
    ),
    "mode-slip": (
        "ModeAtContact.slips_at",
        r"At a contact with $|\Lambda|>b$, where $u$ is continuous from the right, it slips at once, with the sign of the load $\Lambda$.",
    ),
    "mode-tie": (
        "ModeAtContact.tie_rule",
        r"At a contact with $\Lambda=\pm b$, under a smooth force, the first nonzero derivative of the excess of the force over that which keeps the load at $\pm b$ decides.",
    ),
    "mode-marginal": (
        "RuleOfModes.marginal",
        r"Where all these derivatives are 0 and the force is analytic, the pair sticks at the load $\pm b$, with "
        "the acceleration of the slip.",
    ),
    "slip-rate": (
        "RuleOfModes.slip_rate",
        r"In slip the rate of the relative velocity is given by the load in excess of $\pm b$.",
    ),
    "stuck-load": (
        "RuleOfModes.stuck_load",
        r"While stuck body 2 has the acceleration $\Lambda/m_2$, and $|\Lambda|\leqslant b$.",
    ),
    "jump-moves-strip": (
        "RuleOfModes.jump_moves_strip",
        r"The state is continuous whatever the force does; a jump of the force moves the strip $|\Lambda|\leqslant b$.",
    ),
    "damper-breaks": (
        "RuleOfModes.damper_breaks",
        "A free pair, stuck at $x_1=0$ with $v_1>0$, slips at once if $a_1>b(m_1+m_2)/(m_2v_1)$.",
    ),
    "no-zeno": (
        "FinitelyManyModes.no_zeno",
        "Under a piecewise analytic force every bounded time interval has finitely many mode changes.",
    ),
    "no-zeno-varying": (
        "FinitelyManyModes.no_zeno_varying",
        "Under a piecewise analytic force and with friction constant on each of finitely many pieces of time every bounded time interval has finitely many mode changes.",
    ),
    "scenes-analytic": (
        "Analytic.scenes_are_analytic",
        "Piecewise polynomials plus sinusoids are piecewise analytic.",
    ),
    "forced-energy-rate": ("Forced.forced_energy_rate", r"$\dot E=u\,v_1-a_1v_1^2-b|v_1-v_2|$."),
    "input-to-state": (
        "Forced.input_to_state_integral",
        r"Under two continuous forces $N(t)\leqslant N(0)+m_1^{-1/2}\int_0^t|u-\tilde u|$, $\frac12N^2$ the energy of the difference.",
    ),
    "must-stick": ("Forced.must_stick", "At a time at which body 2 accelerates by less than $b/m_2$, $v_1=v_2$."),
    "trackable": (
        "Forced.trackable_iff",
        "From some initial state of body 1 some force makes body 2 follow a velocity exactly if that is $b/m_2$-Lipschitz.",
    ),
    "reach": ("Forced.reach", "A bound on the position of body 2 at a time, whatever the force."),
    "least-time": (
        "Forced.least_time",
        r"From rest to rest over $D$ takes at least $2\sqrt{m_2D/b}$, whatever the force.",
    ),
    "least-time-attained": (
        "Forced.least_time_attained",
        r"The least time $2\sqrt{m_2D/b}$ from rest to rest over $D$ is attained.",
    ),
    "entrained-iff": (
        "Entrainment.entrained_iff",
        "The stuck response to a sinusoidal force is a solution exactly if its amplitude is at most $U_*$.",
    ),
    "stuck-iff": (
        "Entrainment.stuck_iff",
        "With $a_1>0$ some solution sticks permanently under a sinusoidal force exactly if its amplitude is at most "
        "$U_*$.",
    ),
    "third-harmonic": (
        "Entrainment.third_harmonic",
        r"With $a_1=0$ and $\Omega=3\omega$ a stuck motion exists above $U_*$.",
    ),
    "forced-bounded": ("BoundedMotions.bounded", "With $a_1>0$ every motion under a bounded force is bounded."),
    "forced-approach": (
        "BoundedMotions.approach",
        "With $a_1>0$ any two motions under one bounded force approach each other.",
    ),
    "periodic-response": (
        "PeriodicMotion.response",
        "With $a_1>0$ a periodic bounded force has exactly one periodic motion, and it attracts every motion.",
    ),
    "drift": ("Drift.drift", "The position of body 2 changes by the integral of its velocity."),
    "no-drift": (
        "Drift.no_drift",
        "With $a_1>0$, if the force changes its sign after half a period, so does the periodic response, and body 2 returns.",
    ),
    "entrains": (
        "ForcedCapture.entrains",
        "With $a_1>0$ every motion tends to the stuck response to a sinusoidal force of amplitude up to $U_*$.",
    ),
    "synchronises": (
        "ForcedCapture.synchronises",
        "With $a_1>0$ every motion under a sinusoidal force of amplitude below $U_*$ sticks permanently after a finite time.",
    ),
    "arc-begins": (
        "Arcs.arc_begins",
        "A smooth arc that satisfies the friction law under a force is the beginning of a motion under that force.",
    ),
    "follow-forced-arc": (
        "Arcs.follow_arc",
        "A motion under a force that meets the start of such an arc, at any time, follows it.",
    ),
    "antiperiodic": (
        "Arcs.antiperiodic",
        "Under a force that repeats with the opposite sign, a motion whose state does so once does so from then on.",
    ),
    "nonstop-iff": (
        "Nonstop.nonstop_iff",
        r"$a_1\geqslant 0$: a motion that slips one way for half a period, and then is its own negative, exists exactly "
        "from $U_{**}$ on, if $A>0$ and its relative velocity keeps its sign at $U_{**}$.",
    ),
    "nonstop-by-halves": (
        "HalfPeriod.by_halves_iff",
        "A motion with the force's period that slips one way for half of it and then the other way exists exactly where one "
        "exists that also repeats with the opposite sign.",
    ),
    "nonstop-by-halves-needs": (
        "HalfPeriod.by_halves_needs",
        r"Below $U_{**}$ no motion with the force's period slips one way for half of it and then the other way, whatever the relative velocity does at $U_{**}$, if it leaves the turn there ($A>0$).",
    ),
    "nonstop-undamped": (
        "NonstopUndamped.undamped_iff",
        "$a_1=0$: the theorem nonstop-iff with $U_{**}$ in closed form, off the resonances of body 1.",
    ),
    "nonstop-above-resonance": (
        "NonstopUndamped.above_resonance",
        r"$a_1=0$ and $\omega$ above body 1's own frequency: the motion of nonstop-iff exists exactly from $U_{**}$ on, without a "
        "condition.",
    ),
    "nonstop-damped": (
        "NonstopDamped.damped_iff",
        "$a_1>0$, $a_1^2<4m_1a_2$: the theorem nonstop-iff with $U_{**}$ in closed form.",
    ),
    "nonstop-overdamped": (
        "NonstopOverdamped.overdamped_iff",
        "$a_1^2>4m_1a_2$: the theorem nonstop-iff with $U_{**}$ in closed form, by two exponentials.",
    ),
    "nonstop-attracts": (
        "NonstopDamped.nonstop_attracts",
        "With $a_1>0$ a motion of nonstop-iff attracts every motion under its force.",
    ),
    "two-stop-exists": (
        "TwoStop.two_stop_exists",
        "A slip and a stick whose ends meet, and meet with the opposite sign after half a period, are a periodic "
        r"motion if $v_1>v_2$ in the slip and $|\Lambda|\leqslant b$ in the stick.",
    ),
    "two-stop-needs": (
        "TwoStop.two_stop_needs",
        r"A motion that slips and sticks once in each half period, and is its own negative after it, leaves stick at $\Lambda=b$, gains "
        r"$bt_s/m_2$ of velocity in the slip, and has $|\Lambda|\leqslant b$ in the stick.",
    ),
    "stuck-transfer-amplitude": (
        "LeastTimeTransfer.stuck_amplitude",
        "The amplitude of the force of the fastest stuck transfer over $D$ from $x_1=0$.",
    ),
    "arrival-needs": (
        "LeastTimeTransfer.arrival_needs",
        r"To bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, a force needs an amplitude of at least $b+\beta\tau/g(\tau)$, where $g$ is body "
        r"1's impulse response and $g'\geqslant 0$ up to $\tau$.",
    ),
    "least-amplitude": (
        "LeastAmplitude.least_amplitude",
        r"To bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, takes exactly $b+\beta\tau/g(\tau)$, where $g'\geqslant 0$ up to $\tau$.",
    ),
    "least-amplitude-undamped": (
        "LeastAmplitude.least_amplitude_undamped",
        r"$a_1=0$, $\theta=\omega_1\tau\leqslant\pi/2$: to bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, takes exactly $b+m_1\beta\,\theta/\sin\theta$.",
    ),
    "rest-to-rest": (
        "LeastAmplitude.rest_to_rest",
        "With that amplitude both bodies can be at rest then, if the stuck pair can brake with it in the second half.",
    ),
    "ring-factor": (
        "RelativeMotion.ring_factor",
        r"$|v_1-v_2|\leqslant\sqrt\kappa\,N$, $\kappa=(m_1+m_2)/(m_1m_2)$, and no smaller factor suffices.",
    ),
    "displacement-unseen": (
        "RelativeMotion.displacement_unseen",
        "A shift of the initial position of body 2 shifts the relative displacement by as much at all times.",
    ),
    "tolerance-ring": (
        "ToleranceRing.ring",
        "With $a_1>0$ and a bounded force every motion enters a tube around another one at some time, and stays; from then on it is in the ring of relative velocities.",
    ),
}
