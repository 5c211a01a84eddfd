"""The theorems that rows of the ledger may cite, by a short id, each with one sentence that says what it proves.

"Solution" is the absolutely continuous solution of the equations of motion with set-valued friction, from any start;
without a word about damping it is the paper's free system with a1 = 0. The statements themselves are printed by the kernel
and pinned in `pins.json`; a sentence here is for the reader and carries nothing.
"""

from __future__ import annotations

from paper_checks.proofs.cited_forced import FORCED

_FREE: dict[str, tuple[str, str]] = {
    # Section III, every solution
    "well-posed": (
        "Existence.well_posed",
        "From every start there is a solution, and only one, with damping or without.",
    ),
    "contraction": ("Pair.contraction", "The energy distance of two solutions never grows, with damping or without."),
    "uniqueness": ("Pair.unique", "Two solutions that meet are the same from there on, with damping or without."),
    "energy-rate": ("Pair.energy_rate", "dE/dt = -b |v1 - v2| - a1 v1^2 at every time, from the right."),
    "energy-decreases": ("Pair.energy_decreases", "The energy never increases, with damping or without."),
    "bounded-stay": ("Pair.dwell", "A stay off S lasts at most 2 sqrt(2 E m2)/b."),
    "contact": (
        "Stick.contact",
        "Every solution meets S in every time window of length 2 sqrt(2 E m2)/b, so infinitely often.",
    ),
    "ellipse-solution": (
        "Stick.ellipse_solution",
        "Every ellipse on S with energy up to E_cr is a solution: the stuck pair.",
    ),
    "capture": ("Stick.capture", "A solution on S with energy up to E_cr moves along its ellipse for ever."),
    "merging": (
        "Stick.merging",
        "Once its energy is at most E_cr, a solution merges with an ellipse within a bounded time.",
    ),
    "ellipse-stable": ("Stick.ellipse_stable", "The energy distance of a solution to a stuck motion never grows."),
    "energy-limit": ("Limit.limit_not_above", "The limit of the energy is at most E_cr."),
    "convergence": ("Dichotomy.convergence", "Every solution tends to one stuck motion."),
    "dichotomy": (
        "Dichotomy.dichotomy",
        "Every solution merges in finite time with an ellipse, or stays above E_cr and tends to one motion on the critical one.",
    ),
    "displacement-paid": (
        "Corollaries.displacement_paid",
        "The path of the relative displacement costs b times its length in energy.",
    ),
    "displacement-limit": ("Corollaries.displacement_limit", "The relative displacement x1 - x2 has a limit."),
    "sticks-iff": ("Cross.sticks_iff", "On S the pair sticks for ever exactly if its energy is at most E_cr."),
    # one slip, one stick
    "follow": ("Slip.follow", "A solution that meets the start of an explicit arc that obeys the law runs along it."),
    "slip-arc": (
        "Cycle.slip",
        "From an exit ray every solution slips with one sign up to one angle, and lands where the closed form says.",
    ),
    "stick-arc": (
        "Cycle.stick",
        "On S0 above E_cr, moving inwards, every solution sticks until it reaches the opposite ray.",
    ),
    "cycle": ("Orbit.cycle", "From ray to ray: one slip and one stick, with the return map y' = h^2 - r c^2."),
    "exits": ("Orbit.exits", "The exits of a solution follow the orbit of the return map."),
    "exit-energy": ("Orbit.exit_energy", "The energy at each exit is E_cr (1 + q y) along that orbit."),
    "cycle-time": ("Orbit.cycle_time", "The time of a cycle differs from pi/Omega by at most 6 sqrt(w)/Omega."),
    "cycle-time-sharp": (
        "Time.cycle_time_sharp",
        "The time of a cycle differs from pi/Omega by at most (27/2) sqrt q u^3/Omega where u <= 2/3: by a constant times w^(3/2).",
    ),
    "h-increases": ("Excursion.h_increases", "h increases on (0, 2 pi): each push has one slip angle."),
    "depth-upper": ("Rate.depth_upper", "The depth of an excursion is at most (3/2) h^2."),
    "depth-lower": ("Rate.depth_lower", "The depth of an excursion is at least (3/2) (sin phi/phi)^6 h^2."),
    "return-map-rate": ("Rate.sharp", "Along the return map n y_n tends to 4/(9 r)."),
    # slowly to E_cr
    "never-merges": ("Sharp.never_merges", "From an exit ray at a small level the energy stays above E_cr for ever."),
    "no-merging-from-S0": (
        "Law.no_merging_from_S0",
        "From S0 at a small level above E_cr: never merging, one critical motion as the limit, and the sharp law.",
    ),
    "sharp-law": (
        "Law.sharp_law",
        "t (E - E_cr) tends to E_cr (4 pi/9)(m1/m2) sqrt(M/a2) for every solution that never merges.",
    ),
    "trichotomy": (
        "Law.trichotomy",
        "Every solution merges in finite time, or tends to one critical motion by the sharp law.",
    ),
    "two-sided-rate": ("Law.two_sided", "Two explicit bounds of 1/w along a solution from S0 with 0 < w0 <= 4 q/9."),
    "one-over-t": (
        "Paper.one_over_t",
        "c1/t <= E/E_cr - 1 <= c2/t with explicit constants, from S0 slightly above E_cr.",
    ),
    "settling-time": (
        "Uniform.settles",
        "For each level above E_cr there is one time after which every solution from below another level is below it.",
    ),
    "uniform-upper-rate": (
        "Uniform.uniform_upper",
        "E/E_cr - 1 <= c/t with one c for all solutions that start below a level and never merge.",
    ),
    "no-uniform-lower-rate": (
        "Uniform.no_lower_constant",
        "Of every energy above E_cr there are solutions that never merge and are as close to E_cr as one likes from the time "
        "sqrt(2 E(0) m2)/b on.",
    ),
    "exit-and-entry-times": (
        "Paper.times",
        "For every solution that never merges: entries and exits alternate; stays on S0 tend to pi/Omega, slips to 0.",
    ),
    "exits-near-endpoints": (
        "Ends.exits_near_endpoints",
        "A solution that never merges leaves S0 exactly at its ends, enters it ever closer to them, and ever more slowly.",
    ),
    "slower-than-exponential": (
        "Consequences.slower_than_exponential",
        "A solution that never merges keeps its excess energy above every decaying exponential in the end.",
    ),
    "stick-slip-for-ever": (
        "Perpetual.stick_slip_for_ever",
        "For all m1, m2, a2, b > 0 there is a solution that sticks and slips in turn for ever.",
    ),
    # who merges
    "merges-iff": ("Merge.merges_iff", "From S0 with slip angle up to pi: E > E_cr for ever exactly if r c^2 < h^2."),
    "turning-point": ("Turning.root", "The turning function has one zero phi* in (0, pi]."),
    "merging-threshold": (
        "Turning.threshold",
        "Every excursion from a ray ends above E_cr exactly if m1/m2 > -cos 2 phi*.",
    ),
    "critical-mass-ratio-digits": ("Critical.decimals", "14 decimals of the critical mass ratio -cos 2 phi*."),
    "gap-slip": ("Gap.gap_slip", "Every slip from S with a gap and a push, in closed form up to its one end."),
    "crossing": ("Gap.crossing", "A slip that ends beyond the other end of S0 is followed by one of the other sign."),
    "re-entry": (
        "Cross.reentry",
        "A slip that lands in S0 sticks there for ever exactly if its level is not above E_cr.",
    ),
    "first-slip": (
        "Cross.first_slip",
        "From S0 above E_cr: stick, one slip, and merging there exactly if h^2 <= r c^2.",
    ),
    "ray-crossing": (
        "Cross.ray_crossing",
        "From a ray with depth above 2/q the pair crosses S and slips on with the other sign.",
    ),
    "merging-set-first-slip": (
        "Cross.merging_set_S0",
        "The energies on S0 that merge after the first slip are exactly one interval.",
    ),
    "no-first-merging": (
        "Alternation.no_first_merging",
        "If m1/m2 > -cos 2 phi* nothing on S0 merges after its first slip.",
    ),
    "alternation": ("Alternation.alternation", "After a crossing long and short slips alternate."),
    "margin": ("Margin.margin", "The one numerical inequality of the merging set, enclosed in balls by the kernel."),
    "kappa-large": (
        "Kappa.kappa_large",
        "Where merging is possible, the longest slip that lands in S0 is longer than 4 pi/3.",
    ),
    "merging-set-at-re-entry": (
        "Equivalence.merging_set",
        "At the first re-entry after any number of crossings the pair merges exactly if its slip angle is in one interval.",
    ),
    "first-re-entry": (
        "Return.returns",
        "From beyond S0, or from an exit ray, a solution comes back to S0 after finitely many slips, for every mass ratio.",
    ),
    "merging-set": (
        "Merging.merging_set_energies",
        "For m1/m2 <= -cos 2 phi*: the energies on S0 that merge at the first re-entry, which exists, are exactly one interval.",
    ),
    "no-low-level": (
        "Levels.no_low_level",
        "For m1/m2 > -cos 2 phi*: no slip from S, whatever its gap and push, ends at or below E_cr.",
    ),
    "heavy-never-merges": (
        "Heavy.heavy_never_merges",
        "For m1/m2 > -cos 2 phi*: no solution that has touched S above E_cr ever merges, after whatever number of slips.",
    ),
    # the surface, the sliding region and the case study, for solutions
    "rate-above": ("Surface.rate_above", "While v1 > v2 the relative velocity has the rate Phi+ . n_S."),
    "rate-below": ("Surface.rate_below", "While v1 < v2 the relative velocity has the rate Phi- . n_S."),
    "transversal-beyond": ("Surface.transversal_beyond", "On S beyond S0 both rates have the sign of -x."),
    "transversal-inside": ("Surface.transversal_inside", "Each field points back to S exactly in the interior of S0."),
    "slips-beyond": (
        "Surface.slips_beyond",
        "At a contact beyond S0 every solution slips at once, with the sign of -x.",
    ),
    "slips-on-ray": (
        "Surface.slips_on_ray",
        "On an edge of S0, moving outwards, every solution slips at once, inwards.",
    ),
    "sticks-inside": ("Surface.sticks_inside", "On S0, but for the exit rays, every solution sticks for a while."),
    "arc-to-ray": ("Cross.to_ray", "On S0 above E_cr every solution sticks until it reaches one of the two exit rays."),
    "arc-to-left-ray": (
        "Cross.to_ray_left",
        "On S0 above E_cr and moving to the left every solution sticks until it reaches the left exit ray, at the same level.",
    ),
    "ellipse-iff": ("Surface.ellipse_iff", "An ellipse on S is a solution exactly if its energy is at most E_cr."),
    "return-alternatives": (
        "Consequences.return_alternatives",
        "From v1 < v2 every solution comes into S0, or to S beyond the left end, whence it goes on into v1 > v2 at once.",
    ),
    "return-alternatives-mirror": (
        "Consequences.return_alternatives_mirror",
        "From v1 > v2 every solution comes into S0, or to S beyond the right end, whence it goes on into v1 < v2 at once.",
    ),
    "synchronisation": (
        "Consequences.relative_velocity_vanishes",
        "v1 - v2 tends to 0 for all m1, m2, a2, b > 0, a1 >= 0 and from every start.",
    ),
    "driven-acceleration": (
        "Forced.only_gentle",
        "Body 2 changes its velocity by at most b/m2 times the time, whatever the force.",
    ),
    "slips-from-rest": (
        "Example.slips_from_rest",
        "Case study, b = 0.5: released at rest beyond 5 mm every solution slips at once.",
    ),
    "slips-from-6-mm": (
        "Example.six_millimetres",
        "Case study, b = 0.5: released at rest at 6 mm every solution slips at once.",
    ),
    "sticks-from-rest": ("Example.rest_inside", "Released at rest inside S0 every solution sticks for ever."),
    "sticks-from-5-mm": (
        "Example.five_millimetres",
        "Case study, b = 0.5: released at rest up to 5 mm every solution sticks for ever.",
    ),
    # damping
    "captive-sticks": ("Viscous.captive_sticks", "On S below the captive level the pair sticks for ever."),
    "captive-merges": (
        "Viscous.captive_merges",
        "Once its energy is below the captive level, a solution sticks for ever within a bounded time.",
    ),
    "one-body": ("Viscous.one_body", "While stuck the pair moves as one damped body."),
    "viscous-decay": ("Viscous.decay", "With a1 > 0: E(t) <= 3 E(0) exp(-k t), one k for all starts below a level."),
    "viscous-rest": (
        "Viscous.rest",
        "With a1 > 0: one time after which every solution from below a level sticks for ever.",
    ),
}

CITED = _FREE | FORCED
