"""The interactive page: one file, no network, the same bytes every time."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from paper_checks.explore.scenes import buttons

SOLVER = ("oscillator", "first_root", "solver")
"""What solves; it knows no page."""
SCRIPTS = (*SOLVER, "regimes", "scene_file", "scene3d", "strips", "controls", "player", "main")
"""The page's programs in the order in which they are joined."""
FOLDER = Path(__file__).parent


def source(names: Iterable[str] = SCRIPTS) -> str:
    """Return the programs of the page, joined."""
    return "\n".join(FOLDER.joinpath(f"{name}.js").read_text(encoding="utf-8") for name in names)


def page(beside: Iterable[str] = ()) -> str:
    """Return the page; beside a report with these claims, what is said of all runs links to them."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    from markupsafe import Markup

    templates = Environment(loader=FileSystemLoader(FOLDER), autoescape=True, undefined=StrictUndefined)
    (paper, own), known = buttons(), [*beside]
    return templates.get_template("explore.html").render(
        style=Markup(FOLDER.joinpath("explore.css").read_text(encoding="utf-8")),
        program=Markup(source()),
        data={"scenes": [*paper, *own], "criticalRatio": critical_ratio(), "beside": known},
        paper=paper,
        own=own,
        beside=known,
    )


def critical_ratio() -> float:
    """Return the mass ratio m1/m2 from which on nothing on S above E_cr merges, rounded up from a proved enclosure."""
    from paper_checks.claims.beyond.critical_ratio import critical_value
    from paper_checks.decide.balls import precision

    with precision():
        share = critical_value()
        return float(((1 - share) / share).upper())
