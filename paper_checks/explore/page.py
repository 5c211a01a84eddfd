"""The interactive page as text: one section of a page, or a page of its own; no network, the same bytes every time."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from html import escape
from pathlib import Path

from paper_checks.explore.scenes import OWN, Button, Reduced, paper_buttons

SCRIPTS = ("oscillator", "first_root", "solver", "regimes", "scene_file", "scene3d", "strips", "controls", "main")
"""The page's programs in the order in which they are joined; the first three are the solver and know no page."""
SOLVER = SCRIPTS[:3]
TITLE = "Two masses joined by dry friction"


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


def source(names: Iterable[str] = SCRIPTS) -> str:
    """Return the programs of the page, joined."""
    return "\n".join(_beside(f"{name}.js") for name in names)


def section(beside: Iterable[str] = ()) -> str:
    """Return style, body and program as one `<section id="explore">`; every id in it begins with `explore`.

    `beside` names rows whose pages stand in the same folder: what is said of all runs links to them.
    """
    paper = paper_buttons()
    data = json.dumps(
        {
            "scenes": [one.data() for one in (*paper, *OWN)],
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
    )
    program = f'(() => {{\n"use strict";\nconst EXPLORE = {data};\n{source()}\nEXPLORE.solve = solve; EXPLORE.thresholds = thresholds;\nglobalThis.inertialPair = EXPLORE;\n}})();'
    return f"<style>\n{_beside('explore.css')}</style>\n{body}<script>\n{program}\n</script>\n"


def page(beside: Iterable[str] = ()) -> str:
    """Return a whole page with nothing but the section, `beside` which pages of rows it stands."""
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<title>{escape(TITLE)}</title>\n<style>\n{_beside('page.css')}</style>\n</head>\n<body>\n<main>\n"
        f"<h1>{escape(TITLE)}</h1>\n{section(beside)}</main>\n</body>\n</html>\n"
    )


def critical_ratio() -> float:
    """Return the mass ratio m1/m2 from which on nothing on S above E_cr merges, rounded up from a proved enclosure."""
    from paper_checks.claims.critical_ratio import critical_value
    from paper_checks.decide.balls import precision

    with precision():
        share = critical_value()
        return float(((1 - share) / share).upper())


def _buttons(buttons: Iterable[Button], first: int) -> str:
    return "\n".join(
        f'<button type="button" data-scene="{number}" aria-pressed="false">{escape(one.label)}</button>'
        for number, one in enumerate(buttons, first)
    )


def _rows(sliders: Iterable[Slider]) -> str:
    return "\n".join(_row(one) for one in sliders)


def _row(one: Slider) -> str:
    label, value = escape(one.label), getattr(Reduced(), one.name, 0)
    return (
        f'<div class="explore-row" data-name="{one.name}" data-scale="{one.scale}" data-low="{one.low}" data-high="{one.high}">'
        f'<label for="explore-{one.name}">{label}</label>'
        f'<input type="range" id="explore-{one.name}" min="0" max="1000" step="1">'
        f'<input type="number" aria-label="{label}, as a number" min="{one.least}" max="{one.most}" step="any" value="{value}"></div>'
    )


def _beside(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")
