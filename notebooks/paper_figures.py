# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # The paper's figures, recomputed
#
# Figures 4 and 5 and the two itineraries of Section III, from exact trajectories, next to the results of the paper's
# integrator, forward Euler. The numbers beside them are computed in balls, to at least 20 right digits, and rounded
# for print.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
from IPython.display import Markdown

from numerics import load_scene, solve
from numerics.linear.modes import Mode
from numerics.trade.forward_euler import forward_euler
from paper_checks.claims.section_3.itineraries import every_excursion, first_exit, starts_below
from paper_checks.drawing.figures import FIGURES

# %% [markdown]
# ## Figure 4 (a)
#
# From rest at $x_1(0)=0.006$ m, with $b=0.5$ N. The paper sees stiction at all times.

# %%
FIGURES["start-at-6mm"]()

# %%
scene = load_scene("start-at-6mm")
pair, start = scene.pair, scene.initial
print(f"half width of the sliding region: L = {float(pair.half_width)} m, start: x1(0) = {float(start.x1)} m")
needed = pair.m2 * pair.a2 * start.x1 / pair.mass
print(f"force that sticking takes: {float(needed)} N, friction: b = {float(pair.b)} N")

# %% [markdown]
# The start lies outside the sliding region: friction cannot hold the pair there, and it slips at once.

# %%
exact = solve(scene, digits=20, arithmetic="ball")
print(", ".join(mode.value for mode in exact.modes[:5]), "...")
print(f"first adhesion at t = {exact.events[0].t.str(15)} s")

# %% [markdown]
# The picture of the paper is what eqs (11), (12) give when sgn(0) = 0 is read literally: at $\dot z=0$ the pair
# sticks, whatever force that requires.

# %%
literal = load_scene("start-at-6mm-literal")
print(solve(literal, digits=20, arithmetic="ball").message)
for step in (1e-3, 1e-4):
    run = forward_euler(literal, step)
    stuck, growth = run.exact_contacts / len(run.t), run.energy[-1] / run.energy[0]
    print(f"Euler, step {step:g} s: v1 = v2 at {stuck:.0%} of the steps, energy after 5 s: {growth:.4f} E(0)")

# %% [markdown]
# Forward Euler starts at $\dot z=0$ exactly and stays there, while its energy grows.

# %% [markdown]
# ## Figure 4 (b)
#
# From $\dot x_1(0)=0.15$ m/s, with $b=0.5$ N. The paper sees the bodies synchronise after a period of time.

# %%
FIGURES["start-with-speed"]()

# %%
exact = solve(load_scene("start-with-speed"), digits=20, arithmetic="ball")
print(", ".join(mode.value for mode in exact.modes[:8]), "...")
entry, leaving = exact.events[1:3]
print(f"first adhesion from {entry.t.str(12)} s to {leaving.t.str(12)} s")

# %% [markdown]
# The bodies stick and slip in turn. Read literally, (11) and (12) hold them together from the first contact on,
# outside the sliding region.

# %%
literal = solve(load_scene("start-with-speed-literal"), digits=20, arithmetic="ball")
contact = literal.events[0]
print(f"contact at t = {contact.t.str(12)} s, x1 = {contact.y[0].str(12)} m")
print(literal.message)

# %% [markdown]
# ## Figure 5 (a)
#
# The same start with $b=0.05$ N. The paper sees both bodies synchronise at $t\approx 4.7$ s.

# %%
FIGURES["velocities"]()

# %%
exact = solve(load_scene("velocities"), digits=20, arithmetic="ball")
adhesions = [
    f"| {begin.str(12, radius=False)} | {end.str(12, radius=False)} | {(end - begin).str(6, radius=False)} |"
    for mode, begin, end in zip(exact.modes, exact.t, exact.t[1:], strict=False)
    if mode is Mode.STICK and end < exact.t[-1]
]
Markdown("| sticks from (s) | until (s) | for (s) |\n|---|---|---|\n" + "\n".join(adhesions))

