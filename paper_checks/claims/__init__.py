"""The claims of the paper by its sections, then the theorems past it: a module a subject, all of a claim in one place."""

import importlib
import pkgutil
from collections.abc import Iterable
from itertools import chain

from paper_checks.errors import LedgerError
from paper_checks.evidence.claim import Claim

_ORDER = """
importance-of-the-problem understudied-in-the-past modeling-is-challenging one-active-one-passive
friction-processes-studied friction-as-evoked-damping friction-as-cause common-in-manufacturing ring-of-tolerance
rigid-bodies-understood target-or-set-point coulomb-law-is-sufficient history-of-friction-laws secondary-as-damping
friction-opposes-displacement most-general-notation energy-as-lyapunov-function
translational-or-rotational force-as-reference-or-disturbance free-interface stiff-limit in-favour-of-analysis
sgn-three-valued modes-from-closed-form stiction-bracket interface-force-balance viscous-no-direct-effect
filippov-equivalence vector-fields energy-rate energy-dissipation-places parts-of-the-surface transversality-outside
transversality-strip sliding-region two-senses-of-sliding sliding-modes-well-suited critical-energy supercritical-arcs infinitely-many-crossings return-alternatives dichotomy
stick-durations slip-durations exits-near-endpoints relative-displacement-limit global-stability
no-merging-near-critical slower-than-exponential rate-one-over-t viscous-energy-rate viscous-origin-stable
itinerary-that-merges itinerary-that-creeps example-eigenfrequency example-reduction example-stiction-never-violated
example-onset example-two-modes example-damped-oscillations start-at-6mm-sticks start-with-speed-synchronises
constant-damping-rate saw-tooth synchronisation-time relative-motion-converges euler-reproduces-figures
transparent-view driven-body-steered synchronisation-all-parameters finite-time-then-alternation viscous-accelerates
damping-for-tracking two-descriptions motions-on-a-surface surface-friction-is-nontrivial acceleration-bound
efficient-control-is-challenging varying-interface excursion-closed-form
excursion-monotone return-map-expansion sharp-rate-constant rate-bounds-explicit merging-set critical-mass-ratio
merging-bands merging-share long-time-expansion rate-with-error uniform-rate forced-mode-rule forced-no-zeno
forced-contraction forced-periodic-response forced-resonance-bound entrainment-threshold trackable-references
minimum-transfer-time cheapest-transfer tolerance-ring damping-can-desynchronise synchronisation-against-damping
static-friction-stops-creeping friction-in-any-direction stuck-ellipses rotating-force euler-error
"""
"""Of the paper, section by section, then of what is past it; a claim that is not named here comes last."""


def in_order(*subjects: Iterable[object]) -> tuple[Claim, ...]:
    """Return the claims among the subjects' members, each once; raises LedgerError where an id is taken twice."""
    found = {id(one): one for one in chain(*subjects) if isinstance(one, Claim)}.values()
    ids = [claim.id for claim in found]
    if twice := sorted({name for name in ids if ids.count(name) > 1}):
        raise LedgerError(f"claim ids taken twice: {', '.join(twice)}")
    place = {name: number for number, name in enumerate(_ORDER.split())}
    return tuple(sorted(found, key=lambda claim: place.get(claim.id, len(place))))


SUBJECTS = tuple(module.name for module in pkgutil.walk_packages(__path__, f"{__name__}.") if not module.ispkg)
"""The modules of this room by their full names: a claim is found where it is."""
CLAIMS = in_order(*(vars(importlib.import_module(name)).values() for name in SUBJECTS))


def claim_named(name: str) -> Claim:
    """Return the claim with this id; raises KeyError where there is none."""
    return {claim.id: claim for claim in CLAIMS}[name]
