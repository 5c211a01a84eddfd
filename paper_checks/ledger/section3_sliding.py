"""Section III, first half: the model as a Filippov system, its energy and its sliding region."""

from paper_checks.evidence import Verdict
from paper_checks.ledger.claim import Claim

SECTION = "III"

SLIDING = (
    Claim(
        "viscous-no-direct-effect",
        SECTION,
        "opening paragraph",
        r"Taking $a_1=0$ is justified by the fact that the viscous damping of the driving body, "
        r"$a_1\dot{x}_1$, is always dissipative and does not directly affect the interaction of the "
        r"inertial pair.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "filippov-equivalence",
        SECTION,
        "before (e1)",
        r"With $a_1=0$ and $u=0$ the system (2)–(4) is equivalent to (e1)–(e3): $\dot{x}_1=v_1$, "
        r"$m_1\dot{v}_1=-a x_1-b\,\mathrm{sign}(v_1-v_2)$, $m_2\dot{v}_2=b\,\mathrm{sign}(v_1-v_2)$, where "
        r"$a=a_2>0$.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "vector-fields",
        SECTION,
        "after (e3)",
        r"The velocity field of (e1)–(e3) is "
        r"$\Phi_-=\bigl(v_1,\,-\tfrac{a}{m_1}x_1+\tfrac{b}{m_1},\,-\tfrac{b}{m_2}\bigr)$ in "
        r"$\Omega_-=\{v_1<v_2\}$ and "
        r"$\Phi_+=\bigl(v_1,\,-\tfrac{a}{m_1}x_1-\tfrac{b}{m_1},\,\tfrac{b}{m_2}\bigr)$ in "
        r"$\Omega_+=\{v_1>v_2\}$, with a discontinuity on $S=\{v_1=v_2\}$.",
        Verdict.HOLDS,
    ),
    Claim(
        "energy-rate",
        SECTION,
        "(edot)",
        r"With $E=\tfrac{1}{2}(a x_1^2+m_1 v_1^2+m_2 v_2^2)$, $\dot{E}=-b\,|v_1-v_2|\leqslant 0$ along "
        r"every trajectory of (e1)–(e3).",
        Verdict.HOLDS,
    ),
    Claim(
        "energy-dissipation-places",
        SECTION,
        "after (edot)",
        r"The energy is dissipated on those parts of a trajectory which belong to $\Omega_-\cup\Omega_+$ "
        r"and is conserved on the parts which belong to $S$.",
        Verdict.HOLDS,
    ),
    Claim(
        "transversality-outside",
        SECTION,
        "(trans)",
        r"With the normal $n_S=(0,1,-1)$, which points from $\Omega_-$ to $\Omega_+$: $\Phi_\pm\cdot "
        r"n_S<0$ on $S_+$ and $\Phi_\pm\cdot n_S>0$ on $S_-$, where $S_\pm$ are the parts of $S$ with $\pm "
        r"x_1>b(m_1+m_2)/(a m_2)$.",
        Verdict.HOLDS,
    ),
    Claim(
        "transversality-strip",
        SECTION,
        "(trans')",
        r"$\Phi_-\cdot n_S\geqslant 0$ and $\Phi_+\cdot n_S\leqslant 0$ on $S_0$, the part of $S$ with "
        r"$|x_1|\leqslant b(m_1+m_2)/(a m_2)$.",
        Verdict.HOLDS,
    ),
    Claim(
        "sliding-region",
        SECTION,
        "after (trans')",
        r"$S_0$ is the sliding region; it consists of trajectories and parts thereof known as sliding "
        r"modes, each in the intersection of $S_0$ with an ellipsoid $E=E_0$ of constant energy.",
        Verdict.HOLDS,
    ),
    Claim(
        "critical-energy",
        SECTION,
        "(E_cr)",
        r"For $E_0\leqslant E_{cr}=\frac{b^2(m_1+m_2)^2}{2a m_2^2}$ the intersection $\{E=E_0\}\cap S_0$ "
        r"is a closed elliptic trajectory; for $E_0>E_{cr}$ it is not.",
        Verdict.HOLDS,
    ),
    Claim(
        "supercritical-arcs",
        SECTION,
        "after (E_cr)",
        r"For $E_0>E_{cr}$ the intersection $\{E=E_0\}\cap S_0$ consists of two disjoint elliptic arcs, "
        r"each being a part of a trajectory. One of these trajectories exits $S_0$ through the ray "
        r"$\ell_-$ into $\Omega_+$, the other through the ray $\ell_+$ into $\Omega_-$.",
        Verdict.HOLDS,
    ),
)
