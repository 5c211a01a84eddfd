"""The figures of the report, drawn from trajectories and theory, by the name that a finding gives them."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps

from matplotlib.figure import Figure

from paper_checks.drawing.euler_convergence import euler_convergence
from paper_checks.drawing.itineraries import figure_5a, figure_5b
from paper_checks.drawing.phase_portraits import figure_3a, figure_3b, figure_4b
from paper_checks.drawing.style import house_style
from paper_checks.drawing.velocities import figure_4a
from paper_checks.report.files import Figures


def _styled(draw: Callable[[], Figure]) -> Callable[[], Figure]:
    @wraps(draw)
    def drawn() -> Figure:
        with house_style():
            return draw()

    return drawn


FIGURES: Figures = {
    name: _styled(draw)
    for name, draw in (
        ("figure-3a", figure_3a),
        ("figure-3b", figure_3b),
        ("figure-4a", figure_4a),
        ("figure-4b", figure_4b),
        ("figure-5a", figure_5a),
        ("figure-5b", figure_5b),
        ("euler-convergence", euler_convergence),
    )
}
"""The drawings by name; each is drawn in the house style, and saved by `paper_checks.report.vector`."""
