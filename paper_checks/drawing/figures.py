"""The figures of the report, drawn from trajectories and theory: each public function of this room that returns one, by its name."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterator
from pathlib import Path

from matplotlib.figure import Figure

from paper_checks.drawing.style import Figures, house_style


def _drawings() -> Iterator[tuple[str, Callable[[], Figure]]]:
    for module in pkgutil.iter_modules([str(Path(__file__).parent)], f"{__package__}."):
        if module.name != __name__:
            for name, one in vars(importlib.import_module(module.name)).items():
                if not name.startswith("_") and getattr(one, "__annotations__", None) == {"return": "Figure"}:
                    yield name.removesuffix("_figure").replace("_", "-"), house_style()(one)


FIGURES: Figures = dict(_drawings())
"""The drawings by name; each is drawn in the house style, and saved by `paper_checks.report.formats.vector`."""
