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
# # One scene, explored
#
# A scene is a pair of bodies, an initial state and a horizon. Here one scene is built, solved in three arithmetics,
# asked for more and more digits, and taken to the limits of double precision and of ball arithmetic.
# The pair is that of the paper's Fig. 5 (a): unit masses, $a_2=200$ N/m, $b=0.05$ N, $\dot x_1(0)=0.15$ m/s.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import textwrap
from fractions import Fraction
from itertools import accumulate, islice

import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Latex, Markdown, display

from numerics import Pair, Scene, State, sensitivities, solve
from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided, PrecisionExhausted
from numerics.free.frame import Frame
from numerics.free.motion import excursions
from numerics.linear.modes import EventKind
from numerics.trajectory.comparison import distance
from numerics.trajectory.export import as_record
from numerics.trajectory.figures import overview
from paper_checks.evidence.formula import equation
from theory.near_critical import rate_constant
from theory.symbols import a2, b, m1, m2

# %% [markdown]
# ## Build it
#
# Numbers are read as exact decimals: `0.05` is $1/20$, not the nearest binary number. So is everything that follows
# from them without a root.

# %%
pair = Pair(m1=1, m2=1, a2=200, b="0.05")
scene = Scene(pair, State(v1="0.15"), until=5)
display(
    Markdown(
        f"$L={pair.half_width}$ m, half width of the sliding region; $E_{{cr}}={pair.critical_energy}$ J; "
        f"$w(0)=E(0)/E_{{cr}}-1={scene.energy_excess}$"
    )
)

# %% [markdown]
# ## Solve it
#
# `solve` locates the end of each mode, flows there by the closed form, and records the event. In float64 that takes
# milliseconds. The energy falls towards $E_{cr}$; before 5 s the bodies stick twice, each time for a moment.

# %%
fast = solve(scene)
display(overview(fast))
fast

# %% [markdown]
# The same algorithm runs over mpmath numbers and over balls. With balls the order of all events is proved and every
# number is an enclosure.

# %%
fine = solve(scene, arithmetic="mpmath", digits=30)
proved = solve(scene, digits=50, arithmetic="ball")
assert fast.modes == fine.modes == proved.modes
adhesion = proved.event_kinds.index(EventKind.ENTRY)
print("first adhesion (s)")
for trajectory in (fast, fine, proved):
    print(f"{trajectory.arithmetic.name:>8}  {trajectory.events[adhesion].t}")

# %% [markdown]
# Balls are also the measure of the other two. The largest error of any event time:

# %%
with proved.arithmetic.context():
    for trajectory in (fast, fine):
        errors = [distance(one.t, two.t) for one, two in zip(trajectory.events, proved.events, strict=True)]
        print(f"{trajectory.arithmetic.name:>8}  {float(max(errors).upper()):.1e} s")

# %% [markdown]
# ## Digits on demand
#
# `digits=N` raises the working precision until every event and the final state have $N$ right digits. This is the
# time of the first adhesion; the printed radius bounds what is missing.

# %%
for digits in (10, 50, 200):
    event = as_record(solve(scene, digits=digits, arithmetic="ball"))["events"][adhesion]
    print(f"{digits} digits, radius {event['t_radius']} s")
    print(textwrap.indent(textwrap.fill(event["t"], 80), "    "))

# %% [markdown]
# ## The event table
#
# An *entry* ends a slip inside the sliding region, an *exit* ends a stick phase on a ray, and a *crossing* passes $S$
# outside it. The last eight events, to ten digits:

# %%
short = solve(scene, digits=10)
rows = [
    f"| {number} | {kind.value} | {event['from']} to {event['to']} | {event['t']} | {event['x1']} | {event['v1']} |"
    for number, (kind, event) in enumerate(zip(short.event_kinds, as_record(short)["events"], strict=True), start=1)
]
head = "| | kind | modes | $t$ (s) | $x_1$ (m) | $v_1=v_2$ (m/s) |\n|---|---|---|---|---|---|\n"
display(Markdown(head + "\n".join(rows[-8:])))

# %% [markdown]
# ## Between the events
#
# Nothing was sampled while solving. `sol(t)` evaluates the closed form of the segment that holds $t$, here across the
# first two adhesions.

