"""The 1/t law: the energy above E_cr up to 10^100 s, and its product with t over the limit that theory gives."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from matplotlib.figure import Figure

from numerics.free.energy import energy_at
from numerics.scene import Pair
from numerics.scene.file import load_scene
from paper_checks.claims.letters import ECR, RATE
from paper_checks.drawing.style import panels
from theory.energy import critical_energy
from theory.symbols import a2, b, m1, m2

LAST = 100
"""The decimal logarithm of the latest time that is drawn, in s."""
RATE_SCENES = (
    ("start-with-speed", "$b=0.5$ N", "#2e8b3d", "s"),
    ("relative-motion-b02", "$b=0.2$ N", "#c8641e", "D"),
    ("velocities", "$b=0.05$ N", "#1b4f8f", "o"),
)


@cache
def approach(name: str) -> tuple[tuple[int, float, float], ...]:
    """Return (k, log10 of E - E_cr in J, t (E - E_cr) over its limit) at t = 10^k s, from enclosures, binary64."""
    scene = load_scene(name)
    critical = float(scene.pair.a2 * scene.pair.half_width**2 / 2)
    limit = float(limit_of(scene.pair))
    found = []
    for k in (*range(1, 10), *range(10, LAST + 1, 10)):
        excess = energy_at(scene, 10**k, digits=8).energy_excess
        logarithm = float(excess.mid().log()) / np.log(10) + np.log10(critical)
        found.append((k, logarithm, 10 ** (k + logarithm) / limit))
    return tuple(found)


def limit_of(pair: Pair) -> sp.Expr:
    """Return the limit of t (E - E_cr) for a pair, J s, exactly: what the row `sharp-rate-constant` states and decides."""
    values = {m1: pair.m1, m2: pair.m2, a2: pair.a2, b: pair.b}
    return RATE.subs(ECR, critical_energy()).subs(
        {symbol: sp.Rational(value.numerator, value.denominator) for symbol, value in values.items()}
    )


def sharp_rate() -> Figure:
    """Draw E - E_cr to 10^100 s for three frictions, both logarithmic, and its product with t over the limit."""
    figure, (upper, lower) = panels(4.4, 6.2, 2, 1)  # narrow, so that its letters read on a telephone
    for name, label, colour, marker in RATE_SCENES:
        k, logarithm, ratio = np.array(approach(name)).T
        style: dict[str, Any] = {"color": colour, "marker": marker, "ms": 4}
        upper.plot(k, logarithm, lw=1, label=label, **style)
        early = k < 10
        lower.plot(k[early], ratio[early], lw=1, label=label, **style)
    lower.axhline(1, color="black", lw=0.8, ls=":")
    for axis in (upper.xaxis, upper.yaxis, lower.xaxis):
        axis.set_major_formatter(lambda power, _: f"$10^{{{power:.0f}}}$")
    upper.set(xlabel="$t$ (s)", ylabel="$E-E_{cr}$ (J)", title="slope $-1$ up to $10^{100}$ s")
    lower.set(xlabel="$t$ (s)", ylabel="$t\\,(E-E_{cr})$ over its limit\n(dimensionless)",
              title="one limit for each pair", ylim=(0, None))  # fmt: skip
    upper.legend(loc="upper right")
    lower.legend(loc="best")
    return figure
