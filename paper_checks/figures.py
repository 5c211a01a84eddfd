"""The figures of the report, drawn from trajectories and theory, by the name that a finding gives them."""

from __future__ import annotations

from paper_checks.report.files import Figures

FIGURES: Figures = {}
