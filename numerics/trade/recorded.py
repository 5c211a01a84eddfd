"""What a trade has found, as the tables, the report and the notebook read it: a small file of runs.

One is shipped, with the machine that it was measured on, since what the report says must not depend on the hour. With
the extras `comparisons` and `compiled` it is made, in some minutes, by

    python -m numerics trade --json > trade.json && mv trade.json numerics/trade/recorded.json

Every time in it is a ratio that was taken in one process, in turns, by processor time, so that a busy machine changes
little of it; `machine` says whether it was busy. The form:

    {"command": how it was made, "machine": {...}, "left_out": {name: what it needs},
     "scenes": {name: why it is measured},
     "seconds": {name: processor time of one warm solve(scene), read as a user reads it, s},
     "runs": {scene: {who: [[setting, cost, digits, note], ...]}},
     "sweeps": [[scene, ratio, scenes at once, digits of ours, of heyoka, how many heyoka has wrong], ...],
     "sine_cosines": those of 10,000 digits that an event takes in balls of as many}

`cost` is the time of a run by that of `solve(scene)`, null where none was taken; `digits` is -log10 of the worst error;
`note` is empty where the events are right, and begins with NONE where there is no answer.
"""

from __future__ import annotations

import json
import math
import os
import platform
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from numerics.errors import NumericsError
from numerics.tasks import available_cores
from numerics.trade.scenes import kind

SHIPPED = Path(__file__).with_name("recorded.json")
COMMAND = "python -m numerics trade --json"
PACKAGES = ("numpy", "python-flint", "mpmath", "numba", "scipy", "heyoka")
OURS = ("solve", "ball", "mpmath")
NONE = "no answer: "


class UnreadableTrade(NumericsError):
    """A file that holds no trade; the message says what is wrong with it and how to make one."""


class Run(NamedTuple):
    """One contender at one setting on one scene."""

    scene: str
    who: str
    setting: float
    seconds: float | None
    """Its time by that of `solve(scene)` beside it, times the one of `solve(scene)`, s; None where none was taken."""
    digits: float | None
    """-log10 of the worst error; None where the run gave no number."""
    note: str
    """Where the itinerary departs from the true one, or why there is no answer; empty where the events are right."""

    @property
    def ours(self) -> bool:
        """Whether it is a way to call `solve`."""
        return self.who in OURS

    @property
    def right(self) -> bool | None:
        """Whether the events are; None where there is no answer."""
        return None if self.note.startswith(NONE) else not self.note


class Lead(NamedTuple):
    """A peer's run and our fastest right one that is as accurate, None if none is."""

    ratio: float
    """The peer's time by ours; below 1 the peer is faster, 0 where none of ours is as accurate."""
    peer: Run
    ours: Run | None


class Sweep(NamedTuple):
    """Many scenes at once on one core each: `solve_many` beside heyoka, which compiles once for all of them."""

    scene: str
    ratio: float
    """heyoka's time by ours."""
    size: int
    """How many scenes, with other forces or starts."""
    digits: float
    """Ours, proved, of the worst scene."""
    peer_digits: float
    """heyoka's: of its final states against ours, of the worst scene that it has not wrong."""
    peer_wrong: int = 0
    """How many of its final states are off by more than a thousandth of the pair's sizes: an event was lost."""


