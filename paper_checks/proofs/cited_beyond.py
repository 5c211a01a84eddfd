"""The theorems past the paper's own pair that rows may cite; as in `cited.py`."""

from __future__ import annotations

BEYOND: dict[str, tuple[str, str]] = {
    # friction in any number of directions, M q'' + C q' + K q + B^T d psi(B q') contains u
    "inclusion-defects": (
        "Inclusion.defects_add",
        r"Two motions of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, part by at most the integral of their defects' norm.",
    ),
    "inclusion-contraction": (
        "Inclusion.contracts",
        r"Two motions of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, never part in the norm of the energy.",
    ),
    "inclusion-synchronises": (
        "Inclusion.brakes_synchronise",
        "Whatever brakes: its path is at most $E(0)/\\beta$ long, what moves no faster has a limit at most $E/\\beta$ away, "
        "and a slip that cannot jump dies out.",
    ),
    "system-defects": (
        "Systems.system_defects",
        r"Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$ and $C$ monotone, under two forces part by at most "
        r"the integral of the norm of $M^{-1}(u-\tilde u)$.",
    ),
    "system-contraction": (
        "Systems.system_contracts",
        r"Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$, $M,K\geqslant 0$, $C$ monotone and friction bounded, never part in the norm of the energy.",
    ),
    "system-synchronises": (
        "Systems.system_synchronises",
        r"Without a force, $M,K\geqslant 0$ and dampers that take power, any bounded friction with a power of at least $\beta|Bq'|$: $\int|Bq'|\leqslant E(0)/\beta$, the "
        r"displacement converges, and $Bq'\to 0$ where $|Bq'|$ is Lipschitz.",
    ),
    "system-parts": (
        "Systems.system_parts",
        r"Where the dampers give at most $c|v|^2$, as a friction that falls with the speed does, two motions part at most "
        r"like $e^{ct}$.",
    ),
    "pair-inclusion": (
        "Systems.pair_is_an_inclusion",
        "The motions of the pair under a force are the instance with one direction.",
    ),
    # the pair on a surface
    "plane-stuck-iff": (
        "Plane.stuck_iff",
        "On a stuck ellipse the load stays within round friction for ever exactly if the semi-major axis is at most $L$.",
    ),
    "plane-stuck-energies": (
        "Plane.stuck_energies",
        "In a stuck ellipse the load stays within round friction up to $E_{cr}$ always, beyond $2E_{cr}$ never; a line exactly "
        "up to the one, a circle exactly up to the other.",
    ),
    "plane-landing": (
        "Plane.landing_rate",
        r"In slip, $G=b|s|+\Lambda\cdot s$ has the rate $-\kappa(b^2-|\Lambda|^2)+\dot\Lambda\cdot s$.",
    ),
    "rotating-motion": (
        "Rotating.circular_motion",
        "Under a rotating force there is a motion with a friction of constant size and the constant speed $\\rho$ of slip that solves a quadratic.",
    ),
    "rotating-threshold": (
        "Rotating.one_threshold",
        "Unless $a_1=0$ and body 1 alone is in resonance: the equation of rotating-motion has a stuck circle up to $U^*$, and exactly above it "
        "one positive speed of slip under the friction $b$.",
    ),
    "rotating-characteristic": (
        "Rotating.characteristic_at_zero",
        r"With a friction of the speed the characteristic function at 0 is "
        r"$X(0)=\frac{\omega^2}{2\rho|D|^2}\frac{d(U^2)}{d\rho}$.",
    ),
    # friction that falls with the speed
    "falling-parts": (
        "Falling.slips_part",
        "Where friction falls with the speed by a constant slope, the difference of two slips has a motion that grows exponentially, whatever "
        "the damper of body 1.",
    ),
    "jump-ill-posed": (
        "Falling.sticks_left_at_will",
        "With two coefficients of friction and $a_1=0$ a stick with a load between them can be left at each of a continuum of "
        "times.",
    ),
    # static friction above kinetic: motions that keep a stick while the load is below the static friction
    "static-slip-costs": (
        "Robust.slip_costs",
        "With static friction above kinetic, where sticks are kept, every slip of a free motion from a contact to the next "
        "lasts longer than a fixed time and costs at least a fixed energy, which the start gives.",
    ),
    "static-few-slips": (
        "Robust.few_slips",
        "With static friction above kinetic, where sticks are kept, a free motion has at most $E(0)/e_0$ such slips, $e_0>0$ explicit.",
    ),
    "static-sticks-at-last": (
        "Robust.sticks_at_last",
        "With static friction above kinetic, by any jump, every free motion that keeps its sticks sticks for ever from some time on.",
    ),
}
