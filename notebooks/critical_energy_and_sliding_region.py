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
# # The sliding region, the critical energy, and the 1/t law
#
# From the closed form (3), (4) of the paper to the law by which the energy approaches $E_{cr}$. Every formula below is
# an object of the package `theory`, derived there from the model and set here as it is; the sentence after each says
# what it means.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Latex, display
from sympy import Order, expand, factor, lambdify, simplify, sqrt

from numerics import Pair, Scene, State, solve
from paper_checks.evidence.formula import equation
from theory import energy, excursion, filippov, model, near_critical, rate_bounds, scaling
from theory.symbols import V1, V2, X, a1, a2, epsilon, free, m1, m2, q, theta, undamped, w, x1

# %% [markdown]
# ## The model and its modes

# %%
Latex(equation("0", model.driving_equation()) + equation("0", model.driven_equation()))

# %% [markdown]
# These are (3) and (4): the signum of the relative velocity occurs in both, and that of the stiction condition in (4).

# %%
for sign in (1, -1):
    slip = model.slip(sign)
    first, second = equation(r"\ddot x_1", free(slip.acceleration1)), equation(r"\ddot x_2", slip.acceleration2)
    display(Latex(first + second))

# %% [markdown]
# With $\mathrm{sgn}(\dot z)$ put to $1$ and to $-1$ and the control to zero, the equations solve to the two slip modes.

# %%
Latex(equation(r"\ddot x_1=\ddot x_2", free(model.stick().acceleration1)))

# %% [markdown]
# With $\mathrm{sgn}(\dot z)=0$ and the stiction condition met they solve to stick: both bodies move as one mass.

# %% [markdown]
# ## The fields and the switching surface
#
# The free system is taken without the damper first, as in Section III of the paper: $a_1=0$.

# %%
Latex(equation(r"\Phi_+(x_1,v_1,v_2)", filippov.phi(1)) + equation(r"\Phi_-(x_1,v_1,v_2)", filippov.phi(-1)))

# %% [markdown]
# The slip modes are two vector fields, $\Phi_+$ where $v_1>v_2$ and $\Phi_-$ where $v_1<v_2$.

# %%
Latex(equation("n_S", filippov.normal().T))

# %% [markdown]
# The switching surface $S$ is where $v_1-v_2$ vanishes, and its gradient is the normal from $\Omega_-$ to $\Omega_+$.

# %%
products = [filippov.transversality(sign) for sign in (1, -1)]
Latex(equation(r"\Phi_+\cdot n_S", products[0]) + equation(r"\Phi_-\cdot n_S", products[1]))

# %% [markdown]
# On $S$ these products say whether a field points towards $\Omega_+$ (positive) or towards $\Omega_-$ (negative).

# %% [markdown]
# ## The sliding region

# %%
length = filippov.half_width()
other_edge = simplify(filippov.transversality(1).subs(x1, -length))
Latex(equation("L", length) + equation(r"\Phi_+\cdot n_S\big|_{x_1=-L}", other_edge))

# %% [markdown]
# $\Phi_-\cdot n_S$ vanishes at $x_1=L$ and $\Phi_+\cdot n_S$ at $x_1=-L$: these lines cut $S$ into three parts.

# %%
places = {"plus": "L+d", "minus": "-L-d", "sliding": r"L(\lambda-\mu)"}
signs = filippov.manifest_signs()
products = [
    equation(rf"x_1={place}:\quad\Phi_{name}\cdot n_S", signs[part, sign])
    for part, place in places.items()
    for name, sign in (("+", 1), ("-", -1))
]
Latex("".join(products))

# %% [markdown]
# With $d>0$ on $S_\pm$, and $\lambda,\mu\geqslant 0$, $\lambda+\mu=1$ on $S_0$, every sign can be read off: beyond
# the edges both fields cross $S$ in the same direction, and between them both push towards $S$.

# %%
Latex(equation(r"\alpha", filippov.sliding_weight()) + equation(r"\alpha(1-\alpha)", filippov.weight_margin()))

# %% [markdown]
# The combination $\alpha\Phi_++(1-\alpha)\Phi_-$ tangent to $S$ is convex exactly where $\alpha(1-\alpha)\geqslant 0$,
# that is $|x_1|\leqslant L$: the condition for a sliding motion, and its converse.

# %%
sliding = filippov.sliding_field()
Latex(
    equation(r"\Phi_0(x_1,v_1,v_1)", sliding)
    + equation(r"\Phi_0-\Phi_{stick}", simplify(sliding - undamped(model.stick().field)))
)

# %% [markdown]
# Filippov's sliding field is the stick mode of (3), (4): the two readings agree on $S_0$.

# %%
Latex(equation(r"\dot x_1\big|_{x_1=L}", filippov.edge_speed_rate(1)))

# %% [markdown]
# Sliding motion leaves $S_0$ by the edge $x_1=L$ where $v_1>0$: this is the ray $\ell_+$; $\ell_-$ is its mirror image.

# %%
contact = filippov.edge_contact(1)
Latex(
    equation(r"\tfrac{d}{dt}(v_1-v_2)\big|_{x_1=L}", contact.first)
    + equation(r"\tfrac{d^2}{dt^2}(v_1-v_2)\big|_{x_1=L}", contact.second)
)

# %% [markdown]
# Along the slip that follows, the guard $v_1-v_2$ has a double root at its start and a negative second derivative:
# the pair leaves by $\ell_+$ tangentially into $\Omega_-$.

# %% [markdown]
# ## The critical energy

# %%
rates = [factor(undamped(rate)) for rate in (energy.slip_rate(1), energy.slip_rate(-1), energy.stick_rate())]
Latex(
    equation("E", energy.energy())
    + equation(r"\dot E\big|_{\Omega_+}", rates[0])
    + equation(r"\dot E\big|_{\Omega_-}", rates[1])
    + equation(r"\dot E\big|_{S_0}", rates[2])
)

