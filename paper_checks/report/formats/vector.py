"""Figures as vector graphics whose bytes depend on nothing but the figure: no dates, no random ids."""

from __future__ import annotations

import io
import logging

import matplotlib as mpl
from matplotlib.figure import Figure

_NO_SVG_METADATA = {"Date": None, "Creator": None, "Format": None, "Type": None}
_NO_PDF_METADATA = {"CreationDate": None, "Creator": None, "Producer": None}


def svg(figure: Figure) -> bytes:
    """Return the figure as an SVG file's bytes; letters are outlines, so that it looks the same everywhere."""
    with mpl.rc_context({"svg.hashsalt": "paper_checks", "svg.fonttype": "path"}):
        return _saved(figure, "svg", _NO_SVG_METADATA)


def pdf(figure: Figure) -> bytes:
    """Return the figure as a PDF file's bytes."""
    logging.getLogger("fontTools").setLevel(logging.ERROR)  # it warns of the age of matplotlib's own fonts
    with mpl.rc_context({"pdf.fonttype": 42}):
        return _saved(figure, "pdf", _NO_PDF_METADATA)


def _saved(figure: Figure, form: str, metadata: dict[str, None]) -> bytes:
    stream = io.BytesIO()
    figure.savefig(stream, format=form, metadata=metadata, bbox_inches="tight", dpi=200)
    return stream.getvalue()