# %% [markdown]
# The first adhesion is at 4.5498 s and lasts 0.03 s. At 4.7 s the pair is slipping.

# %%
print(f"mode at 4.7 s: {exact.mode_at('4.7').value}")
for step in (1e-3, 1e-4):
    run = forward_euler(load_scene("velocities-literal"), step)
    print(f"Euler, step {step:g} s: v1 = v2 at {run.exact_contacts} steps, chatter: {run.chatter} changes of sign")

# %% [markdown]
# After its start forward Euler never meets $v_1=v_2$ exactly. What looks like adhesion is chatter, and with a step of
# 1 ms there is not even that within 5 s.

# %% [markdown]
# ## Figure 5 (b)
#
# The relative motion $(z,\dot z)$ for three values of $b$. The paper sees it converge to $\dot z=0$.

# %%
FIGURES["relative-motion"]()

# %%
runs = {
    f"$b={float(scene.pair.b):g}$": solve(scene, digits=25, arithmetic="ball")
    for scene in map(load_scene, ("relative-motion-b005", "relative-motion-b02", "relative-motion-b05"))
}
rows = [
    f"| {name} | {next(event.t for event in run.events if event.after is Mode.STICK).str(8, radius=False)} "
    f"| {first_exit(run).t.str(8, radius=False)} | {sum(event.before is Mode.STICK for event in run.events)} "
    f"| {first_exit(run).reduced.w.str(6, radius=False)} | {run.reduced.final.w.str(6, radius=False)} |"
    for name, run in runs.items()
]
head = "| | first adhesion (s) | it ends (s) | exits up to 5 s | $w$ at the first exit | $w$ at 5 s |"
Markdown("\n".join([head, "|---|---|---|---|---|---|", *rows]))

# %% [markdown]
# $\dot z$ becomes small, but none of the three runs ever merges with a periodic orbit. The reason is an argument about
# one excursion from a ray, valid for $m_2\leqslant m_1$, whose assumption holds at the first exit of each run:

# %%
evidence = [*every_excursion(), *(item for name, run in runs.items() for item in starts_below(run, name))]
rows = [f"| {item.statement} | {item.engine} | {item.passed} |" for item in evidence]
Markdown("| statement | checked by | found true |\n|---|---|---|\n" + "\n".join(rows))

# %% [markdown]
# So after every slip $0<w'<w$: the pair sticks, leaves by a ray again, and so on without end.

# %% [markdown]
# ## The two itineraries of Section III
#
# The paper draws them without numbers; these scenes exhibit them. Both are projected on the plane $S$.

# %%
FIGURES["itinerary-that-merges"]()

# %%
merging = solve(load_scene("itinerary-that-merges"), digits=20, arithmetic="ball")
print(", ".join(mode.value for mode in merging.modes))
print(f"w after the slip: {merging.reduced.final.w.str(12)}; {merging.message}")

# %% [markdown]
# (a) The pair enters the sliding region once, with $w<0$, and stays on an orbit below $E_{cr}$.

# %%
FIGURES["itinerary-that-creeps"]()

# %%
winding = solve(load_scene("itinerary-that-creeps"), digits=20, arithmetic="ball")
points = ("A1", "B1", "A2", "C1", "B2", "D1", "A3")
rows = [
    f"| {point} | {event.kind.value} | {event.t.str(8, radius=False)} | {event.y[0].str(8, radius=False)} "
    f"| {event.reduced.w.str(8, radius=False)} |"
    for point, event in zip(points, winding.events, strict=True)
]
Markdown("| point | event | $t$ (s) | $x_1$ (m) | $w$ |\n|---|---|---|---|---|\n" + "\n".join(rows))

# %% [markdown]
# (b) O1 to O2 as in the paper: two crossings, then stick and slip in turn with $w>0$.
