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
# # Beyond the paper: one map, and what it decides
#
# The paper shows that a pair which starts on $S_0$ "slightly" above $E_{cr}$ approaches it slowly and never merges. In
# reduced coordinates more can be said: the pair without a damper has one parameter, the mass share
# $r=m_2/(m_1+m_2)$, and an excursion from $S_0$ and back is an explicit curve of one angle. From that curve come the
# whole return map, the energy at any time, however late, and for every pair the energies from which it merges at the
# first re-entry.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from flint import arb
from IPython.display import Latex, display
from sympy import lambdify

from numerics import Pair, Scene, State
from numerics.free.energy import energy_at
from paper_checks.drawing.merging import CRITICAL_SHARE, merging_interval
from paper_checks.drawing.style import house_style
from paper_checks.evidence.formula import equation
from theory import excursion, near_critical, return_map
from theory.symbols import q, theta

# %% [markdown]
# ## One excursion, as a curve of its slip angle
#
# With $M=m_1+m_2$, $q=m_1/M$, lengths in half widths $L$ of $S_0$ and times in $1/\Omega=\sqrt{M/a_2}$, the pair
# leaves by $\ell_+$ at $X=1$ with speed $\sqrt q\,u$. The slip ends at the angle $\theta$ in $(0,2\pi)$ with
# $h(\theta)=u$.

# %%
landing = return_map.landing()
before, after = return_map.return_map_of_angle()
display(Latex(equation(r"h(\theta)", excursion.h()) + equation(r"c(\theta)", return_map.depth())))
Latex(equation(r"\frac{1-X'}{q}", return_map.depth()) + equation(r"\frac{V'}{\sqrt q}", landing.push))

# %% [markdown]
# Here $u$ is the scaled speed at the start. $h$ increases from $0$ to infinity: the angle parametrises all excursions.
# The depth $c$ increases too, $c'=h$: the faster the pair leaves, the deeper it re-enters, until $qc=2$; from there on
# it passes the far edge and crosses $S$ instead of sticking.

# %%
angles = np.linspace(1e-3, 5.6, 2000)
speed = lambdify(theta, excursion.h())(angles)
deep = lambdify(theta, return_map.depth())(angles)
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
left.plot(angles, speed, "k-", label="speed at the exit, $h$")
left.plot(angles, deep, "k--", label="depth at the return, $c$")
left.set(xlabel=r"slip angle $\theta$", ylim=(0, 10), title="exit speed and depth, for every pair")
left.legend()
for share, style in ((0.2, "-"), (0.5, "--"), (0.8, "-.")):
    position = 1 - (1 - share) * deep
    right.plot(angles[position > -1], position[position > -1], "k" + style, label=f"$m_2/M={share}$")
right.axhspan(-1, 1, color="0.93")
right.set(xlabel=r"slip angle $\theta$", ylabel="$X'$", title="where the pair comes back into $S_0$", ylim=(-1.1, 1.1))
right.legend()
plt.show()

# %% [markdown]
# ## The return map
#
# On the ray the state is one number, the excess energy $w=E/E_{cr}-1$. Scaled as $y=w/q$ an excursion maps

# %%
Latex(equation("y", before) + equation("y'", after))

# %% [markdown]
# so that the mass share enters as one factor. The map falls at 0 as $y'=y-\frac94ry^2+\dots$, with exact coefficients:

# %%
Latex(equation("y'", return_map.return_map_series(5)))

# %% [markdown]
# The pair merges where $y'\leqslant0$. Below a threshold $r^*$ the graph stays above zero: no pair with $m_2<r^*M$
# merges after a start on $S_0$ above $E_{cr}$; at $r^*$ it does from some energies. Beyond, the graph dips below zero,
# and merging has a window (grey).

