"""The force that sticking needs in Fig. 4 (a), beside what friction has."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from numerics.scene.file import load_scene
from paper_checks.drawing.style import BODY_1, panels


def force_needed() -> Figure:
    """Draw the size of the force that keeps the bodies of Fig. 4 (a) together, |m2 x1''| when stuck, and what friction has."""
    scene = load_scene("start-at-6mm")
    pair = scene.pair
    rate = float(pair.a2 / pair.mass) ** 0.5
    most, available = float(pair.m2 * pair.a2 / pair.mass * scene.initial.x1), float(pair.b)
    t = np.linspace(0, 2 * np.pi / rate, 401)
    needed = most * np.abs(np.cos(rate * t))
    figure, axes = panels(4.9, 2.8)  # narrow, so that its letters read on a telephone
    axes.plot(t, needed, color=BODY_1, lw=1.6)
    axes.axhline(available, color="black", lw=1.2, ls="--")
    axes.fill_between(t, available, needed, where=(needed > available).tolist(), color="#e8a0a0", lw=0)
    axes.annotate(f"at the start {most:g} N are needed", (0, most), (0.06, most + 0.045), fontsize=9, va="bottom",
                  arrowprops={"arrowstyle": "-", "lw": 0.8})  # fmt: skip
    axes.text(0.157, available + 0.012, f"friction has {available:g} N", ha="center", va="bottom", fontsize=9)
    axes.text(0.314, 0.3, "needed, if the\nbodies stuck", ha="center", va="center", fontsize=9, color=BODY_1)
    axes.set(xlim=(0, t[-1]), ylim=(0, 0.75), xlabel="$t$ (s)", ylabel="size of the force\nbetween the bodies (N)")
    return figure