# %%
times = np.linspace(4.3, 5, 1400)
_, v1_at, _, v2_at = fast.sol(times)
figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
axes.plot(times, v1_at - v2_at, lw=1.2, label=r"$\dot z=v_1-v_2$")
for kind, marker in zip(EventKind, "o^x", strict=True):
    at = [event.t for event in fast.events if event.kind is kind and event.t > times[0]]
    axes.plot(at, [0] * len(at), marker, color="black", mfc="none", label=kind.value)
axes.set(xlabel="$t$ (s)", ylabel=r"$\dot z$ (m/s)")
axes.legend()
plt.show()

# %% [markdown]
# In balls the answer is an enclosure, at any time that can be written down.

# %%
for time in ("4.55", "4.6"):
    print(f"mode at {time} s: {proved.mode_at(time).value}")
for name, value in zip(("x1", "v1", "x2", "v2"), proved.sol(Fraction("4.55")), strict=True):
    print(f"{name}(4.55 s) = {value.str(30)}")

# %% [markdown]
# ## The energy ledger
#
# What the energy has lost is set against the work of friction, $b\int|v_1-v_2|\,dt$, and of a viscous damper,
# $a_1\int v_1^2\,dt$; each integral is a closed form per segment. The residual is rounding in float64 and an enclosure
# of zero in balls.

# %%
damped = Scene(Pair(m1=1, m2=1, a2=200, b="0.05", a1="0.1"), State(v1="0.15"), until=5)
ledgers = {"undamped": fast.ledger, "damped": solve(damped).ledger}
rows = [
    f"| {name} | {one.initial:.6g} | {one.final:.6g} | {one.friction:.6g} | {one.viscous:.6g} | {one.residual:.1e} |"
    for name, one in ledgers.items()
]
head = "| float64, in J | $E(0)$ | $E(5)$ | friction | viscous | residual |\n|---|---|---|---|---|---|\n"
display(Markdown(head + "\n".join(rows)))
print(f"damped, in balls: residual {solve(damped, digits=15, arithmetic='ball').ledger.residual} J")
solve(damped).plot("energy")
plt.show()

# %% [markdown]
# ## What depends on what
#
# `sensitivities` differentiates through all events: how the final state moves with the initial one and the parameters.

# %%
sensitivities(fast)

# %% [markdown]
# ## On the edge
#
# With $b=0.5$ N the sliding region ends at $x_1=0.005$ m. From rest exactly there the pair sticks permanently; from
# $10^{-24}$ m further out it slips, although both numbers are the same in binary64.

# %%
wide = Pair(m1=1, m2=1, a2=200, b="0.5")
on_edge, beyond = "0.005", "0.005000000000000000000001"
print(f"the same binary64 number: {float(on_edge) == float(beyond)}\n")
for position in (on_edge, beyond):
    run = solve(Scene(wide, State(x1=position), until=1), digits=20, arithmetic="ball")
    print(f"x1(0) = {position} m, w = {float(run.reduced.final.w):.3g}: {run.message}")
    print("    " + ", ".join(mode.value for mode in run.modes))

# %% [markdown]
# The slips from there last a few picoseconds. The bound of float64 does not tell such a start from the edge, so `solve`
# goes on in ball arithmetic; the double root at the start of a slip is divided out.

# %%
run = solve(Scene(wide, State(x1=beyond), until=1))
durations = np.diff(run.t).astype(float)
print("slips (s): ", ", ".join(f"{duration:.3g}" for duration in durations[0::2]))
print("sticks (s):", ", ".join(f"{duration:.6g}" for duration in durations[1::2]))

# %% [markdown]
# ## Where the answer is *undecided*
#
# Let body 1 rest where spring and friction balance while body 2 slows down: they stick after exactly 0.2 s. With the
# horizon at exactly 0.2 s no finite precision tells which comes first, and the balls of the paper's pair say so.
# Without `arithmetic`, `solve` follows this motion exactly, as its free part vanishes: the event is not before the
# horizon.

# %%
balanced = Scene(wide, State(x1="0.0025", v2="0.1"), until="0.2")
try:
    solve(balanced, digits=10, arithmetic="ball", max_digits=200)
except EventUndecided as error:
    print(f"EventUndecided: {error}\n")
