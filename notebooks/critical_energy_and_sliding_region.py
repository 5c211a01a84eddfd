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
# The derivation from (3), (4) to the energy up to which a stuck pair sticks at all later times, with code to run
# beside it. The lines are those of the chapter "The derivation, line by line" of the report: each is checked again
# as it is shown. Every formula is an object of the package `theory`. `one_over_t_law` goes on from here.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
from IPython.display import Latex, Markdown
from sympy import simplify

from numerics import Pair, Scene, State, solve
from paper_checks.drawing.figures import FIGURES
from paper_checks.evidence.formula import equation
from paper_checks.report.content.derivation import markdown
from theory import energy, filippov, scaling
from theory.symbols import a1, a2, b, m1, m2, undamped, x1

# %%
Markdown(markdown("derivation-model", "derivation-fields"))

# %%
Markdown(markdown("derivation-transversality", "derivation-strip"))

# %% [markdown]
# Both products are expressions, and so is $L$. Put in numbers, or another position than the edge.

# %%
pair = {m1: 1, m2: 1, a2: 200, b: 0.5}
length = filippov.half_width().subs(pair)
for share in (-1.1, -0.5, 0.5, 1.1):
    rates = [filippov.transversality(sign).subs(pair).subs(x1, share * length) for sign in (1, -1)]
    print(f"x1 = {share:+.1f} L: along Phi+ {rates[0]:+.2f}, along Phi- {rates[1]:+.2f} m/s^2")

# %%
Markdown(markdown("derivation-filippov", "derivation-energy"))

# %%
Markdown(markdown("derivation-critical-energy"))

# %%
FIGURES["ellipse-in-strip"]()

# %%
Markdown(markdown("derivation-arcs"))

# %% [markdown]
# The solver does not know this level. From rest just inside the edge, and just outside:

# %%
real = Pair(m1=1, m2=1, a2=200, b="0.5")
for place in ("0.00499", "0.00501"):
    start = Scene(real, State(x1=place, x2=place), until=3)
    print(f"x1(0) = {place} m, L = {float(real.half_width)} m: {solve(start, digits=10).message}")

# %% [markdown]
# ## With a damper
#
# With $a_1>0$ the load $a_2x_1+a_1v_1$ replaces $a_2x_1$.

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
# This is the largest level whose ellipse fits into the tilted strip; a pair that sticks at or below it sticks
# permanently, as the energy only falls, and without a damper ($\zeta=0$) it is $E_{cr}$.

# %%
damped = Pair(m1=1, m2=1, a2=200, b="0.5", a1=1)
scene = Scene(damped, State(x1=damped.half_width), until=10)
ratio = critical / captive
print(f"E(0) = {float(ratio.subs({m1: 1, m2: 1, a1: 1, a2: 200})):g} E_captive")
solve(scene, digits=10).message

# %% [markdown]
# The converse is lost: from rest at $x_1=L$, where $E(0)=E_{cr}$, this pair starts above that level and sticks
# permanently nevertheless.
