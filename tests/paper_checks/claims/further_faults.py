"""Faults that take more than a name (faults.toml has the others): the row, what is changed, and how."""

from dataclasses import replace
from types import SimpleNamespace

import sympy as sp
from flint import arb

from numerics.linear.modes import Mode
from numerics.trajectory.status import Status
from paper_checks.claims import filippov, force, itineraries, steering
from paper_checks.claims.points import at_rest
from theory import forced, plane
from theory.symbols import a1, a2, acceleration1, b, m1, m2, q, v1, v2, x1

from .faults import entry, limit_changed, plus, with_entry

FAULTS = [
    ("sgn-three-valued", "filippov.contraction_terms", lambda terms: lambda: (terms()[0], -terms()[1])),
    ("sgn-three-valued", "signum.INSIDE", lambda _: at_rest("0")),
    ("sgn-three-valued", "signum.residual", lambda _: lambda found: (found.x1,)),
    ("viscous-no-direct-effect", "viscous.stick", lambda _: lambda: filippov.slip(1)),
    ("viscous-no-direct-effect", "viscous.slip", lambda _: lambda sign: filippov.stick()),
    ("viscous-no-direct-effect", "viscous.mode_at_start", lambda _: lambda scene: Mode.STICK),
    ("viscous-no-direct-effect", "viscous.mode_at_start", lambda _: lambda scene: Mode.SLIP_MINUS),
    ("filippov-equivalence", "filippov.free_system", lambda field: lambda sign: field(sign / 2)),
    ("energy-rate", "energy.energy", plus(-m1 * v1**2)),
    ("sliding-region", "sliding.stick_rate", plus(-b * v1)),
    ("sliding-region", "sliding.energy", plus(-a2 * x1**2)),
    ("supercritical-arcs", "capture.phi", lambda phi: lambda sign: phi(1)),
    ("return-alternatives", "capture.phi", lambda phi: lambda sign: phi(1)),
    ("infinitely-many-crossings", "capture.energy", plus(-m2 * v2**2 / 4)),
    ("dichotomy", "convergence.stick_rate", plus(-b * v1)),
    ("stick-durations", "excursions.excursion", lambda one: lambda: replace(one(), velocity=-one().velocity)),
    (
        "slip-durations",
        "near_critical.cycle",
        lambda cycle: lambda: replace(cycle(), slip_duration=2 * cycle().slip_duration),
    ),
    ("slip-durations", "excursions.h_limits", lambda limits: lambda: (limits()[0], sp.Integer(1))),
    ("exits-near-endpoints", "near_critical.critical_limits", limit_changed("entry_velocity", lambda value: value + b)),
    (
        "rate-one-over-t",
        "near_critical.enclosed_rate",
        lambda run: lambda q, w, n, tolerance: run(q, w, n // 100, tolerance),
    ),
    ("viscous-origin-stable", "viscous.sliding_field", lambda field: lambda damped: -field(damped)),
    ("viscous-origin-stable", "viscous.sliding_field", lambda field: lambda damped: field(False)),
    ("viscous-origin-stable", "energy.load", lambda load: lambda damped: load(False)),
    ("itinerary-that-merges", "itineraries.Status", lambda _: SimpleNamespace(STUCK_FOR_EVER=Status.REACHED_HORIZON)),
    ("itinerary-that-merges", "itineraries.exact", lambda exact: lambda value: exact(value - 1)),
    ("itinerary-that-merges", "itineraries.PLUS", lambda _: itineraries.MINUS),
    ("itinerary-that-creeps", "itineraries.PLUS", lambda _: itineraries.MINUS),
    ("itinerary-that-creeps", "itineraries.exact", lambda exact: lambda value: exact(value + 3)),
    ("example-reduction", "example.printed_reduction", with_entry([0, acceleration1])),
    ("example-two-modes", "example.residual", lambda _: lambda found: (found.x1,)),
    ("synchronisation-all-parameters", "energy.energy", lambda energy: lambda: energy() - m1 * v2**2),
    ("synchronisation-all-parameters", "energy.sliding_field", lambda _: lambda damped: sp.Matrix([0, b, -b])),
    ("finite-time-then-alternation", "itineraries.exact", lambda exact: lambda _: exact(1)),
    ("finite-time-then-alternation", "itineraries.r", lambda r: 3 * r),
    ("acceleration-bound", "discussion.sliding_field", lambda field: lambda damped=False: 2 * field(damped)),
    ("damping-for-tracking", "steering.SINE", lambda scene: replace(scene, initial=steering.State())),
    ("motions-on-a-surface", "theory.plane.by_components", lambda _: plane.by_direction),
    ("motions-on-a-surface", "theory.plane.by_direction", lambda _: lambda slip: b * slip),
    ("free-interface", "force.SLIPPING", lambda point: {**point, force.sigma: 0}),
    ("varying-interface", "steering.APART", lambda point: {**point, forced.b_other: 3}),
    ("excursion-closed-form", "slips.landing_residuals", entry(2, lambda zero: zero + q)),
    ("return-map-expansion", "return_map.RADIUS", lambda radius: radius + 2),
    ("rate-bounds-explicit", "rate.bounds", lambda bounds: lambda *numbers: bounds(*numbers)[::-1]),
    ("merging-set", "critical_ratio.half_angle", lambda f: lambda: f() + arb("1e-40")),
    ("forced-contraction", "theory.forced.energy_rate", plus(a1 * v1**2)),
    ("forced-periodic-response", "theory.jumping_force.contact_state", plus(sp.Matrix([0, 1, 0]))),
]
