"""Whoever takes part, behind one interface: ours (ours.py) and the peers of comparisons/."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any, Protocol

from numerics.scene import Scene
from numerics.trade.comparisons.peer import Peer, PeerRun, PeerTexts
from numerics.trade.outcome import Outcome, float_text, letters


class Contender(Protocol):
    """A Peer whose answers may have any number of digits."""

    label: str
    """Under which it is listed: its name, and its use where another one has the same name."""
    name: str
    use: str
    knob: str
    settings: tuple[float, ...]
    """The values of the knob that are worth measuring, from coarse to fine."""
    ours: bool

    def takes(self, scene: Scene) -> bool:
        """Return whether it is made for a scene: with a force or without."""

    def missing(self) -> str | None:
        """Return what has to be installed before it can run, in words for a reader; None if nothing is missing."""

    def prepare(self, scene: Scene, setting: float) -> Callable[[], Any]:
        """Build and compile everything once; the function that is returned is what is timed. Raises Unsupported."""

    def outcome(self, run: Any) -> Outcome:
        """Return as text what a run says; not timed."""


class PeerContender:
    """A peer; its numbers are floats, unless it writes them with more digits itself."""

    ours = False

    def __init__(self, peer: Peer, label: str | None = None) -> None:
        """Take over what the peer says of itself."""
        self._peer, self.label = peer, label or peer.name
        self.name, self.use, self.knob, self.settings = peer.name, peer.use, peer.knob, tuple(peer.settings)

    def takes(self, scene: Scene) -> bool:
        """Return whether the peer is for forced scenes and the scene is one, or neither."""
        return scene.is_forced == self._peer.forced

    def missing(self) -> str | None:
        """Return what the peer says is missing."""
        return self._peer.missing()

    def prepare(self, scene: Scene, setting: float) -> Callable[[], Any]:
        """Prepare the peer."""
        return self._peer.prepare(scene, setting)

    def outcome(self, run: Any) -> Outcome:
        """Return a PeerRun as text."""
        return peer_outcome(run)


def peer_outcome(run: PeerRun) -> Outcome:
    """Return what a peer says as text, with all the digits of its own format."""
    times = [float(t) for t in run.t_events]
    texts = run.texts() if run.texts else _float_texts(run)
    return Outcome(
        kinds=letters(run.kinds),
        times=times,
        last_event=texts.last_event,
        final=list(texts.final),
        dissipated=texts.dissipated,
        steps=int(run.steps),
    )


def _float_texts(run: PeerRun) -> PeerTexts:
    last = float_text(run.t_events[-1]) if len(run.t_events) else None
    return PeerTexts(last, tuple(float_text(value) for value in run.y_final), float_text(run.dissipated))


def all_contenders() -> list[Contender]:
    """Return everyone, ours first, whether installed or not."""
    from numerics.trade.comparisons.registry import all_peers, forced_peers
    from numerics.trade.ours import our_contenders

    forced = [PeerContender(peer, f"{peer.name}, u(t)") for peer in forced_peers()]
    return [*our_contenders(), *labelled(all_peers()), *forced]


def labelled(peers: Sequence[Peer]) -> list[Contender]:
    """Return peers as contenders; two uses of one tool are told apart by the first words of the use."""
    often = Counter(peer.name for peer in peers)
    told = {peer: f"{peer.name} ({peer.use.partition(',')[0]})" for peer in peers}
    return [PeerContender(peer, peer.name if often[peer.name] == 1 else told[peer]) for peer in peers]
