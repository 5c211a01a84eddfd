"""The figures of the report, drawn from trajectories and theory, by the name that a finding gives them."""

from __future__ import annotations

from paper_checks.drawing.euler_convergence import euler_convergence
from paper_checks.drawing.excursions import excursion_curves, merging_window, return_map
from paper_checks.drawing.force_needed import force_needed
from paper_checks.drawing.itineraries import itinerary_that_creeps, itinerary_that_merges
from paper_checks.drawing.merging import merging_bands, merging_map, merging_share
from paper_checks.drawing.model import two_bodies
from paper_checks.drawing.past_the_line import rotating_force, static_friction, stuck_ellipses, two_motions
from paper_checks.drawing.phase_portraits import relative_motion, start_at_6mm, start_with_speed
from paper_checks.drawing.rates import long_time, rate_bounds_explicit, rate_with_error, uniform_rate_figure
from paper_checks.drawing.relative_velocity import relative_velocity
from paper_checks.drawing.sharp_rate import sharp_rate
from paper_checks.drawing.style import Figures, house_style
from paper_checks.drawing.velocities import velocities_scene

FIGURES: Figures = {
    name: house_style()(draw)
    for name, draw in (
        ("two-bodies", two_bodies),
        ("force-needed", force_needed),
        ("relative-velocity", relative_velocity),
        ("sharp-rate", sharp_rate),
        ("start-at-6mm", start_at_6mm),
        ("start-with-speed", start_with_speed),
        ("velocities", velocities_scene),
        ("relative-motion", relative_motion),
        ("itinerary-that-merges", itinerary_that_merges),
        ("itinerary-that-creeps", itinerary_that_creeps),
        ("euler-convergence", euler_convergence),
        ("excursion-curves", excursion_curves),
        ("return-map", return_map),
        ("merging-window", merging_window),
        ("merging-map", merging_map),
        ("merging-bands", merging_bands),
        ("merging-share", merging_share),
        ("rate-bounds", rate_bounds_explicit),
        ("long-time", long_time),
        ("rate-with-error", rate_with_error),
        ("uniform-rate", uniform_rate_figure),
        ("static-friction", static_friction),
        ("two-motions", two_motions),
        ("stuck-ellipses", stuck_ellipses),
        ("rotating-force", rotating_force),
    )
}
"""The drawings by name; each is drawn in the house style, and saved by `paper_checks.report.formats.vector`."""
