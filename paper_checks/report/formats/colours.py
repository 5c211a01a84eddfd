"""Figures in light and in dark: every colour of an SVG becomes a variable with a value for each."""

from __future__ import annotations

import colorsys
import re
from collections.abc import Iterable

_HEX = re.compile(r"#([0-9a-fA-F]{6})\b")
_PAGE = {"ffffff": "var(--paper)", "000000": "var(--ink)"}
"""White and black are the page's own."""
_INK, _PAPER = 0.90, 0.10
"""Lightness of what is black and of what is white on a light page, on a dark one (HLS, dimensionless)."""


def themed(svg: str) -> str:
    """Return the SVG with each colour as `var(--c-rrggbb)`; what has no colour of its own is black, and turns too."""
    return _HEX.sub(lambda match: f"var(--c-{match[1].lower()})", svg)


def rules(svgs: Iterable[str]) -> str:
    """Return the CSS that gives every colour in these SVGs (as drawn, not yet themed) its two values."""
    found = sorted({match[1].lower() for svg in svgs for match in _HEX.finditer(svg)})
    light = "".join(f" --c-{one}: {_PAGE.get(one, '#' + one)};" for one in found)
    dark = "".join(f" --c-{one}: {dark_of(one)};" for one in found if one not in _PAGE)
    return f":root {{{light} }}\n@media screen and (prefers-color-scheme: dark) {{ :root {{{dark} }} }}\n"


def dark_of(colour: str) -> str:
    """Return the colour for a dark page: the same hue, its lightness turned over.

    >>> dark_of("000000"), dark_of("ffffff")
    ('#e6e6e6', '#191919')
    """
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (0, 2, 4))
    hue, lightness, saturation = colorsys.rgb_to_hls(red, green, blue)
    turned = _INK + (_PAPER - _INK) * lightness
    return "#" + "".join(f"{round(255 * one):02x}" for one in colorsys.hls_to_rgb(hue, turned, 0.9 * saturation))
