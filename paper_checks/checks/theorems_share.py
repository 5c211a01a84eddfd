"""Past the paper: the bands of energies that ever merge, and how much of an energy sphere does."""

from __future__ import annotations

from fractions import Fraction

from paper_checks.checks.registry import Context, check
from paper_checks.evidence.evidence import argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.steps.creeping import creeps_for_ever
from paper_checks.steps.merging_bands import bands
from paper_checks.steps.merging_share import exact_share, limit, random_states

SHARES = (Fraction(3, 5), Fraction(7, 10), Fraction(4, 5))


@check("merging-bands")
def merging_bands(context: Context) -> Finding:  # noqa: ARG001
    """Energies that merge, in turn with energies that never do."""
    return conclude(
        Verdict.HOLDS,
        "The energies on $S_0$ that ever merge form many bands: between two that merge lies one that never does. Each trajectory is solved in "
        "balls until it sticks for ever, or leaves $S_0$ by a ray so little above $E_{cr}$ that it never merges.",
        carried(
            "bands",
            argument(
                "Two energies that merge with one between them that never does are in two components.",
                *(bands(share)[1] for share in SHARES),
                creeps_for_ever(),
            ),
        ),
        figure="merging-bands",
    )


@check("merging-share")
def merging_share(context: Context) -> Finding:
    """The share of the energy sphere, as an integral; random states beside it."""
    return conclude(
        Verdict.HOLDS,
        "Merging in finite time is the common case just above $E_{cr}$ in the whole state space, though it never happens from $S_0$ there: up "
        "to $r^*$ the share of the states that merge is an integral over the disc of captive contacts, and falls like $1/E$.",
        carried("share", exact_share()),
        carried("limit", limit()),
        random_states(Fraction(3, 10), Fraction(4), 3000, context.seed),
        random_states(Fraction(1, 2), Fraction(3, 2), 3000, context.seed),
        derivation=(
            "$$\\frac{1}{2\\pi\\sqrt{q\\,r\\,E}}\\int_{X^2+V^2\\leqslant 1}\\frac{1-X}{|V_1-V_2|_E}\\,dX\\,dV$$",
        ),
        figure="merging-share",
    )
