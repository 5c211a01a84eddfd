"""The theorems on the pair under a force that rows may cite; as in `cited.py`.

"Motion" is the continuous solution under the force, whose impulse may be any continuous function; it is absolutely continuous
where the impulse is.
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
    "interface-one-strength": (
        "Interface.rubs_constant",
        "A friction of one strength at all times: the motions under a force, and only they.",
    ),
    "interface-well-posed": (
        "InterfaceExists.interface_well_posed",
        "With a friction of at most $b(t)\\geqslant 0$ against the slip, where $b$ is the rate from the right of a continuous function, there is exactly one motion from every initial state.",
    ),
    "interface-contraction": (
        "Interface.interface_contraction",
        "Two motions under one force with a friction of one strength $b$ along both, as any $b(t)$ has, never move apart in the energy norm.",
    ),
    "interface-distance-rate": (
        "Interface.interface_distance_rate",
        r"Where the frictions $f,\tilde f$ of two motions exist from the right, $\tfrac12\tfrac{d}{dt}N^2=(u-\tilde u)(v_1-\tilde v_1)-a_1(v_1-\tilde v_1)^2-(f-\tilde f)(\dot z-\dot{\tilde z})$.",
    ),
    "interface-energy-rate": (
        "Interface.interface_energy_rate",
        "With a friction of the strength $b(t)$, whatever it depends on, $\\dot E=u\\,v_1-a_1v_1^2-b(t)|v_1-v_2|$, where the impulse has the rate $u$ from the right.",
    ),
    "interface-input-to-state": (
        "Interface.interface_input_to_state",
        r"With a friction of one strength $b(t)$, under two forces: $N(t)\leqslant N(r)+m_1^{-1/2}\int_r^t|u-\tilde u|$, $\frac12N^2$ the energy of the difference.",
    ),
    "interface-rule": (
        "InterfaceMode.interface_rule",
        r"Where the strength $b$ is constant for a while from a contact on: stick for $|\Lambda|<b$, slip with the sign of $\Lambda$ for $|\Lambda|>b$, at $\Lambda=\pm b$ the first nonzero derivative, and stick at the edge where all are 0 and the force is analytic.",
    ),
    "interface-no-zeno": (
        "InterfaceMode.interface_no_zeno",
        "Under a piecewise analytic force and with a strength $b>0$ that is constant on pieces, finitely many in every bounded time, every bounded time interval has finitely many mode changes.",
    ),
    "interface-synchronises": (
        "Interface.interface_synchronises",
        r"Without a force, with a strength between $b_{\min}>0$ and $b_{\max}$, whatever it depends on: $\dot E\leqslant-b_{\min}|\dot z|$, $\dot z\to 0$, and $z$ has a limit.",
    ),
    "state-well-posed": (
        "InterfaceExists.state_well_posed",
        r"With a strength $b\geqslant 0$ that depends on $x_1$, $z$ and $|\dot z|$ with bounded slopes there is exactly one motion from every initial state.",
    ),
    "growth-by-place": (
        "Interface.growth_by_place",
        r"Where $|b-\tilde b|\leqslant\ell|x_1-\tilde x_1|$ along two motions: $N(t)\leqslant e^{\gamma t}N(0)$, $\gamma=\ell\sqrt{(m_1+m_2)/(m_1m_2a_2)}$.",
    ),
    "growth-by-state": (
        "Interface.growth_by_state",
        r"Where $|b-\tilde b|\leqslant\ell(|x_1-\tilde x_1|+|z-\tilde z|+||\dot z|-|\dot{\tilde z}||)$ along two motions, $N^2+(z-\tilde z)^2$ grows at most as $e^{2\gamma t}$, $\gamma=\ell\sqrt{\kappa/a_2}+(\ell+1)\sqrt\kappa+\ell\kappa$.",
    ),
    "growth-by-speed": (
        "Interface.growth_by_speed",
        r"Where $b$ falls by at most $\ell$ times the increase of $|\dot z|$: $N(t)\leqslant e^{\gamma t}N(0)$, $\gamma=\ell(m_1+m_2)/(m_1m_2)$.",
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
    "scenes-analytic": (
        "Analytic.scenes_are_analytic",
        "Piecewise polynomials plus sinusoids are piecewise analytic.",
    ),
    "forced-energy-rate": (
        "Forced.forced_energy_rate",
        r"$\dot E=u\,v_1-a_1v_1^2-b|v_1-v_2|$, where the impulse has the rate $u$ from the right.",
    ),
    "input-to-state": (
        "Forced.input_to_state_integral",
        r"Under two continuous forces $N(t)\leqslant N(0)+m_1^{-1/2}\int_0^t|u-\tilde u|$, $\frac12N^2$ the energy of the difference.",
    ),
    "must-stick": ("Forced.must_stick", "At a time at which body 2 accelerates by less than $b/m_2$, $v_1=v_2$."),
    "trackable": (
        "Forced.trackable_iff",
        "From some initial state of body 1 some force makes body 2 follow a velocity exactly if that is $b/m_2$-Lipschitz.",
    ),
    "tracks": (
        "Tracking.tracks",
        r"With $a_1>0$, under the force of the stuck motion along a reference with $|\ddot x_{\mathrm{ref}}|\leqslant b/m_2$, but for a constant, if it is bounded: $v_1$, $v_2$ and $x_1$ of "
        "every motion tend to the velocity of the reference, and to its place but for the constant.",
    ),
    "controlled-contraction": (
        "Approach.controlled_contraction",
        r"Under a force and a damper $a_1(t)\geqslant 0$ whose impulses have them as rates from the right at every time, two motions never move apart in the energy norm.",
    ),
    "keeps-offset": (
        "Offset.keeps_offset",
        r"$m_1=m_2=a_1=a_2=b=1$, $u=\frac12\sin t$: the reference $-\frac14(\sin t+\cos t)$ is a motion, and one that starts with its $x_2$ and $v_2$, body 1 at rest at 0, takes on its velocities and keeps an offset of $x_2$ between $-266.2$ and $-266.1$ mm.",
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
    "weak-sticks": (
        "WeakTransfer.sticks_half_turn",
        r"From rest at $x_1=0$ no force of at most $F$, $3F\leqslant bM/m_2$, breaks the undamped pair within $\pi/\Omega$.",
    ),
    "weak-takes": (
        "WeakTransfer.weak_takes",
        r"Under such forces, where $a_2D\leqslant F$, from rest at $x_1=0$ to rest at $D$ takes at least the time of two arcs, under $F$ and then under $-F$.",
    ),
    "weak-attained": ("WeakTransfer.weak_attained", "Both arcs are a motion, and the pair can then be held there."),
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
        "exists that also repeats with the opposite sign; each for some phase of the force.",
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
    "undamped-entrained": (
        "UndampedEntrainment.undamped_entrained",
        r"With $a_1=0$ every motion under a sinusoidal force of amplitude below $U_*$ tends to one that sticks permanently, and $\int|\dot z|\,dt$ is at most the energy distance from the stuck response at $t=0$ over $b\,(1-U/U_*)$.",
    ),
    "resonance-edge": (
        "AtResonance.edge_family",
        r"With $a_1=0$, under $u=\frac{4b}{\pi}\sin\omega_1t$ there is a family of motions that slip permanently, one way for half a period and then the other way, in closed form.",
    ),
    "resonance-edge-bounded": (
        "AtResonance.edge_bounded",
        r"With $a_1=0$, every motion under $u=\frac{4b}{\pi}\sin\omega_1t$ is bounded.",
    ),
    "third-root-law": (
        "ThirdRoot.third_root_law",
        r"For $c,\kappa,K>0$: if $X$ is large at first and $V=0$, and from step to step, while $X$ is large and $V\leqslant 1$, $X$ does not fall and gains $c/X^2$ within $(K\sqrt V+K/X)/X^2$, and $V\geqslant 0$ gains at most $-\kappa V/X+K/X^2$, then $X\to\infty$, $V\to 0$ and $X_n^3/n\to 3c$.",
    ),
    "controlled-approach": (
        "Approach.controlled_approach",
        r"With a damper $a_1(t)$ between two positive bounds and a bounded force every motion tends to each that is bounded.",
    ),
}
