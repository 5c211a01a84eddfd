"""The sharp rate: t (E - E_cr) against time for three frictions, each over the limit that the theorem gives its pair."""

from __future__ import annotations

import sympy as sp
from matplotlib.figure import Figure

from numerics.free.energy import energy_at
from numerics.scene import Scene
from numerics.scene.file import load_scene
from paper_checks.claims.letters import ECR, RATE
from paper_checks.drawing.style import FRICTIONS, panels
from theory.energy import critical_energy
from theory.symbols import a2, b, m1, m2

TIMES = tuple(sorted({round(10 ** (k / 4)) for k in range(4, 17)}))
"""The times that are drawn, s."""


def ratio(scene: Scene, time: int) -> float:
    """Return t (E - E_cr) over its limit at a time in s, from an enclosure, binary64."""
    pair = scene.pair
    excess = float(pair.critical_energy) * float(energy_at(scene, time, digits=8).energy_excess.mid())
    values = {m1: pair.m1, m2: pair.m2, a2: pair.a2, b: pair.b}
    exact = {symbol: sp.Rational(value.numerator, value.denominator) for symbol, value in values.items()}
    return time * excess / float(RATE.subs(ECR, critical_energy()).subs(exact))


def sharp_rate() -> Figure:
    """Draw that ratio from 10 s to 10,000 s."""
    figure, axes = panels(4.4, 3.0)  # narrow, so that its letters read on a telephone
    for name, friction, colour, dashes in FRICTIONS:
        scene = load_scene(name)
        axes.semilogx(TIMES, [ratio(scene, time) for time in TIMES], color=colour, ls=dashes, label=f"$b={friction}$ N")
    axes.axhline(1, color="black", lw=0.8, ls=":")
    axes.set(xlabel="$t$ (s)", ylabel="$t\\,(E-E_{cr})$ over its limit\n(dimensionless)", ylim=(0.6, 2))
    axes.legend()
    return figure
