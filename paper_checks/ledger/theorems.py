"""Past the paper: theorems about the free undamped pair for all mass ratios m1/m2, and about the pair under a force."""

from paper_checks.ledger.theorems_control import CONTROL
from paper_checks.ledger.theorems_entrainment import DRIVEN
from paper_checks.ledger.theorems_excursion import EXCURSIONS
from paper_checks.ledger.theorems_forced import FORCED
from paper_checks.ledger.theorems_merging import MERGING, SHARES
from paper_checks.ledger.theorems_rate import LATE, RATES, UNIFORM
from paper_checks.ledger.theorems_response import RESPONSES

THEOREMS = EXCURSIONS + RATES + MERGING + SHARES + LATE + UNIFORM + FORCED + RESPONSES + DRIVEN + CONTROL
