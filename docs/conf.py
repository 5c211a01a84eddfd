"""Sphinx: how these pages are built. They open from disk and fetch nothing: formulas are MathML, fonts the reader's."""

from __future__ import annotations

import inspect
import re
import sys
from pathlib import Path
from typing import Any

from math_core import LatexToMathML

sys.path[:0] = [str(Path(__file__).resolve().parent.parent), str(Path(__file__).resolve().parent)]

from rendered import render  # noqa: E402

from numerics.trajectory.units import unit  # noqa: E402

project = "inertial-pair"
author = "The inertial-pair authors"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
exclude_patterns = ["_build"]
html_theme = "alabaster"
html_title = "inertial-pair"
html_theme_options = {
    "fixed_sidebar": True,
    "page_width": "1260px",
    "body_max_width": "1000px",
    "code_font_size": "0.78em",  # with the comment at its end a line of an example fits
    "description": "Two masses, one dry contact",
    "show_powered_by": False,
}
html_sidebars = {"**": ["about.html", "searchfield.html", "navigation.html"]}
html_math_renderer = "mathml"
html_copy_source = False
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_preserve_defaults = True
html_show_copyright = False

_CODE = re.compile(r"(`[^`]+`)")


def in_mathml(translator: Any, node: Any) -> None:
    """Write a formula, inline or on a line of its own, as MathML."""
    from docutils.nodes import SkipNode

    is_block = node.tagname == "math_block"
    formula = LatexToMathML().convert_with_local_state(node.astext(), displaystyle=is_block)
    formula = formula.replace(' accent="true"', "")  # a dot would touch its letter
    translator.body.append(f"<p>{formula}</p>" if is_block else formula)
    raise SkipNode


def as_rest(_app: Any, what: str, _name: str, documented: Any, _options: Any, lines: list[str]) -> None:
    """Turn a docstring, which is plain text, into reStructuredText: tables stay as they are, no letter is markup.

    A function, or a class that users build, has a table of its parameters.
    """
    blocks = [_block(one) for one in "\n".join(lines).strip("\n").split("\n\n")]
    if what in {"function", "method", "class"}:
        blocks += _parameters(documented)
    lines[:] = "\n\n".join(blocks).split("\n")


def _parameters(documented: Any) -> list[str]:
    """Return the table of the parameters of a function or a class, without those of two or fewer."""
    try:
        known = [one for name, one in inspect.signature(documented).parameters.items() if name not in {"self", "cls"}]
    except (TypeError, ValueError):
        return []
    if len(known) < 3:
        return []
    rows = [("parameter", "type", "default", "unit")]
    for one in known:
        default = "" if one.default is one.empty else f"``{one.default!r}``"
        kind = "" if one.annotation is one.empty else f"``{one.annotation}``"
        rows.append((one.name, kind, default, unit(one.name)))
    table = ("\n".join(f"   {'* -' if k == 0 else '  -'} {cell}" for k, cell in enumerate(row)) for row in rows)
    return [".. list-table::\n   :header-rows: 1\n\n" + "\n".join(table)]


def _block(block: str) -> str:
    if block.lstrip().startswith(">>>"):
        return block
    if block.startswith(" ") or re.search(r"\S {3,}\S", block):
        return "::\n\n" + "\n".join(f"    {line}" for line in block.split("\n"))
    return "".join(
        f"`{part}`" if part[:1] == "`" else re.sub(r"([*|_\\])", r"\\\1", part) for part in _CODE.split(block)
    )


def setup(app: Any) -> None:
    """Register them, and run the notebooks before the pages are read."""
    app.add_html_math_renderer("mathml", inline_renderers=(in_mathml, None), block_renderers=(in_mathml, None))
    app.connect("autodoc-process-docstring", as_rest)
    app.connect("builder-inited", lambda _: render())
