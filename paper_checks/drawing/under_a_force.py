"""The pair under a force: thresholds, resonance, the fastest transfer, Fig. 1 for a scene."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from numerics.control.answers import solved_again
from numerics.control.pictures import draw_ring, draw_thresholds, draw_transfer
from numerics.control.ring import ring_entry
from numerics.control.transfer import fastest_transfer
from numerics.scene import Force, Pair, Piece, Scene, Sine, State
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trajectory.figures import marks_of
from paper_checks.drawing.style import BODY_1, BODY_2, panels, samples
from theory import critical_resonance as critical
from theory.forced_response import natural
from theory.symbols import b, m1

PAIR, DAMPED = Pair(1, 1, 200, "0.5"), Pair(1, 1, 200, "0.5", 2)
"""The paper's case study with b = 0.5 N, and the same with a damper."""
RESONANT = Pair(1, 1, 100, "0.5")
"""A pair whose body 1 alone has the frequency 10/s."""
EDGE = 4 * float(RESONANT.b) / np.pi
"""The amplitude at that frequency, N, that friction can just take, in double precision."""
DRIVEN = Scene(DAMPED, State(), until=4, force=Force.sine("0.5", 12))


def thresholds_over_frequency() -> Figure:
    """Draw U*, U** and the edge of the non-stop regime over the frequency, without and with a damper; regimes shaded."""
    figure, both = panels(9.4, 4.4, 1, 2)
    for ax, pair, title in zip(both, (PAIR, DAMPED), ("$a_1=0$", "$a_1=2$ N s/m"), strict=True):
        draw_thresholds(pair, np.geomspace(4, 60, 700), ax)
        ax.set_title(title)
        for rate, name in ((pair.a2 / pair.mass, r"$\Omega$"), (pair.a2 / pair.m1, r"$\omega_1$")):
            ax.axvline(float(rate) ** 0.5, color="#777777", lw=0.7, ls=":")
            ax.text(float(rate) ** 0.5, 0.98, name, transform=ax.get_xaxis_transform(), ha="right", va="top")
    marks = marks_of(both[0])
    figure.legend(marks.values(), marks, loc="outside lower center", ncols=2, frameon=False)
    return figure


def resonance() -> Figure:
    """Draw v1 at the resonance of body 1 below and above U = 4b/pi, a1 = 0, and how the amplitude grows at U = 4b/pi."""
    figure, (below, above, at_edge) = panels(12.6, 3.9, 1, 3)
    for ax, amplitude in ((below, "0.6"), (above, "0.7")):
        solved = solve(Scene(RESONANT, State(), until=20, force=Force.sine(amplitude, 10)))
        t, y = samples(solved, 24)
        ax.plot(t, y[1], color=BODY_1, lw=0.9, label="$v_1$")
        ax.plot(t, y[3], color=BODY_2, lw=0.9, ls="--", label="$v_2$")
        rate = (float(amplitude) - EDGE) / (2 * float(RESONANT.m1))
        if rate > 0:
            label = [r"$(U-4b/\pi)\,t/(2m_1)$", "_"]
            ax.plot(t, np.outer(t, (rate, -rate)), color="black", lw=0.8, ls=":", label=label)
        ax.set(xlabel="$t$ (s)", ylabel="velocity (m/s)", title=f"$U={amplitude}$ N, $4b/\\pi={EDGE:.4f}$ N")
    _draw_third_root(at_edge)
    for ax in (below, above, at_edge):
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncols=3)
    return figure


def _draw_third_root(ax: Axes) -> None:
    """Draw |A| period by period at U = 4b/pi: of a sine alone, and with a part at half its frequency beside it."""
    omega, times = float(RESONANT.a2 / RESONANT.m1) ** 0.5, 0.4 * np.pi * np.geomspace(1, 400, 60).round()
    growth = critical.growth_by_one_part().subs(
        {critical.order: Fraction(1, 2), natural: omega, m1: RESONANT.m1, b: RESONANT.b}
    )
    for push, colour in ((Fraction(0), BODY_2), (Fraction(1, 2), BODY_1), (Fraction(1), "black")):
        force = Force([Piece(0, (), [Sine(EDGE, 10, 0), Sine(push, 5, "0.3")])])
        run = solve(Scene(RESONANT, State(), until=510, force=force), t_eval=times, max_events=4_000)
        size = np.hypot(run.y[1], omega * run.y[0])
        ax.loglog(times, size, color=colour, label=f"$p={float(push):g}$ N" if push else "the sine alone")
        if push:
            limit = float(growth.subs(critical.push, push))
            ax.loglog(times, (limit * times) ** (1 / 3), color=colour, lw=0.8, ls=":")
    ax.set(xlabel="$t$ (s)", ylabel="$|A|$ (m/s)", title=r"$U=4b/\pi$, beside it $p\,\sin(\omega_1t/2+0.3)$")


def fastest_transfer_figure() -> Figure:
    """Draw the fastest transfer over 1 mm with a force of at most 1.08 N: body 1 runs ahead, and is met at half time."""
    found = fastest_transfer(load_scene("at-rest"), "0.001", amplitude="1.08")
    solved = solved_again(found)
    assert solved is not None
    return draw_transfer(found, solved)


def tolerance_ring_of_a_scene() -> Figure:
    """Draw Fig. 1 for the scene of Fig. 5: the ring of 1 mm, velocities counted in parts of 20/s."""
    return draw_ring(ring_entry(load_scene("velocities"), "0.001", rate=20))
