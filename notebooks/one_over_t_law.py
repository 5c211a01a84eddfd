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
# $a_1=0$. Every formula below is an object of the package `theory`, derived there from the model and set here as it is;
# the sentence after each says what it means. `critical_energy_and_sliding_region` says where $S_0$, its rays $\ell_\pm$
# and $E_{cr}$ come from.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Latex
from sympy import Order, lambdify, simplify, sqrt

from paper_checks.evidence.formula import equation
from theory import energy, excursion, near_critical, rate_bounds, scaling
from theory.symbols import epsilon, q, theta, w

# %% [markdown]
# ## Reduced coordinates
#
# $L$, $\Omega$ and $M=m_1+m_2$ are taken as units: $X=x_1/L$, $V_i=v_i/(L\Omega)$, $\tau=\Omega t$.

# %%
Latex(equation("L", scaling.half_width()) + equation(r"\Omega", scaling.stick_frequency()))

# %% [markdown]
# The length is the half width of $S_0$, the frequency that of stick.

# %%
Latex(
    equation(r"\tfrac{d}{d\tau}(X,V_1,V_2)\big|_{slip+}", scaling.reduced_slip(1))
    + equation(r"\tfrac{d}{d\tau}(X,V_1,V_2)\big|_{slip-}", scaling.reduced_slip(-1))
    + equation(r"\tfrac{d}{d\tau}(X,V_1,V_2)\big|_{stick}", scaling.reduced_stick())
)

# %% [markdown]
# One parameter is left of the four, the mass fraction $q=m_1/M$; in what follows $r=1-q$.

# %%
Latex(
    equation("E/E_{cr}", scaling.reduced_energy())
    + equation(r"\tfrac{dw}{d\tau}\big|_{slip-}", scaling.excess_rate(-1))
)

# %% [markdown]
# The excess energy $w=E/E_{cr}-1$ falls in slip; its sign decides whether a stuck pair stays stuck.

# %% [markdown]
# ## One excursion
#
# The pair leaves $S_0$ by $\ell_+$ at $X=1$, $V_1=V_2=\epsilon>0$, so with $w=\epsilon^2$.

# %%
slip = excursion.slip_from_ray()
Latex(equation("X", slip.X) + equation("V_1", slip.V1) + equation("V_2", slip.V2))

# %% [markdown]
# This is the slip as a function of the slip angle $\theta=\tau/\sqrt q$.

# %%
double_root, remaining = excursion.guard_factors()
Latex(equation("V_1-V_2", double_root * remaining) + equation(r"h(\theta)", excursion.h()))

# %% [markdown]
# The first factor is the double root at the start; the excursion ends where the other vanishes, at
# $h(\theta)=\epsilon/\sqrt q$.

# %%
positive, increment = excursion.half_angle_slope()
Latex(
    equation(r"h'(2\phi)", positive * increment)
    + equation(r"(\sin\phi-\phi\cos\phi)'", simplify(increment.diff(excursion.angle)))
    + equation(r"h(0),\ h(2\pi)", excursion.h_limits())
)

# %% [markdown]
# On $0<\phi<\pi$ both are positive, so $h$ rises from $0$ to $\infty$ on $(0,2\pi)$: there is exactly one such
# $\theta$, and it can stand for $\epsilon$.

# %%
one = excursion.excursion()
Latex(equation("w", one.excess) + equation("w'", excursion.next_excess()))

# %% [markdown]
# The excursion map $w\mapsto w'$ in closed form, by the parameter $\theta$.

# %%
Latex(equation("1-X", rate_bounds.reentry_depth()))

# %% [markdown]
# Re-entry is at depth $1-X$ behind the edge, which for $\theta\leqslant\pi$ is between $0$ and $2q<2$: inside $S_0$.

# %%
factors = excursion.next_excess_slope()
Latex(
    equation(r"\frac{dw'}{d\theta}\,\Big/\,(2q\,h\,h')", factors[-1])
    + equation(r"w-w'-2r\,q\,D", excursion.energy_balance())
    + equation("D'/h'", excursion.displacement_slope()[0])
    + equation("w_{safe}", rate_bounds.no_merging_excess())
)

# %% [markdown]
# The factor of $dw'/d\theta$ is $1-r(1-\cos\theta)>0$ up to $\theta=\pi/2$, where $w=w_{safe}$, and $D$ grows from
# $0$: from $w\leqslant w_{safe}$ on, every excursion ends in $S_0$ with $0<w'<w$, so the pair never merges.

# %%
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

# %% [markdown]
# ## The 1/t law

# %%
cycle = near_critical.cycle()
Latex(
    equation(r"\theta", cycle.slip_angle.coeff(epsilon, 1) * epsilon + Order(epsilon**3))
    + equation("w'", cycle.next_excess.subs(epsilon, sqrt(w)) + Order(w**3))
)

# %% [markdown]
# For small $w$ the slip lasts about $3\sqrt w$ in units of $1/\Omega$ and costs an amount of order $w^2$.

# %%
Latex(
    equation(r"\lim_{w\to 0}\frac{w'}{w}", near_critical.excess_ratio_limit())
    + equation(r"\lim_{w\to 0}\left(\frac{1}{w'}-\frac{1}{w}\right)", near_critical.inverse_step())
)

# %% [markdown]
# So the decay is slower than every exponential, and $1/w$ grows by the same amount with every excursion in the limit.

# %%
Latex(
    equation(r"\lim_{w\to 0}(\tau_{slip}+\tau_{stick})", near_critical.cycle_limit())
    + equation(r"\lim_{\tau\to\infty}\tau\,w", near_critical.cycle_limit() / near_critical.inverse_step())
)

# %% [markdown]
# An excursion and the stick after it take half a period in the limit; time per excursion over gain of $1/w$ per
# excursion is the limit of $\tau w$ (Stolz–Cesàro).

# %%
constant = near_critical.rate_constant()
relative = simplify(constant / energy.critical_energy())
Latex(equation(r"\lim_{t\to\infty}t\,(E-E_{cr})", constant) + equation(r"\lim_{t\to\infty}t\,w", relative))

# %% [markdown]
# In SI units: the constant contains the parameters of the pair and nothing of its initial state.

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
