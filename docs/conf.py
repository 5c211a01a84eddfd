"""Sphinx: how these pages are built. They open from disk and fetch nothing: formulas are MathML, fonts the reader's."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from math_core import LatexToMathML

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

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


def as_rest(_app: Any, _what: str, _name: str, _object: Any, _options: Any, lines: list[str]) -> None:
    """Turn a docstring, which is plain text, into reStructuredText: tables stay as they are, no letter is markup."""
    blocks = "\n".join(lines).strip("\n").split("\n\n")
    lines[:] = "\n\n".join(map(_block, blocks)).split("\n")


def _block(block: str) -> str:
    if block.lstrip().startswith(">>>"):
        return block
    if block.startswith(" ") or re.search(r"\S {3,}\S", block):
        return "::\n\n" + "\n".join(f"    {line}" for line in block.split("\n"))
    return "".join(
        f"`{part}`" if part[:1] == "`" else re.sub(r"([*|_\\])", r"\\\1", part) for part in _CODE.split(block)
    )


def setup(app: Any) -> None:
    """Register both."""
    app.add_html_math_renderer("mathml", inline_renderers=(in_mathml, None), block_renderers=(in_mathml, None))
    app.connect("autodoc-process-docstring", as_rest)
