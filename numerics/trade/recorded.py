"""A trade that was measured before, as the report and the notebook read it: what they say must not depend on the hour.

Two are shipped, on free scenes and on those under a force, each with the machine that it was measured on. With the
extra `comparisons` they are made by

    python -m numerics trade --size default --json > trade.json && mv trade.json numerics/trade/recorded.json
    python -m numerics trade --only forced --json > trade.json && mv trade.json numerics/trade/recorded_forced.json

and any other output of `python -m numerics trade --json` can take the place of either, or of both.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, TypeVar

from numerics.errors import NumericsError
from numerics.trade.front import Lead, Point, leads
from numerics.trade.growth import Growth
from numerics.trade.interface import Wait
from numerics.trade.scenes import FORCED

Kind = TypeVar("Kind", Growth, Wait)
SHIPPED = Path(__file__).with_name("recorded.json")
SHIPPED_FORCED = Path(__file__).with_name("recorded_forced.json")
HOW_TO = "python -m numerics trade --json"


class UnreadableTrade(NumericsError):
    """A file that holds no trade; the message says what is wrong with it and how to make one."""


@dataclass(frozen=True)
class RecordedScene:
    """A scene by its name, and why it was measured."""

    name: str
    why: str


@dataclass(frozen=True)
class Participant:
    """Who took part, and whether it is ours."""

    label: str
    ours: bool


@dataclass(frozen=True)
class RecordedRun:
    """One contender at one setting on one scene."""

    contender: str
    ours: bool
    scene: str
    knob: str
    setting: float
    status: str
    note: str
    prepare_seconds: float | None
    """building, compiling or loading, s"""
    seconds: float | None
    """the warm median, s"""
    right: bool | None
    """whether the event sequence is right; None without an outcome"""
    difference: str | None
    error: float | None
    """log10 of the worst of final state, last event and dissipated energy; inf where it is no number"""


@dataclass(frozen=True)
class RecordedTrade:
    """Everything that one run of the trade wrote down."""

    size: str
    machine: Mapping[str, Any]
    left_out: Mapping[str, str]
    """Contenders that were not installed, with what was missing."""
    scenes: tuple[RecordedScene, ...]
    runs: tuple[RecordedRun, ...]
    growth: tuple[Growth, ...]
    interface: tuple[Wait, ...] = ()
    """What a user waits for at the public interface; older records do not say."""

    @property
    def contenders(self) -> list[Participant]:
        """Return who took part, in the order of the record."""
        return list(dict.fromkeys(Participant(one.contender, one.ours) for one in self.runs))

    def part(self, *, forced: bool) -> RecordedTrade:
        """Return the trade on the scenes with a force alone, or on the others; of the latter also growth and waits."""
        scenes = tuple(one for one in self.scenes if one.name.startswith(FORCED) == forced)
        names = {one.name for one in scenes}
        runs = tuple(one for one in self.runs if one.scene in names)
        kept = replace(self, scenes=scenes, runs=runs)
        return replace(kept, growth=(), interface=()) if forced else kept

    def points(self, scene: RecordedScene) -> list[Point]:
        """Return the measured points of one scene."""
        return [
            Point(one.contender, one.ours, one.setting, one.seconds, one.error, bool(one.right))
            for one in self.runs
            if one.scene == scene.name and one.seconds is not None and one.error is not None
        ]

    def leads(self, scene: RecordedScene) -> list[Lead]:
        """Return our lead over every point of a peer whose event sequence is right."""
        return [one for one in leads(self.points(scene)) if one.peer.right]


def divided(trade: RecordedTrade) -> tuple[RecordedTrade, RecordedTrade]:
    """Return a trade on free scenes and on those under a force; the shipped one's where it has none."""
    free, forced = (trade.part(forced=one) for one in (False, True))
    return (
        free if free.scenes else recorded().part(forced=False),
        forced if forced.scenes else recorded(SHIPPED_FORCED).part(forced=True),
    )


def recorded(path: Path | None = None) -> RecordedTrade:
    """Return the trade of a file, by default the shipped one. Raises UnreadableTrade."""
    file = path or SHIPPED
    try:
        record = json.loads(file.read_text("utf-8"))
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is no text"
        raise UnreadableTrade(f"{file.name} cannot be read: {reason}") from None
    except json.JSONDecodeError as error:
        raise UnreadableTrade(f"{file.name} is no JSON (line {error.lineno}); make one with `{HOW_TO}`") from None
    try:
        return _trade(record)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        what = f"{error} is missing" if isinstance(error, KeyError) else str(error)
        raise UnreadableTrade(f"{file.name} is no output of `{HOW_TO}`: {what}") from None


def _trade(record: dict[str, Any]) -> RecordedTrade:
    machine = record["machine"]
    for part in ("processor", "cores", "python", "packages"):
        machine[part]
    found = RecordedTrade(
        size=record["size"],
        machine=machine,
        left_out={one["contender"]: one["missing"] for one in record["left_out"]},
        scenes=tuple(RecordedScene(one["scene"], one["why"]) for one in record["scenes"]),
        runs=tuple(_run(one) for one in record["runs"]),
        growth=tuple(_known(Growth, record["growth"])),
        interface=tuple(_known(Wait, record.get("interface", []))),
    )
    if not found.scenes or not found.runs:
        raise ValueError("it has no scenes or no runs")
    return found


def _run(one: dict[str, Any]) -> RecordedRun:
    seconds, error = one["seconds"], one.get("log10_error")
    return RecordedRun(
        contender=str(one["contender"]),
        ours=bool(one["ours"]),
        scene=str(one["scene"]),
        knob=str(one["knob"]),
        setting=float(one["setting"]),
        status=str(one["status"]),
        note=str(one["note"]),
        prepare_seconds=None if one["prepare_seconds"] is None else float(one["prepare_seconds"]),
        seconds=None if seconds is None else float(seconds),
        right=one.get("right"),
        difference=one.get("difference"),
        error=None if error is None else float(error),
    )


def _known(kind: type[Kind], records: Iterable[dict[str, Any]]) -> Iterable[Kind]:
    """Yield records of a kind by the fields that it has."""
    known = {field.name for field in fields(kind)}
    for one in records:
        yield kind(**{name: value for name, value in one.items() if name in known})
