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
# How fast is how exact? First a measurement that was made once and is shipped; then a small one here and now; then
# how to ask for an accuracy instead of a method; last the advice that follows from the measurement.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Markdown, display

from numerics import Scene, Solver, State, load_scene, solve, solve_many
from numerics.trade.clock import timed
from numerics.trade.contender import all_contenders
from numerics.trade.judge import judge
from numerics.trade.recorded import recorded
from numerics.trade.reference import POINT_DIGITS, proved
from numerics.trade.scenes import HEADLINE
from numerics.trade.table import error_text, seconds_text
from paper_checks.report.content.blocks import Section
from paper_checks.report.formats.markdown import markdown
from paper_checks.speed import section

# %% [markdown]
# ## The recorded measurement

# %%
trade = recorded()
drawn = section.figures(trade)
Markdown(markdown(Section("measured", "On what it was measured", tuple(section.provenance(trade)))))

# %% [markdown]
# Each panel is a scene, each mark a method at one setting. Filled marks have the event sequence right, hollow ones have
# it wrong; the black line is the front, the right runs that no other right run beats in both time and digits.

# %%
drawn[section.WORK_PRECISION]()

# %% [markdown]
# How our own cost grows: with digits, beside one sine and cosine at so many digits; with the events; with the mass
# ratio; and for batches with their size.

# %%
display(*(draw() for name, draw in drawn.items() if name != section.WORK_PRECISION))

# %% [markdown]
# ## A small one, here and now
#
# The paper's scene with $b=0.5$ N, 5 s. What a user calls (`solve`, `Solver`, `solve_many`, `ball`) stands beside the
# runs inside (`float64`, `double-double`). What is not installed is named.

# %%
scene = load_scene(HEADLINE)
truth = proved(scene)
wanted = ("float64", "double-double", "solve", "Solver", "ball", "SciPy DOP853", "heyoka (edge coordinates)")
rows = []
for one in all_contenders():
    if one.takes(scene) and one.label.startswith(wanted):
        if one.missing():
            rows.append(f"| {one.label} | | not installed: needs {one.missing()} | | |")
            continue
        for setting in dict.fromkeys((one.settings[0], 100.0 if one.knob == "digits" else one.settings[-1])):
            call = one.prepare(scene, setting)
            took = timed(call, budget=0.2).seconds
            found = judge(one.outcome(call()), truth, POINT_DIGITS, scene)
            word = "right" if found.right else f"wrong: {found.difference}"
            rows.append(f"| {one.label} | {setting:g} | {seconds_text(took)} | {error_text(found.error)} | {word} |")
head = "| method | setting | warm time | error | events |\n|---|---|---|---|---|\n"
Markdown(head + "\n".join(rows))

# %% [markdown]
# The error is the largest of that of the final state, the last event's time and the dissipated energy. It is bounded by
# a reference of 40 digits: errors of balls below that cannot be told from 0 here.

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
# ## One pair, many starts, in your own loop
#
# A prepared `Solver` has read its pair; what is left is one run. Here it looks for the speed from which the pair makes
# its tenth event within 5 s.

# %%
solver = Solver(scene.pair)
low, high = 0.0, 0.15
while high - low > 1e-6:
    middle = (low + high) / 2
    low, high = (low, middle) if len(solver(State(v1=middle), 5).t) > 11 else (middle, high)
print(f"ten events from v1(0) = {high:.6f} m/s")

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

# %% [markdown]
# ## What follows

# %%
Markdown(markdown(section.advice_alone(trade)))
