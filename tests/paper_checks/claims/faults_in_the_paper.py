"""Of each claim of the paper: what in its steps, or beneath them, turns it when it is changed, and how."""

from dataclasses import replace
from types import SimpleNamespace

import sympy as sp

from numerics import Mode
from numerics.trajectory.status import Status
from paper_checks.claims.section_2 import force
from paper_checks.claims.section_3 import filippov, itineraries
from paper_checks.claims.section_4 import onset
from paper_checks.claims.section_5 import steering
from paper_checks.claims.section_5.points import EDGE, INSIDE, START_AT_6MM
from theory import plane
from theory.symbols import a1, a2, acceleration1, b, m1, m2, q, u, v1, v2, x1

from .faults import (
    changed,
    confused,
    crossing_contact,
    doubled,
    entry,
    failing,
    halved,
    inwards_missed,
    negated,
    other_sign,
    part,
    plus,
    reversed_contact,
    squared,
    unbounded_sign,
    without,
)

FAULTS = {
    "sgn-three-valued": {
        "filippov.sliding_field": doubled,
        "filippov.load_threshold": doubled,
        "filippov.contraction_rate": negated,
        "filippov.contraction_terms": entry(1, lambda one: -one),
        "filippov._share": doubled,
        "signum.transversality": negated,
        "signum.residual": lambda _: lambda found: (found.x1,),
        "signum.INSIDE": lambda _: START_AT_6MM,
    },
    "modes-from-closed-form": {
        "model.branch_named": lambda one: lambda name: one("stick" if name == "half adhesion" else name),
        "model.START_AT_6MM": lambda _: INSIDE,
        "model.EDGE": lambda _: INSIDE,
        "model.mode_equations": other_sign,
    },
    "stiction-bracket": {
        "model._factor": plus(1),
        "model.INSIDE": lambda _: START_AT_6MM,
        "model.EDGE": lambda _: START_AT_6MM,
    },
    "friction-opposes-displacement": {"model.EXAMPLE_PAIR": lambda pair: {**pair, b: 1}},
    "interface-force-balance": {
        "model.START_AT_6MM": lambda _: INSIDE,
        "model.EDGE": lambda _: START_AT_6MM,
        "model.spurious_branch": failing,
    },
    "viscous-no-direct-effect": {
        "viscous.a1": lambda a1: -a1,
        "viscous.slip": lambda _: lambda sign: filippov.stick(),
        "viscous.mode_at_start": lambda _: lambda scene: Mode.STICK,
    },
    "filippov-equivalence": {
        "filippov.sliding_field": doubled,
        "filippov.free_system": lambda field: lambda sign: field(sign / 2),
        "filippov.half_width": doubled,
        "filippov.b": lambda friction: -friction,
    },
    "vector-fields": {
        "theory.filippov.slip": other_sign,
    },
    "energy-rate": {
        "energy.energy": plus(-m1 * v1**2),
    },
    "energy-dissipation-places": {
        "energy.energy": doubled,
    },
    "transversality-outside": {
        "theory.filippov.guard": negated,
    },
    "transversality-strip": {
        "theory.filippov.slip": other_sign,
    },
    "sliding-region": {
        "sliding.sliding_weight": halved,
        "sliding.half_width": doubled,
        "sliding.sliding_field": doubled,
        "sliding.stick_rate": plus(-b * v1),
        "sliding.energy": plus(-a2 * x1**2),
    },
    "energy-as-lyapunov-function": {
        "interpretation.energy": plus(-m1 * v1**2),
        "energy.energy": negated,
    },
    "translational-or-rotational": {
        "theory.scaling.radius": lambda radius: radius**2,
        "interpretation.driven_equation": plus(x1),
    },
    "stiff-limit": {
        "interpretation.slip_rate": other_sign,
        "theory.presliding.other": changed(lambda one: -one),
        "filippov.set_valued_sign": unbounded_sign,
    },
    "parts-of-the-surface": {
        "interpretation.surface": part("sliding", lambda one: one.subs(b, 2 * b)),
        "interpretation.half_width": halved,
    },
    "two-senses-of-sliding": {
        "interpretation.guard": doubled,
        "interpretation.sliding_field": plus(sp.ImmutableMatrix([0, b, 0])),
    },
    "critical-energy": {
        "theory.energy.half_width": doubled,
        "levels.critical_energy": squared,
        "levels.level_semi_axis": doubled,
    },
    "supercritical-arcs": {
        "theory.filippov.load_threshold": halved,
        "levels.critical_energy": halved,
        "levels.edge_contact": reversed_contact,
        "levels.product": changed(lambda one: 0 * one),
        "capture.phi": lambda phi: lambda sign: phi(1),
        "levels.sliding_field": negated,
    },
    "return-alternatives": {
        "theory.filippov.guard": negated,
        "sliding.half_width": halved,
        "sliding.edge_contact": crossing_contact,
        "capture.phi": lambda phi: lambda sign: phi(1),
    },
    "infinitely-many-crossings": {
        "capture.phi": other_sign,
        "capture.dwell_time_bound": halved,
        "capture.energy": plus(-m2 * v2**2 / 4),
        "capture.prove": confused("<=", ">=", 2),
        "energy.slip_rate": negated,
    },
    "dichotomy": {
        "capture.half_width": halved,
        "filippov.contraction_rate": negated,
        "filippov.set_valued_sign": unbounded_sign,
        "convergence.stick_rate": plus(-b * v1),
        "convergence.rates": negated,
        "convergence.energy_parts": halved,
        "convergence.half_width": halved,
    },
    "relative-displacement-limit": {
        "energy.slip_rate": without(a1, b),
        "energy.energy": doubled,
    },
    "global-stability": {
        "filippov.contraction_rate": negated,
        "filippov.contraction_terms": entry(1, lambda one: -one),
        "capture.critical_energy": squared,
    },
    "stick-durations": {
        "near_critical.critical_limits": part("stick_duration", lambda value: 2 * value),
        "excursions.half_angle_slope": entry(1, lambda one: -one),
        "excursions.excursion": part("velocity", lambda one: -one),
    },
    "slip-durations": {
        "near_critical.critical_limits": part("slip_duration", lambda value: value + 1),
        "near_critical.cycle": part("slip_duration", lambda one: 2 * one),
        "excursions.guard_of_u": negated,
        "excursions.h_limits": entry(1, lambda _: sp.Integer(1)),
        "excursions.h_slope": squared,
    },
    "exits-near-endpoints": {
        "near_critical.critical_limits": part("entry_velocity", lambda value: value + b),
        "near_critical.b": lambda symbol: symbol**2,
        "excursions.excursion": inwards_missed,
        "theory.near_critical.exit_speed": plus(1),
    },
    "no-merging-near-critical": {
        "capture.critical_energy": halved,
        "excursions.no_merging_excess": doubled,
        "excursions.depth": negated,
        "excursions.prove": (confused(">=", ">", 2), confused(">=", "<=", 0)),
        "theory.return_map.h": doubled,
    },
    "slower-than-exponential": {
        "near_critical.excess_ratio_limit": halved,
        "near_critical.cycle_limit": doubled,
        "excursions.return_map_slope_residual": plus(q),
    },
    "rate-one-over-t": {
        "excursions.inverse_step": doubled,
        "excursions.quadratic_coefficient": negated,
        "excursions.cycle_limit": doubled,
        "excursions.rate_constant": squared,
        "excursions.critical_energy": doubled,
        "near_critical.prove": confused("<=", ">=", 0),
        "near_critical.enclosed_rate": lambda run: lambda q, w, n, tolerance: run(q, w, n // 100, tolerance),
    },
    "viscous-energy-rate": {"energy.energy": doubled},
    "viscous-origin-stable": {
        "viscous.sliding_field": lambda field: lambda damped: field(False),
        "viscous.damping_ratio": doubled,
        "energy.captive_energy": doubled,
        "energy.load": lambda load: lambda damped: load(False),
        "energy.lipschitz_constant": without(a1),
    },
    "itinerary-that-merges": {
        "itineraries.Status": lambda _: SimpleNamespace(STUCK_FOR_EVER=Status.REACHED_HORIZON),
        "itineraries.exact": lambda exact: lambda value: exact(value - 1),
        "itineraries.PLUS": lambda _: itineraries.MINUS,
    },
    "itinerary-that-creeps": {
        "itineraries.PLUS": lambda _: itineraries.MINUS,
        "itineraries.exact": lambda exact: lambda value: exact(value + 3),
        "itineraries.LARGEST": lambda largest: largest / 10,
    },
    "example-reduction": {
        "example.printed_reduction": plus(sp.Matrix([0, acceleration1])),
        "example.START_AT_6MM": lambda _: INSIDE,
    },
    "example-two-modes": {
        "example.residual": lambda _: lambda found: (found.x1,),
    },
    "example-stiction-never-violated": {
        "onset.START_AT_6MM": lambda _: EDGE,
        "onset.critical_energy": doubled,
        "onset.half_width": doubled,
        "onset.undamped": lambda _: lambda acceleration: 2 * acceleration,
        "onset.bracket_is_off_in_slip": failing,
        "onset.spurious_branch": failing,
    },
    "example-onset": {
        "onset.INSIDE": lambda _: START_AT_6MM,
        "onset.TOGETHER": lambda point: {**point, onset.v1: 1, onset.v2: 1},
        "onset.half_width": halved,
        "onset.edge_speed_squared": negated,
    },
    "example-damped-oscillations": {
        "onset.amplitude_squared": other_sign,
        "onset.LONG_SLIP": lambda point: {**point, onset.v2: 0},
        "onset.DRIVEN": lambda point: {**point, onset.v1: 1},
        "energy.energy": doubled,
    },
    "synchronisation-all-parameters": {
        "energy.energy": plus(-m1 * v2**2),
        "energy.lipschitz_constant": halved,
        "energy.sliding_field": lambda _: lambda damped: sp.Matrix([0, b, -b]),
    },
    "finite-time-then-alternation": {
        "itineraries.exact": lambda exact: lambda _: exact(1),
        "itineraries.r": lambda r: 3 * r,
        "synchronisation.INSIDE": lambda _: START_AT_6MM,
        "capture.critical_energy": doubled,
        "excursions.half_angle_slope": entry(1, lambda one: 2 * one),
    },
    "viscous-accelerates": {
        "synchronisation.captive_energy": halved,
        "energy.captive_energy": squared,
        "energy.load": negated,
        "synchronisation.DAMPED": lambda point: {**point, a1: 0},
        "damping.FIGURE": lambda point: {**point, m1: 2},
    },
    "two-descriptions": {
        "discussion.APART": lambda apart: 2 * apart,
        "discussion.START_AT_6MM": lambda _: INSIDE,
        "filippov.contraction_rate": negated,
    },
    "acceleration-bound": {
        "discussion.START_AT_6MM": lambda _: INSIDE,
        "discussion.load_threshold": doubled,
        "discussion.branch_named": lambda one: lambda name: one("stick" if name == "broken adhesion" else name),
    },
    "one-active-one-passive": {
        "theory.forced_control.strongest": doubled,
        "theory.forced.forced_system": doubled,
    },
    "ring-of-tolerance": {
        "theory.forced_control.ring_ratio": halved,
        "tolerance.INSIDE": lambda point: {**point, x1: 1},
        "theory.forced.contraction_rate": negated,
    },
    "target-or-set-point": {
        "theory.forced_control.stuck_force": negated,
    },
    "force-as-reference-or-disturbance": {
        "force.AT_REST": lambda point: {**point, force.x1: 1},
        "force.driving_equation": plus(u),
        "force.driven_equation": plus(a1),
    },
    "driven-body-steered": {
        "theory.forced.energy_rate": plus(b),
    },
    "damping-for-tracking": {
        "theory.forced.place_dependent_damper_rate": negated,
        "steering.PLACE": lambda place: place + 1,
        "steering.SINE": lambda scene: replace(scene, initial=steering.State()),
        "theory.forced.contraction_rate": negated,
    },
    "motions-on-a-surface": {
        "theory.plane.by_components": lambda _: plane.by_direction,
        "theory.plane.by_direction": lambda _: lambda slip: b * slip,
        "theory.plane.contraction_by_friction": negated,
        "theory.plane.energy_rate": negated,
    },
    "free-interface": {
        "force.SLIPPING": lambda point: {**point, force.sigma: 0},
        "theory.forced_control.strongest": doubled,
    },
    "varying-interface": {
        "theory.finite_slope.scaled_field": doubled,
        "theory.forced.place_dependent_rate": negated,
    },
    "start-at-6mm-sticks": {
        "starts.half_width": doubled,
        "starts.transversality": negated,
        "itineraries.next_excess": doubled,
    },
    "start-with-speed-synchronises": {
        "itineraries.LARGEST": lambda largest: largest / 2,
        "itineraries.guard_of_u": doubled,
    },
    "relative-motion-converges": {
        "itineraries.LARGEST": lambda largest: largest / 2,
        "itineraries.guard_of_u": doubled,
    },
    "synchronisation-time": {"itineraries.LARGEST": lambda largest: largest / 2, "itineraries.guard_of_u": doubled},
    "constant-damping-rate": {
        "velocities.slip": other_sign,
        "velocities._slips": lambda slips: lambda trajectory: slips(trajectory) - 2,
        "velocities.pi": lambda _: sp.pi / 2,
    },
    "euler-reproduces-figures": {
        "euler.sliding_field": doubled,
        "euler.run": part("adhesion", lambda at: at and at + 4),
    },
}
