"""The theorems on (3), (4), on Coulomb's law in Filippov's sense under a force, and on the case study, that rows may cite.

"Almost every time" is all of $[0,\\infty)$ but for a null set on each bounded interval; as in `cited.py` else.
"""

from __future__ import annotations

SWITCHING: dict[str, tuple[str, str]] = {
    "filippov-iff": (
        "Filippov.filippov_iff",
        "A solution is what Filippov calls one: absolutely continuous, and in the differential inclusion at almost all times.",
    ),
    "filippov-well-posed": (
        "Filippov.filippov_well_posed",
        "From every initial state there is exactly one Filippov solution, with or without damping.",
    ),
    "filippov-forced": (
        "Filippov.filippov_forced",
        "Under any integrable force a Filippov solution is a motion: what is proved of all motions is true of it.",
    ),
    "forced-filippov-iff": (
        "Filippov.forced_filippov_iff",
        "Under an integrable force that is continuous at almost every time the motions are the Filippov solutions, and only they.",
    ),
    "switching-iff": (
        "Switching.switching_iff",
        "The absolutely continuous solutions of (3), (4) without a control, met at almost all times, are Filippov's, and only they.",
    ),
    "forced-switching-iff": (
        "Switching.forced_switching_iff",
        r"Under any force the absolutely continuous solutions of (3), (4), met at almost every time, are the Filippov solutions with $|\Lambda|<b$ at almost every time with $v_1=v_2$, and only they.",
    ),
    "literal-solutions": (
        "Switching.literal_solutions",
        r"Under an integrable force that is continuous at almost every time (3), (4) have a solution from the start of a motion exactly if that has $|\Lambda|\neq b$ at almost every time with $v_1=v_2$; every such solution is that motion.",
    ),
    "momentum-balance": (
        "Switching.momentum_balance",
        r"Every solution of (3), (4) has $m_1\dot v_1+a_1v_1+a_2x_1+m_2\dot v_2=u$ at almost every time: the forces between the bodies add up to nothing.",
    ),
    "no-solution-under-control": (
        "Switching.no_solution_under_control",
        "Case study, $b=0.5$, from rest at 0 under $u=1+50t^2$: (3), (4) have no solution.",
    ),
    "no-solution-inside": (
        "Switching.no_solution_inside",
        r"With $\mathrm{sgn}(0)=0$ in place of the set-valued sign Coulomb's law has no solution from a contact with $0<|a_2x_1+a_1v_1|<b(m_1+m_2)/m_2$.",
    ),
    "literal-reference": (
        "StuckReferences.literal_reference",
        r"A pair that sticks has the velocity $v$ under (3), (4) and some force exactly if $v$ is absolutely continuous with $|\dot v|<b/m_2$ at almost every time, wherever body 1 starts.",
    ),
    "literal-transfer": (
        "StuckReferences.literal_transfer",
        r"Under (3), (4) a stuck pair takes body 2 from rest to rest over any $D$ of either sign in any time above $2\sqrt{m_2|D|/b}$, and stays, under a force that is continuous at almost every time.",
    ),
    "edges-isolated": (
        "EdgesIsolated.edges_isolated",
        r"Around every time of a solution: with $v_1=v_2$ (3) gives an acceleration of absolute value below $b/m_2$, but perhaps at that time itself.",
    ),
    "case-study-reduction": (
        "CaseStudy.reduction",
        "Case study: (3), (4) at one time are (11) and, in slip or where $|x_1|<b/100$, (12); with $v_1=v_2$ body 2 has no acceleration where $|x_1|>b/100$, and half of body 1's where $|x_1|=b/100$.",
    ),
    "law-satisfies-case-study": (
        "CaseStudy.law_case_study",
        "Case study: every Filippov solution satisfies (11), (12) at almost every time.",
    ),
    "case-study-agrees-until": (
        "CaseStudy.agree_until",
        "Case study: a solution of (11), (12) that keeps every stick agrees with the Filippov solution up to $T$ exactly if at no time before $T$ it has $v_1=v_2$ and $|x_1|>b/100$.",
    ),
    "two-solutions-from-6-mm": (
        "CaseStudy.two_from_six",
        "Case study, $b=0.5$, from rest at 6 mm: the stuck $x_1=0.006\\cos 10t$ satisfies (11), (12), and so does a Filippov solution that slips at once, the only one of (3), (4) and of the inclusion.",
    ),
    "ring-missed": (
        "CaseStudy.ring_missed",
        "Case study, $b=0.5$, from rest at 4 mm, body 2 at 0 or at 1 mm: both pairs stick permanently, 4 and 3 mm apart, and no region narrower than 1 mm is reached by both relative motions.",
    ),
}
