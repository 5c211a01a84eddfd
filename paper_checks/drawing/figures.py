"""The figures of the report, drawn from trajectories and theory, by the name that a finding gives them."""

from __future__ import annotations

from paper_checks.drawing.ellipse_in_strip import ellipse_in_strip
from paper_checks.drawing.euler_convergence import euler_convergence
from paper_checks.drawing.excursions import excursion_curves, merging_window, return_map
from paper_checks.drawing.force_needed import force_needed
from paper_checks.drawing.itineraries import itinerary_that_creeps, itinerary_that_merges
from paper_checks.drawing.merging import merging_interval, merging_share
from paper_checks.drawing.model import two_bodies
from paper_checks.drawing.past_the_line import rotating_force, static_friction, stuck_ellipses, two_motions
from paper_checks.drawing.phase_portraits import relative_motion, start_at_6mm, start_with_speed
from paper_checks.drawing.rates import rate_bounds_figure, uniform_rate_figure
from paper_checks.drawing.relative_velocity import relative_velocity
from paper_checks.drawing.sharp_rate import sharp_rate
from paper_checks.drawing.style import Figures, house_style
from paper_checks.drawing.velocities import velocities

DRAWINGS = (
    two_bodies,
    ellipse_in_strip,
    force_needed,
    relative_velocity,
    sharp_rate,
    start_at_6mm,
    start_with_speed,
    velocities,
    relative_motion,
    itinerary_that_merges,
    itinerary_that_creeps,
    euler_convergence,
    excursion_curves,
    return_map,
    merging_window,
    merging_interval,
    merging_share,
    rate_bounds_figure,
    uniform_rate_figure,
    static_friction,
    two_motions,
    stuck_ellipses,
    rotating_force,
)
FIGURES: Figures = {draw.__name__.removesuffix("_figure").replace("_", "-"): house_style()(draw) for draw in DRAWINGS}
"""The drawings by name; each is drawn in the house style, and saved by `paper_checks.report.formats.vector`."""