# %% [markdown]
# Slip dissipates $b|v_1-v_2|$ and stick conserves: on $S_0$ a trajectory stays on one level $E=E_0$.

# %%
Latex(equation(r"E\big|_S", energy.on_surface()) + equation("A", energy.level_semi_axis()))

# %% [markdown]
# On $S$ the level $E=E_0$ is an ellipse with semi-axis $A$ along $x_1$.

# %%
Latex(equation(r"E_{cr}", energy.critical_energy()))

# %% [markdown]
# The ellipse touches the edges of $S_0$ where $A=L$; solved for $E_0$ this is the critical energy.

# %%
Latex(equation("L^2-A^2", energy.semi_axis_margin()))

# %% [markdown]
# The condition: the difference is $E_{cr}-E_0$ times a positive factor, so for $E_0\leqslant E_{cr}$ the whole ellipse
# lies in $S_0$ and is a closed trajectory.

# %%
at_edge, inside = energy.arc_speed_terms()
Latex(equation(r"v_1^2\big|_{x_1=\pm L}", at_edge) + equation(r"v_1^2-v_1^2\big|_{x_1=\pm L}", inside))

# %% [markdown]
# The converse: for $E_0>E_{cr}$ the ellipse meets the edges, and as the second term is nonnegative on $S_0$, $v_1$
# never vanishes between them; so there are two arcs, one leaving by $\ell_+$ and one by $\ell_-$.

# %%
level = lambdify((X, V1), expand(scaling.reduced_energy().subs(V2, V1)))
x, v = np.meshgrid(np.linspace(-1, 1, 201), np.linspace(-1.6, 1.6, 321))
figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
axes.axvspan(-1, 1, color="0.93", label="$S_0$")
lines = axes.contour(x, v, level(x, v), [0.25, 0.6, 1, 1.5, 2.2], colors=["C0", "C0", "black", "C3", "C3"])
axes.clabel(lines, fmt=lambda value: f"$E_0={value:g}\\,E_{{cr}}$", fontsize=8)
axes.plot([1, 1], [0, 1.6], color="C1", lw=3, label=r"$\ell_+$")
axes.plot([-1, -1], [0, -1.6], color="C2", lw=3, label=r"$\ell_-$")
axes.set(xlim=(-1.5, 1.5), xlabel="$x_1/L$", ylabel=r"$v_1/(L\,\Omega)=v_2/(L\,\Omega)$")
axes.set_title("Levels of the energy on $S$")
axes.legend(loc="center right")
plt.show()

# %% [markdown]
# Closed up to $E_{cr}$ (black), cut in two above it (red); sliding motion turns clockwise.

# %% [markdown]
# ## With a damper
#
# Where $a_1>0$ changes this, the place of $a_2x_1$ is taken by the load $a_2x_1+a_1v_1$.

# %%
products = [filippov.transversality(sign, damped=True) for sign in (1, -1)]
Latex(equation(r"\Phi_+\cdot n_S", products[0]) + equation(r"\Phi_-\cdot n_S", products[1]))

# %% [markdown]
# Both change their sign where the load passes $\pm a_2L$.

# %%
region = filippov.surface(damped=True).sliding
Latex(equation("S_0", region, relation=r":\quad "))

# %% [markdown]
# The sliding region becomes a tilted strip: friction has to carry the force of the damper as well.

# %%
Latex(
    equation(r"\Phi_0(x_1,v_1,v_1)", filippov.sliding_field(damped=True))
    + equation(r"\dot E\big|_{S_0}", energy.stick_rate())
)

# %% [markdown]
# Stick is now a damped oscillation, so a level of the energy is no longer a trajectory.

# %%
rate = filippov.edge_speed_rate(1, damped=True)
Latex(equation(r"\tfrac{d}{dt}\left(x_1+\tfrac{a_1}{a_2}v_1\right)\big|_{a_2x_1+a_1v_1=a_2L}", rate))

# %% [markdown]
# The ray begins later: the pair leaves by this edge only where the rate is positive, not for all $v_1>0$.

# %%
captive = energy.captive_energy()
critical = energy.critical_energy()
Latex(
    equation(r"E_{captive}", captive)
    + equation(r"E_{captive}\big|_{a_1=0}-E_{cr}", simplify(undamped(captive) - critical))
    + equation(r"E_{captive}/E_{cr}", scaling.to_reduced(captive / critical))
)

# %% [markdown]
# This is the largest level whose ellipse fits into the tilted strip; a pair that sticks at or below it sticks for ever,
# as the energy only falls, and without damper ($\zeta=0$) it is $E_{cr}$.

# %%
pair = Pair(m1=1, m2=1, a2=200, b="0.5", a1=1)
scene = Scene(pair, State(x1=pair.half_width), until=10)
ratio = critical / captive
print(f"E(0) = {float(ratio.subs({m1: 1, m2: 1, a1: 1, a2: 200})):g} E_captive")
solve(scene, digits=10).message

# %% [markdown]
# The converse is lost: from rest at $x_1=L$, where $E(0)=E_{cr}$, this pair starts above that level and sticks for ever
# all the same.

# %% [markdown]
# ## Reduced coordinates
#
# $L$, $\Omega$ and $M=m_1+m_2$ are taken as units, $a_1=0$ again: $X=x_1/L$, $V_i=v_i/(L\Omega)$, $\tau=\Omega t$.

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
# The curves are tangent to the diagonal at $0$, which is why the approach is slow; a light driving body ($q<1/2$) can
# lose so much in one excursion that $w'<0$: then the pair has merged.

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
