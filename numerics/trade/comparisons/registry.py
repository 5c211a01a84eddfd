"""Everyone who is compared with us. Building the list imports no integrator: each is imported when it prepares."""

from __future__ import annotations

from numerics.trade.comparisons.diffrax_peer import DiffraxPeer
from numerics.trade.comparisons.euler_peer import EulerPeer
from numerics.trade.comparisons.forced_diffrax import ForcedDiffraxPeer
from numerics.trade.comparisons.forced_heyoka import ForcedHeyokaPeer
from numerics.trade.comparisons.forced_scipy import ForcedScipyPeer
from numerics.trade.comparisons.forced_siconos import ForcedSiconosPeer
from numerics.trade.comparisons.hand_written import HandWrittenPeer
from numerics.trade.comparisons.heyoka_peer import HeyokaPeer
from numerics.trade.comparisons.heyoka_tuned import TunedHeyokaPeer
from numerics.trade.comparisons.peer import Peer
from numerics.trade.comparisons.scipy_peer import ScipyPeer
from numerics.trade.comparisons.scipy_tuned import TunedScipyPeer
from numerics.trade.comparisons.siconos_peer import SiconosPeer


def all_peers() -> tuple[Peer, ...]:
    """Return every peer for free scenes, installed or not."""
    return (
        EulerPeer(compiled=False),
        EulerPeer(compiled=True),
        *(ScipyPeer(method) for method in ("DOP853", "Radau", "LSODA")),
        TunedScipyPeer("DOP853"),
        HeyokaPeer(),
        TunedHeyokaPeer("double"),
        TunedHeyokaPeer("long double"),
        TunedHeyokaPeer("quadruple"),
        TunedHeyokaPeer("real"),
        DiffraxPeer("Tsit5"),
        DiffraxPeer("Dopri8"),
        SiconosPeer("ZeroOrderHold"),
        SiconosPeer("EulerMoreau"),
    )


def forced_peers() -> tuple[Peer, ...]:
    """Return every peer for scenes with a force, installed or not; the last two are what engineers write by hand."""
    return (
        *(ForcedScipyPeer(method) for method in ("DOP853", "Radau", "LSODA")),
        ForcedHeyokaPeer(),
        ForcedDiffraxPeer("Dopri8"),
        ForcedSiconosPeer(),
        HandWrittenPeer("Karnopp"),
        HandWrittenPeer("tanh"),
    )
