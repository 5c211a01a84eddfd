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
        r"Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$ under two forces part by at most the integral of "
        r"the norm of $M^{-1}(u-\tilde u)$.",
    ),
    "system-contraction": (
        "Systems.system_contracts",
        r"Two motions of $Mq''+Cq'+Kq+B^{T}\partial\psi(Bq')\ni u$ never part in the norm of the energy.",
    ),
    "system-synchronises": (
        "Systems.system_synchronises",
        r"Without a force, any friction with a power of at least $\beta|Bq'|$: $\int|Bq'|\leqslant E(0)/\beta$, the "
        r"displacement converges, and $Bq'\to 0$ where $|Bq'|$ is Lipschitz.",
    ),
    # static friction above kinetic: motions that keep a stick while the load is below the static friction
    "static-slip-costs": (
        "Robust.slip_costs",
        "With static friction above kinetic, every slip of a free motion lasts longer and costs more energy than a fixed "
        "amount that the start gives.",
    ),
    "static-few-slips": (
        "Robust.few_slips",
        "With static friction above kinetic, a free motion has at most $E(0)/e_0$ slips, $e_0>0$ explicit.",
    ),
    "static-sticks-at-last": (
        "Robust.sticks_at_last",
        "With static friction above kinetic, by any jump, every free motion sticks for ever from some time on.",
    ),
}
