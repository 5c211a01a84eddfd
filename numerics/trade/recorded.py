"""What a trade has found, as the command, the report and the notebook read it: a small file of rows.

One is shipped, with the machine that it was measured on, since what the report says must not depend on the hour. With
the extras `comparisons` and `compiled` it is made, in a minute, by

    python -m numerics trade --digits 1000 --json > trade.json && mv trade.json numerics/trade/recorded.json

Seconds are the processor time of a warm call, read as a user reads it; the ratio is to `float64` on the same scene, in
the same run, in turns, so that a busy machine changes it little. Errors are judge.py's.
"""

from __future__ import annotations

import json
import os
import platform
import re
from dataclasses import dataclass, fields
from importlib.metadata import version
from importlib.util import find_spec
from itertools import starmap
from pathlib import Path
from typing import Any, NamedTuple

from numerics.errors import NumericsError
from numerics.tasks import available_cores
from numerics.trade.contenders import BALLS, FLOAT64, PEERS

SHIPPED = Path(__file__).with_name("recorded.json")
COMMAND = "python -m numerics trade --digits 1000 --json"
PACKAGES = ("numpy", "python-flint", "mpmath", "numba", "scipy", "heyoka")


class UnreadableTrade(NumericsError):
    """A file that holds no trade; the message says what is wrong with it and how to make one."""


class Row(NamedTuple):
    """One contender with one setting on one scene."""

    scene: str
    method: str
    setting: float
    seconds: float | None
    """None where there is no answer."""
    ratio: Any
    """To the time of float64; None where that has no answer."""
    events: int
    """How many are right, from the start on."""
    digits: Any
    """-log10 of the largest error; None where there is no answer, or an event is wrong."""
    note: str
    """The first event that is wrong, or why there is no answer; empty where all are right."""

    @property
    def ours(self) -> bool:
        """Whether it is a way to call `solve`."""
        return self.method in {FLOAT64, BALLS}

    @property
    def right(self) -> bool:
        """Whether there is an answer, and every event is right."""
        return self.digits is not None


class Lead(NamedTuple):
    """The peer's time by ours, below 1 where the peer is faster, and both."""

    ratio: float
    peer: Row
    ours: Row


@dataclass(frozen=True)
class Trade:
    """Everything that one run of the trade wrote down."""

    machine: dict[str, Any]
    left_out: dict[str, str]
    """Contenders that did not take part, and why."""
    scenes: dict[str, str]
    """What each one is."""
    rows: tuple[Row, ...]

    def of(self, scene: str, method: str | None = None) -> list[Row]:
        """Return the rows of one scene, of all or of one contender."""
        return [one for one in self.rows if one.scene == scene and method in (None, one.method)]

    def lead(self, scene: str) -> Lead | None:
        """Return float64's lead over heyoka; None where either has no right row.

        Of each of heyoka's arithmetics its fastest row counts that is as accurate, or else its most accurate one; of
        double and long double the faster.
        """
        ours = next((one for one in self.of(scene, FLOAT64) if one.right), None)
        if ours is None:
            return None
        best = list[Row]()
        for peer in PEERS:
            some = [one for one in self.of(scene, peer) if one.right]
            best += sorted(some, key=lambda one: (-min(one.digits, ours.digits), one.ratio))[:1]
        return Lead((one := min(best, key=lambda one: one.ratio)).ratio, one, ours) if best else None

    def text(self) -> str:
        """Return the trade as JSON, a line for each row."""
        head = {"command": COMMAND, "columns": Row._fields}
        head |= {one.name: getattr(self, one.name) for one in fields(self) if one.name != "rows"}
        rows = ",\n".join(map(json.dumps, self.rows))
        return f'{json.dumps(head, indent=1)[:-2]},\n "rows": [\n{rows}]}}\n'


def recorded(file: Path | None = None) -> Trade:
    """Return the trade of a file, by default the shipped one. Raises UnreadableTrade."""
    path = file or SHIPPED
    try:
        record = json.loads(path.read_text("utf-8"))
        if record["columns"] != [*Row._fields]:
            raise ValueError("other columns")
        return Trade(record["machine"], record["left_out"], record["scenes"], tuple(starmap(Row, record["rows"])))
    except OSError as error:
        raise UnreadableTrade(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, TypeError, LookupError) as error:
        raise UnreadableTrade(f"{path.name} is no output of `{COMMAND}`: {error!r}") from None


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