@dataclass(frozen=True)
class Trade:
    """Everything that one run of the trade wrote down."""

    machine: dict[str, Any]
    left_out: dict[str, str]
    """What was not installed, with what was missing."""
    scenes: dict[str, str]
    """Names, and why each is measured."""
    runs: tuple[Run, ...]
    sweeps: tuple[Sweep, ...] = ()
    sine_cosines: float | None = None
    """How many of 10,000 digits an event takes in balls of as many."""

    def of(self, scene: str, who: str | None = None) -> list[Run]:
        """Return the runs on one scene, of all or of one contender."""
        return [one for one in self.runs if one.scene == scene and who in (None, one.who)]

    def names(self, *, forced: bool) -> list[str]:
        """Return the scenes with a force, or those without."""
        return [one for one in self.scenes if (kind(one) == "forced") == forced]

    def leads(self, scene: str) -> list[Lead]:
        """Return our lead over every right run of a peer that has a time, the least first."""
        known = [(one.seconds, one.digits, one) for one in self.of(scene) if one.right and one.seconds and one.digits]
        found = []
        for seconds, digits, peer in (one for one in known if not one[2].ours):
            equal = [(own, one) for own, reached, one in known if one.ours and reached >= digits]
            least, ours = min(equal, default=(math.inf, None))
            found.append(Lead(seconds / least, peer, ours))
        return sorted(found, key=lambda one: one.ratio)

    def beside(self, scene: str, digits: int, peer: str = "heyoka") -> Lead | None:
        """Return our lead with so many digits asked for (0: none) over a peer's cheapest run that has these, or ours.

        Where no run of the peer has them, it is its most accurate one; None where either has no right run with a time.
        """
        some = [one for one in self.of(scene) if one.right and one.seconds and one.digits]
        ours = next((one for one in some if one.who == "solve" and one.setting == digits), None)
        peers = [one for one in some if one.who == peer]
        if not (ours and peers):
            return None
        enough = [one for one in peers if (one.digits or 0.0) >= (digits or ours.digits or 0.0)]
        key = (lambda one: one.seconds) if enough else (lambda one: -one.digits)
        best: Run = min(enough or peers, key=key)
        return Lead((best.seconds or 0.0) / (ours.seconds or math.inf), best, ours)

    def text(self) -> str:
        """Return the trade as JSON, a line for each scene and contender."""
        unit = {one.scene: one.seconds for one in self.runs if one.who == "solve" and one.setting == 0 and one.seconds}
        runs = {scene: dict(_lines(self.of(scene), unit.get(scene, 1.0))) for scene in self.scenes}
        lines = ",\n".join(
            f"{json.dumps(scene)}: {{\n" + ",\n".join(f" {json.dumps(who)}: {one}" for who, one in some.items()) + "}"
            for scene, some in runs.items()
        )
        head = {"command": COMMAND, "machine": self.machine, "left_out": self.left_out, "scenes": self.scenes}
        tail = {"seconds": {name: _short(one) for name, one in unit.items()}, "sweeps": self.sweeps}
        rest = json.dumps(head | tail | {"sine_cosines": self.sine_cosines}, indent=1)
        return f'{rest[:-2]},\n "runs": {{\n{lines}}}}}\n'


def _lines(runs: list[Run], unit: float) -> Iterator[tuple[str, str]]:
    for who in dict.fromkeys(one.who for one in runs):
        some = [
            [one.setting, _short(one.seconds and one.seconds / unit), _short(one.digits), one.note]
            for one in runs
            if one.who == who
        ]
        yield who, json.dumps(some)


def _short(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.3g}" if value < 100 else f"{value:.0f}")


def recorded(file: Path | None = None) -> Trade:
    """Return the trade of a file, by default the shipped one. Raises UnreadableTrade."""
    path = file or SHIPPED
    try:
        record = json.loads(path.read_text("utf-8"))
        units: Mapping[str, float] = record["seconds"]
        runs = tuple(
            Run(scene, who, float(setting), None if cost is None else cost * units.get(scene, 1.0), digits, note)
            for scene, some in record["runs"].items()
            for who, of in some.items()
            for setting, cost, digits, note in of
        )
        sweeps = tuple(Sweep(*one) for one in record["sweeps"])
        missing = [key for key in ("processor", "cores", "python", "packages") if key not in record["machine"]]
        if not runs or missing:
            raise ValueError("it has no runs or no machine")
        [float(part or 0.0) for one in runs for part in (one.seconds, one.digits)]
        return Trade(record["machine"], record["left_out"], record["scenes"], runs, sweeps, record["sine_cosines"])
    except OSError as error:
        raise UnreadableTrade(f"{path.name} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        what = f"{error} is missing" if isinstance(error, KeyError) else str(error)
        raise UnreadableTrade(f"{path.name} is no output of `{COMMAND}`: {what}") from None


def machine() -> dict[str, Any]:
    """Return on what is measured: processor, cores, load and whether that is busy, versions; no paths and no dates."""
    info = Path("/proc/cpuinfo")
    models = re.findall(r"model name\s*: (.*)", info.read_text("utf-8")) if info.exists() else []
    load = round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else None
    return {
        "processor": (*models, platform.processor(), platform.machine())[0],
        "cores": available_cores(),
        "load": load,
        "busy": load is not None and load > available_cores() / 2,
        "python": platform.python_version(),
        "packages": {name: version(name) for name in PACKAGES if find_spec(name.removeprefix("python-"))},
    }
