"""Abstract and Section I: what the paper says of control through the interface before the model."""

from __future__ import annotations

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.evidence.finding import Verdict
from paper_checks.ledger.claim import Claim
from theory.forced_control import ring_ratio
from theory.symbols import m1, m2

ABSTRACT = (
    Claim(
        "one-active-one-passive",
        "Abstract",
        "sixth sentence",
        (
            clause(
                "freedoms",
                r"The system has one active degree of freedom (the driving body) and one passive degree of freedom (the driven body).",
            ),
        ),
        Verdict.HOLDS,
    ),
)

SECTION_1 = (
    Claim(
        "ring-of-tolerance",
        "I",
        "Fig. 1 and the sentence before it",
        r"In controlled motion with a frictional interface a trajectory of the relative motion should reach some region of control tolerance, surrounding a "
        r"steady-state periodic orbit (in the relative coordinates), and stay there.",
        Verdict.HOLDS_CORRECTED,
        correction=(
            clause(
                "response",
                r"Under a bounded periodic force and with $a_1>0$, $(x_1,v_1,v_2)$ has one periodic orbit; every motion enters each tube $N\leqslant\varepsilon$ "
                r"around it, once and for good;",
                kernel=("periodic-response", "forced-contraction"),
            ),
            clause(
                "velocity",
                r"in the tube the relative velocity is within $\sqrt\kappa\,\varepsilon$ of the orbit's, «kappa»;",
                kappa=Formula(r"\kappa", "=", (m1 + m2) / (m1 * m2), equals(ring_ratio)),
                kernel=("ring-factor",),
            ),
            clause(
                "displacement",
                r"the relative displacement is not drawn anywhere: a start with another $x_2(0)$ keeps the difference for ever, so the ring has to be centred on "
                r"the motion's own limit.",
                kernel=("displacement-unseen",),
            ),
        ),
    ),
    Claim(
        "target-or-set-point",
        "I",
        "paragraph after Fig. 1",
        (
            clause(
                "target",
                r"A controlled motion along a target trajectory,",
            ),
            clause(
                "set-point",
                r"or (even simpler) towards a set-point reference, remains largely unexplored for the manipulation of objects that are solely connected via a frictional "
                r"interface.",
            ),
        ),
        Verdict.HOLDS,
        open=(
            "That such control remains largely unexplored is a statement about the literature, which is not judged here. What is judged is what the sentence takes for granted: that there is such "
            "control, and that a set-point is the simpler of both.",
        ),
    ),
)
