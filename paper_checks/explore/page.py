"""The interactive page as text: one section of a page, or a page of its own; no network, the same bytes every time."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from html import escape
from pathlib import Path

from paper_checks.explore.scenes import OWN, Button, ReducedScene, paper_buttons
from paper_checks.explore.surfaces import SurfaceButton, surface_buttons

SOLVER = ("oscillator", "first_root", "solver", "surface")
"""What solves, on one line and on a surface; it knows no page."""
_SHOWN = (
    "regimes",
    "scene_file",
    "scene3d",
    "strips",
    "surface_view",
    "controls",
    "player",
    "tabs",
    "surface_main",
    "main",
)
SCRIPTS = (*SOLVER, *_SHOWN)
"""The page's programs in the order in which they are joined."""


@dataclass(frozen=True)
class Slider:
    """A quantity that the reader sets: its label, its scale on the slider, and the bounds of slider and field."""

    name: str
    label: str
    scale: str
    low: float
    high: float
    least: float
    most: float


START = (
    Slider("X", "x₁/L, spring", "signed", -40, 40, -1000, 1000),
    Slider("V1", "v₁/(LΩ), driving body 1", "signed", -40, 40, -1000, 1000),
    Slider("V2", "v₂/(LΩ), driven body 2", "signed", -40, 40, -1000, 1000),
)
PAIR = (
    Slider("ratio", "mass ratio m₁/m₂", "log", 0.02, 50, 1e-4, 1e4),
    Slider("zeta", "damping ratio ζ = a₁/(2MΩ)", "linear", 0, 1, 0, 50),
)
FORCE = (
    Slider("size", "size of u/b", "signed", -40, 40, -1000, 1000),
    Slider("omega", "frequency ω/Ω", "log", 0.05, 20, 1e-3, 100),
)
RUN = (Slider("until", "length of the run, Ωt", "log", 2, 400, 0.01, 2000),)
ABOVE = "above-"
"""What the ids of the second tab begin with."""
ABOVE_START = tuple(
    Slider(name, label, "signed", -20, 20, -1000, 1000)
    for name, label in (("x", "x/L"), ("y", "y/L"), ("v1x", "v₁/(LΩ) in x"), ("v1y", "v₁/(LΩ) in y"))
)
ABOVE_SECOND = tuple(Slider(f"v2{one}", f"v₂/(LΩ) in {one}", "signed", -20, 20, -1000, 1000) for one in "xy")
ABOVE_FORCE = (
    Slider("size", "size of u/b", "log", 0.05, 40, 1e-4, 1000),
    Slider("angle", "its angle at the start, degrees", "linear", -180, 180, -180, 180),
    Slider("omega", "frequency ω/Ω", "log", 0.05, 20, 1e-3, 100),
)


def source(names: Iterable[str] = SCRIPTS) -> str:
    """Return the programs of the page, joined."""
    return "\n".join(_beside(f"{name}.js") for name in names)


def section(beside: Iterable[str] = ()) -> str:
    """Return style, body and program as one `<section id="explore">`; every id in it begins with `explore`.

    `beside` names rows whose pages stand in the same folder: what is said of all runs links to them.
    """
    paper, surfaces = paper_buttons(), surface_buttons()
    data = json.dumps(
        {
            "scenes": [one.data() for one in (*paper, *OWN)],
            "above": [one.data() for one in surfaces],
            "criticalRatio": critical_ratio(),
            "beside": [*beside],
        },
        ensure_ascii=False,
    )
    body = _beside("explore.html").format(
        paper=_buttons(paper, 0),
        own=_buttons(OWN, len(paper)),
        start=_rows(START),
        pair=_rows(PAIR),
        force=_rows(FORCE),
        run=_rows(RUN),
        above=_beside("surface.html").format(
            scenes=_buttons(surfaces, 0, "above"),
            start=_rows(ABOVE_START, ABOVE),
            second=_rows(ABOVE_SECOND, ABOVE),
            force=_rows(ABOVE_FORCE, ABOVE),
            pair=_rows(PAIR, ABOVE),
            run=_rows(RUN, ABOVE),
        ),
    )
    program = f'(() => {{\n"use strict";\nconst EXPLORE = {data};\n{source()}\nObject.assign(EXPLORE, {{ solve, thresholds, solveAbove }});\nglobalThis.inertialPair = EXPLORE;\n}})();'
    return f"<style>\n{_beside('explore.css')}</style>\n{body}<script>\n{program}\n</script>\n"


def page(beside: Iterable[str] = ()) -> str:
    """Return a whole page with the section; among the pages of a report, `beside` those of these rows, with the way back."""
    rows = tuple(beside)
    back = '<p><a href="../report.html">Back to the report</a></p>\n' if rows else ""
    parts = {"{style}": _beside("page.css"), "{back}": back, "{section}": section(rows)}
    return re.sub(r"\{(style|back|section)\}", lambda place: parts[place[0]], _beside("page.html"))


def critical_ratio() -> float:
    """Return the mass ratio m1/m2 from which on nothing on S above E_cr merges, rounded up from a proved enclosure."""
    from paper_checks.claims.critical_ratio import critical_value
    from paper_checks.decide.balls import precision

    with precision():
        share = critical_value()
        return float(((1 - share) / share).upper())


def _buttons(buttons: Iterable[Button | SurfaceButton], first: int, kind: str = "scene") -> str:
    return "\n".join(
        f'<button type="button" data-{kind}="{number}" aria-pressed="false">{escape(one.label)}</button>'
        for number, one in enumerate(buttons, first)
    )


def _rows(sliders: Iterable[Slider], prefix: str = "") -> str:
    return "\n".join(_row(one, prefix) for one in sliders)


def _row(one: Slider, prefix: str) -> str:
    label, value, name = escape(one.label), getattr(ReducedScene(), one.name, 0), f"explore-{prefix}{one.name}"
    return (
        f'<div class="explore-row" data-name="{one.name}" data-scale="{one.scale}" data-low="{one.low}" data-high="{one.high}">'
        f'<label for="{name}">{label}</label>'
        f'<input type="range" id="{name}" min="0" max="1000" step="1">'
        f'<input type="number" aria-label="{label}, as a number" min="{one.least}" max="{one.most}" step="any" value="{value}"></div>'
    )


def _beside(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")
