"""Figures in light and in dark: every colour of an SVG becomes a variable with a value for each."""

from __future__ import annotations

import colorsys
import re

_HEX = re.compile(r"#([0-9a-fA-F]{6})\b")
_PAGE = {"ffffff": "#fdfcf9", "000000": "#1b1b1a"}
"""White and black are those of the page."""
_INK, _PAPER = 0.90, 0.10
"""Lightness of what is black and of what is white on a light page, on a dark one (HLS, dimensionless)."""


def themed(svg: str) -> str:
    """Return the SVG with each colour as `var(--c-rrggbb)`, and a style that gives it its two values."""
    found = sorted({match[1].lower() for match in _HEX.finditer(svg)} | {"000000"})
    light = "".join(f"--c-{one}:{_PAGE.get(one, '#' + one)};" for one in found)
    dark = "".join(f"--c-{one}:{dark_of(one)};" for one in found)
    rules = f"svg{{{light}fill:var(--c-000000)}}@media screen and (prefers-color-scheme: dark){{svg{{{dark}}}}}"
    whole = _HEX.sub(lambda match: f"var(--c-{match[1].lower()})", svg)
    return re.sub(r"(<svg\b[^>]*>)", rf"\1<style>{rules}</style>", whole, count=1)


def dark_of(colour: str) -> str:
    """Return the colour for a dark page: the same hue, its lightness turned over.

    >>> dark_of("000000"), dark_of("ffffff")
    ('#e6e6e6', '#191919')
    """
    red, green, blue = (int(colour[i : i + 2], 16) / 255 for i in (0, 2, 4))
    hue, lightness, saturation = colorsys.rgb_to_hls(red, green, blue)
    turned = _INK + (_PAPER - _INK) * lightness
    return "#" + "".join(f"{round(255 * one):02x}" for one in colorsys.hls_to_rgb(hue, turned, 0.9 * saturation))