print(f"from exact data: {len(solve(balanced).events)} events before the horizon")
later = solve(Scene(wide, balanced.initial, until="0.21"), digits=10, arithmetic="ball")
print(f"balls, horizon at 0.21 s: {later.events[0].kind.value} at {later.events[0].t} s")

# %% [markdown]
# Digits that the cap on the working precision does not allow are not promised either.

# %%
try:
    solve(scene, digits=50, arithmetic="ball", max_digits=60)
except PrecisionExhausted as error:
    print(f"PrecisionExhausted: {error}")

# %% [markdown]
# ## A hair above the critical energy
#
# The pair starts on the left edge and moves inwards, with an excess energy of exactly $w=10^{-12}$. For equal
# masses it loses about $(9/4)w^2$ at a slip: a relative change of some $10^{-12}$.

# %%
hair = Scene(wide, State(x1="-0.005", v1="5e-8", v2="5e-8"), until=20)
print(f"w(0) = {hair.energy_excess}")
near, enclosed = solve(hair), solve(hair, digits=30, arithmetic="ball")
print(
    f"solve: {near.arithmetic.name}, {len(near.events)} events in 20 s; the same to 30 digits: {len(enclosed.events)}"
)
rounded = wide.energy([float(one) for one in enclosed.final_state], float) / float(wide.critical_energy) - 1
with enclosed.arithmetic.context():
    lost = enclosed.arithmetic.number(hair.energy_excess) - enclosed.reduced.final.w
    formed = distance(rounded, enclosed.reduced.final.w).upper()
print(f"w lost in 20 s, proved: {float(lost):.6e}")
print(f"error of E/E_cr - 1, formed from the final state in float64: {float(formed):.1e}")

# %% [markdown]
# That is why $w$ is carried as a variable of its own: formed from the state, its error would be far larger than all
# the energy that was lost.

# %% [markdown]
# ## A thousand excursions
#
# From ray to ray the state is the one number $w$. `excursions` goes on with it from where the first scene leaves the
# sliding region, without any time stepping. This is what theory expects of it:

# %%
law = rate_constant()
limit = float(law.subs({m1: 1, m2: 1, a2: 200, b: Fraction("0.05")}))
display(Latex(equation(r"\lim_{t\to\infty}t\,(E-E_{cr})", law)))
print(f"{limit:.10g} J s for this pair")

# %% [markdown]
# In balls, with $t$ counted from the start of the scene and taken at the end of each stick phase:

# %%
leaving = next(event for event in proved.events if event.kind is EventKind.EXIT)
balls = Ball(40)
with balls.context():
    frame = Frame(balls, pair)
    run = list(islice(excursions(frame, leaving.reduced.w), 1000))
    times = [leaving.t + tau / frame.rate for tau in accumulate(one.slip + one.stick for one in run)]
    products = [t * frame.critical_energy * one.w_after for t, one in zip(times, run, strict=True)]
print(f"excursions: {len(run)}, until t = {times[-1].str(20)} s")
print(f"w from {run[0].w.str(20)} to {run[-1].w_after.str(20)}")
print(f"t (E - E_cr) = {products[-1].str(20)} J s, {float(products[-1]) / limit:.4f} of the limit")

# %% [markdown]
# Other energies on the ray lead to the same constant. The closer a start is to the critical energy, the later it
# follows the law.

# %%
figure, axes = plt.subplots(figsize=(8, 3.8), layout="constrained")
counts = np.arange(1, 1001)
label = f"the scene, from $w={float(leaving.reduced.w):.3f}$"
axes.plot(counts, np.array(products, dtype=float) / limit, label=label)
for start in (1.0, 0.1, 0.01, 0.001):
    with balls.context():
        run = list(islice(excursions(frame, balls.number(Fraction(str(start)))), 1000))
        durations = [float(one.slip + one.stick) for one in run]
        energies = float(frame.critical_energy) * np.array([float(one.w_after) for one in run])
    times = np.cumsum(durations) / float(frame.rate)
    axes.plot(counts, times * energies / limit, "--", lw=1, label=f"from a ray, $w={start:g}$")
axes.axhline(1, color="gray", lw=0.8)
axes.set(xscale="log", yscale="log", xlabel="excursions", ylabel=r"$t\,(E-E_{cr})$ over its limit")
axes.legend()
plt.show()
