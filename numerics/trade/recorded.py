"""What a trade has found, as the tables, the report and the notebook read it: a small file of runs.

One is shipped, with the machine that it was measured on, since what the report says must not depend on the hour. With
the extras `comparisons` and `compiled` it is made, in some minutes, by

    python -m numerics trade --json > trade.json && mv trade.json numerics/trade/recorded.json

    {"command": how it was made, "machine": {...}, "left_out": {name: what it needs}, "scenes": {name: why},
     "sweeps": [[scene, ratio, scenes at once, digits of ours, of heyoka, how many heyoka has wrong], ...],
     "runs": [[scene, who, setting, seconds, digits, note], ...]}

Seconds are the processor time of a warm `solve(scene)`, read as a user reads it, times a ratio that was taken in one
process, in turns, so that a busy machine changes little; `machine` says whether it was busy. `digits` is -log10 of the
worst error; `note` is empty where the events are right, and begins with NONE where there is no answer.
"""

from __future__ import annotations

import json
import os
import platform
import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from numerics.errors import NumericsError
from numerics.tasks import available_cores
from numerics.trade.scenes import KINDS, kind

SHIPPED = Path(__file__).with_name("recorded.json")
COMMAND = "python -m numerics trade --json"
PACKAGES = ("numpy", "python-flint", "mpmath", "numba", "scipy", "heyoka")
OURS, PEERS = ("solve", "ball"), ("heyoka", "heyoka long double")
"""Ours, and whom it is measured against: the fastest integrator of its kind that we know."""
ASKED = {0: "`solve(scene)`", 12: "`digits=12`", 20: "`digits=20`"}
"""Our settings, as a user writes them."""
NONE = "no answer: "


class UnreadableTrade(NumericsError):
    """A file that holds no trade; the message says what is wrong with it and how to make one."""


class TimedRun(NamedTuple):
    """One contender at one setting on one scene."""

    scene: str
    who: str
    setting: float
    seconds: Any
    """A float; None where none was taken."""
    digits: Any
    """A float; None where the run gave no number."""
    note: str
    """Where the itinerary departs from the true one, or why there is no answer."""

    @property
    def ours(self) -> bool:
        """Whether it is a way to call `solve`."""
        return self.who in OURS

    @property
    def right(self) -> bool | None:
        """Whether the events are; None where there is no answer."""
        return None if self.note.startswith(NONE) else not self.note


class Lead(NamedTuple):
    """The peer's time by ours, below 1 where the peer is faster, and both."""

    ratio: float
    peer: TimedRun
    ours: TimedRun


class Sweep(NamedTuple):
    """Many scenes at once on one core each: heyoka's time by that of `solve_many`; heyoka compiles once for all."""

    scene: str
    ratio: float
    size: int
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
    scenes: dict[str, str]
    runs: tuple[TimedRun, ...]
    sweeps: tuple[Sweep, ...] = ()

    def of(self, scene: str, who: str | None = None) -> list[TimedRun]:
        """Return the runs on one scene, of all or of one contender."""
        return [one for one in self.runs if one.scene == scene and who in (None, one.who)]

    def beside(self, scene: str, asked: int) -> Lead | None:
        """Return our lead with so many digits asked for (0: none) over heyoka; None where either has no right run.

        Of each of its arithmetics that is its cheapest run with these digits, or with ours, or else its most accurate
        one; and of those that have the digits asked for the fastest.
        """
        some = [one for one in self.of(scene) if one.right and one.seconds and one.digits]
        ours = next((one for one in some if (one.who, one.setting) == ("solve", asked)), None)
        if ours is None:
            return None
        kinds = [[one for one in some if one.who == peer] for peer in PEERS]
        best = [nearest(runs, asked or ours.digits) for runs in kinds if runs]
        return Lead(one.seconds / ours.seconds, one, ours) if best and (one := nearest(best, asked)) else None

    def ratios(self) -> dict[str, dict[str, float]]:
        """Return how many times as fast as heyoka each setting of ours is, by kinds of scenes, and many at once."""
        leads = {
            f"{what}, {words}": {
                name: lead.ratio for name in self.scenes if kind(name) == which and (lead := self.beside(name, asked))
            }
            for which, words in KINDS.items()
            for asked, what in ASKED.items()
        } | {"`solve_many`, one core each": {one.scene: one.ratio for one in self.sweeps}}
        return {what: ratios for what, ratios in leads.items() if ratios}

    def text(self) -> str:
        """Return the trade as JSON, a line for each run."""
        head = {"command": COMMAND} | {name: part for name, part in asdict(self).items() if name != "runs"}
        rows = ",\n".join(map(json.dumps, self.runs))
        return f'{json.dumps(head, indent=1)[:-2]},\n "runs": [\n{rows}]}}\n'


def nearest(runs: Sequence[TimedRun], digits: float) -> TimedRun:
    """Return the cheapest run with so many digits, or else the most accurate one."""
    enough = [one for one in runs if one.digits >= digits]
    return min(enough, key=lambda one: one.seconds) if enough else max(runs, key=lambda one: one.digits)


def short(value: Any) -> Any:
    """Return three digits of a number, None for none."""
    return value and float(f"{value:.3g}" if value < 100 else f"{value:.0f}")


def recorded(file: Path | None = None) -> Trade:
    """Return the trade of a file, by default the shipped one. Raises UnreadableTrade."""
    path = file or SHIPPED
    try:
        record = json.loads(path.read_text("utf-8"))
        record.pop("command", None)
        runs = tuple(TimedRun(*one) for one in record.pop("runs"))
        sweeps = tuple(Sweep(*one) for one in record.pop("sweeps"))
        if not runs or not {"processor", "cores", "python", "packages"} <= set(record["machine"]):
            raise ValueError("it has no runs or no machine")
        [float(part or 0.0) for one in runs for part in (one.seconds, one.digits)]
        return Trade(**record, runs=runs, sweeps=sweeps)
    except OSError as error:
        raise UnreadableTrade(f"{path} cannot be read: {error.strerror}") from None
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
