"""Past the paper: theorems about the free undamped pair, each for all mass ratios m1/m2."""

from paper_checks.ledger.theorems_excursion import EXCURSIONS
from paper_checks.ledger.theorems_merging import MERGING, SHARES
from paper_checks.ledger.theorems_rate import LATE, RATES, UNIFORM

THEOREMS = EXCURSIONS + RATES + MERGING + SHARES + LATE + UNIFORM
