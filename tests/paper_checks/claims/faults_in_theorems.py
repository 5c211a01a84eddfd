"""Of each theorem beyond the paper: what in its steps, or beneath them, turns it when it is changed, and how."""

from fractions import Fraction

import sympy as sp
from flint import arb

from theory.filippov import phi
from theory.symbols import b, epsilon, q, theta, x1

from .faults import (
    changed,
    confused,
    doubled,
    entry,
    halved,
    negated,
    plus,
    raised,
    squared,
    unbounded_sign,
)

FAULTS = {
    "excursion-closed-form": {
        "slips.guard_residual": plus(theta),
        "slips.contact_slope_residual": plus(1),
        "slips.landing_residuals": entry(2, lambda zero: zero + q),
        "slips.depth_slope_residual": plus(theta),
        "slips.guard_factors": entry(0, lambda one: -one),
        "slips.depth": negated,
        "slips.turning_angle": plus(1),
        "slips.prove": confused(">", ">="),
    },
    "excursion-monotone": {
        "slips.cusa_huygens": negated,
        "slips.h": squared,
        "slips.depth_slope_residual": plus(1),
    },
    "return-map-expansion": {
        "return_map.printed_depth_coefficients": entry(2, raised),
        "return_map.depth_series": entry(6, raised),
        "return_map.delay": doubled,
        "return_map._coefficients": entry(2, lambda one: -one),
    },
    "sharp-rate-constant": {
        "rate.depth_series": entry(0, raised),
    },
    "rate-bounds-explicit": {
        "rate.depth_series": entry(0, raised),
        "rate.prove": confused(">=", "<=", 0),
    },
    "rate-with-error": {
        "uniform_rate.ranges": changed(lambda ends: [arb("inf") for _ in ends]),
    },
    "uniform-rate": {
        "uniform_rate.first_contact_bound": halved,
        "uniform_rate.prove": confused(">=", "<=", 0),
    },
    "merging-share": {
        "merging_share.flux": doubled,
        "merging_share.dissipation": doubled,
        "merging_share.sphere": halved,
        "merging_share.divergence": plus(1),
        "merging_share.large_energy_limit": squared,
    },
    "merging-set": {
        "critical_ratio.depth": doubled,
        "merging.half_angle": doubled,
        "critical_ratio.critical_share": doubled,
        "critical_ratio.critical_mass_ratio_residual": plus(theta),
    },
    "critical-mass-ratio": {
        "critical_ratio.ratio_slope_residual": plus(1),
        "critical_ratio.turning_function": negated,
        "critical_ratio.turning_slope": entry(1, lambda one: 2 * one),
    },
    "long-time-expansion": {
        "long_time.map_coefficients": entry(1, lambda one: 2 * one),
        "long_time.logarithm_coefficient": halved,
        "long_time.balanced_share": squared,
        "long_time.abel_defect": plus(q),
    },
    "forced-mode-rule": {
        "theory.forced.coupling": doubled,
    },
    "forced-no-zeno": {
        "theory.forced.deviation_force": plus(b),
        "theory.forced.excess_load": doubled,
    },
    "forced-contraction": {
        "filippov.set_valued_sign": unbounded_sign,
    },
    "forced-periodic-response": {
        "theory.forced.undamped_difference": entry(1, lambda one: -one),
        "theory.jumping_force.contact_state": plus(sp.Matrix([0, 1, 0])),
        "theory.jumping_force.loads": entry(1, lambda one: one / 2),
        "theory.jumping_force.apart_squared": doubled,
        "theory.jumping_force.slowest_and_fastest": entry(1, lambda one: one + 1),
    },
    "forced-resonance-bound": {
        "theory.forced_response.mean_absolute_cosine": doubled,
        "theory.forced_response.path_beside": doubled,
        "theory.critical_resonance.gain": changed(lambda gained: 2 * gained),
        "theory.critical_resonance.late": negated,
        "theory.critical_resonance.moment": doubled,
    },
    "euler-error": {
        "euler_error.RIGHT": lambda step: step + Fraction(1, 10**6),
        "euler_error.WRONG": lambda step: step - Fraction(1, 10**6),
        "euler_error.ALLOWED": lambda most: most / 2,
        "euler_error.LATEST": lambda most: most / 2,
        "static_friction.load": halved,
    },
    "entrainment-threshold": {
        "theory.forced_response.stuck_impedance": negated,
        "theory.forced_response.harmonic_slope": plus(1),
        "theory.forced_response.square_wave": entry(0, lambda one: 2 * one),
        "theory.forced_response.non_stop_parts": entry(1, lambda one: -one),
        "theory.forced_response.short_slip": entry(1, lambda one: one / 2),
        "theory.forced_response.two_stop_conditions": entry(2, lambda one: one + 1),
        "theory.forced.contraction_rate": doubled,
        "theory.forced.relative_rate": plus(b),
    },
    "trackable-references": {
        "theory.forced_control.stuck_force": negated,
    },
    "minimum-transfer-time": {
        "theory.forced_control.strongest": doubled,
        "theory.forced_control.stuck_force": doubled,
    },
    "cheapest-transfer": {
        "theory.cheapest.along": doubled,
        "theory.cheapest.gathered": negated,
        "theory.cheapest.slip_gathered": negated,
        "theory.cheapest.slip_force": doubled,
    },
    "tolerance-ring": {
        "theory.forced_control.ring_ratio": doubled,
        "tolerance.prove": confused("<=", ">=", 0),
    },
    "static-friction-stops-creeping": {
        "theory.finite_slope.strength": negated,
        "theory.finite_slope.path": doubled,
        "theory.finite_slope.gain": plus(epsilon),
        "static_friction.inverse_step": doubled,
    },
    "damping-can-desynchronise": {
        "theory.forced.creeping_load": negated,
    },
    "synchronisation-against-damping": {
        "damping.STUCK": (lambda point: {**point, x1: -1}, lambda point: {**point, b: sp.Rational(1, 10)}),
        "damping.load_threshold": doubled,
        "damping.sliding_field": lambda _: lambda **_named: phi(1, damped=True),
        "theory.forced.creeping_load": negated,
    },
}
