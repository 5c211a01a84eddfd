"""Figures as vector graphics whose bytes depend on nothing but the figure: no dates, no random ids."""

from __future__ import annotations

import io

import matplotlib as mpl
from matplotlib.figure import Figure


def svg(figure: Figure) -> str:
    """Return the figure as SVG text; letters are outlines, so that it looks the same everywhere."""
    stream = io.StringIO()
    with mpl.rc_context({"svg.hashsalt": "paper_checks", "svg.fonttype": "path"}):
        metadata = dict.fromkeys(("Date", "Creator", "Format", "Type"))
        figure.savefig(stream, format="svg", metadata=metadata, bbox_inches="tight")
    return stream.getvalue()
