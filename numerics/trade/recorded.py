"""What a trade has found, as the tables, the report and the notebook read it: a small file of runs.

One is shipped, with the machine that it was measured on, since what the report says must not depend on the hour. With
the extras `comparisons` and `compiled` it is made by

    python -m numerics trade --json > trade.json && mv trade.json numerics/trade/recorded.json

Its form is becoming this one. Every cost is a ratio that was taken in one process, in turns, by processor time, so that
a busy machine changes little of it:

    {"command": "python -m numerics trade --json",
     "machine": {"processor": text, "cores": n, "load": at the start, "python": version, "packages": {name: version}},
     "left_out": {name: what it needs},
     "scenes": {name: why it is measured},
     "seconds": {name: processor time of one warm solve(scene), read as a user reads it, s},
     "columns": ["scene", "who", "setting", "cost", "digits", "right", "note"],
     "runs": [one list a run],
     "sweeps": [[scene, how many times as fast as heyoka solve_many is, scenes at once, digits of ours, of heyoka]],
     "sine_cosines": those of 10,000 digits that an event takes in balls of as many}

`cost` is the processor time of a run by that of `solve(scene)` on the same scene (1 for `solve`, setting 0), null
where nothing was timed; `digits` is -log10 of the worst error, `right` whether the events are, `note` what is wrong. In
Python: `Trade.machine`, `.left_out`, `.scenes`, `.seconds`, `.runs` (of `Run`, with the property `ours`), `.sweeps` (of
`Sweep`: scene, ratio, size, digits, peer_digits), `.sine_cosines`; `Trade.of(scene, who)`, `.names(forced=...)`,
`.leads(scene)` and `Lead` as now; `Trade.time(run)` is cost * seconds[scene], or None.
"""

from __future__ import annotations

import json
import math
import os
import platform
import re
from dataclasses import asdict, dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from numerics.errors import NumericsError
from numerics.tasks import available_cores
from numerics.trade.scenes import kind

SHIPPED = Path(__file__).with_name("recorded.json")
PACKAGES = ("numpy", "python-flint", "numba", "pyperf", "scipy", "heyoka", "diffrax", "jax")


class UnreadableTrade(NumericsError):
    """A file that holds no trade; the message says what is wrong with it and how to make one."""


class Run(NamedTuple):
    """One contender at one setting on one scene."""

    scene: str
    who: str
    ours: bool
    setting: float
    seconds: float | None
    """The median of warm calls in fresh processes; None where nothing was timed."""
    deviation: float | None
    """Their median absolute deviation, s; None where one call was timed."""
    digits: float | None
    """-log10 of the worst error; None where the run gave no number."""
    right: bool | None
    """Whether the events are; None where there is no answer."""
    note: str
    """Where the itinerary departs from the true one, or why there is no answer."""


class Lead(NamedTuple):
    """A peer's run and our fastest right one that is as accurate, None if none is."""

    ratio: float
    """The peer's time by ours; below 1 the peer is faster, 0 where none of ours is as accurate."""
    peer: Run
    ours: Run | None


@dataclass(frozen=True)
class Trade:
    """Everything that one run of the trade wrote down."""

    size: str
    machine: dict[str, Any]
    left_out: dict[str, str]
    """What was not installed, with what was missing."""
    scenes: dict[str, str]
    """Names, and why each is measured."""
    runs: tuple[Run, ...]

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

    def text(self) -> str:
        """Return the trade as JSON, a line for each run."""
        head = {key: value for key, value in asdict(self).items() if key != "runs"}
        runs = ",\n".join(json.dumps(one) for one in self.runs)
        return f'{json.dumps(head, indent=1)[:-2]},\n "columns": {json.dumps(Run._fields)},\n "runs": [\n{runs}\n]}}\n'


def recorded(file: Path | None = None) -> Trade:
    """Return the trade of a file, by default the shipped one. Raises UnreadableTrade."""
    path = file or SHIPPED
    try:
        record = json.loads(path.read_text("utf-8"))
        columns = record.pop("columns")
        runs = tuple(Run(**dict(zip(columns, one, strict=True))) for one in record.pop("runs"))
        found = Trade(runs=runs, **record)
        if not runs or any(key not in found.machine for key in ("processor", "cores", "python", "packages")):
            raise ValueError("it has no runs or no machine")
        [float(part or 0.0) for one in runs for part in (one.setting, one.seconds, one.digits)]
    except OSError as error:
        raise UnreadableTrade(f"{path.name} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        what = f"{error} is missing" if isinstance(error, KeyError) else str(error)
        raise UnreadableTrade(f"{path.name} is no output of `python -m numerics trade --json`: {what}") from None
    return found


def machine() -> dict[str, Any]:
    """Return on what is measured: processor, cores, load, versions; no paths and no dates."""
    info = Path("/proc/cpuinfo")
    models = re.findall(r"model name\s*: (.*)", info.read_text("utf-8")) if info.exists() else []
    return {
        "processor": (*models, platform.processor(), platform.machine())[0],
        "cores": available_cores(),
        "load": round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else None,
        "python": platform.python_version(),
        "packages": {name: version(name) for name in PACKAGES if find_spec(name.removeprefix("python-"))},
    }
