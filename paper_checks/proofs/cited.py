"""The theorems that rows of the ledger may cite, by a short id, each with one sentence that says what it proves.

"Solution" is the absolutely continuous solution of the equations of motion with set-valued friction, from any start;
without a word about damping it is the paper's free system with a1 = 0. The statements themselves are printed by the kernel
and are on record in `rocq/Audit.out`; a sentence here is for the reader and carries nothing.
"""

from __future__ import annotations

from paper_checks.proofs.cited_beyond import BEYOND
from paper_checks.proofs.cited_forced import FORCED
from paper_checks.proofs.cited_merging import MERGING
from paper_checks.proofs.cited_switching import SWITCHING

_FREE: dict[str, tuple[str, str]] = {
    # Section III, every solution
    "well-posed": (
        "WellPosed.well_posed",
        "From every initial state there is exactly one solution, with or without damping.",
    ),
    "contraction": ("Pair.contraction", "The flow is non-expansive in the energy norm, with or without damping."),
    "uniqueness": ("Pair.unique", "Two solutions that meet coincide from then on, with or without damping."),
    "energy-rate": ("Pair.energy_rate", r"$\dot E=-b|v_1-v_2|-a_1v_1^2$ at every time, from the right."),
    "energy-decreases": ("Pair.energy_decreases", "The energy never increases, with or without damping."),
    "bounded-stay": ("Pair.dwell", r"A stay off $S$ lasts at most $2\sqrt{2Em_2}/b$."),
    "contact": (
        "Stick.contact",
        r"Every solution meets $S$ in every time window of length $2\sqrt{2Em_2}/b$, so infinitely often.",
    ),
    "ellipse-solution": (
        "Stick.ellipse_solution",
        "Every ellipse on $S$ with energy up to $E_{cr}$ is a solution: the stuck pair.",
    ),
    "capture": ("Stick.capture", "A solution on $S$ with energy up to $E_{cr}$ moves along its ellipse permanently."),
    "merging": (
        "Stick.merging",
        "Once its energy is at most $E_{cr}$, a solution merges with an ellipse within a bounded time.",
    ),
    "ellipse-stable": ("Stick.ellipse_stable", "The energy distance of a solution to a stuck motion never grows."),
    "energy-limit": ("EnergyLimit.limit_not_above", "The limit of the energy is at most $E_{cr}$."),
    "convergence": ("Dichotomy.convergence", "Every solution tends to one stuck motion."),
    "dichotomy": (
        "Dichotomy.dichotomy",
        "Every solution merges in finite time with an ellipse, or stays above $E_{cr}$ and tends to one motion on "
        "the critical one.",
    ),
    "displacement-paid": (
        "DisplacementLimit.displacement_paid",
        r"$b\,|z(t)-z(r)|\leqslant E(r)-E(t)$ for the relative displacement $z=x_1-x_2$ and $r\leqslant t$, with or without damping.",
    ),
    "displacement-limit": ("DisplacementLimit.displacement_limit", "The relative displacement $x_1-x_2$ has a limit."),
    "sticks-iff": (
        "AfterOneSlip.sticks_iff",
        "On $S$ the pair sticks permanently exactly if its energy is at most $E_{cr}$.",
    ),
    # one slip, one stick
    "follow": (
        "FollowArc.follow",
        "A solution that meets the start of an explicit arc that satisfies the law follows it.",
    ),
    "slip-arc": (
        "SlipFromGap.slip",
        r"From the right exit ray with the exit speed $h$ of an angle every solution slips up to that angle, and ends where the closed form says.",
    ),
    "stick-arc": (
        "Cycle.stick",
        "On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left exit ray, at a time in closed form.",
    ),
    "cycle": (
        "ExitOrbit.cycle",
        r"From a ray with slip angle up to $\pi$ and $r\,c^2<h^2$ to the other ray: one slip and one stick, with the return map $y'=h^2-r\,c^2$.",
    ),
    "exits": (
        "ExitOrbit.exits",
        "From a ray with slip angle up to $\\pi$ and $r\\,c^2<h^2$ the exits of a solution follow the orbit of the return map.",
    ),
    "exit-energy": ("ExitOrbit.exit_energy", r"Along the orbit of exits the energy at each is $E_{cr}(1+q\,y)$."),
    "cycle-time": (
        "ExitOrbit.cycle_time",
        r"With slip angle up to $\pi$ and $r\,c^2<h^2$ the time of a cycle differs from $\pi/\Omega$ by at most $6\sqrt w/\Omega$.",
    ),
    "cycle-time-sharp": (
        "CycleTime.cycle_time_sharp",
        r"With $r\,c^2<h^2$ the time of a cycle differs from $\pi/\Omega$ by at most $\tfrac{27}{2}\sqrt q\,h^3/\Omega$ where "
        r"$h=\sqrt{w/q}\leqslant\tfrac{2}{3}$: by a constant times $w^{3/2}$.",
    ),
    "h-increases": (
        "Excursion.h_increases",
        r"$h$ increases on $(0,2\pi)$: no two slip angles have the same exit speed.",
    ),
    "excursion-rise": (
        "ExcursionShape.rise",
        r"$h$ increases on $(0,2\pi)$, takes every positive value once and has $h''>0$; $h-d\cot(\theta/2)$ increases for every $d\geqslant 0$.",
    ),
    "excursion-depth": (
        "ExcursionShape.deepens",
        r"$c'=h$; $c$ takes every positive value once on $(0,2\pi)$ and is concave as a function of $h^2$.",
    ),
    "excursions-grow": (
        "ExcursionShape.grow_together",
        "Of two excursions from a ray the faster one lasts longer, goes deeper and loses more energy.",
    ),
    "one-contact": (
        "ExcursionShape.one_contact",
        r"Every slip from $S$ with a gap $d\geqslant 0$ and a push $\nu$ ($\nu>0$ if $d=0$) ends at the one angle with $\nu=h-d\cot(\theta/2)$.",
    ),
    "turning-angle": (
        "ExcursionShape.turning_angle",
        r"$\sin\theta=\theta\cos\theta$ has one solution $\theta_v$ in $(0,2\pi)$.",
    ),
    "leaves-by": (
        "ExcursionShape.leaves_by",
        r"After an excursion from a ray that re-enters $S_0$ above $E_{cr}$ the pair leaves by the other ray if $\theta<\theta_v$, and by the same if $\theta>\theta_v$.",
    ),
    "depth-upper": ("ReturnMap.depth_upper", r"The depth of an excursion is at most $\tfrac{3}{2}h^2$."),
    "depth-lower": (
        "ReturnMap.depth_lower",
        r"The depth of an excursion is at least $\tfrac{3}{2}(\sin\varphi/\varphi)^6h^2$.",
    ),
    "return-map-rate": ("ReturnMap.sharp", r"Along the return map $n\,y_n\to 4/(9r)$."),
    # slowly to E_cr
    "never-merges": (
        "SharpRate.never_merges",
        r"From an exit ray with slip angle up to $\pi$ and $r\,c^2<h^2$ the energy stays above $E_{cr}$ at all later times.",
    ),
    "no-merging-from-S0": (
        "SharpLaw.no_merging_from_S0",
        "From $S_0$ slightly above $E_{cr}$ a solution never merges, tends to one critical motion and obeys the sharp law.",
    ),
    "sharp-law": (
        "SharpLaw.sharp_law",
        r"$t\,(E-E_{cr})\to E_{cr}\tfrac{4\pi}{9}\tfrac{m_1}{m_2}\sqrt{M/a_2}$ for every solution that never "
        "merges.",
    ),
    "trichotomy": (
        "SharpLaw.trichotomy",
        "Every solution merges in finite time, or tends to one critical motion and obeys the sharp law.",
    ),
    "two-sided-rate": (
        "SharpLaw.two_sided",
        r"Explicit bounds of $1/w$ along a solution from $S_0$ with $0<w_0\leqslant\tfrac{4}{9}q$, the upper one where $6\sqrt{w_0}<\pi$.",
    ),
    "rate-bounds": (
        "RateBounds.rate_bounds",
        r"From an exit ray with $y_0\leqslant\tfrac{4}{9}$ on, $w$ lies between $q/(1/y_0+A(s/T_-+1))$ and $q/(1/y_0+a'(s/T_+-1))$, the constants explicit in the first excursion.",
    ),
    "cycle-time-exact": (
        "RateBounds.cycle_time_exact",
        r"From a ray with $h\leqslant\tfrac{2}{3}$ a cycle takes $(\pi+\sqrt q\,\theta-\arctan(\sqrt q\sqrt{h^2-r\,c^2})-\arctan\frac{\sqrt q\,(\theta-h)}{1-q\,c})/\Omega$.",
    ),
    "law-with-error": (
        "LawWithError.law_with_error",
        r"From a ray with $y_0\leqslant(\pi/2-1)^2$, given $g\leqslant\pi G/c^2$, $\pi G/(r\,c^2)\leqslant g'$ and $F\,(1+\sqrt{1-rs})/(h\,s)\leqslant f$ at all slip angles up to $\pi/2$, with $g\leqslant 0\leqslant g',f$: "
        r"$(g\,y_0-f\sqrt{y_0})/r\leqslant R_n\leqslant g'y_0$ at every exit.",
    ),
    "long-time": (
        "LongTime.long_time",
        r"A solution that never merges comes to exits where $w=\frac{C}{\tau}(1-\frac{\pi B\ln(\alpha\tau/\pi)+K}{\tau}+O(\tau^{-3/2}))$, given the bounds of law-with-error.",
    ),
    "one-over-t": (
        "OneOverT.one_over_t",
        r"From $S_0$ slightly above $E_{cr}$, for each $T>0$: $c_1/t\leqslant E/E_{cr}-1\leqslant c_2/t$ from $T$ on, explicit, $c_1$ by $T$.",
    ),
    "settling-time": (
        "UniformRate.settles",
        "For each level above $E_{cr}$ there is one time after which every solution that starts below another level is below it.",
    ),
    "uniform-upper-rate": (
        "UniformRate.uniform_upper",
        r"$E/E_{cr}-1\leqslant c/t$ with one $c$ for all solutions that start below a level and never merge.",
    ),
    "no-uniform-lower-rate": (
        "UniformRate.no_lower_constant",
        r"From every energy above $E_{cr}$ some solutions never merge and are arbitrarily close to $E_{cr}$ from the time $\sqrt{2E(0)m_2}/b$ on.",
    ),
    "exit-and-entry-times": (
        "OneOverT.times",
        r"For every solution that never merges: entries and exits alternate; stays on $S_0$ tend to $\pi/\Omega$, "
        "slips to 0.",
    ),
    "exits-near-endpoints": (
        "ExitPlaces.exits_near_endpoints",
        "A solution that never merges leaves $S_0$ exactly where $|x_1|=L$; its entries tend to $|x_1|=L$, and the velocities at "
        "both to 0.",
    ),
    "slower-than-exponential": (
        "Consequences.slower_than_exponential",
        "The excess energy of a solution that never merges is eventually above every decaying exponential.",
    ),
    "stick-slip-for-ever": (
        "EndlessStickSlip.stick_slip_for_ever",
        "For all $m_1,m_2,a_2,b>0$ there is a solution that sticks and slips in turn without end.",
    ),
    # the surface, the sliding region and the case study, for solutions
    "rate-above": (
        "SwitchingSurface.rate_above",
        r"While $v_1>v_2$ the relative velocity has the rate $\Phi_+\cdot n_S$.",
    ),
    "rate-below": (
        "SwitchingSurface.rate_below",
        r"While $v_1<v_2$ the relative velocity has the rate $\Phi_-\cdot n_S$.",
    ),
    "transversal-beyond": (
        "SwitchingSurface.transversal_beyond",
        "On $S$ beyond $S_0$ both rates have the sign of $-x_1$.",
    ),
    "transversal-inside": (
        "SwitchingSurface.transversal_inside",
        "Both fields point back to $S$ exactly in the interior of $S_0$, back or along it exactly on $S_0$.",
    ),
    "slips-beyond": (
        "SwitchingSurface.slips_beyond",
        "At a contact beyond $S_0$ every solution slips at once, with the sign of $-x_1$.",
    ),
    "slips-on-ray": (
        "SwitchingSurface.slips_on_ray",
        r"On an edge of $S_0$, moving outwards, every solution slips at once, with $\dot z$ of the sign of $-x_1$.",
    ),
    "sticks-inside": (
        "SwitchingSurface.sticks_inside",
        "On $S_0$, but for the exit rays, every solution sticks for a while.",
    ),
    "arc-to-ray": (
        "SharpLaw.to_ray",
        "On $S_0$ above $E_{cr}$ every solution sticks until it reaches one of the two exit rays.",
    ),
    "arc-to-left-ray": (
        "SharpLaw.to_ray_left",
        "On $S_0$ above $E_{cr}$ and moving to the left every solution sticks until it reaches the left exit ray, "
        "at the same level.",
    ),
    "ellipse-iff": (
        "SwitchingSurface.ellipse_iff",
        "An ellipse on $S$ is a solution exactly if its energy is at most $E_{cr}$.",
    ),
    "two-arcs": (
        "TwoArcs.two_arcs",
        "A level above $E_{cr}$ meets $S_0$ in two arcs, the graphs of a speed and of its negative over $[-L,L]$; each is run through by a motion, which "
        "slips at its end: from the left ray into $v_1>v_2$, from the right one into $v_1<v_2$.",
    ),
    "return-alternatives": (
        "Consequences.return_alternatives",
        "From $v_1<v_2$ every solution reaches $S_0$, or $S$ beyond its left edge, from where it passes into $v_1>v_2$ at once.",
    ),
    "return-alternatives-mirror": (
        "Consequences.return_alternatives_mirror",
        "From $v_1>v_2$ every solution reaches $S_0$, or $S$ beyond its right edge, from where it passes into $v_1<v_2$ at once.",
    ),
    "synchronisation": (
        "Consequences.relative_velocity_vanishes",
        r"$v_1-v_2\to 0$ for all $m_1,m_2,a_2,b>0$, $a_1\geqslant 0$ and from every start.",
    ),
    "driven-acceleration": (
        "Forced.only_gentle",
        "Body 2 changes its velocity by at most $b/m_2$ times the time, whatever the force.",
    ),
    "slips-from-rest": (
        "StartFromRest.slips_from_rest",
        "Case study, $b=0.5$: released at rest at $x_1>5$ mm every solution slips at once.",
    ),
    "slips-from-6-mm": (
        "StartFromRest.six_millimetres",
        "Case study, $b=0.5$: released at rest at 6 mm every solution slips at once.",
    ),
    "sticks-from-rest": (
        "StartFromRest.rest_inside",
        "Released at rest inside $S_0$ every solution sticks permanently.",
    ),
    "sticks-from-5-mm": (
        "StartFromRest.five_millimetres",
        "Case study, $b=0.5$: released at rest up to 5 mm every solution sticks permanently.",
    ),
    # one motion
    "trajectory-velocities": (
        "Velocities.trajectory",
        "The scene of Fig. 5 until 5 s: 24 events of every solution, with bounds on their times, positions and velocities.",
    ),
    "first-adhesion": (
        "FirstAdhesion.first_adhesion",
        "The scene of Fig. 5: every solution sticks from 4.549769479... s to 4.579537997... s, not before, slips until "
        "4.771754480... s, including 4.7 s, and sticks again.",
    ),
    # scenes of Section IV, at all times
    "creeps-b-0.05": (
        "CreepingScenes.creeps_b005",
        "The scene of Fig. 5 (a): 20 crossings, first adhesion at 4.549769... s, and from then on sticks and slips in turn without end, above $E_{cr}$, each slip "
        "slower than the one before, none faster than 2.3202 mm/s.",
    ),
    "creeps-b-0.2": (
        "CreepingScenes.creeps_b02",
        "The same with $b=0.2$: 4 crossings, first adhesion at 0.984017... s, none faster than 10.219 mm/s from then on.",
    ),
    "creeps-b-0.5": (
        "CreepingScenes.creeps_b05",
        "The same with $b=0.5$, as in Fig. 4 (b): 1 crossing, first adhesion at 0.276302... s, none faster than 20.381 mm/s from then on.",
    ),
    "itinerary-creeps": (
        "CreepingScenes.itinerary_creeps",
        r"$m_1=m_2=1$, $a_2=200$, $b=0.5$, $\dot x_1(0)=0.21$: the energy stays above $E_{cr}$, and the motion tends to one on the critical ellipse.",
    ),
    "peaks-fall": (
        "Fading.peaks_fall",
        r"Where a motion never merges, the peaks of $|v_1|$ between entries tend to $L\Omega$ like $1/t$: at late entries each is at $x_1=0$, in stick, and $t\,(|v_1|-L\Omega)\to\frac12L\Omega\cdot\frac{4\pi}{9}\frac{m_1}{m_2}\sqrt{M/a_2}$.",
    ),
    # damping
    "captive-sticks": ("Viscous.captive_sticks", "On $S$ below the captive level the pair sticks permanently."),
    "captive-merges": (
        "Viscous.captive_merges",
        "Once its energy is below the captive level, a solution sticks permanently after a bounded time.",
    ),
    "one-body": ("Viscous.one_body", "While stuck the pair moves as one damped body."),
    "viscous-decay": (
        "Viscous.decay",
        r"With $a_1>0$: $E(t)\leqslant 3E(0)\,e^{-kt}$, with one $k>0$ for all initial energies below a level.",
    ),
    "viscous-rest": (
        "Viscous.rest",
        "With $a_1>0$: one time after which every solution that starts below a level sticks permanently.",
    ),
}

CITED = _FREE | SWITCHING | MERGING | FORCED | BEYOND
