"""Fig. 4 (a), (b) and Fig. 5 (b): phase portraits, the exact solution beside forward Euler."""

from __future__ import annotations

from fractions import Fraction

from matplotlib.figure import Figure

from paper_checks.drawing.style import (
    BODY_1,
    BODY_2,
    FRICTIONS,
    MM,
    SLIDING,
    STEP_TEXT,
    euler,
    mark_events,
    panels,
    samples,
    solved,
)

SHOWN = Fraction(3, 2)
"""How long Fig. 4 is drawn, s: more would fill the picture with ever the same."""


def start_at_6mm() -> Figure:
    """Draw both bodies from x1(0) = 0.006 m, b = 0.5 N."""
    title = "Fig. 4 (a): $b=0.5$ N, $x_1(0)=6$ mm, else 0; up to $t=1.5$ s"
    return _bodies("start-at-6mm", title, "slips at once, never sticks for good", "stuck")


def start_with_speed() -> Figure:
    """Draw both bodies from v1(0) = 0.15 m/s, b = 0.5 N."""
    title = "Fig. 4 (b): $b=0.5$ N, $\\dot x_1(0)=150$ mm/s, else 0; up to $t=1.5$ s"
    return _bodies("start-with-speed", title, "stick and slip alternate permanently", "chatter")


def _bodies(scene: str, title: str, found: str, by_euler: str) -> Figure:
    figure, (first, second) = panels(8.2, 4.4, 1, 2, sharex=True, sharey=True)
    exact, half = solved(scene, SHOWN), MM * float(solved(scene, SHOWN).scene.pair.half_width)
    of_euler = f"forward Euler on (11), (12), step {STEP_TEXT}: {by_euler}"
    run = euler(f"{scene}-literal", SHOWN).y[:, ::10]
    for axes, name, y in ((first, f"exact: {found}", samples(exact)[1]), (second, of_euler, run)):
        x1, v1, x2, v2 = MM * y
        axes.axvspan(-half, half, color=SLIDING, zorder=0, linewidth=0, label="$S_0$: $|x_1|\\leqslant L$")
        axes.plot(x1, v1, color=BODY_1, label="body 1: $(x_1,\\dot x_1)$")
        axes.plot(x2, v2, color=BODY_2, ls=(0, (5, 1.5)), label="body 2: $(x_2,\\dot x_2)$")
        axes.plot([x1[0], x2[0]], [v1[0], v2[0]], linestyle="none", marker="s", ms=4.5, color="black", label="start")
        axes.set(xlabel="position (mm)", ylabel="velocity (mm/s)", title=name)
    mark_events(first, exact, 1, against=0)
    figure.suptitle(title, fontsize=10)
    figure.legend(*first.get_legend_handles_labels(), loc="outside lower center", ncols=7)
    return figure


def relative_motion() -> Figure:
    """Draw z' against z for the three values of b, and the end of it in close-up, where forward Euler differs."""
    figure, (whole, end) = panels(8.2, 4.2, 1, 2)
    for name, friction, colour, dashes in FRICTIONS:
        x1, v1, x2, v2 = MM * samples(solved(name))[1]
        for axes in (whole, end):
            axes.plot(x1 - x2, v1 - v2, color=colour, ls=dashes, label=f"$b={friction}$ N")
        of_euler = MM * euler(name).y[:, ::5]
        end.plot(of_euler[0] - of_euler[2], of_euler[1] - of_euler[3], color=colour, lw=0.8, alpha=0.45)
    end.plot([], [], color="black", lw=0.8, alpha=0.45, label=f"forward Euler, step {STEP_TEXT}")
    for axes in (whole, end):
        axes.axhline(0, color="black", lw=0.6, zorder=1)
        axes.set(xlabel="$z=x_1-x_2$ (mm)", ylabel="$\\dot z=\\dot x_1-\\dot x_2$ (mm/s)")
    whole.set_title("Fig. 5 (b), exact: $\\dot x_1(0)=150$ mm/s, else 0")
    end.set(xlim=(-0.2, 1.7), ylim=(-6, 9), title="close-up of the end")
    figure.legend(*end.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure
