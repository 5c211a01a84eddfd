"""The claims of the paper, in its order, then the theorems past it: what is said, where, the verdict on record."""

from paper_checks.ledger.claim import Claim, Kind, in_order
from paper_checks.ledger.section1 import ABSTRACT, SECTION_1
from paper_checks.ledger.section2 import SECTION_2
from paper_checks.ledger.section3_convergence import ALTERNATIVES, CONVERGENCE
from paper_checks.ledger.section3_sliding import SLIDING
from paper_checks.ledger.section3_viscous import ITINERARIES, VISCOUS
from paper_checks.ledger.section4 import EXAMPLE_SYSTEM
from paper_checks.ledger.section4_results import NUMERICAL_RESULTS
from paper_checks.ledger.section5 import SECTION_5
from paper_checks.ledger.section5_outlook import OUTLOOK
from paper_checks.ledger.theorems import THEOREMS

CLAIMS = in_order(
    ABSTRACT,
    SECTION_1,
    SECTION_2,
    SLIDING,
    ALTERNATIVES,
    CONVERGENCE,
    VISCOUS,
    ITINERARIES,
    EXAMPLE_SYSTEM,
    NUMERICAL_RESULTS,
    SECTION_5,
    OUTLOOK,
    THEOREMS,
)


def claim_named(name: str) -> Claim:
    """Return the claim with this id; raises KeyError where there is none."""
    return {claim.id: claim for claim in CLAIMS}[name]


__all__ = ["CLAIMS", "Claim", "Kind", "claim_named"]
