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
# # The pair under a force: what control through the interface can do
#
# The paper's most general model has a force $u(t)$ on body 1, and its readers are control engineers. Only friction,
# at most $b$, acts on body 2. This notebook asks what that allows: when a vibration carries body 2 along, which
# references it can follow, how fast it can be moved, and when the relative motion has settled. What the tools answer
# is an enclosure or comes from one, and what is planned is solved again.

# %%
# %matplotlib inline
# %config InlineBackend.figure_formats = ["svg"]
from fractions import Fraction

import numpy as np

from numerics import (
    Force,
    Pair,
    Scene,
    State,
    fastest_transfer,
    load_reference,
    load_scene,
    response,
    ring_entry,
    solve,
    thresholds,
    track,
)
from numerics.control.answers import solved_again
from numerics.control.pictures import draw_response, draw_tracking
from paper_checks.drawing import under_a_force
from paper_checks.drawing.style import house_style

pair = Pair(m1=1, m2=1, a2=200, b="0.5", a1=2)

# %% [markdown]
# ## A vibration: three regimes
#
# Under $u=U\sin\omega t$ this pair, with a damper, can stick permanently if and only if its stuck response needs no
# more friction than is available, $U\le U^*=\beta\,|a_2-M\omega^2+ia_1\omega|/\omega^2$ with $\beta=b/m_2$. A motion
# that slips permanently, with two reversals a period, needs $U\ge U^{**}$, and a relative velocity that keeps its
# sign between the reversals: it exists from some amplitude on, at some frequencies only well above $U^{**}$. In
# between the pair ends up slipping, and sticks or reverses more than twice, in each period.

# %%
with house_style():
    figure = under_a_force.thresholds_over_frequency()
figure

# %%
known = thresholds(pair, 12, digits=30)
print("U*  =", known.entrainment.str(30, radius=False), "N")
print("U** =", known.non_stop.str(30, radius=False), "N")

# %% [markdown]
# With a damper there is one periodic motion, and every motion tends to it. Its events are enclosed by an interval
# Newton step over a box that the solver follows as a whole, and the Floquet multipliers say how fast it attracts.

# %%
shaken = response(Scene(pair, State(), until=4, force=Force.sine("0.5", 12)))
again = solve(shaken.one_period())
print(shaken.regime.value)
print("multipliers", [abs(one).str(15, radius=False) for one in shaken.multipliers])
print("modes of a period, solved by events:", [mode.value for mode in again.modes])
draw_response(shaken)

# %% [markdown]
# ## Resonance
#
# At the resonance of body 1 without a damper friction can take no more than $4b$ times the amplitude in a cycle:
# below $U=4b/\pi$ all velocities stay bounded, above it all motions grow.

# %%
with house_style():
    figure = under_a_force.resonance()
figure

# %% [markdown]
# ## An asymmetric force makes body 2 drift
#
# With a damper, the drift of body 2 is exactly 0 if $u(t+T/2)=-u(t)$. A second harmonic breaks that.

# %%
for share in ("0", "0.05", "0.1"):
    force = Force.sine("0.5", 12) + Force.sine(Fraction(share) / 2, 24, 1)
    drifting = response(Scene(pair, State(), until=4, force=force)).orbit
    print(f"a second harmonic of {share}: {1000 * float(drifting.travel / drifting.drive.period):.3f} mm/s")

# %% [markdown]
# ## A reference
#
# Body 2 can follow an $r$ with its initial position and velocity, from a suitable initial state of body 1, if and
# only if $|r''|\le b/m_2$. The force of a pair that sticks is then $u=Mr''+a_1r'+a_2(r+x_1(0)-r(0))$.

# %%
rest = load_scene("at-rest")
followed = track(rest, load_reference("s-curve"))
print("asks at most", followed.share.str(12), "of the friction;", solved_again(followed).modes)
print("too-fast:", track(rest, load_reference("too-fast")).share.str(12), "of the friction, so that no force can do it")
draw_tracking(followed, rest.pair)

# %% [markdown]
# ## The fastest transfer
#
# From rest to rest over $D$ no control is faster than $2\sqrt{m_2D/b}$. With enough force the bodies stick all the
# way; with less, body 1 can slip ahead until both velocities agree at half time, down to $U_{min}$. Below that, and
# above what a stuck pair can do between $-U$ and $U$, the minimum time is open.

# %%
for amplitude in (None, "1.05", "0.5"):
    found = fastest_transfer(rest, "0.001", amplitude=amplitude)
    end = solved_again(found).final_state[2]
    print(f"U = {amplitude}: {found.time.str(15)} s, bound {found.bound.str(15)} s, arrives at {end.str(12)} m")
    print("   ", found.fastest)
with house_style():
    figure = under_a_force.fastest_transfer_figure()
figure

# %% [markdown]
# ## The ring of Fig. 1
#
# When has the relative motion settled? The limit of $z=x_1-x_2$ of a pair that slips infinitely often is a sum over
# infinitely many slips; a function with $s(F(y))=y-F(y)-s(y)$ adds them up. From the entry on the motion is inside
# the ring permanently.

# %%
settled = ring_entry(load_scene("velocities"), "0.001", rate=20, digits=30)
print("limit of x1 - x2:", settled.centre.str(30), "m")
print("inside for good from", settled.entry.str(30), "s;", settled.why)
with house_style():
    figure = under_a_force.tolerance_ring_of_a_scene()
figure

# %% [markdown]
# Under a force the ring moves with the periodic motion. The period map is proved to shrink distances over a
# whole neighbourhood of it, which bounds all that can still happen after the last event that was computed.

# %%
scene = Scene(pair, State(v1=1), until=5, force=Force.sine(2, 12))
print("around the periodic motion for good from", ring_entry(scene, "0.02", digits=12).entry.str(15), "s")
print("velocities at 10 s:", np.round(solve(Scene(pair, State(v1=1), 10, force=Force.sine(2, 12))).y[[1, 3], -1], 6))
