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
# # One excursion, and the 1/t law
#
# From the slip between two phases of stick to the law by which the energy approaches $E_{cr}$, without a damper:
# $a_1=0$. The lines are those of the chapter "The derivation, line by line" of the report: each is checked again
# as it is shown.
# `critical_energy_and_sliding_region` has the lines before.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Markdown
from sympy import lambdify

from numerics import load_scene
from paper_checks.drawing.sharp_rate import ratio
from paper_checks.report.content.derivation import markdown
from theory import excursion, near_critical, rate_bounds
from theory.symbols import q, theta

# %%
Markdown(markdown("derivation-slip"))

# %% [markdown]
# The map $w\mapsto w'$ by its parameter, the slip angle:

# %%
one = excursion.excursion()
angles = np.linspace(0.01, np.pi, 400)
before, after = lambdify((theta, q), one.excess), lambdify((theta, q), excursion.next_excess())
figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
for color, fraction in enumerate((0.2, 0.5, 0.8)):
    axes.plot(before(angles, fraction), after(angles, fraction), f"C{color}", label=f"$m_1/M={fraction}$")
    safe = float(rate_bounds.no_merging_excess().subs(q, fraction))
    axes.plot(safe, after(np.pi / 2, fraction), f"C{color}o", mfc="none")
axes.plot([], [], "ko", mfc="none", label="$w_{safe}$")
axes.axline((0, 0), slope=1, color="0.6", lw=0.8, ls="--", label="$w'=w$")
axes.axhline(0, color="0.6", lw=0.8)
axes.set(xlim=(0, 2), ylim=(-0.35, 1), xlabel="$w$ on the ray", ylabel="$w'$ after the excursion")
axes.set_title("Excursion map, slip angles up to $\\pi$")
axes.legend()
plt.show()

# %% [markdown]
# The curves are tangent to the diagonal at $0$, which is why the approach is slow; a light driving body
# ($m_1/m_2<0.7926\ldots$) can lose so much in one excursion that $w'<0$: then the pair has merged.

# %%
Markdown(markdown("derivation-expansion"))

# %%
Markdown(markdown("derivation-rate"))

# %% [markdown]
# The law against the solver: $t\,(E-E_{cr})$ of a scene, over the constant.

# %%
scene = load_scene("velocities")
for power in (1, 2, 4, 8, 16):
    print(f"t = 1e{power} s: {ratio(scene, 10**power):.6f}")

# %% [markdown]
# One excursion's gain of $1/w$, between two bounds that hold for all excursions from that angle on:

# %%
lower, upper = rate_bounds.inverse_step_bounds()
exact = rate_bounds.inverse_step()
angles = np.linspace(0.1, np.pi / 2, 200)
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
curves = {"upper bound": (upper, "C3--"), "exact": (exact, "k-"), "lower bound": (lower, "C0--")}
for label, (gain, style) in curves.items():
    axes.plot(angles, lambdify(theta, gain.subs(q, 0.5))(angles), style, label=label)
limit = float(near_critical.inverse_step().subs(q, 0.5))
axes.plot(0, limit, "ko", mfc="none", label=f"limit ${limit:g}$")
axes.set(xlabel=r"slip angle $\theta$", ylabel=r"$1/w'-1/w$")
axes.set_title("Gain of $1/w$ in one excursion, $m_1=m_2$")
axes.legend()
plt.show()

# %% [markdown]
# As $\theta$ falls from one excursion to the next, the bounds at one angle hold for all excursions that follow: this
# gives the two-sided form of the law, $c_1/t\leqslant E-E_{cr}\leqslant c_2/t$ from some time on.
