(** Every theorem that a claim cites: its id, what it says in words, and which others it uses; then the kernel's own answer.
    Written by `python -m paper_checks.proofs audit`, with its output as it was last read, Audit.out. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From InertialPair Require AfterOneSlip AlmostEverywhere AlternatingAngles AlternatingSlips Analytic Approach Arcs AtResonance BeforeContact BoundedMotions CaseStudy Consequences CreepingScenes CriticalRatioDigits Cycle CycleLength Dichotomy Dini DisplacementLimit Drift EdgesIsolated EndlessStickSlip EnergyLimit Entrainment EulerLaw EulerSlip Excursion ExcursionShape ExitOrbit ExitPlaces Fading FallingFriction Filippov FinitelyManyModes FirstAdhesion FollowArc Forced ForcedCapture ForcedExistence ForcedTies FrictionSystems HalfPeriod HeavyDamper Interface InterfaceExists InterfaceMode KappaBound LawWithError LeastAmplitude LeastTimeTransfer LevelAfterSlip LongTime MergingAngles MergingByMassRatio MergingEnergies MergingIff ModeAtContact Modes MonotoneInclusion Nonstop NonstopDamped NonstopOverdamped NonstopUndamped Offset OneEnergy OneOverT PaidRates Pair PairTies PeriodicMotion Pursuit RateBounds Rates Reentry RelativeMotion ReturnMap ReturnToS0 RotatingForce RotatingUnstable RoundFriction RuleOfModes SharpLaw SharpRate ShortSlipMargin SlipFromGap SlipTies StartFromRest StaticFriction Stick SticksKept StuckReferences Switching SwitchingSurface SwitchingSurfaceTies SwitchingTies ThirdRoot ThresholdTies ToleranceRing Tracking Trajectory TransferTies TurnedFrame TurningFunction TwoArcs TwoStop UndampedEntrainment UniformRate VaryingFriction Velocities Viscous Waves WeakTransfer WellPosed.
Open Scope R_scope.
Set Printing Width 110.
Set Printing Depth 1000.


Goal True. idtac "== alternation
Where the longest slip from a ray that ends in $S_0$ has an angle $2\varphi_c\geqslant 4\pi/3$: a crossing slip at least that long is followed by one of at most $2\pi-2\varphi_c$, and a crossing slip of at most that by one at least as long as the longest.
uses: crossing, h-increases". Abort.
Check @AlternatingSlips.alternation.
Print Assumptions AlternatingSlips.alternation.

Goal True. idtac "== antiperiodic
Under a force that repeats with the opposite sign, a motion whose state does so once does so from then on.
uses: forced-contraction". Abort.
Check @Arcs.antiperiodic.
Print Assumptions Arcs.antiperiodic.

Goal True. idtac "== arc-begins
A smooth arc that satisfies the friction law under a force is the beginning of a motion under that force.
uses: interface-one-strength, interface-well-posed". Abort.
Check @Arcs.arc_begins.
Print Assumptions Arcs.arc_begins.

Goal True. idtac "== arc-to-left-ray
On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left exit ray, at the same level.
uses: stick-arc". Abort.
Check @SharpLaw.to_ray_left.
Print Assumptions SharpLaw.to_ray_left.

Goal True. idtac "== arc-to-ray
On $S_0$ above $E_{cr}$ every solution sticks until it reaches one of the two exit rays.
uses: arc-to-left-ray". Abort.
Check @SharpLaw.to_ray.
Print Assumptions SharpLaw.to_ray.

Goal True. idtac "== arrival-needs
To bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, a force needs an amplitude of at least $b+\beta\tau/g(\tau)$, where $g$ is body 1's impulse response and $g'\geqslant 0$ up to $\tau$.
uses: driven-acceleration". Abort.
Check @LeastTimeTransfer.arrival_needs.
Print Assumptions LeastTimeTransfer.arrival_needs.

Goal True. idtac "== captive-merges
Once its energy is below the captive level, a solution sticks permanently after a bounded time.
uses: captive-sticks, contact, energy-decreases". Abort.
Check @Viscous.captive_merges.
Print Assumptions Viscous.captive_merges.

Goal True. idtac "== captive-sticks
On $S$ below the captive level the pair sticks permanently.
uses: energy-decreases". Abort.
Check @Viscous.captive_sticks.
Print Assumptions Viscous.captive_sticks.

Goal True. idtac "== capture
A solution on $S$ with energy up to $E_{cr}$ moves along its ellipse permanently.
uses: ellipse-solution, uniqueness". Abort.
Check @Stick.capture.
Print Assumptions Stick.capture.

Goal True. idtac "== case-study-agrees-until
Case study: a solution of (11), (12) that keeps every stick agrees with the Filippov solution up to $T$ exactly if at no time before $T$ it has $v_1=v_2$ and $|x_1|>b/100$.
uses: filippov-iff, slips-beyond". Abort.
Check @CaseStudy.agree_until.
Print Assumptions CaseStudy.agree_until.

Goal True. idtac "== case-study-reduction
Case study: (3), (4) at one time are (11) and, in slip or where $|x_1|<b/100$, (12); with $v_1=v_2$ body 2 has no acceleration where $|x_1|>b/100$, and half of body 1's where $|x_1|=b/100$.
uses: no other". Abort.
Check @CaseStudy.reduction.
Print Assumptions CaseStudy.reduction.

Goal True. idtac "== contact
Every solution meets $S$ in every time window of length $2\sqrt{2Em_2}/b$, so infinitely often.
uses: no other". Abort.
Check @Stick.contact.
Print Assumptions Stick.contact.

Goal True. idtac "== contraction
The flow is non-expansive in the energy norm, with or without damping.
uses: no other". Abort.
Check @Pair.contraction.
Print Assumptions Pair.contraction.

Goal True. idtac "== controlled-approach
With a damper $a_1(t)$ between two positive bounds and a bounded force every motion tends to each that is bounded.
uses: controlled-contraction, driven-acceleration, interface-one-strength". Abort.
Check @Approach.controlled_approach.
Print Assumptions Approach.controlled_approach.

Goal True. idtac "== controlled-contraction
Under a force and a damper $a_1(t)\geqslant 0$ whose impulses have them as rates from the right at every time, two motions never move apart in the energy norm.
uses: no other". Abort.
Check @Approach.controlled_contraction.
Print Assumptions Approach.controlled_contraction.

Goal True. idtac "== convergence
Every solution tends to one stuck motion.
uses: energy-decreases, energy-limit, energy-rate, free-case, interface-one-strength, interface-synchronises". Abort.
Check @Dichotomy.convergence.
Print Assumptions Dichotomy.convergence.

Goal True. idtac "== creeps-b-0.05
The scene of Fig. 5 (a): 20 crossings, first adhesion at 4.549769... s, and from then on sticks and slips in turn without end, above $E_{cr}$, each slip slower than the one before, none faster than 2.3202 mm/s.
uses: free-case, trajectory-velocities". Abort.
Check @CreepingScenes.creeps_b005.
Print Assumptions CreepingScenes.creeps_b005.

Goal True. idtac "== creeps-b-0.2
The same with $b=0.2$: 4 crossings, first adhesion at 0.984017... s, none faster than 10.219 mm/s from then on.
uses: follow-forced-arc, forced-contraction, free-case, interface-one-strength, interface-well-posed". Abort.
Check @CreepingScenes.creeps_b02.
Print Assumptions CreepingScenes.creeps_b02.

Goal True. idtac "== creeps-b-0.5
The same with $b=0.5$, as in Fig. 4 (b): 1 crossing, first adhesion at 0.276302... s, none faster than 20.381 mm/s from then on.
uses: follow-forced-arc, forced-contraction, free-case, interface-one-strength, interface-well-posed". Abort.
Check @CreepingScenes.creeps_b05.
Print Assumptions CreepingScenes.creeps_b05.

Goal True. idtac "== critical-mass-ratio-digits
The critical mass ratio $-\cos 2\varphi^*$ up to $2\cdot 10^{-14}$, and $\varphi^*$ up to $10^{-15}$.
uses: no other". Abort.
Check @CriticalRatioDigits.decimals.
Print Assumptions CriticalRatioDigits.decimals.

Goal True. idtac "== crossing
A slip that ends beyond the other end of $S_0$ is followed by one of the other sign.
uses: gap-slip, h-increases". Abort.
Check @SlipFromGap.crossing.
Print Assumptions SlipFromGap.crossing.

Goal True. idtac "== cycle
From a ray with slip angle up to $\pi$ and $r\,c^2<h^2$ to the other ray: one slip and one stick, with the return map $y'=h^2-r\,c^2$.
uses: gap-slip, h-increases, slip-arc, stick-arc, turning-point". Abort.
Check @ExitOrbit.cycle.
Print Assumptions ExitOrbit.cycle.

Goal True. idtac "== cycle-time
With slip angle up to $\pi$ and $r\,c^2<h^2$ the time of a cycle differs from $\pi/\Omega$ by at most $6\sqrt w/\Omega$.
uses: depth-upper, h-increases, turning-point". Abort.
Check @ExitOrbit.cycle_time.
Print Assumptions ExitOrbit.cycle_time.

Goal True. idtac "== cycle-time-exact
From a ray with $h\leqslant\tfrac{2}{3}$ a cycle takes $(\pi+\sqrt q\,\theta-\arctan(\sqrt q\sqrt{h^2-r\,c^2})-\arctan\frac{\sqrt q\,(\theta-h)}{1-q\,c})/\Omega$.
uses: depth-upper, h-increases, turning-point". Abort.
Check @RateBounds.cycle_time_exact.
Print Assumptions RateBounds.cycle_time_exact.

Goal True. idtac "== damper-breaks
A free pair, stuck at $x_1=0$ with $v_1>0$, slips at once if $a_1>b(m_1+m_2)/(m_2v_1)$.
uses: free-case, mode-slip". Abort.
Check @RuleOfModes.damper_breaks.
Print Assumptions RuleOfModes.damper_breaks.

Goal True. idtac "== depth-lower
The depth of an excursion is at least $\tfrac{3}{2}(\sin\varphi/\varphi)^6h^2$.
uses: no other". Abort.
Check @ReturnMap.depth_lower.
Print Assumptions ReturnMap.depth_lower.

Goal True. idtac "== depth-upper
The depth of an excursion is at most $\tfrac{3}{2}h^2$.
uses: no other". Abort.
Check @ReturnMap.depth_upper.
Print Assumptions ReturnMap.depth_upper.

Goal True. idtac "== dichotomy
Every solution merges in finite time with an ellipse, or stays above $E_{cr}$ and tends to one motion on the critical one.
uses: convergence, merging". Abort.
Check @Dichotomy.dichotomy.
Print Assumptions Dichotomy.dichotomy.

Goal True. idtac "== displacement-limit
The relative displacement $x_1-x_2$ has a limit.
uses: displacement-paid, energy-decreases". Abort.
Check @DisplacementLimit.displacement_limit.
Print Assumptions DisplacementLimit.displacement_limit.

Goal True. idtac "== displacement-paid
$b\,|z(t)-z(r)|\leqslant E(r)-E(t)$ for the relative displacement $z=x_1-x_2$ and $r\leqslant t$, with or without damping.
uses: energy-rate". Abort.
Check @DisplacementLimit.displacement_paid.
Print Assumptions DisplacementLimit.displacement_paid.

Goal True. idtac "== displacement-unseen
A shift of the initial position of body 2 shifts the relative displacement by as much at all times.
uses: forced-contraction". Abort.
Check @RelativeMotion.displacement_unseen.
Print Assumptions RelativeMotion.displacement_unseen.

Goal True. idtac "== drift
The position of body 2 changes by the integral of its velocity.
uses: no other". Abort.
Check @Drift.drift.
Print Assumptions Drift.drift.

Goal True. idtac "== driven-acceleration
Body 2 changes its velocity by at most $b/m_2$ times the time, whatever the force.
uses: no other". Abort.
Check @Forced.only_gentle.
Print Assumptions Forced.only_gentle.

Goal True. idtac "== edges-isolated
Around every time of a solution: with $v_1=v_2$ (3) gives an acceleration of absolute value below $b/m_2$, but perhaps at that time itself.
uses: free-case, interface-no-zeno, interface-one-strength, mode-slip, mode-stick, stuck-load". Abort.
Check @EdgesIsolated.edges_isolated.
Print Assumptions EdgesIsolated.edges_isolated.

Goal True. idtac "== ellipse-iff
An ellipse on $S$ is a solution exactly if its energy is at most $E_{cr}$.
uses: ellipse-solution, sticks-iff". Abort.
Check @SwitchingSurface.ellipse_iff.
Print Assumptions SwitchingSurface.ellipse_iff.

Goal True. idtac "== ellipse-solution
Every ellipse on $S$ with energy up to $E_{cr}$ is a solution: the stuck pair.
uses: no other". Abort.
Check @Stick.ellipse_solution.
Print Assumptions Stick.ellipse_solution.

Goal True. idtac "== ellipse-stable
The energy distance of a solution to a stuck motion never grows.
uses: contraction, ellipse-solution". Abort.
Check @Stick.ellipse_stable.
Print Assumptions Stick.ellipse_stable.

Goal True. idtac "== energy-decreases
The energy never increases, with or without damping.
uses: no other". Abort.
Check @Pair.energy_decreases.
Print Assumptions Pair.energy_decreases.

Goal True. idtac "== energy-limit
The limit of the energy is at most $E_{cr}$.
uses: contact, energy-decreases, energy-rate". Abort.
Check @EnergyLimit.limit_not_above.
Print Assumptions EnergyLimit.limit_not_above.

Goal True. idtac "== energy-rate
$\dot E=-b|v_1-v_2|-a_1v_1^2$ at every time, from the right.
uses: no other". Abort.
Check @Pair.energy_rate.
Print Assumptions Pair.energy_rate.

Goal True. idtac "== entrains
With $a_1>0$ every motion tends to the stuck response to a sinusoidal force of amplitude up to $U_*$.
uses: forced-approach". Abort.
Check @ForcedCapture.entrains.
Print Assumptions ForcedCapture.entrains.

Goal True. idtac "== euler-law
Forward Euler with the step $h$ and a friction in $[-b,b]$ of the sign of the slip: $N(t)^2\leqslant N(0)^2+h\,t\,C(C+C')$, $C$ and $C'$ the speeds of its steps and of the motion in the energy norm.
uses: no other". Abort.
Check @EulerLaw.euler_law.
Print Assumptions EulerLaw.euler_law.

Goal True. idtac "== euler-slip-step
For $a_1=0$, $\omega_1^2=a_2/m_1$: a step $h$ of forward Euler in which the slip with the friction at its beginning does not end adds at most $\frac12h^2\omega_1B$ to the energy distance from a motion, $B^2=a_2v_1^2+m_1\dot v_1^2$.
uses: arc-begins, forced-contraction, free-case". Abort.
Check @EulerSlip.euler_slip_step.
Print Assumptions EulerSlip.euler_slip_step.

Goal True. idtac "== excursion-depth
$c'=h$; $c$ takes every positive value once on $(0,2\pi)$ and is concave as a function of $h^2$.
uses: depth-upper, h-increases". Abort.
Check @ExcursionShape.deepens.
Print Assumptions ExcursionShape.deepens.

Goal True. idtac "== excursion-rise
$h$ increases on $(0,2\pi)$, takes every positive value once and has $h''>0$; $h-d\cot(\theta/2)$ increases for every $d\geqslant 0$.
uses: h-increases". Abort.
Check @ExcursionShape.rise.
Print Assumptions ExcursionShape.rise.

Goal True. idtac "== excursions-grow
Of two excursions from a ray the faster one lasts longer, goes deeper and loses more energy.
uses: gap-slip, h-increases". Abort.
Check @ExcursionShape.grow_together.
Print Assumptions ExcursionShape.grow_together.

Goal True. idtac "== exit-and-entry-times
For every solution that never merges: entries and exits alternate; stays on $S_0$ tend to $\pi/\Omega$, slips to 0.
uses: arc-to-ray, contact, cycle, cycle-time, depth-lower, depth-upper, energy-decreases, energy-limit, exits, first-re-entry, h-increases, turning-point". Abort.
Check @OneOverT.times.
Print Assumptions OneOverT.times.

Goal True. idtac "== exit-energy
Along the orbit of exits the energy at each is $E_{cr}(1+q\,y)$.
uses: exits, ray-energy". Abort.
Check @ExitOrbit.exit_energy.
Print Assumptions ExitOrbit.exit_energy.

Goal True. idtac "== exits
From a ray with slip angle up to $\pi$ and $r\,c^2<h^2$ the exits of a solution follow the orbit of the return map.
uses: cycle, h-increases, turning-point". Abort.
Check @ExitOrbit.exits.
Print Assumptions ExitOrbit.exits.

Goal True. idtac "== exits-near-endpoints
A solution that never merges leaves $S_0$ exactly where $|x_1|=L$; its entries tend to $|x_1|=L$, and the velocities at both to 0.
uses: energy-decreases, energy-limit, exit-and-entry-times, sticks-inside". Abort.
Check @ExitPlaces.exits_near_endpoints.
Print Assumptions ExitPlaces.exits_near_endpoints.

Goal True. idtac "== falling-parts
Where friction falls with speed at a constant slope, the difference of two slips has an exponentially growing mode, whatever the damper of body 1.
uses: no other". Abort.
Check @FallingFriction.slips_part.
Print Assumptions FallingFriction.slips_part.

Goal True. idtac "== filippov-forced
Under any integrable force a Filippov solution is a motion: what is proved of all motions is true of it.
uses: no other". Abort.
Check @Filippov.filippov_forced.
Print Assumptions Filippov.filippov_forced.

Goal True. idtac "== filippov-iff
A solution is what Filippov calls one: absolutely continuous, and in the differential inclusion at almost all times.
uses: forced-filippov-iff, free-case". Abort.
Check @Filippov.filippov_iff.
Print Assumptions Filippov.filippov_iff.

Goal True. idtac "== filippov-well-posed
From every initial state there is exactly one Filippov solution, with or without damping.
uses: filippov-forced, forced-well-posed". Abort.
Check @Filippov.filippov_well_posed.
Print Assumptions Filippov.filippov_well_posed.

Goal True. idtac "== first-adhesion
The scene of Fig. 5: every solution sticks from 4.549769479... s to 4.579537997... s, not before, slips until 4.771754480... s, including 4.7 s, and sticks again.
uses: free-case, trajectory-velocities". Abort.
Check @FirstAdhesion.first_adhesion.
Print Assumptions FirstAdhesion.first_adhesion.

Goal True. idtac "== first-landing
From a ray with the exit speed of an angle: one slip up to that angle, to the energy $E_{cr}(1+q(h^2-r\,c^2))$, and merging there exactly if $h^2\leqslant r\,c^2$.
uses: gap-slip, sticks-iff". Abort.
Check @AfterOneSlip.merges_at_first_landing.
Print Assumptions AfterOneSlip.merges_at_first_landing.

Goal True. idtac "== first-re-entry
From beyond $S_0$, or from an exit ray, a solution returns to $S_0$ after finitely many slips, for every mass ratio.
uses: crossing, energy-decreases, gap-slip, h-increases". Abort.
Check @ReturnToS0.returns.
Print Assumptions ReturnToS0.returns.

Goal True. idtac "== follow
A solution that meets the start of an explicit arc that satisfies the law follows it.
uses: follow-forced-arc, free-case". Abort.
Check @FollowArc.follow.
Print Assumptions FollowArc.follow.

Goal True. idtac "== follow-forced-arc
A motion under a force that meets the start of such an arc, at any time, follows it.
uses: arc-begins, forced-contraction". Abort.
Check @Arcs.follow_arc.
Print Assumptions Arcs.follow_arc.

Goal True. idtac "== forced-approach
With $a_1>0$ any two motions under one bounded force approach each other.
uses: driven-acceleration, forced-bounded, interface-one-strength". Abort.
Check @BoundedMotions.approach.
Print Assumptions BoundedMotions.approach.

Goal True. idtac "== forced-bounded
With $a_1>0$ every motion under a bounded force is bounded.
uses: no other". Abort.
Check @BoundedMotions.bounded.
Print Assumptions BoundedMotions.bounded.

Goal True. idtac "== forced-contraction
Under any force the flow is non-expansive in the energy norm.
uses: no other". Abort.
Check @Forced.forced_contraction.
Print Assumptions Forced.forced_contraction.

Goal True. idtac "== forced-energy-rate
$\dot E=u\,v_1-a_1v_1^2-b|v_1-v_2|$, where the impulse has the rate $u$ from the right.
uses: no other". Abort.
Check @Forced.forced_energy_rate.
Print Assumptions Forced.forced_energy_rate.

Goal True. idtac "== forced-filippov-iff
Under an integrable force that is continuous at almost every time the motions are the Filippov solutions, and only they.
uses: filippov-forced". Abort.
Check @Filippov.forced_filippov_iff.
Print Assumptions Filippov.forced_filippov_iff.

Goal True. idtac "== forced-switching-iff
Under any force the absolutely continuous solutions of (3), (4), met at almost every time, are the Filippov solutions with $|\Lambda|<b$ at almost every time with $v_1=v_2$, and only they.
uses: no other". Abort.
Check @Switching.forced_switching_iff.
Print Assumptions Switching.forced_switching_iff.

Goal True. idtac "== forced-well-posed
Under any force with a continuous impulse there is exactly one solution from every initial state.
uses: forced-contraction, interface-one-strength, interface-well-posed". Abort.
Check @ForcedExistence.forced_well_posed.
Print Assumptions ForcedExistence.forced_well_posed.

Goal True. idtac "== free-case
Without a force the forced system is the free system.
uses: no other". Abort.
Check @Forced.free_case.
Print Assumptions Forced.free_case.

Goal True. idtac "== gap-slip
A slip from $S$ with a gap and the initial speed of an angle, in closed form up to that angle, where it ends.
uses: follow, h-increases". Abort.
Check @SlipFromGap.gap_slip.
Print Assumptions SlipFromGap.gap_slip.

Goal True. idtac "== growth-by-place
Where $|b-\tilde b|\leqslant\ell|x_1-\tilde x_1|$ along two motions: $N(t)\leqslant e^{\gamma t}N(0)$, $\gamma=\ell\sqrt{(m_1+m_2)/(m_1m_2a_2)}$.
uses: no other". Abort.
Check @Interface.growth_by_place.
Print Assumptions Interface.growth_by_place.

Goal True. idtac "== growth-by-speed
Where $b$ falls by at most $\ell$ times the increase of $|\dot z|$: $N(t)\leqslant e^{\gamma t}N(0)$, $\gamma=\ell(m_1+m_2)/(m_1m_2)$.
uses: no other". Abort.
Check @Interface.growth_by_speed.
Print Assumptions Interface.growth_by_speed.

Goal True. idtac "== growth-by-state
Where $|b-\tilde b|\leqslant\ell(|x_1-\tilde x_1|+|z-\tilde z|+||\dot z|-|\dot{\tilde z}||)$ along two motions, $N^2+(z-\tilde z)^2$ grows at most as $e^{2\gamma t}$, $\gamma=\ell\sqrt{\kappa/a_2}+(\ell+1)\sqrt\kappa+\ell\kappa$.
uses: no other". Abort.
Check @Interface.growth_by_state.
Print Assumptions Interface.growth_by_state.

Goal True. idtac "== h-increases
$h$ increases on $(0,2\pi)$: no two slip angles have the same exit speed.
uses: no other". Abort.
Check @Excursion.h_increases.
Print Assumptions Excursion.h_increases.

Goal True. idtac "== heavy-damping
As $a_1\to\infty$, from a given state: from any time on $|v_1|$ is of the order $1/a_1$; in a slip of sign $\sigma$ that lasts any time $a_2x_1+a_1v_1$ tends to $-b\sigma$; and the time after which the pair sticks permanently tends to $m_2|v_2(0)|/b$.
uses: contact, energy-decreases, free-case". Abort.
Check @HeavyDamper.heavy_damping.
Print Assumptions HeavyDamper.heavy_damping.

Goal True. idtac "== heavy-never-merges
For $m_1/m_2>-\cos 2\varphi^*$: no solution that has touched $S$ above $E_{cr}$ ever merges, after whatever number of slips.
uses: arc-to-ray, energy-decreases, first-landing, first-re-entry, gap-slip, h-increases, no-low-level, no-merging-from-S0". Abort.
Check @MergingByMassRatio.heavy_never_merges.
Print Assumptions MergingByMassRatio.heavy_never_merges.

Goal True. idtac "== inclusion-contraction
The flow of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, is non-expansive in the energy norm.
uses: inclusion-defects". Abort.
Check @MonotoneInclusion.contracts.
Print Assumptions MonotoneInclusion.contracts.

Goal True. idtac "== inclusion-defects
Two motions of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, separate by at most the integral of the norm of their defects.
uses: no other". Abort.
Check @MonotoneInclusion.defects_add.
Print Assumptions MonotoneInclusion.defects_add.

Goal True. idtac "== inclusion-synchronises
Any force that brakes: the path of the slip is at most $E(0)/\beta$ long, what moves no faster has a limit at most $E/\beta$ away, and a slip that cannot jump tends to 0.
uses: no other". Abort.
Check @MonotoneInclusion.brakes_synchronise.
Print Assumptions MonotoneInclusion.brakes_synchronise.

Goal True. idtac "== interface-contraction
Two motions under one force with a friction of one strength $b$ along both, as any $b(t)$ has, never move apart in the energy norm.
uses: no other". Abort.
Check @Interface.interface_contraction.
Print Assumptions Interface.interface_contraction.

Goal True. idtac "== interface-distance-rate
Where the frictions $f,\tilde f$ of two motions exist from the right, $\tfrac12\tfrac{d}{dt}N^2=(u-\tilde u)(v_1-\tilde v_1)-a_1(v_1-\tilde v_1)^2-(f-\tilde f)(\dot z-\dot{\tilde z})$.
uses: no other". Abort.
Check @Interface.interface_distance_rate.
Print Assumptions Interface.interface_distance_rate.

Goal True. idtac "== interface-energy-rate
With a friction of the strength $b(t)$, whatever it depends on, $\dot E=u\,v_1-a_1v_1^2-b(t)|v_1-v_2|$, where the impulse has the rate $u$ from the right.
uses: no other". Abort.
Check @Interface.interface_energy_rate.
Print Assumptions Interface.interface_energy_rate.

Goal True. idtac "== interface-input-to-state
With a friction of one strength $b(t)$, under two forces: $N(t)\leqslant N(r)+m_1^{-1/2}\int_r^t|u-\tilde u|$, $\frac12N^2$ the energy of the difference.
uses: no other". Abort.
Check @Interface.interface_input_to_state.
Print Assumptions Interface.interface_input_to_state.

Goal True. idtac "== interface-no-zeno
Under a piecewise analytic force and with a strength $b>0$ that is constant on pieces, finitely many in every bounded time, every bounded time interval has finitely many mode changes.
uses: interface-one-strength, interface-well-posed, mode-slip, mode-stick". Abort.
Check @InterfaceMode.interface_no_zeno.
Print Assumptions InterfaceMode.interface_no_zeno.

Goal True. idtac "== interface-one-strength
A friction of one strength at all times: the motions under a force, and only they.
uses: no other". Abort.
Check @Interface.rubs_constant.
Print Assumptions Interface.rubs_constant.

Goal True. idtac "== interface-rule
Where the strength $b$ is constant for a while from a contact on: stick for $|\Lambda|<b$, slip with the sign of $\Lambda$ for $|\Lambda|>b$, at $\Lambda=\pm b$ the first nonzero derivative, and stick at the edge where all are 0 and the force is analytic.
uses: interface-one-strength, interface-well-posed, mode-marginal, mode-slip, mode-stick, mode-tie". Abort.
Check @InterfaceMode.interface_rule.
Print Assumptions InterfaceMode.interface_rule.

Goal True. idtac "== interface-synchronises
Without a force, with a strength between $b_{\min}>0$ and $b_{\max}$, whatever it depends on: $\dot E\leqslant-b_{\min}|\dot z|$, $\dot z\to 0$, and $z$ has a limit.
uses: interface-energy-rate". Abort.
Check @Interface.interface_synchronises.
Print Assumptions Interface.interface_synchronises.

Goal True. idtac "== interface-well-posed
With a friction of at most $b(t)\geqslant 0$ against the slip, where $b$ is the rate from the right of a continuous function, there is exactly one motion from every initial state.
uses: interface-contraction". Abort.
Check @InterfaceExists.interface_well_posed.
Print Assumptions InterfaceExists.interface_well_posed.

Goal True. idtac "== itinerary-creeps
$m_1=m_2=1$, $a_2=200$, $b=0.5$, $\dot x_1(0)=0.21$: the energy stays above $E_{cr}$, and the motion tends to one on the critical ellipse.
uses: dichotomy, energy-decreases, follow-forced-arc, forced-contraction, free-case, heavy-never-merges, interface-one-strength, interface-well-posed". Abort.
Check @CreepingScenes.itinerary_creeps.
Print Assumptions CreepingScenes.itinerary_creeps.

Goal True. idtac "== jump-ill-posed
With two coefficients of friction and $a_1=0$ a stick with a load between them can end at each of a continuum of times.
uses: free-case, interface-one-strength, interface-well-posed, slips-beyond". Abort.
Check @FallingFriction.sticks_left_at_will.
Print Assumptions FallingFriction.sticks_left_at_will.

Goal True. idtac "== jump-moves-strip
The state is continuous whatever the force does; a jump of the force moves the strip $|\Lambda|\leqslant b$.
uses: no other". Abort.
Check @RuleOfModes.jump_moves_strip.
Print Assumptions RuleOfModes.jump_moves_strip.

Goal True. idtac "== kappa-large
Where merging is possible, the longest slip that ends in $S_0$ is longer than the angle $4\pi/3$.
uses: turning-point". Abort.
Check @KappaBound.kappa_large.
Print Assumptions KappaBound.kappa_large.

Goal True. idtac "== keeps-offset
$m_1=m_2=a_1=a_2=b=1$, $u=\frac12\sin t$: the reference $-\frac14(\sin t+\cos t)$ is a motion, and one that starts with its $x_2$ and $v_2$, body 1 at rest at 0, takes on its velocities and keeps an offset of $x_2$ between $-266.2$ and $-266.1$ mm.
uses: follow-forced-arc, forced-approach, forced-contraction, interface-one-strength, interface-well-posed". Abort.
Check @Offset.keeps_offset.
Print Assumptions Offset.keeps_offset.

Goal True. idtac "== law-satisfies-case-study
Case study: every Filippov solution satisfies (11), (12) at almost every time.
uses: case-study-reduction, forced-switching-iff, switching-iff". Abort.
Check @CaseStudy.law_case_study.
Print Assumptions CaseStudy.law_case_study.

Goal True. idtac "== law-with-error
From a ray with $y_0\leqslant(\pi/2-1)^2$, given $g\leqslant\pi G/c^2$, $\pi G/(r\,c^2)\leqslant g'$ and $F\,(1+\sqrt{1-rs})/(h\,s)\leqslant f$ at all slip angles up to $\pi/2$, with $g\leqslant 0\leqslant g',f$: $(g\,y_0-f\sqrt{y_0})/r\leqslant R_n\leqslant g'y_0$ at every exit.
uses: depth-upper, exit-energy, exits, h-increases, turning-point". Abort.
Check @LawWithError.law_with_error.
Print Assumptions LawWithError.law_with_error.

Goal True. idtac "== least-amplitude
To bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, takes exactly $b+\beta\tau/g(\tau)$, where $g'\geqslant 0$ up to $\tau$.
uses: arc-begins, arrival-needs, follow-forced-arc". Abort.
Check @LeastAmplitude.least_amplitude.
Print Assumptions LeastAmplitude.least_amplitude.

Goal True. idtac "== least-amplitude-undamped
$a_1=0$, $\theta=\omega_1\tau\leqslant\pi/2$: to bring body 2 to rest at $D$ in the least time, from rest with $x_1=0$, takes exactly $b+m_1\beta\,\theta/\sin\theta$.
uses: least-amplitude". Abort.
Check @LeastAmplitude.least_amplitude_undamped.
Print Assumptions LeastAmplitude.least_amplitude_undamped.

Goal True. idtac "== least-time
From rest to rest over $D$ takes at least $2\sqrt{m_2D/b}$, whatever the force.
uses: reach". Abort.
Check @Forced.least_time.
Print Assumptions Forced.least_time.

Goal True. idtac "== least-time-attained
The least time $2\sqrt{m_2D/b}$ from rest to rest over $D$ is attained.
uses: no other". Abort.
Check @Forced.least_time_attained.
Print Assumptions Forced.least_time_attained.

Goal True. idtac "== leaves-by
After an excursion from a ray that re-enters $S_0$ above $E_{cr}$ the pair leaves by the other ray if $\theta<\theta_v$, and by the same if $\theta>\theta_v$.
uses: arc-to-left-ray, gap-slip". Abort.
Check @ExcursionShape.leaves_by.
Print Assumptions ExcursionShape.leaves_by.

Goal True. idtac "== light-driver
As $m_1/m_2\to 0$ the values of $h^2$ at both roots of $h=\sqrt r\,c$ tend to those at the two roots of $h=c$.
uses: depth-upper, h-increases, turning-point". Abort.
Check @MergingAngles.light_driver.
Print Assumptions MergingAngles.light_driver.

Goal True. idtac "== literal-reference
A pair that sticks has the velocity $v$ under (3), (4) and some force exactly if $v$ is absolutely continuous with $|\dot v|<b/m_2$ at almost every time, wherever body 1 starts.
uses: forced-switching-iff". Abort.
Check @StuckReferences.literal_reference.
Print Assumptions StuckReferences.literal_reference.

Goal True. idtac "== literal-solutions
Under an integrable force that is continuous at almost every time (3), (4) have a solution from the start of a motion exactly if that has $|\Lambda|\neq b$ at almost every time with $v_1=v_2$; every such solution is that motion.
uses: filippov-forced, forced-contraction, forced-switching-iff". Abort.
Check @Switching.literal_solutions.
Print Assumptions Switching.literal_solutions.

Goal True. idtac "== literal-transfer
Under (3), (4) a stuck pair takes body 2 from rest to rest over any $D$ of either sign in any time above $2\sqrt{m_2|D|/b}$, and stays, under a force that is continuous at almost every time.
uses: no other". Abort.
Check @StuckReferences.literal_transfer.
Print Assumptions StuckReferences.literal_transfer.

Goal True. idtac "== long-time
A solution that never merges comes to exits where $w=\frac{C}{\tau}(1-\frac{\pi B\ln(\alpha\tau/\pi)+K}{\tau}+O(\tau^{-3/2}))$, given the bounds of law-with-error.
uses: arc-to-ray, contact, cycle-time, depth-lower, depth-upper, energy-decreases, energy-limit, exit-energy, exits, first-re-entry, h-increases, law-with-error, return-map-rate, turning-point". Abort.
Check @LongTime.long_time.
Print Assumptions LongTime.long_time.

Goal True. idtac "== margin
The one numerical inequality of the merging set, enclosed in balls by the kernel.
uses: no other". Abort.
Check @ShortSlipMargin.margin.
Print Assumptions ShortSlipMargin.margin.

Goal True. idtac "== merging
Once its energy is at most $E_{cr}$, a solution merges with an ellipse within a bounded time.
uses: capture, contact, energy-decreases". Abort.
Check @Stick.merging.
Print Assumptions Stick.merging.

Goal True. idtac "== merging-energies
Of the solutions that are on $S_0$ with one energy above $E_{cr}$ all merge, or none; for $0<w\leqslant q(\pi/2-1)^2$ none; and no interval of energies that merge contains two with one between them that does not.
uses: arc-to-ray, free-case, interface-one-strength, interface-well-posed, no-merging-from-S0, sticks-iff, uniqueness". Abort.
Check @OneEnergy.merging_energies.
Print Assumptions OneEnergy.merging_energies.

Goal True. idtac "== merging-set
For $m_1/m_2\leqslant-\cos 2\varphi^*$ the equation $h=\sqrt r\,c$ has two roots, which are one at equality; the energies on $S_0$ above $E_{cr}$ from the one root to the other, and no others, merge at the first contact, and they, and no others, at the first re-entry, after any number of crossings; those below never merge.
uses: alternation, arc-to-ray, depth-upper, energy-decreases, first-landing, first-re-entry, gap-slip, h-increases, kappa-large, margin, merging-threshold, no-merging-from-S0, ray-energy, re-entry, sticks-iff, turning-point". Abort.
Check @MergingEnergies.merging_set.
Print Assumptions MergingEnergies.merging_set.

Goal True. idtac "== merging-threshold
$h^2>r\,c^2$ at all slip angles below $2\pi$ exactly if $m_1/m_2>-\cos 2\varphi^*$; else not at $2\varphi^*$.
uses: turning-point". Abort.
Check @TurningFunction.threshold.
Print Assumptions TurningFunction.threshold.

Goal True. idtac "== mode-marginal
Where all these derivatives are 0 and the force is analytic, the pair sticks at the load $\pm b$, with the acceleration of the slip.
uses: follow-forced-arc". Abort.
Check @RuleOfModes.marginal.
Print Assumptions RuleOfModes.marginal.

Goal True. idtac "== mode-slip
At a contact with $|\Lambda|>b$, where $u$ is continuous from the right, it slips at once, with the sign of the load $\Lambda$.
uses: no other". Abort.
Check @ModeAtContact.slips_at.
Print Assumptions ModeAtContact.slips_at.

Goal True. idtac "== mode-stick
At a contact with $|\Lambda|<b$, where $u$ is continuous from the right, the pair sticks for a while.
uses: no other". Abort.
Check @ModeAtContact.sticks_at.
Print Assumptions ModeAtContact.sticks_at.

Goal True. idtac "== mode-tie
At a contact with $\Lambda=\pm b$, under a smooth force, the first nonzero derivative of the excess of the force over that which keeps the load at $\pm b$ decides.
uses: no other". Abort.
Check @ModeAtContact.tie_rule.
Print Assumptions ModeAtContact.tie_rule.

Goal True. idtac "== momentum-balance
Every solution of (3), (4) has $m_1\dot v_1+a_1v_1+a_2x_1+m_2\dot v_2=u$ at almost every time: the forces between the bodies add up to nothing.
uses: forced-switching-iff". Abort.
Check @Switching.momentum_balance.
Print Assumptions Switching.momentum_balance.

Goal True. idtac "== must-stick
At a time at which body 2 accelerates by less than $b/m_2$, $v_1=v_2$.
uses: no other". Abort.
Check @Forced.must_stick.
Print Assumptions Forced.must_stick.

Goal True. idtac "== never-merges
From an exit ray with slip angle up to $\pi$ and $r\,c^2<h^2$ the energy stays above $E_{cr}$ at all later times.
uses: cycle-time, depth-lower, energy-decreases, exit-energy, h-increases, turning-point". Abort.
Check @SharpRate.never_merges.
Print Assumptions SharpRate.never_merges.

Goal True. idtac "== no-drift
With $a_1>0$, if the force changes its sign after half a period, so does the periodic response, and body 2 returns.
uses: forced-approach". Abort.
Check @Drift.no_drift.
Print Assumptions Drift.no_drift.

Goal True. idtac "== no-low-level
For $m_1/m_2>-\cos 2\varphi^*$: no slip from $S$, whatever its gap and initial speed, ends at or below $E_{cr}$.
uses: merging-threshold". Abort.
Check @LevelAfterSlip.no_low_level.
Print Assumptions LevelAfterSlip.no_low_level.

Goal True. idtac "== no-merging-from-S0
From $S_0$ slightly above $E_{cr}$ a solution never merges, tends to one critical motion and obeys the sharp law.
uses: arc-to-ray, cycle-time, depth-lower, depth-upper, dichotomy, energy-decreases, exit-energy, h-increases, never-merges, return-map-rate, turning-point". Abort.
Check @SharpLaw.no_merging_from_S0.
Print Assumptions SharpLaw.no_merging_from_S0.

Goal True. idtac "== no-solution-under-control
Case study, $b=0.5$, from rest at 0 under $u=1+50t^2$: (3), (4) have no solution.
uses: literal-solutions". Abort.
Check @Switching.no_solution_under_control.
Print Assumptions Switching.no_solution_under_control.

Goal True. idtac "== no-uniform-lower-rate
From every energy above $E_{cr}$ some solutions never merge and are arbitrarily close to $E_{cr}$ from the time $\sqrt{2E(0)m_2}/b$ on.
uses: arc-begins, energy-decreases, free-case, no-merging-from-S0". Abort.
Check @UniformRate.no_lower_constant.
Print Assumptions UniformRate.no_lower_constant.

Goal True. idtac "== nonstop-above-resonance
$a_1=0$ and $\omega$ above body 1's own frequency: the motion of nonstop-iff exists exactly from $U_{**}$ on, without a condition.
uses: nonstop-undamped". Abort.
Check @NonstopUndamped.above_resonance.
Print Assumptions NonstopUndamped.above_resonance.

Goal True. idtac "== nonstop-attracts
With $a_1>0$ a motion of nonstop-iff attracts every motion under its force.
uses: forced-approach". Abort.
Check @NonstopDamped.nonstop_attracts.
Print Assumptions NonstopDamped.nonstop_attracts.

Goal True. idtac "== nonstop-by-halves
A motion with the force's period that slips one way for half of it and then the other way exists exactly where one exists that also repeats with the opposite sign; each for some phase of the force.
uses: no other". Abort.
Check @HalfPeriod.by_halves_iff.
Print Assumptions HalfPeriod.by_halves_iff.

Goal True. idtac "== nonstop-by-halves-needs
Below $U_{**}$ no motion with the force's period slips one way for half of it and then the other way, whatever the relative velocity does at $U_{**}$, if it leaves the turn there ($A>0$).
uses: no other". Abort.
Check @HalfPeriod.by_halves_needs.
Print Assumptions HalfPeriod.by_halves_needs.

Goal True. idtac "== nonstop-damped
$a_1>0$, $a_1^2<4m_1a_2$: the theorem nonstop-iff with $U_{**}$ in closed form.
uses: nonstop-iff". Abort.
Check @NonstopDamped.damped_iff.
Print Assumptions NonstopDamped.damped_iff.

Goal True. idtac "== nonstop-iff
$a_1\geqslant 0$: a motion that slips one way for half a period, and then is its own negative, exists exactly from $U_{**}$ on, if $A>0$ and its relative velocity keeps its sign at $U_{**}$.
uses: antiperiodic, arc-begins". Abort.
Check @Nonstop.nonstop_iff.
Print Assumptions Nonstop.nonstop_iff.

Goal True. idtac "== nonstop-overdamped
$a_1^2>4m_1a_2$: the theorem nonstop-iff with $U_{**}$ in closed form, by two exponentials.
uses: nonstop-iff". Abort.
Check @NonstopOverdamped.overdamped_iff.
Print Assumptions NonstopOverdamped.overdamped_iff.

Goal True. idtac "== nonstop-undamped
$a_1=0$: the theorem nonstop-iff with $U_{**}$ in closed form, off the resonances of body 1.
uses: nonstop-iff". Abort.
Check @NonstopUndamped.undamped_iff.
Print Assumptions NonstopUndamped.undamped_iff.

Goal True. idtac "== one-contact
Every slip from $S$ with a gap $d\geqslant 0$ and a push $\nu$ ($\nu>0$ if $d=0$) ends at the one angle with $\nu=h-d\cot(\theta/2)$.
uses: excursion-rise, gap-slip, h-increases". Abort.
Check @ExcursionShape.one_contact.
Print Assumptions ExcursionShape.one_contact.

Goal True. idtac "== one-over-t
From $S_0$ slightly above $E_{cr}$, for each $T>0$: $c_1/t\leqslant E/E_{cr}-1\leqslant c_2/t$ from $T$ on, explicit, $c_1$ by $T$.
uses: two-sided-rate". Abort.
Check @OneOverT.one_over_t.
Print Assumptions OneOverT.one_over_t.

Goal True. idtac "== pair-inclusion
The pair under a force is the case with one direction.
uses: no other". Abort.
Check @FrictionSystems.pair_is_an_inclusion.
Print Assumptions FrictionSystems.pair_is_an_inclusion.

Goal True. idtac "== peaks-fall
Where a motion never merges, the peaks of $|v_1|$ between entries tend to $L\Omega$ like $1/t$: at late entries each is at $x_1=0$, in stick, and $t\,(|v_1|-L\Omega)\to\frac12L\Omega\cdot\frac{4\pi}{9}\frac{m_1}{m_2}\sqrt{M/a_2}$.
uses: arc-to-ray, contact, cycle, cycle-time, depth-lower, depth-upper, energy-decreases, energy-limit, exits, first-landing, first-re-entry, gap-slip, h-increases, ray-energy, sharp-law, turning-point". Abort.
Check @Fading.peaks_fall.
Print Assumptions Fading.peaks_fall.

Goal True. idtac "== periodic-response
With $a_1>0$ a periodic bounded force has exactly one periodic motion, and it attracts every motion.
uses: forced-approach, forced-bounded, forced-contraction, interface-one-strength, interface-well-posed". Abort.
Check @PeriodicMotion.response.
Print Assumptions PeriodicMotion.response.

Goal True. idtac "== plane-landing
In slip, $G=b|s|+\Lambda\cdot s$ has the rate $-\kappa(b^2-|\Lambda|^2)+\dot\Lambda\cdot s$.
uses: no other". Abort.
Check @RoundFriction.landing_rate.
Print Assumptions RoundFriction.landing_rate.

Goal True. idtac "== plane-stuck-energies
On a stuck ellipse the load stays within isotropic friction always up to $E_{cr}$, never beyond $2E_{cr}$; on a line exactly up to the first, on a circle exactly up to the second.
uses: plane-stuck-iff". Abort.
Check @RoundFriction.stuck_energies.
Print Assumptions RoundFriction.stuck_energies.

Goal True. idtac "== plane-stuck-iff
On a stuck ellipse the load stays within isotropic friction permanently exactly if the semi-major axis is at most $L$.
uses: no other". Abort.
Check @RoundFriction.stuck_iff.
Print Assumptions RoundFriction.stuck_iff.

Goal True. idtac "== plane-stuck-load
A stuck pair in the plane moves on an ellipse; the force on body 2 is within $b$ exactly while the place is within $L$; its energy by the ellipse, and $E_{cr}=a_2L^2/2$.
uses: no other". Abort.
Check @RoundFriction.stuck_load.
Print Assumptions RoundFriction.stuck_load.

Goal True. idtac "== rate-above
While $v_1>v_2$ the relative velocity has the rate $\Phi_+\cdot n_S$.
uses: no other". Abort.
Check @SwitchingSurface.rate_above.
Print Assumptions SwitchingSurface.rate_above.

Goal True. idtac "== rate-below
While $v_1<v_2$ the relative velocity has the rate $\Phi_-\cdot n_S$.
uses: no other". Abort.
Check @SwitchingSurface.rate_below.
Print Assumptions SwitchingSurface.rate_below.

Goal True. idtac "== rate-bounds
From an exit ray with $y_0\leqslant\tfrac{4}{9}$ on, $w$ lies between $q/(1/y_0+A(s/T_-+1))$ and $q/(1/y_0+a'(s/T_+-1))$, the constants explicit in the first excursion.
uses: cycle-time, depth-lower, depth-upper, energy-decreases, exit-energy, h-increases, never-merges, turning-point". Abort.
Check @RateBounds.rate_bounds.
Print Assumptions RateBounds.rate_bounds.

Goal True. idtac "== ray-crossing
From a ray with the exit speed of an angle whose depth is above $2/q$ the pair crosses $S$ and slips on with the other sign.
uses: crossing". Abort.
Check @AfterOneSlip.ray_crossing.
Print Assumptions AfterOneSlip.ray_crossing.

Goal True. idtac "== ray-energy
On an exit ray with the exit speed $h$ the energy is $E_{cr}(1+q\,h^2)$.
uses: no other". Abort.
Check @ExitOrbit.ray_energy.
Print Assumptions ExitOrbit.ray_energy.

Goal True. idtac "== re-entry
A slip from $S$ with a gap and the initial speed of an angle that ends in $S_0$ sticks there permanently exactly if its energy is not above $E_{cr}$.
uses: arc-to-ray, capture, gap-slip, sticks-iff". Abort.
Check @AfterOneSlip.reentry.
Print Assumptions AfterOneSlip.reentry.

Goal True. idtac "== reach
A bound on the position of body 2 at a time, whatever the force.
uses: driven-acceleration". Abort.
Check @Forced.reach.
Print Assumptions Forced.reach.

Goal True. idtac "== resonance-edge
With $a_1=0$, under $u=\frac{4b}{\pi}\sin\omega_1t$ there is a family of motions that slip permanently, one way for half a period and then the other way, in closed form: for $c\geqslant\frac{b}{m_2\omega_1}$, and for no smaller $c$.
uses: antiperiodic, arc-begins". Abort.
Check @AtResonance.edge_family.
Print Assumptions AtResonance.edge_family.

Goal True. idtac "== resonance-edge-bounded
With $a_1=0$, every motion under $u=\frac{4b}{\pi}\sin\omega_1t$ is bounded.
uses: antiperiodic, arc-begins, forced-contraction". Abort.
Check @AtResonance.edge_bounded.
Print Assumptions AtResonance.edge_bounded.

Goal True. idtac "== rest-to-rest
With that amplitude both bodies can be at rest then, if the stuck pair can brake with it in the second half.
uses: arc-begins, follow-forced-arc". Abort.
Check @LeastAmplitude.rest_to_rest.
Print Assumptions LeastAmplitude.rest_to_rest.

Goal True. idtac "== return-alternatives
From $v_1<v_2$ every solution reaches $S_0$, or $S$ beyond its left edge, from where it passes into $v_1>v_2$ at once.
uses: contact, rate-below, slips-beyond, transversal-beyond". Abort.
Check @Consequences.return_alternatives.
Print Assumptions Consequences.return_alternatives.

Goal True. idtac "== return-alternatives-mirror
From $v_1>v_2$ every solution reaches $S_0$, or $S$ beyond its right edge, from where it passes into $v_1<v_2$ at once.
uses: return-alternatives". Abort.
Check @Consequences.return_alternatives_mirror.
Print Assumptions Consequences.return_alternatives_mirror.

Goal True. idtac "== return-map-rate
Along the return map $n\,y_n\to 4/(9r)$.
uses: depth-lower, depth-upper, h-increases". Abort.
Check @ReturnMap.sharp.
Print Assumptions ReturnMap.sharp.

Goal True. idtac "== ring-factor
$|v_1-v_2|\leqslant\sqrt\kappa\,N$, $\kappa=(m_1+m_2)/(m_1m_2)$, and no smaller factor suffices.
uses: no other". Abort.
Check @RelativeMotion.ring_factor.
Print Assumptions RelativeMotion.ring_factor.

Goal True. idtac "== ring-missed
Case study, $b=0.5$, from rest at 4 mm, body 2 at 0 or at 1 mm: both pairs stick permanently, 4 and 3 mm apart, and no region narrower than 1 mm is reached by both relative motions.
uses: sticks-from-5-mm". Abort.
Check @CaseStudy.ring_missed.
Print Assumptions CaseStudy.ring_missed.

Goal True. idtac "== rotating-characteristic
With friction that depends on the speed, the characteristic function at 0 is $X(0)=\frac{\omega^2}{2\rho|D|^2}\frac{d(U^2)}{d\rho}$.
uses: no other". Abort.
Check @RotatingForce.characteristic_at_zero.
Print Assumptions RotatingForce.characteristic_at_zero.

Goal True. idtac "== rotating-motion
Under a rotating force there is a motion with a friction of constant size and the constant speed $\rho$ of slip that solves a quadratic.
uses: no other". Abort.
Check @RotatingForce.circular_motion.
Print Assumptions RotatingForce.circular_motion.

Goal True. idtac "== rotating-threshold
Unless $a_1=0$ and body 1 alone is in resonance: the equation of rotating-motion has a stuck circle up to $U^*$, and exactly above it one positive speed of slip under the friction $b$.
uses: no other". Abort.
Check @RotatingForce.one_threshold.
Print Assumptions RotatingForce.one_threshold.

Goal True. idtac "== rotating-unstable
Where $X(0)<0$, the equations linearised about the slip that rotates with the force have a solution that grows like $e^{\lambda t}$, $\lambda>0$.
uses: no other". Abort.
Check @RotatingUnstable.repels.
Print Assumptions RotatingUnstable.repels.

Goal True. idtac "== scenes-analytic
Piecewise polynomials plus sinusoids are piecewise analytic.
uses: no other". Abort.
Check @Analytic.scenes_are_analytic.
Print Assumptions Analytic.scenes_are_analytic.

Goal True. idtac "== settling-time
For each level above $E_{cr}$ there is one time after which every solution that starts below another level is below it.
uses: contact, energy-decreases, energy-rate". Abort.
Check @UniformRate.settles.
Print Assumptions UniformRate.settles.

Goal True. idtac "== sharp-law
$t\,(E-E_{cr})\to E_{cr}\tfrac{4\pi}{9}\tfrac{m_1}{m_2}\sqrt{M/a_2}$ for every solution that never merges.
uses: contact, energy-decreases, energy-limit, first-re-entry, no-merging-from-S0". Abort.
Check @SharpLaw.sharp_law.
Print Assumptions SharpLaw.sharp_law.

Goal True. idtac "== slip-arc
From the right exit ray with the exit speed $h$ of an angle every solution slips up to that angle, and ends where the closed form says.
uses: gap-slip". Abort.
Check @SlipFromGap.slip.
Print Assumptions SlipFromGap.slip.

Goal True. idtac "== slip-rate
In slip the rate of the relative velocity is given by the load in excess of $\pm b$.
uses: no other". Abort.
Check @RuleOfModes.slip_rate.
Print Assumptions RuleOfModes.slip_rate.

Goal True. idtac "== slips-beyond
At a contact beyond $S_0$ every solution slips at once, with the sign of $-x_1$.
uses: gap-slip, h-increases". Abort.
Check @SwitchingSurface.slips_beyond.
Print Assumptions SwitchingSurface.slips_beyond.

Goal True. idtac "== slips-from-6-mm
Case study, $b=0.5$: released at rest at 6 mm every solution slips at once.
uses: slips-from-rest". Abort.
Check @StartFromRest.six_millimetres.
Print Assumptions StartFromRest.six_millimetres.

Goal True. idtac "== slips-from-rest
Case study, $b=0.5$: released at rest at $x_1>5$ mm every solution slips at once.
uses: slips-beyond". Abort.
Check @StartFromRest.slips_from_rest.
Print Assumptions StartFromRest.slips_from_rest.

Goal True. idtac "== slips-on-ray
On an edge of $S_0$, moving outwards, every solution slips at once, with $\dot z$ of the sign of $-x_1$.
uses: first-landing". Abort.
Check @SwitchingSurface.slips_on_ray.
Print Assumptions SwitchingSurface.slips_on_ray.

Goal True. idtac "== slower-than-exponential
The excess energy of a solution that never merges is eventually above every decaying exponential.
uses: sharp-law". Abort.
Check @Consequences.slower_than_exponential.
Print Assumptions Consequences.slower_than_exponential.

Goal True. idtac "== state-well-posed
With a strength $b\geqslant 0$ that depends on $x_1$, $z$ and $|\dot z|$ with bounded slopes there is exactly one motion from every initial state.
uses: growth-by-state". Abort.
Check @InterfaceExists.state_well_posed.
Print Assumptions InterfaceExists.state_well_posed.

Goal True. idtac "== static-few-slips
With static friction above kinetic, where sticks are kept, a free motion has at most $E(0)/e_0$ such slips, $e_0>0$ explicit.
uses: static-slip-costs". Abort.
Check @StaticFriction.few_slips.
Print Assumptions StaticFriction.few_slips.

Goal True. idtac "== static-kept
With static friction above kinetic there is, from every state, a free motion that keeps its sticks.
uses: free-case, interface-one-strength, interface-well-posed". Abort.
Check @SticksKept.sticks_kept.
Print Assumptions SticksKept.sticks_kept.

Goal True. idtac "== static-slip-costs
With static friction above kinetic, where sticks are kept, every slip of a free motion from a contact to the next lasts longer than a fixed time and dissipates at least a fixed energy, both given by $E(0)$.
uses: no other". Abort.
Check @StaticFriction.slip_costs.
Print Assumptions StaticFriction.slip_costs.

Goal True. idtac "== static-sticks-at-last
With static friction above kinetic, by any amount, every free motion that keeps its sticks sticks permanently from some time on.
uses: no other". Abort.
Check @StaticFriction.sticks_at_last.
Print Assumptions StaticFriction.sticks_at_last.

Goal True. idtac "== stick-arc
On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left exit ray, at a time in closed form.
uses: follow". Abort.
Check @Cycle.stick.
Print Assumptions Cycle.stick.

Goal True. idtac "== stick-slip-for-ever
For all $m_1,m_2,a_2,b>0$ there is a solution that sticks and slips in turn without end.
uses: exit-and-entry-times, no-merging-from-S0, well-posed". Abort.
Check @EndlessStickSlip.stick_slip_for_ever.
Print Assumptions EndlessStickSlip.stick_slip_for_ever.

Goal True. idtac "== sticks-from-5-mm
Case study, $b=0.5$: released at rest up to 5 mm every solution sticks permanently.
uses: sticks-from-rest". Abort.
Check @StartFromRest.five_millimetres.
Print Assumptions StartFromRest.five_millimetres.

Goal True. idtac "== sticks-from-rest
Released at rest inside $S_0$ every solution sticks permanently.
uses: sticks-iff". Abort.
Check @StartFromRest.rest_inside.
Print Assumptions StartFromRest.rest_inside.

Goal True. idtac "== sticks-iff
On $S$ the pair sticks permanently exactly if its energy is at most $E_{cr}$.
uses: capture, energy-decreases, energy-limit, energy-rate". Abort.
Check @AfterOneSlip.sticks_iff.
Print Assumptions AfterOneSlip.sticks_iff.

Goal True. idtac "== sticks-inside
On $S_0$, but for the exit rays, every solution sticks for a while.
uses: arc-to-ray, sticks-iff". Abort.
Check @SwitchingSurface.sticks_inside.
Print Assumptions SwitchingSurface.sticks_inside.

Goal True. idtac "== stuck-iff
With $a_1>0$ some solution sticks permanently under a sinusoidal force exactly if its amplitude is at most $U_*$.
uses: driven-acceleration, forced-approach". Abort.
Check @Entrainment.stuck_iff.
Print Assumptions Entrainment.stuck_iff.

Goal True. idtac "== stuck-load
While stuck body 2 has the acceleration $\Lambda/m_2$, and $|\Lambda|\leqslant b$.
uses: driven-acceleration". Abort.
Check @RuleOfModes.stuck_load.
Print Assumptions RuleOfModes.stuck_load.

Goal True. idtac "== stuck-transfer-amplitude
The amplitude of the force of the fastest stuck transfer over $D$ from $x_1=0$.
uses: no other". Abort.
Check @LeastTimeTransfer.stuck_amplitude.
Print Assumptions LeastTimeTransfer.stuck_amplitude.

Goal True. idtac "== switching-iff
The absolutely continuous solutions of (3), (4) without a control, met at almost all times, are Filippov's, and only they.
uses: forced-switching-iff". Abort.
Check @Switching.switching_iff.
Print Assumptions Switching.switching_iff.

Goal True. idtac "== synchronisation
$v_1-v_2\to 0$ for all $m_1,m_2,a_2,b>0$, $a_1\geqslant 0$ and from every start.
uses: free-case, interface-one-strength, interface-synchronises". Abort.
Check @Consequences.relative_velocity_vanishes.
Print Assumptions Consequences.relative_velocity_vanishes.

Goal True. idtac "== synchronises
With $a_1>0$ every motion under a sinusoidal force of amplitude below $U_*$ sticks permanently after a finite time.
uses: entrains". Abort.
Check @ForcedCapture.synchronises.
Print Assumptions ForcedCapture.synchronises.

Goal True. idtac "== system-contraction
The flow of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$, $C$ monotone and friction bounded, is non-expansive in the energy norm.
uses: inclusion-contraction". Abort.
Check @FrictionSystems.system_contracts.
Print Assumptions FrictionSystems.system_contracts.

Goal True. idtac "== system-defects
Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$ and $C$ monotone, under two forces separate by at most the integral of the norm of $M^{-1}(u-\tilde u)$.
uses: inclusion-defects". Abort.
Check @FrictionSystems.system_defects.
Print Assumptions FrictionSystems.system_defects.

Goal True. idtac "== system-parts
Where the dampers supply a power of at most $c|v|^2$, as friction that falls with speed does, two motions separate at most like $e^{ct}$.
uses: no other". Abort.
Check @FrictionSystems.system_parts.
Print Assumptions FrictionSystems.system_parts.

Goal True. idtac "== system-synchronises
Without a force, $M,K\geqslant 0$ and dissipative dampers, any bounded friction with a power of at least $\beta|Bq'|$: $\int|Bq'|\leqslant E(0)/\beta$, the displacement converges, and $Bq'\to 0$ where $|Bq'|$ is Lipschitz.
uses: inclusion-synchronises". Abort.
Check @FrictionSystems.system_synchronises.
Print Assumptions FrictionSystems.system_synchronises.

Goal True. idtac "== third-root-law
For $c,\kappa,K>0$: if $X$ is large at first and $V=0$, and from step to step, while $X$ is large and $V\leqslant 1$, $X$ does not fall and gains $c/X^2$ within $(K\sqrt V+K/X)/X^2$, and $V\geqslant 0$ gains at most $-\kappa V/X+K/X^2$, then $X\to\infty$, $V\to 0$ and $X_n^3/n\to 3c$.
uses: no other". Abort.
Check @ThirdRoot.third_root_law.
Print Assumptions ThirdRoot.third_root_law.

Goal True. idtac "== tie-captive
With damping: the level whose ellipse lies in the sliding region.
uses: no other". Abort.
Check @PairTies.tie_captive.
Print Assumptions PairTies.tie_captive.

Goal True. idtac "== tie-case-study
Equations (11) and (12) of the paper at one time.
uses: no other". Abort.
Check @SwitchingTies.tie_case_study.
Print Assumptions SwitchingTies.tie_case_study.

Goal True. idtac "== tie-critical-energy
The critical energy.
uses: no other". Abort.
Check @PairTies.tie_critical_energy.
Print Assumptions PairTies.tie_critical_energy.

Goal True. idtac "== tie-critical-mass-ratio
The critical mass ratio by the zero of the turning function.
uses: no other". Abort.
Check @SlipTies.tie_critical_mass_ratio.
Print Assumptions SlipTies.tie_critical_mass_ratio.

Goal True. idtac "== tie-depth
The depth of an excursion.
uses: no other". Abort.
Check @SlipTies.tie_depth.
Print Assumptions SlipTies.tie_depth.

Goal True. idtac "== tie-dwell-time
The longest stay off $S$.
uses: no other". Abort.
Check @PairTies.tie_dwell_time.
Print Assumptions PairTies.tie_dwell_time.

Goal True. idtac "== tie-energy
The energy.
uses: no other". Abort.
Check @PairTies.tie_energy.
Print Assumptions PairTies.tie_energy.

Goal True. idtac "== tie-entrained-amplitude
$U_*$, the amplitude up to which the stuck response is a motion.
uses: no other". Abort.
Check @ThresholdTies.tie_entrained_amplitude.
Print Assumptions ThresholdTies.tie_entrained_amplitude.

Goal True. idtac "== tie-forced
A motion under a force obeys the equations of the theory, with impulses of friction and of the force.
uses: no other". Abort.
Check @ForcedTies.tie_forced.
Print Assumptions ForcedTies.tie_forced.

Goal True. idtac "== tie-gap-driven
Slip from $S$ at the gap $d$: driven (driven: of body 2).
uses: no other". Abort.
Check @SlipTies.tie_gap_driven.
Print Assumptions SlipTies.tie_gap_driven.

Goal True. idtac "== tie-gap-place
Slip from $S$ at the gap $d$: place (driven: of body 2).
uses: no other". Abort.
Check @SlipTies.tie_gap_place.
Print Assumptions SlipTies.tie_gap_place.

Goal True. idtac "== tie-gap-speed
Slip from $S$ at the gap $d$: speed (driven: of body 2).
uses: no other". Abort.
Check @SlipTies.tie_gap_speed.
Print Assumptions SlipTies.tie_gap_speed.

Goal True. idtac "== tie-h
$h$: the push whose slip has the angle $\theta$.
uses: no other". Abort.
Check @SlipTies.tie_h.
Print Assumptions SlipTies.tie_h.

Goal True. idtac "== tie-half-angle-h
The same in the half angle.
uses: no other". Abort.
Check @SlipTies.tie_half_angle_h.
Print Assumptions SlipTies.tie_half_angle_h.

Goal True. idtac "== tie-half-time
Half the least time of a transfer.
uses: no other". Abort.
Check @TransferTies.tie_half_time.
Print Assumptions TransferTies.tie_half_time.

Goal True. idtac "== tie-half-width
The half width $L$ of the sliding region.
uses: no other". Abort.
Check @PairTies.tie_half_width.
Print Assumptions PairTies.tie_half_width.

Goal True. idtac "== tie-least-amplitude
The least amplitude with which body 2 arrives in the least time, by body 1's impulse response.
uses: least-amplitude". Abort.
Check @TransferTies.tie_least_amplitude.
Print Assumptions TransferTies.tie_least_amplitude.

Goal True. idtac "== tie-least-amplitude-undamped
The same without a damper, by the angle that body 1 turns in half of that time.
uses: least-amplitude-undamped". Abort.
Check @TransferTies.tie_least_amplitude_undamped.
Print Assumptions TransferTies.tie_least_amplitude_undamped.

Goal True. idtac "== tie-leave
The size of the part out of phase with which it leaves by an edge.
uses: no other". Abort.
Check @ThresholdTies.tie_leave.
Print Assumptions ThresholdTies.tie_leave.

Goal True. idtac "== tie-level
The energy level at the end of a slip from the gap $d$.
uses: tie-depth, tie-half-angle-h". Abort.
Check @SlipTies.tie_level.
Print Assumptions SlipTies.tie_level.

Goal True. idtac "== tie-load
The load, the friction that a stick needs.
uses: no other". Abort.
Check @SwitchingTies.tie_load.
Print Assumptions SwitchingTies.tie_load.

Goal True. idtac "== tie-non-stop-amplitude
$U_{**}$, the amplitude that slip without a stop needs, by the response to the square wave.
uses: no other". Abort.
Check @ThresholdTies.tie_non_stop_amplitude.
Print Assumptions ThresholdTies.tie_non_stop_amplitude.

Goal True. idtac "== tie-non-stop-damped
The same with a damper that lets body 1 swing.
uses: tie-non-stop-amplitude". Abort.
Check @ThresholdTies.tie_non_stop_damped.
Print Assumptions ThresholdTies.tie_non_stop_damped.

Goal True. idtac "== tie-non-stop-undamped
The same without a damper, in closed form.
uses: no other". Abort.
Check @ThresholdTies.tie_non_stop_undamped.
Print Assumptions ThresholdTies.tie_non_stop_undamped.

Goal True. idtac "== tie-push
The push whose slip from the gap $d$ has the half angle $\varphi$.
uses: tie-half-angle-h". Abort.
Check @SlipTies.tie_push.
Print Assumptions SlipTies.tie_push.

Goal True. idtac "== tie-rate
The constant of the sharp law, in units of the critical energy.
uses: no other". Abort.
Check @SlipTies.tie_rate.
Print Assumptions SlipTies.tie_rate.

Goal True. idtac "== tie-rate-above
The rate of the relative velocity above $S$: the field's normal component.
uses: no other". Abort.
Check @SwitchingSurfaceTies.tie_rate_above.
Print Assumptions SwitchingSurfaceTies.tie_rate_above.

Goal True. idtac "== tie-rate-below
The rate of the relative velocity below $S$: the field's normal component.
uses: no other". Abort.
Check @SwitchingSurfaceTies.tie_rate_below.
Print Assumptions SwitchingSurfaceTies.tie_rate_below.

Goal True. idtac "== tie-ratio
$h/c$ in the half angle.
uses: no other". Abort.
Check @SlipTies.tie_ratio.
Print Assumptions SlipTies.tie_ratio.

Goal True. idtac "== tie-ray
The speed on an exit ray: $h$, in units of $L\Omega\sqrt q$.
uses: no other". Abort.
Check @SlipTies.tie_ray.
Print Assumptions SlipTies.tie_ray.

Goal True. idtac "== tie-return-map
The return map, in the half angle.
uses: tie-depth, tie-half-angle-h". Abort.
Check @SlipTies.tie_return_map.
Print Assumptions SlipTies.tie_return_map.

Goal True. idtac "== tie-slip-driven
Slip from the ray: driven (driven: of body 2).
uses: no other". Abort.
Check @SlipTies.tie_slip_driven.
Print Assumptions SlipTies.tie_slip_driven.

Goal True. idtac "== tie-slip-frequency
The frequency of slip.
uses: no other". Abort.
Check @SlipTies.tie_slip_frequency.
Print Assumptions SlipTies.tie_slip_frequency.

Goal True. idtac "== tie-slip-place
Slip from the ray: place (driven: of body 2).
uses: no other". Abort.
Check @SlipTies.tie_slip_place.
Print Assumptions SlipTies.tie_slip_place.

Goal True. idtac "== tie-slip-speed
Slip from the ray: speed (driven: of body 2).
uses: no other". Abort.
Check @SlipTies.tie_slip_speed.
Print Assumptions SlipTies.tie_slip_speed.

Goal True. idtac "== tie-slip-time
The duration of an excursion.
uses: no other". Abort.
Check @SlipTies.tie_slip_time.
Print Assumptions SlipTies.tie_slip_time.

Goal True. idtac "== tie-solution
A solution obeys the equations of motion of the theory, with an impulse that follows the sign of its guard.
uses: no other". Abort.
Check @PairTies.tie_solution.
Print Assumptions PairTies.tie_solution.

Goal True. idtac "== tie-stick-frequency
The frequency of stick.
uses: no other". Abort.
Check @PairTies.tie_stick_frequency.
Print Assumptions PairTies.tie_stick_frequency.

Goal True. idtac "== tie-stick-place
Stick: the place of both bodies.
uses: no other". Abort.
Check @PairTies.tie_stick_place.
Print Assumptions PairTies.tie_stick_place.

Goal True. idtac "== tie-stick-rotation
The stick between two excursions, as the difference of two arc cosines.
uses: no other". Abort.
Check @SlipTies.tie_stick_rotation.
Print Assumptions SlipTies.tie_stick_rotation.

Goal True. idtac "== tie-stick-speed
Stick: the speed of both bodies.
uses: no other". Abort.
Check @PairTies.tie_stick_speed.
Print Assumptions PairTies.tie_stick_speed.

Goal True. idtac "== tie-stuck-amplitude
The amplitude of the fastest stuck transfer.
uses: stuck-transfer-amplitude". Abort.
Check @TransferTies.tie_stuck_amplitude.
Print Assumptions TransferTies.tie_stuck_amplitude.

Goal True. idtac "== tie-stuck-force
The force of the fastest stuck transfer: that of the stuck pair along it.
uses: no other". Abort.
Check @TransferTies.tie_stuck_force.
Print Assumptions TransferTies.tie_stuck_force.

Goal True. idtac "== tie-switching
Equations (3) and (4) of the paper at one time.
uses: no other". Abort.
Check @SwitchingTies.tie_switching.
Print Assumptions SwitchingTies.tie_switching.

Goal True. idtac "== tie-turn
The part in phase of a motion that never stops.
uses: no other". Abort.
Check @ThresholdTies.tie_turn.
Print Assumptions ThresholdTies.tie_turn.

Goal True. idtac "== tie-turn-place
The place of body 1 where the square wave turns.
uses: no other". Abort.
Check @ThresholdTies.tie_turn_place.
Print Assumptions ThresholdTies.tie_turn_place.

Goal True. idtac "== tie-turn-speed
Its velocity there.
uses: no other". Abort.
Check @ThresholdTies.tie_turn_speed.
Print Assumptions ThresholdTies.tie_turn_speed.

Goal True. idtac "== tie-turning-function
The function whose zero is where $h/c$ turns.
uses: no other". Abort.
Check @SlipTies.tie_turning_function.
Print Assumptions SlipTies.tie_turning_function.

Goal True. idtac "== tolerance-ring
With $a_1>0$ and a bounded force every motion enters a tube around another one at some time, and stays; from then on it is in the ring of relative velocities.
uses: forced-approach, forced-contraction, ring-factor". Abort.
Check @ToleranceRing.ring.
Print Assumptions ToleranceRing.ring.

Goal True. idtac "== trackable
From some initial state of body 1 some force makes body 2 follow a velocity exactly if that is $b/m_2$-Lipschitz.
uses: driven-acceleration". Abort.
Check @Forced.trackable_iff.
Print Assumptions Forced.trackable_iff.

Goal True. idtac "== tracks
With $a_1>0$, under the force of the stuck motion along a reference with $|\ddot x_{\mathrm{ref}}|\leqslant b/m_2$, but for a constant, if it is bounded: $v_1$, $v_2$ and $x_1$ of every motion tend to the velocity of the reference, and to its place but for the constant.
uses: forced-approach". Abort.
Check @Tracking.tracks.
Print Assumptions Tracking.tracks.

Goal True. idtac "== trajectory-velocities
The scene of Fig. 5 until 5 s: 24 events of every solution, with bounds on their times, positions and velocities.
uses: follow-forced-arc, forced-contraction, interface-one-strength, interface-well-posed". Abort.
Check @Velocities.trajectory.
Print Assumptions Velocities.trajectory.

Goal True. idtac "== transversal-beyond
On $S$ beyond $S_0$ both rates have the sign of $-x_1$.
uses: no other". Abort.
Check @SwitchingSurface.transversal_beyond.
Print Assumptions SwitchingSurface.transversal_beyond.

Goal True. idtac "== transversal-inside
Both fields point back to $S$ exactly in the interior of $S_0$, back or along it exactly on $S_0$.
uses: no other". Abort.
Check @SwitchingSurface.transversal_inside.
Print Assumptions SwitchingSurface.transversal_inside.

Goal True. idtac "== turning-angle
$\sin\theta=\theta\cos\theta$ has one solution $\theta_v$ in $(0,2\pi)$.
uses: no other". Abort.
Check @ExcursionShape.turning_angle.
Print Assumptions ExcursionShape.turning_angle.

Goal True. idtac "== turning-point
The turning function has one zero $\varphi^*$ in $(0,\pi]$.
uses: no other". Abort.
Check @TurningFunction.root.
Print Assumptions TurningFunction.root.

Goal True. idtac "== two-arcs
A level above $E_{cr}$ meets $S_0$ in two arcs, the graphs of a speed and of its negative over $[-L,L]$; each is run through by a motion, which slips at its end: from the left ray into $v_1>v_2$, from the right one into $v_1<v_2$.
uses: arc-to-left-ray, energy-decreases, ray-energy, slips-on-ray, well-posed". Abort.
Check @TwoArcs.two_arcs.
Print Assumptions TwoArcs.two_arcs.

Goal True. idtac "== two-sided-rate
Explicit bounds of $1/w$ along a solution from $S_0$ with $0<w_0\leqslant\tfrac{4}{9}q$, the upper one where $6\sqrt{w_0}<\pi$.
uses: arc-to-ray, cycle-time, depth-lower, depth-upper, energy-decreases, exit-energy, h-increases, never-merges, ray-energy, turning-point". Abort.
Check @SharpLaw.two_sided.
Print Assumptions SharpLaw.two_sided.

Goal True. idtac "== two-solutions-from-6-mm
Case study, $b=0.5$, from rest at 6 mm: the stuck $x_1=0.006\cos 10t$ satisfies (11), (12), and so does a Filippov solution that slips at once, the only one of (3), (4) and of the inclusion.
uses: filippov-iff, filippov-well-posed, law-satisfies-case-study, slips-from-6-mm, switching-iff". Abort.
Check @CaseStudy.two_from_six.
Print Assumptions CaseStudy.two_from_six.

Goal True. idtac "== two-stop-exists
A slip and a stick whose ends meet, and meet with the opposite sign after half a period, are a periodic motion if $v_1>v_2$ in the slip and $|\Lambda|\leqslant b$ in the stick.
uses: antiperiodic, arc-begins, follow-forced-arc". Abort.
Check @TwoStop.two_stop_exists.
Print Assumptions TwoStop.two_stop_exists.

Goal True. idtac "== two-stop-needs
A motion that slips and sticks once in each half period, and is its own negative after it, leaves stick at $\Lambda=b$, gains $bt_s/m_2$ of velocity in the slip, and has $|\Lambda|\leqslant b$ in the stick.
uses: stuck-load". Abort.
Check @TwoStop.two_stop_needs.
Print Assumptions TwoStop.two_stop_needs.

Goal True. idtac "== undamped-entrained
With $a_1=0$ every motion under a sinusoidal force of amplitude below $U_*$ tends to one that sticks permanently, and $\int|\dot z|\,dt$ is at most the energy distance from the stuck response at $t=0$ over $b\,(1-U/U_{*})$.
uses: driven-acceleration, forced-contraction, interface-one-strength". Abort.
Check @UndampedEntrainment.undamped_entrained.
Print Assumptions UndampedEntrainment.undamped_entrained.

Goal True. idtac "== uniform-upper-rate
$E/E_{cr}-1\leqslant c/t$ with one $c$ for all solutions that start below a level and never merge.
uses: contact, crossing, energy-decreases, gap-slip, h-increases, settling-time, two-sided-rate". Abort.
Check @UniformRate.uniform_upper.
Print Assumptions UniformRate.uniform_upper.

Goal True. idtac "== uniqueness
Two solutions that meet coincide from then on, with or without damping.
uses: contraction". Abort.
Check @Pair.unique.
Print Assumptions Pair.unique.

Goal True. idtac "== viscous-decay
With $a_1>0$: $E(t)\leqslant 3E(0)\,e^{-kt}$, with one $k>0$ for all initial energies below a level.
uses: energy-decreases, energy-rate". Abort.
Check @Viscous.decay.
Print Assumptions Viscous.decay.

Goal True. idtac "== viscous-rest
With $a_1>0$: one time after which every solution that starts below a level sticks permanently.
uses: captive-merges, energy-decreases, viscous-decay". Abort.
Check @Viscous.rest.
Print Assumptions Viscous.rest.

Goal True. idtac "== weak-attained
Both arcs are a motion, and the pair can then be held there.
uses: arc-begins, follow-forced-arc". Abort.
Check @WeakTransfer.weak_attained.
Print Assumptions WeakTransfer.weak_attained.

Goal True. idtac "== weak-sticks
From rest at $x_1=0$ no force of at most $F$, $3F\leqslant bM/m_2$, breaks the undamped pair within $\pi/\Omega$.
uses: no other". Abort.
Check @WeakTransfer.sticks_half_turn.
Print Assumptions WeakTransfer.sticks_half_turn.

Goal True. idtac "== weak-takes
Under such forces, where $a_2D\leqslant F$, from rest at $x_1=0$ to rest at $D$ takes at least the time of two arcs, under $F$ and then under $-F$.
uses: weak-sticks". Abort.
Check @WeakTransfer.weak_takes.
Print Assumptions WeakTransfer.weak_takes.

Goal True. idtac "== well-posed
From every initial state there is exactly one solution, with or without damping.
uses: forced-well-posed, free-case". Abort.
Check @WellPosed.well_posed.
Print Assumptions WellPosed.well_posed.

Goal True. idtac "== AlmostEverywhere.ac". Abort.
Print AlmostEverywhere.ac.

Goal True. idtac "== AlmostEverywhere.almost". Abort.
Print AlmostEverywhere.almost.

Goal True. idtac "== AlmostEverywhere.chain". Abort.
Print AlmostEverywhere.chain.

Goal True. idtac "== AlmostEverywhere.lengths". Abort.
Print AlmostEverywhere.lengths.

Goal True. idtac "== AlmostEverywhere.moves". Abort.
Print AlmostEverywhere.moves.

Goal True. idtac "== AlmostEverywhere.null". Abort.
Print AlmostEverywhere.null.

Goal True. idtac "== Analytic.analytic_at". Abort.
Print Analytic.analytic_at.

Goal True. idtac "== Analytic.by_pieces". Abort.
Print Analytic.by_pieces.

Goal True. idtac "== Analytic.piece". Abort.
Print Analytic.piece.

Goal True. idtac "== Analytic.piecewise_analytic". Abort.
Print Analytic.piecewise_analytic.

Goal True. idtac "== Approach.controlled". Abort.
Print Approach.controlled.

Goal True. idtac "== Arcs.forced_arc". Abort.
Print Arcs.forced_arc.

Goal True. idtac "== AtResonance.edge_v1". Abort.
Print AtResonance.edge_v1.

Goal True. idtac "== AtResonance.edge_v2". Abort.
Print AtResonance.edge_v2.

Goal True. idtac "== AtResonance.edge_x". Abort.
Print AtResonance.edge_x.

Goal True. idtac "== CaseStudy.case_study". Abort.
Print CaseStudy.case_study.

Goal True. idtac "== CaseStudy.kept". Abort.
Print CaseStudy.kept.

Goal True. idtac "== CaseStudy.six". Abort.
Print CaseStudy.six.

Goal True. idtac "== CreepingScenes.creeps". Abort.
Print CreepingScenes.creeps.

Goal True. idtac "== CriticalRatioDigits.hi". Abort.
Print CriticalRatioDigits.hi.

Goal True. idtac "== CriticalRatioDigits.lo". Abort.
Print CriticalRatioDigits.lo.

Goal True. idtac "== Cycle.amp". Abort.
Print Cycle.amp.

Goal True. idtac "== Cycle.o1". Abort.
Print Cycle.o1.

Goal True. idtac "== Cycle.on_ray". Abort.
Print Cycle.on_ray.

Goal True. idtac "== Cycle.ray". Abort.
Print Cycle.ray.

Goal True. idtac "== CycleLength.delay". Abort.
Print CycleLength.delay.

Goal True. idtac "== Dini.cont". Abort.
Print Dini.cont.

Goal True. idtac "== Dini.dini_le". Abort.
Print Dini.dini_le.

Goal True. idtac "== Dini.little". Abort.
Print Dini.little.

Goal True. idtac "== Dini.rderiv". Abort.
Print Dini.rderiv.

Goal True. idtac "== Entrainment.Fstar". Abort.
Print Entrainment.Fstar.

Goal True. idtac "== Entrainment.Z". Abort.
Print Entrainment.Z.

Goal True. idtac "== Entrainment.cA". Abort.
Print Entrainment.cA.

Goal True. idtac "== Entrainment.cB". Abort.
Print Entrainment.cB.

Goal True. idtac "== Entrainment.drive". Abort.
Print Entrainment.drive.

Goal True. idtac "== Entrainment.rV". Abort.
Print Entrainment.rV.

Goal True. idtac "== Entrainment.rX". Abort.
Print Entrainment.rX.

Goal True. idtac "== EulerLaw.euler". Abort.
Print EulerLaw.euler.

Goal True. idtac "== EulerLaw.pull". Abort.
Print EulerLaw.pull.

Goal True. idtac "== EulerSlip.slip_v1". Abort.
Print EulerSlip.slip_v1.

Goal True. idtac "== EulerSlip.slip_v2". Abort.
Print EulerSlip.slip_v2.

Goal True. idtac "== Excursion.h". Abort.
Print Excursion.h.

Goal True. idtac "== ExcursionShape.c". Abort.
Print ExcursionShape.c.

Goal True. idtac "== ExcursionShape.h1". Abort.
Print ExcursionShape.h1.

Goal True. idtac "== ExcursionShape.h2". Abort.
Print ExcursionShape.h2.

Goal True. idtac "== ExitOrbit.cyc". Abort.
Print ExitOrbit.cyc.

Goal True. idtac "== ExitOrbit.half". Abort.
Print ExitOrbit.half.

Goal True. idtac "== ExitOrbit.next". Abort.
Print ExitOrbit.next.

Goal True. idtac "== ExitOrbit.ok". Abort.
Print ExitOrbit.ok.

Goal True. idtac "== ExitOrbit.orb". Abort.
Print ExitOrbit.orb.

Goal True. idtac "== ExitOrbit.tim". Abort.
Print ExitOrbit.tim.

Goal True. idtac "== Fading.sticks_and_slips". Abort.
Print Fading.sticks_and_slips.

Goal True. idtac "== Filippov.filippov". Abort.
Print Filippov.filippov.

Goal True. idtac "== Filippov.included". Abort.
Print Filippov.included.

Goal True. idtac "== Filippov.integral_of". Abort.
Print Filippov.integral_of.

Goal True. idtac "== FollowArc.arc". Abort.
Print FollowArc.arc.

Goal True. idtac "== Forced.bang". Abort.
Print Forced.bang.

Goal True. idtac "== Forced.forced". Abort.
Print Forced.forced.

Goal True. idtac "== Forced.push". Abort.
Print Forced.push.

Goal True. idtac "== Forced.run". Abort.
Print Forced.run.

Goal True. idtac "== Forced.side". Abort.
Print Forced.side.

Goal True. idtac "== FrictionSystems.dampers". Abort.
Print FrictionSystems.dampers.

Goal True. idtac "== FrictionSystems.flow". Abort.
Print FrictionSystems.flow.

Goal True. idtac "== FrictionSystems.impulse". Abort.
Print FrictionSystems.impulse.

Goal True. idtac "== FrictionSystems.inclusion". Abort.
Print FrictionSystems.inclusion.

Goal True. idtac "== FrictionSystems.mechanical". Abort.
Print FrictionSystems.mechanical.

Goal True. idtac "== FrictionSystems.moves". Abort.
Print FrictionSystems.moves.

Goal True. idtac "== FrictionSystems.pair_flow". Abort.
Print FrictionSystems.pair_flow.

Goal True. idtac "== FrictionSystems.pair_friction". Abort.
Print FrictionSystems.pair_friction.

Goal True. idtac "== FrictionSystems.pair_ip". Abort.
Print FrictionSystems.pair_ip.

Goal True. idtac "== FrictionSystems.state_ip". Abort.
Print FrictionSystems.state_ip.

Goal True. idtac "== HalfPeriod.by_halves". Abort.
Print HalfPeriod.by_halves.

Goal True. idtac "== Interface.rubs". Abort.
Print Interface.rubs.

Goal True. idtac "== InterfaceExists.rubs_by_state". Abort.
Print InterfaceExists.rubs_by_state.

Goal True. idtac "== LawWithError.gain". Abort.
Print LawWithError.gain.

Goal True. idtac "== LeastAmplitude.arrives". Abort.
Print LeastAmplitude.arrives.

Goal True. idtac "== LeastTimeTransfer.half_time". Abort.
Print LeastTimeTransfer.half_time.

Goal True. idtac "== LeastTimeTransfer.stuck_force". Abort.
Print LeastTimeTransfer.stuck_force.

Goal True. idtac "== ModeAtContact.beyond". Abort.
Print ModeAtContact.beyond.

Goal True. idtac "== ModeAtContact.load". Abort.
Print ModeAtContact.load.

Goal True. idtac "== Modes.finitely_many_modes". Abort.
Print Modes.finitely_many_modes.

Goal True. idtac "== Modes.one_mode". Abort.
Print Modes.one_mode.

Goal True. idtac "== MonotoneInclusion.brakes". Abort.
Print MonotoneInclusion.brakes.

Goal True. idtac "== MonotoneInclusion.drags". Abort.
Print MonotoneInclusion.drags.

Goal True. idtac "== MonotoneInclusion.driven". Abort.
Print MonotoneInclusion.driven.

Goal True. idtac "== MonotoneInclusion.inner". Abort.
Print MonotoneInclusion.inner.

Goal True. idtac "== MonotoneInclusion.monotone". Abort.
Print MonotoneInclusion.monotone.

Goal True. idtac "== MonotoneInclusion.motion". Abort.
Print MonotoneInclusion.motion.

Goal True. idtac "== MonotoneInclusion.norm". Abort.
Print MonotoneInclusion.norm.

Goal True. idtac "== MonotoneInclusion.vcont". Abort.
Print MonotoneInclusion.vcont.

Goal True. idtac "== MonotoneInclusion.vderiv". Abort.
Print MonotoneInclusion.vderiv.

Goal True. idtac "== MonotoneInclusion.vlittle". Abort.
Print MonotoneInclusion.vlittle.

Goal True. idtac "== Nonstop.Fslip". Abort.
Print Nonstop.Fslip.

Goal True. idtac "== Nonstop.Z1". Abort.
Print Nonstop.Z1.

Goal True. idtac "== Nonstop.leave". Abort.
Print Nonstop.leave.

Goal True. idtac "== Nonstop.nonstop". Abort.
Print Nonstop.nonstop.

Goal True. idtac "== Nonstop.slipping". Abort.
Print Nonstop.slipping.

Goal True. idtac "== Nonstop.turn". Abort.
Print Nonstop.turn.

Goal True. idtac "== Nonstop.wave". Abort.
Print Nonstop.wave.

Goal True. idtac "== NonstopDamped.Fslip_damped". Abort.
Print NonstopDamped.Fslip_damped.

Goal True. idtac "== NonstopDamped.damped_swing'". Abort.
Print NonstopDamped.damped_swing'.

Goal True. idtac "== NonstopDamped.ring_frequency". Abort.
Print NonstopDamped.ring_frequency.

Goal True. idtac "== NonstopDamped.turn_place". Abort.
Print NonstopDamped.turn_place.

Goal True. idtac "== NonstopDamped.turn_speed". Abort.
Print NonstopDamped.turn_speed.

Goal True. idtac "== NonstopDamped.weight". Abort.
Print NonstopDamped.weight.

Goal True. idtac "== NonstopOverdamped.creep". Abort.
Print NonstopOverdamped.creep.

Goal True. idtac "== NonstopOverdamped.creep'". Abort.
Print NonstopOverdamped.creep'.

Goal True. idtac "== NonstopOverdamped.fast". Abort.
Print NonstopOverdamped.fast.

Goal True. idtac "== NonstopOverdamped.part". Abort.
Print NonstopOverdamped.part.

Goal True. idtac "== NonstopOverdamped.slow". Abort.
Print NonstopOverdamped.slow.

Goal True. idtac "== NonstopUndamped.Fslip_undamped". Abort.
Print NonstopUndamped.Fslip_undamped.

Goal True. idtac "== NonstopUndamped.swing'". Abort.
Print NonstopUndamped.swing'.

Goal True. idtac "== Offset.half_sine". Abort.
Print Offset.half_sine.

Goal True. idtac "== Offset.swing". Abort.
Print Offset.swing.

Goal True. idtac "== Offset.swing'". Abort.
Print Offset.swing'.

Goal True. idtac "== OneEnergy.from_S0". Abort.
Print OneEnergy.from_S0.

Goal True. idtac "== OneEnergy.merges". Abort.
Print OneEnergy.merges.

Goal True. idtac "== Pair.energy". Abort.
Print Pair.energy.

Goal True. idtac "== Pair.solution". Abort.
Print Pair.solution.

Goal True. idtac "== Pursuit.integral". Abort.
Print Pursuit.integral.

Goal True. idtac "== ReturnMap.depth". Abort.
Print ReturnMap.depth.

Goal True. idtac "== ReturnMap.hh". Abort.
Print ReturnMap.hh.

Goal True. idtac "== ReturnToS0.contact_after". Abort.
Print ReturnToS0.contact_after.

Goal True. idtac "== ReturnToS0.first_reentry". Abort.
Print ReturnToS0.first_reentry.

Goal True. idtac "== RotatingForce.Ustar_plane". Abort.
Print RotatingForce.Ustar_plane.

Goal True. idtac "== RotatingForce.X0". Abort.
Print RotatingForce.X0.

Goal True. idtac "== RotatingForce.balance". Abort.
Print RotatingForce.balance.

Goal True. idtac "== RotatingForce.circular". Abort.
Print RotatingForce.circular.

Goal True. idtac "== RotatingForce.force2". Abort.
Print RotatingForce.force2.

Goal True. idtac "== RotatingForce.g_a". Abort.
Print RotatingForce.g_a.

Goal True. idtac "== RotatingForce.g_s". Abort.
Print RotatingForce.g_s.

Goal True. idtac "== RotatingForce.stiffness". Abort.
Print RotatingForce.stiffness.

Goal True. idtac "== RotatingUnstable.grows". Abort.
Print RotatingUnstable.grows.

Goal True. idtac "== RoundFriction.ellipse". Abort.
Print RoundFriction.ellipse.

Goal True. idtac "== RoundFriction.semi_major_square". Abort.
Print RoundFriction.semi_major_square.

Goal True. idtac "== SharpLaw.small". Abort.
Print SharpLaw.small.

Goal True. idtac "== SharpRate.rate". Abort.
Print SharpRate.rate.

Goal True. idtac "== SlipFromGap.G1". Abort.
Print SlipFromGap.G1.

Goal True. idtac "== SlipFromGap.G2". Abort.
Print SlipFromGap.G2.

Goal True. idtac "== SlipFromGap.Gx". Abort.
Print SlipFromGap.Gx.

Goal True. idtac "== SlipFromGap.at_gap". Abort.
Print SlipFromGap.at_gap.

Goal True. idtac "== SlipFromGap.ct". Abort.
Print SlipFromGap.ct.

Goal True. idtac "== SlipFromGap.level". Abort.
Print SlipFromGap.level.

Goal True. idtac "== SlipFromGap.push". Abort.
Print SlipFromGap.push.

Goal True. idtac "== StaticFriction.jumping". Abort.
Print StaticFriction.jumping.

Goal True. idtac "== StaticFriction.least_loss". Abort.
Print StaticFriction.least_loss.

Goal True. idtac "== StaticFriction.least_slip". Abort.
Print StaticFriction.least_slip.

Goal True. idtac "== StaticFriction.load_rate". Abort.
Print StaticFriction.load_rate.

Goal True. idtac "== StaticFriction.one_slip". Abort.
Print StaticFriction.one_slip.

Goal True. idtac "== StaticFriction.stick_load". Abort.
Print StaticFriction.stick_load.

Goal True. idtac "== StaticFriction.two_frictions". Abort.
Print StaticFriction.two_frictions.

Goal True. idtac "== Stick.Ecr". Abort.
Print Stick.Ecr.

Goal True. idtac "== Stick.L". Abort.
Print Stick.L.

Goal True. idtac "== Stick.V". Abort.
Print Stick.V.

Goal True. idtac "== Stick.X". Abort.
Print Stick.X.

Goal True. idtac "== Stick.omega". Abort.
Print Stick.omega.

Goal True. idtac "== Switching.sgn". Abort.
Print Switching.sgn.

Goal True. idtac "== Switching.switched". Abort.
Print Switching.switched.

Goal True. idtac "== Switching.switching". Abort.
Print Switching.switching.

Goal True. idtac "== SwitchingSurface.normal_rate". Abort.
Print SwitchingSurface.normal_rate.

Goal True. idtac "== ThirdRoot.period_of_growth". Abort.
Print ThirdRoot.period_of_growth.

Goal True. idtac "== Trajectory.ending". Abort.
Print Trajectory.ending.

Goal True. idtac "== Trajectory.event". Abort.
Print Trajectory.event.

Goal True. idtac "== Trajectory.force_at". Abort.
Print Trajectory.force_at.

Goal True. idtac "== Trajectory.in_R". Abort.
Print Trajectory.in_R.

Goal True. idtac "== Trajectory.in_mode". Abort.
Print Trajectory.in_mode.

Goal True. idtac "== Trajectory.last_friction". Abort.
Print Trajectory.last_friction.

Goal True. idtac "== Trajectory.mode". Abort.
Print Trajectory.mode.

Goal True. idtac "== Trajectory.motion". Abort.
Print Trajectory.motion.

Goal True. idtac "== Trajectory.pieces". Abort.
Print Trajectory.pieces.

Goal True. idtac "== Trajectory.scene". Abort.
Print Trajectory.scene.

Goal True. idtac "== Trajectory.spell". Abort.
Print Trajectory.spell.

Goal True. idtac "== Trajectory.unfolds". Abort.
Print Trajectory.unfolds.

Goal True. idtac "== Trajectory.within". Abort.
Print Trajectory.within.

Goal True. idtac "== TurningFunction.K". Abort.
Print TurningFunction.K.

Goal True. idtac "== TurningFunction.ratio". Abort.
Print TurningFunction.ratio.

Goal True. idtac "== TwoArcs.level_speed". Abort.
Print TwoArcs.level_speed.

Goal True. idtac "== TwoStop.slips". Abort.
Print TwoStop.slips.

Goal True. idtac "== TwoStop.sticks". Abort.
Print TwoStop.sticks.

Goal True. idtac "== TwoStop.two_stop". Abort.
Print TwoStop.two_stop.

Goal True. idtac "== VaryingFriction.varying". Abort.
Print VaryingFriction.varying.

Goal True. idtac "== Velocities.the_ending". Abort.
Print Velocities.the_ending.

Goal True. idtac "== Velocities.the_events". Abort.
Print Velocities.the_events.

Goal True. idtac "== Velocities.the_scene". Abort.
Print Velocities.the_scene.

Goal True. idtac "== Viscous.captive". Abort.
Print Viscous.captive.

Goal True. idtac "== Waves.arith". Abort.
Print Waves.arith.

Goal True. idtac "== Waves.fade". Abort.
Print Waves.fade.

Goal True. idtac "== Waves.pval". Abort.
Print Waves.pval.

Goal True. idtac "== Waves.real". Abort.
Print Waves.real.

Goal True. idtac "== Waves.steady". Abort.
Print Waves.steady.

Goal True. idtac "== Waves.sval". Abort.
Print Waves.sval.

Goal True. idtac "== Waves.tone". Abort.
Print Waves.tone.

Goal True. idtac "== Waves.tval". Abort.
Print Waves.tval.
