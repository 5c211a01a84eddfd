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
# # The sliding region and the critical energy
#
# From the closed form (3), (4) of the paper to the energy up to which every stuck pair stays stuck, without a damper
# and with one. Every formula below is an object of the package `theory`, derived there from the model and set here as
# it is; the sentence after each says what it means. `one_over_t_law` goes on from here.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Latex, display
from sympy import expand, factor, lambdify, simplify

from numerics import Pair, Scene, State, solve
from paper_checks.evidence.formula import equation
from theory import energy, filippov, model, scaling
from theory.symbols import V1, V2, X, a1, a2, free, m1, m2, undamped, x1

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
