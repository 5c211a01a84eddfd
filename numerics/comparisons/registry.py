"""Everyone who is compared with us. Building the list imports no integrator: each is imported when it prepares."""

from __future__ import annotations

from numerics.comparisons.diffrax_peer import DiffraxPeer
from numerics.comparisons.euler_peer import EulerPeer
from numerics.comparisons.heyoka_peer import HeyokaPeer
from numerics.comparisons.heyoka_tuned import TunedHeyokaPeer
from numerics.comparisons.peer import Peer
from numerics.comparisons.scipy_peer import ScipyPeer
from numerics.comparisons.scipy_tuned import TunedScipyPeer
from numerics.comparisons.siconos_peer import SiconosPeer


def all_peers() -> tuple[Peer, ...]:
    """Return every peer, installed or not."""
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
