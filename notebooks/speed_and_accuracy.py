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
# # Speed and accuracy
#
# Speed against accuracy. First a measurement that was made once and is shipped, and what follows from it; then one
# scene here and now; then how to ask for an accuracy instead of a method, and what a run is really off by.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import HTML

from numerics import Scene, State, load_scene, solve, solve_many
from numerics.trade.command import print_trade
from numerics.trade.figure import draw_trade
from numerics.trade.measure import trade
from numerics.trade.recorded import recorded
from paper_checks.report.content import speed
from paper_checks.report.content.blocks import section
from paper_checks.report.formats.html import fragment

# %% [markdown]
# ## The recorded measurement
#
# First what follows from it, computed from its numbers; then the figure. Each small mark is a run on one scene.
# Filled marks have the event sequence right, hollow ones have it wrong.

# %%
measured = recorded()
HTML(fragment(section(speed.text(measured))))

# %%
speed.figures(measured)["work-precision"]()

# %% [markdown]
# ## One scene, here and now
#
# The paper's scene with $b=0.5$ N, 5 s. What is not installed is left out and named; on the command line this is
# `python -m numerics trade SCENE`, with a scene of your own.

# %%
scene = load_scene("relative-motion-b05")
here = trade({"relative-motion-b05": (scene, "")}, digits=100)
print_trade(here)
draw_trade(here)

# %% [markdown]
# ## Ask for digits, not for a method
#
# `solve(scene, digits=N)` takes the cheapest arithmetic that delivers $N$ right digits of every event and of the final
# state; `tried` says what it looked at.

# %%
for digits in (5, 10, 20, 100):
    run = solve(scene, digits=digits)
    print(f"{digits:>3} digits: {run.arithmetic.name}; tried: {run.tried}")

# %% [markdown]
# In float64 the digits come from error bounds that are carried from event to event. The bounds belong to the answer:

# %%
fast = solve(scene)
accuracy = fast.accuracy
last = fast.events[-1]
print(f"last event at {last.t!r} s, right to {accuracy.t[-1]:.1e} s")
print(f"final state  {[float(f'{value:.6g}') for value in fast.y[:, -1]]}, right to {max(accuracy.final):.1e}")
print(f"dissipated   {fast.ledger.friction:.12g} J, right to {accuracy.dissipated:.1e} J")
print(
    f"{accuracy.digits} digits of every one of these are right; the order of the events is certain: {accuracy.certain}"
)

# %% [markdown]
# What they are really off by, the scene solved again in balls says:

# %%
print(fast.check())

# %% [markdown]
# ## Many scenes
#
# `solve_many` takes arrays and gives arrays, right digits among them. Here the initial speed runs up to the paper's;
# without numba the same text runs as plain Python.

# %%
pair = scene.pair
speeds = np.linspace(0.01, 0.15, 1500)
many = solve_many(float(pair.m1), float(pair.m2), float(pair.a2), float(pair.b), v1=speeds, until=5, jobs=1)
figure, (top, bottom) = plt.subplots(2, 1, figsize=(8, 5), sharex=True, layout="constrained")
top.plot(1000 * speeds, many.events, "k.", ms=2)
top.set(ylabel="events in 5 s")
bottom.plot(1000 * speeds, many.digits, "k.", ms=2)
bottom.set(xlabel=r"$\dot x_1(0)$ (mm/s)", ylabel="right digits", ylim=(0, 17), yticks=[0, 5, 10, 15])
plt.show()
print(f"{len(speeds)} scenes, {many.events.sum()} events; at least {many.digits.min()} right digits")

# %% [markdown]
# A scene with too few digits says so. It is the one to solve again with `digits=N`:

# %%
worst = int(np.argmin(many.digits))
print(f"fewest digits: {many.digits[worst]}, from v1(0) = {speeds[worst]:.6f} m/s with {many.events[worst]} events")
again = solve(Scene(pair, State(v1=speeds[worst]), until=5), digits=12)
print(f"asked for 12: {again.arithmetic.name}; tried: {again.tried}")
