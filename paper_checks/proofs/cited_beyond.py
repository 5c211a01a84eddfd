"""The theorems past the paper's own pair that rows may cite; as in `cited.py`."""

from __future__ import annotations

BEYOND: dict[str, tuple[str, str]] = {
    # friction in any number of directions, M q'' + C q' + K q + B^T d psi(B q') contains u
    "inclusion-defects": (
        "MonotoneInclusion.defects_add",
        r"Two motions of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, separate by at most the integral of the norm of their defects.",
    ),
    "inclusion-contraction": (
        "MonotoneInclusion.contracts",
        r"The flow of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, is non-expansive in the energy norm.",
    ),
    "inclusion-synchronises": (
        "MonotoneInclusion.brakes_synchronise",
        r"Any force that brakes: the path of the slip is at most $E(0)/\beta$ long, what moves no faster has a limit at most $E/\beta$ away, "
        "and a slip that cannot jump tends to 0.",
    ),
    "system-defects": (
        "FrictionSystems.system_defects",
        r"Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$ and $C$ monotone, under two forces separate by at most the integral of the norm of $M^{-1}(u-\tilde u)$.",
    ),
    "system-contraction": (
        "FrictionSystems.system_contracts",
        r"The flow of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$, $C$ monotone and friction bounded, is non-expansive in the energy norm.",
    ),
    "system-synchronises": (
        "FrictionSystems.system_synchronises",
        r"Without a force, $M,K\geqslant 0$ and dissipative dampers, any bounded friction with a power of at least $\beta|Bq'|$: $\int|Bq'|\leqslant E(0)/\beta$, the "
        r"displacement converges, and $Bq'\to 0$ where $|Bq'|$ is Lipschitz.",
    ),
    "system-parts": (
        "FrictionSystems.system_parts",
        r"Where the dampers supply a power of at most $c|v|^2$, as friction that falls with speed does, two motions separate at most like $e^{ct}$.",
    ),
    "pair-inclusion": (
        "FrictionSystems.pair_is_an_inclusion",
        "The pair under a force is the case with one direction.",
    ),
    # the pair on a surface
    "plane-stuck-load": (
        "RoundFriction.stuck_load",
        r"A stuck pair in the plane moves on an ellipse; the force on body 2 is within $b$ exactly while the place is within $L$; its energy by the ellipse, and $E_{cr}=a_2L^2/2$.",
    ),
    "plane-stuck-iff": (
        "RoundFriction.stuck_iff",
        "On a stuck ellipse the load stays within isotropic friction permanently exactly if the semi-major axis is at most $L$.",
    ),
    "plane-stuck-energies": (
        "RoundFriction.stuck_energies",
        "On a stuck ellipse the load stays within isotropic friction always up to $E_{cr}$, never beyond $2E_{cr}$; on a line exactly up to the first, on a circle exactly up to the second.",
    ),
    "plane-landing": (
        "RoundFriction.landing_rate",
        r"In slip, $G=b|s|+\Lambda\cdot s$ has the rate $-\kappa(b^2-|\Lambda|^2)+\dot\Lambda\cdot s$.",
    ),
    "rotating-motion": (
        "RotatingForce.circular_motion",
        "Under a rotating force there is a motion with a friction of constant size and the constant speed $\\rho$ of slip that solves a quadratic.",
    ),
    "rotating-threshold": (
        "RotatingForce.one_threshold",
        "Unless $a_1=0$ and body 1 alone is in resonance: the equation of rotating-motion has a stuck circle up to $U^*$, and exactly above it "
        "one positive speed of slip under the friction $b$.",
    ),
    "rotating-characteristic": (
        "RotatingForce.characteristic_at_zero",
        r"With friction that depends on the speed, the characteristic function at 0 is "
        r"$X(0)=\frac{\omega^2}{2\rho|D|^2}\frac{d(U^2)}{d\rho}$.",
    ),
    "rotating-unstable": (
        "RotatingUnstable.repels",
        r"Where $X(0)<0$, the equations linearised about the slip that rotates with the force have a solution that grows like $e^{\lambda t}$, $\lambda>0$.",
    ),
    # friction that falls with the speed
    "falling-parts": (
        "FallingFriction.slips_part",
        "Where friction falls with speed at a constant slope, the difference of two slips has an exponentially growing mode, whatever the damper of body 1.",
    ),
    "jump-ill-posed": (
        "FallingFriction.sticks_left_at_will",
        "With two coefficients of friction and $a_1=0$ a stick with a load between them can end at each of a continuum of times.",
    ),
    # static friction above kinetic: motions that keep a stick while the load is below the static friction
    "static-slip-costs": (
        "StaticFriction.slip_costs",
        "With static friction above kinetic, where sticks are kept, every slip of a free motion from a contact to the next lasts longer than a fixed time and dissipates at least a fixed energy, both given by $E(0)$.",
    ),
    "static-few-slips": (
        "StaticFriction.few_slips",
        "With static friction above kinetic, where sticks are kept, a free motion has at most $E(0)/e_0$ such slips, $e_0>0$ explicit.",
    ),
    "static-sticks-at-last": (
        "StaticFriction.sticks_at_last",
        "With static friction above kinetic, by any amount, every free motion that keeps its sticks sticks permanently from some time on.",
    ),
    "static-kept": (
        "SticksKept.sticks_kept",
        "With static friction above kinetic there is, from every state, a free motion that keeps its sticks.",
    ),
    # a numerical method
    "euler-law": (
        "EulerLaw.euler_law",
        r"Forward Euler with the step $h$ and a friction in $[-b,b]$ of the sign of the slip: $N(t)^2\leqslant N(0)^2+h\,t\,C(C+C')$, $C$ and $C'$ the speeds of its steps and of the motion in the energy norm.",
    ),
    "euler-slip-step": (
        "EulerSlip.euler_slip_step",
        r"For $a_1=0$, $\omega_1^2=a_2/m_1$: a step $h$ of forward Euler in which the slip with the friction at its beginning does not end adds at most $\frac12h^2\omega_1B$ to the energy distance from a motion, $B^2=a_2v_1^2+m_1\dot v_1^2$.",
    ),
}
