"""Section II: dynamics of a pair of bodies with frictional interface."""

from paper_checks.finding import Verdict
from paper_checks.ledger.claim import Claim

SECTION = "II"

SECTION_2 = (
    Claim(
        "sgn-three-valued",
        SECTION,
        "eq. (1) and the sentence after it",
        r"The signum is three-valued, $\mathrm{sgn}(v)=1,\,0,\,-1$ for $v>0$, $v=0$, $v<0$, unlike a "
        r"set-valued sign operator; this allows well-defined solutions at zero differential velocity "
        r"between the two moving bodies.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "modes-from-closed-form",
        SECTION,
        "eqs. (3), (4)",
        r"Including the signum in (3) and (4) switches directly between the two modes: (i) "
        r"$\dot{x}_1=\dot{x}_2$, no frictional damping, and the driving body carries the total mass "
        r"$m_1+m_2$; (ii) the second body slides under the friction force, which accelerates or "
        r"decelerates both bodies. Neither if-else statements nor case differences are required.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "stiction-bracket",
        SECTION,
        "eq. (4), last sentence of Section II",
        r"Decoupling of the bodies, that is switching to mode (ii), is enabled in (4) by the first bracket "
        r"for $\dot{z}\neq 0$ and by the second bracket, "
        r"$\tfrac{1}{2}\bigl(1-\mathrm{sgn}(|\ddot{x}_1|-b\,m_2^{-1})\bigr)$, for the case when the "
        r"stiction condition, printed as $|\ddot{x}_1|>b\,m_2^{-1}$, is violated.",
        Verdict.HOLDS_CORRECTED,
    ),
    Claim(
        "interface-force-balance",
        SECTION,
        "eqs. (3), (4)",
        r"The friction force in (3) and (4) is the interaction of the two bodies: in mode (ii) it impacts "
        r"the momentum of both, which accelerate or decelerate each other; the interface conserves the "
        r"momentum of the moving pair (Section I). Hence, in every branch of (3) and (4), what one body "
        r"receives the other one gives.",
        Verdict.REFUTED,
    ),
)
