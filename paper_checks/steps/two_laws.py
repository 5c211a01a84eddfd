"""Under a force: where (3), (4) and Coulomb's law, with set-valued friction, have the same motions, for a1 >= 0."""

from __future__ import annotations

from functools import cache

import sympy as sp

from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.solvers.smt import prove
from paper_checks.steps.forced_distance import one_solution, same_modes
from paper_checks.steps.solutions import spurious_branch, spurious_branches_leave
from paper_checks.steps.transfers import stuck_force
from theory import forced
from theory import forced_control as control
from theory.model import stick
from theory.symbols import b, m2


@cache
def stiction_by_load() -> Evidence:
    """The bracket of (4) asks for the load."""
    return identity(
        r"in stick under a force $m_2\ddot x_1=\Lambda$: the bracket of (4) is $1$, $\frac12$, $0$ where $|\Lambda|<,\,=,\,>b$",
        m2 * stick().acceleration1,
        forced.load(),
    )


@cache
def agree() -> Evidence:
    """Every solution of (3), (4) is the motion of Coulomb's law, which is one of them if it is at the limit almost never."""
    return argument(
        r"A solution of (3), (4) has $\ddot z=0$ at almost every time with $\dot z=0$, so neither half nor broken adhesion there: it sticks with $|\Lambda|<b$, and is the one motion of Coulomb's law. Conversely, "
        r"that motion has $\ddot z=0$ at almost every time with $\dot z=0$, so its friction is $\Lambda$, $|\Lambda|\leqslant b$; where $|\Lambda|<b$ it meets (3), (4), and where $|\Lambda|=b$ it does not, as (4) hands on half.",
        spurious_branch("half adhesion"),
        spurious_branch("broken adhesion"),
        spurious_branches_leave(),
        stiction_by_load(),
        same_modes(),
        one_solution(),
    )


@cache
def stuck_below_the_limit() -> Evidence:
    """A stuck pair that asks for less than all of the friction obeys (3), (4), too; it needs no more time than one likes."""
    slower = sp.Symbol("k", positive=True)
    return argument(
        r"A pair that sticks along a reference has the load $m_2\ddot x_{\mathrm{ref}}$: with $|\ddot x_{\mathrm{ref}}|<b/m_2$ it obeys (3), (4) as it obeys Coulomb's law. Half of the way with the acceleration $4D/T^2$ and half with "
        r"its opposite takes the time $T$, and asks for less than $b/m_2$ if $T$ exceeds the least time.",
        stuck_force(),
        agree(),
        identity(
            r"at the least time that acceleration is $b/m_2$",
            4 * control.path / control.least_time() ** 2,
            control.strongest(),
        ),
        prove(
            r"in $k>1$ times the least time it is less, $b/(m_2k^2)<b/m_2$",
            [sp.Gt(slower, 1)],
            sp.Lt(b, b * slower**2, evaluate=False),
        ),
    )