# %%
maps = lambdify((theta, q), (before, after))
figure, panels = plt.subplots(1, 3, figsize=(10, 3.8), layout="constrained")
shares = (0.4, CRITICAL_SHARE, 0.8)
for axes, share, start in zip(panels, shares, (6, 10, 100), strict=True):
    ys, nexts = maps(angles, 1 - share)
    orbit = [start]
    while len(orbit) < 40 and orbit[-1] > 0:
        orbit.append(np.interp(orbit[-1], ys, nexts))
    steps = np.repeat(orbit, 2)
    axes.plot(ys[ys < start], nexts[ys < start], "k-", lw=1.5)
    axes.plot([0, start], [0, start], "k:", lw=1)
    axes.axhline(0, color="0.5", lw=0.8)
    axes.fill_between(ys[ys < start], nexts[ys < start], 0, where=nexts[ys < start] < 0, color="0.7")
    axes.plot(steps[:-2], steps[1:-1], color="C3", lw=0.9)
    axes.set(xlabel="$y$", ylabel="$y'$", title=f"$m_2/M={share:.4g}$")
plt.show()

# %% [markdown]
# Left: every orbit converges slowly to $0$, that is to $E_{cr}$. Middle: at $r^*$ the graph touches zero in one
# point. Right: from $y=100$ the first excursion leads into the window, and the second one merges.

# %% [markdown]
# ## The energy at any time
#
# Near $0$ the map has a Fatou coordinate, which turns iteration into addition. `energy_at` counts excursions with it,
# so that any number of them costs the same. The pair of the paper's Fig. 5 (a), at times from 0.1 s to $10^{100}$ s:

# %%
pair = Pair(m1=1, m2=1, a2=200, b="0.05")
early = [f"{m}e{k}" for k in range(-1, 6) for m in (1, 3)]
times = {"0.15": [*early, *(f"1e{k}" for k in range(6, 101, 2))], "0.5": early, "1": early}
runs = {v: [energy_at(Scene(pair, State(v1=v), until=1), t, digits=12) for t in at] for v, at in times.items()}
last = runs["0.15"][-1]
print(f"at t = {times['0.15'][-1]} s: E/E_cr - 1 = {last.energy_excess.str(12, radius=False)}")
print(f"after {last.excursions} excursions")

# %% [markdown]
# All runs end on one line, whatever $E(0)$ was: $t\,(E-E_{cr})$ has a limit. In reduced time,

# %%
Latex(equation(r"\lim_{\tau\to\infty}\tau w", near_critical.reduced_rate_constant()))

# %%
figure, (top, bottom) = plt.subplots(2, 1, figsize=(8, 6.5), layout="constrained")
with last.frame.arithmetic.context():
    law = float(4 * arb.pi() / 9 * last.frame.q / last.frame.r / last.frame.rate)
critical = float(pair.critical_energy)
for (v, found), marker in zip(runs.items(), "os^", strict=True):
    at = np.array([float(t) for t in times[v]])
    excess = np.array([float(one.energy_excess) for one in found])
    top.loglog(at, excess * critical, "k" + marker, ms=4, mfc="none", label=f"$v_1(0)={v}$ m/s")
    bottom.semilogx(at, excess * at / law, "k" + marker, ms=4, mfc="none")
top.loglog([0.1, 1e100], [law * critical / 0.1, law * critical / 1e100], "C3-", lw=1, label="the sharp law")
top.set(xlabel="$t$ (s)", ylabel="$E-E_{cr}$ (J)", xlim=(0.05, 1e101))
top.legend()
bottom.axhline(1, color="C3", lw=1)
bottom.set(xlabel="$t$ (s), the beginning", ylabel=r"$t\,(E-E_{cr})$ / its limit", xlim=(10, 1e6), ylim=(0.9, 2))
plt.show()

# %% [markdown]
# ## Which pairs merge from which energies
#
# The same two formulas decide where the first slip after $S_0$ ends below $E_{cr}$: exactly if
# $R^2=(h/c)^2\leqslant r$, for each mass ratio an interval of energies.

# %%
with house_style():
    figure = merging_interval()
figure

# %% [markdown]
# Left of the dashed line, $m_2/M<r^*$, nothing merges. Below the interval lies the paper's "slightly above $E_{cr}$",
# now for each mass ratio exactly: there the pair never merges. Above it a later slip may end below $E_{cr}$.

# %%
print(f"the threshold: m2/m1 = {CRITICAL_SHARE / (1 - CRITICAL_SHARE):.12f}")
