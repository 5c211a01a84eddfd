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
# # Friction from a measured velocity: the inverse problem
#
# A sensor has recorded the velocity of body 1. How large are the friction force $b$ and the mass $m_1$, and how sure
# is that? The pair slips and sticks, and a solver that steps over events has no useful derivatives. Here events are
# exact, and `sensitivities(trajectory, t)` gives the derivatives of the state at any times, across all events before
# them. The method of Gauss and Newton needs no more.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Ellipse

from numerics import Pair, Scene, State, sensitivities, solve

# %% [markdown]
# ## The measurement
#
# The truth is known here, so that the answer can be judged: $b=0.05$ N, $m_1=1$ kg. The sensor samples at 25 Hz for
# 6 s and has an error of $\sigma=2$ mm/s.

# %%
true, sigma, until = np.array([0.05, 1.0]), 0.002, 6
times = np.arange(1, 25 * until) / 25
truth = solve(Scene(Pair(m1=true[1], m2=1, a2=200, b=true[0]), State(v1="0.15"), until))
measured = truth.sol(times)[1] + np.random.default_rng(1).normal(0, sigma, len(times))
sticks = sum(mode.value == "stick" for mode in truth.modes)
print(f"{len(times)} samples, {len(truth.events)} events, {sticks} stick phases")

# %% [markdown]
# ## The fit
#
# Minimise $\sum_k (v_1(t_k;b,m_1)-y_k)^2$: from a guess, solve the linear problem that the derivatives $J$ make of it,
# and go on from there until nothing changes. The guess is off by 10 % and 5 %.

# %%
found = np.array([0.055, 1.05])
for _ in range(8):
    run = solve(Scene(Pair(m1=found[1], m2=1, a2=200, b=found[0]), State(v1="0.15"), until))
    wrt = sensitivities(run).wrt
    slopes = sensitivities(run, times)[1, [wrt.index("b"), wrt.index("m1")]].T  # of v1, by b and m1
    rest = measured - run.sol(times)[1]
    change = np.linalg.lstsq(slopes, rest, rcond=None)[0]
    print(f"b = {found[0]:.7f} N, m1 = {found[1]:.6f} kg, root mean square {np.sqrt(np.mean(rest**2)) * 1e3:.4f} mm/s")
    found = found + change
    if (abs(change) < 1e-6).all():
        break

# %% [markdown]
# ## How sure
#
# Near the minimum the model is linear in its parameters, and the covariance of the estimate is
# $\hat\sigma^2(J^{\mathsf T}J)^{-1}$, with $\hat\sigma$ from what is left. The truth should be within two standard
# deviations in 19 of 20 measurements.

# %%
spread = np.sqrt(np.sum(rest**2) / (len(times) - 2))
covariance = spread**2 * np.linalg.inv(slopes.T @ slopes)
deviations = np.sqrt(np.diag(covariance))
correlation = covariance[0, 1] / deviations.prod()
for name, value, deviation, unit, exact in zip(("b", "m1"), found, deviations, ("N", "kg"), true, strict=True):
    off = (value - exact) / deviation
    print(f"{name} = {value:.6f} +- {deviation:.6f} {unit}; the truth, {exact:g}, is {abs(off):.1f} deviations away")
print(f"sigma = {spread * 1e3:.2f} mm/s, correlation {correlation:.2f}")

# %%
figure, (data, plane) = plt.subplots(1, 2, figsize=(10, 3.4), width_ratios=(5, 3), layout="constrained")
run.plot("velocities", data)
data.plot(times, measured, ".", color="black", ms=4, label="measured")
data.set_title("Measured and fitted")
widths, directions = np.linalg.eigh(covariance / np.outer(deviations, deviations))  # in deviations
angle = np.degrees(np.arctan2(directions[1, -1], directions[0, -1]))
for k in (1, 2):
    plane.add_patch(Ellipse((0, 0), *(2 * k * np.sqrt(widths[::-1])), angle=angle, fill=False))
plane.plot(*((true - found) / deviations), "o", label="truth")
plane.plot(0, 0, "+", color="black", label="estimate")
plane.set(xlim=(-3, 3), ylim=(-3, 3), xlabel="b, in deviations", ylabel="m1, in deviations", title="Uncertainty")
plane.legend()
figure

# %% [markdown]
# ## Is that uncertainty right?
#
# Measure again twenty times, with other noise, and fit each from where the first fit ended, by two steps. The
# estimates must scatter as the formula says, and about 19 of 20 be within two deviations of the truth.

# %%
noise, estimates = np.random.default_rng(2), []
for _ in range(20):
    again, fitted = truth.sol(times)[1] + noise.normal(0, sigma, len(times)), found
    for _ in range(2):
        run = solve(Scene(Pair(m1=fitted[1], m2=1, a2=200, b=fitted[0]), State(v1="0.15"), until))
        slopes = sensitivities(run, times)[1, [wrt.index("b"), wrt.index("m1")]].T
        fitted = fitted + np.linalg.lstsq(slopes, again - run.sol(times)[1], rcond=None)[0]
    estimates.append(fitted)
predicted = deviations * sigma / spread  # with the true sigma
within = np.mean(abs(np.array(estimates) - true) < 2 * predicted, axis=0)
print("deviations of 20 estimates:", np.std(estimates, axis=0), "predicted:", predicted)
print(f"within two deviations: b {within[0]:.0%}, m1 {within[1]:.0%}")

# %% [markdown]
# ## What the data cannot determine
#
# A pair that sticks all the time says nothing about $b$: stuck below the critical energy its derivative by $b$ is 0,
# and the fit has no answer. Look at `slopes` before you trust an estimate.

# %%
still = solve(Scene(Pair(m1=1, m2=1, a2=200, b="0.05"), State(x1="0.0004", x2="0.0004"), until))
print(still.message, "- largest derivative of v1 by b:", abs(sensitivities(still, times)[1, wrt.index("b")]).max())
