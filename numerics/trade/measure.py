"""Every setting of a contender on a scene, in a child process that is ended and replaced when it hangs or dies."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import Enum
from typing import Any

from numerics.trade import reference
from numerics.trade.child import Child, Deadline, Died, Hung
from numerics.trade.contender import Contender
from numerics.trade.judge import Verdict, finite, judge
from numerics.trade.outcome import Outcome
from numerics.trade.scenes import Benchmark, scene_as_record

SOURCE = "numerics.trade.contender:all_contenders"


class Status(Enum):
    """How a measurement ended."""

    MEASURED = "measured"
    STOPPED = "stopped"
    FAILED = "failed"
    NOT_TRIED = "not tried"


@dataclass(frozen=True)
class Limits:
    """How long the parent waits for one setting, s."""

    prepare: float
    """building and compiling, and the start of the child"""
    run: float
    """the first run; also all repetitions together, beyond their budget"""
    budget: float
    """how long warm runs are repeated; 0: the first run is the number"""


@dataclass(frozen=True)
class Ran:
    """What a child told of one setting, not yet judged."""

    status: Status
    note: str
    prepare_seconds: float | None = None
    seconds: float | None = None
    batches: int = 0
    """of warm runs behind the median; 0: the number is the first run's"""
    outcome: Outcome | None = None


@dataclass(frozen=True)
class Measurement:
    """One contender at one setting on one scene: time, errors, and what else happened."""

    contender: str
    ours: bool
    scene: str
    knob: str
    setting: float
    ran: Ran
    verdict: Verdict | None

    def as_record(self) -> dict[str, Any]:
        """Return it as the object that JSON carries; of the outcome only its size."""
        record: dict[str, Any] = {
            name: getattr(self, name) for name in ("contender", "ours", "scene", "knob", "setting")
        }
        ran = asdict(self.ran)
        outcome = ran.pop("outcome")
        record |= finite(ran) | {"status": self.ran.status.value}
        if outcome is not None:
            record |= {"events": len(outcome["kinds"]), "steps": outcome["steps"]}
        if self.verdict is not None:
            errors = self.verdict.as_record()
            record |= {name: errors[name] for name in ("right", "difference")}
            record |= {f"log10_{name}": errors[name] for name in ("state", "last_event", "energy", "error")}
        return record


class References:
    """The references of all scenes, each solved once for each number of digits, in a child with a limit."""

    def __init__(self, child: Child, limit: float) -> None:
        """Take the child to solve in."""
        self._child, self._limit = child, limit
        self.solved: dict[tuple[str, int], Ran] = {}

    def get(self, scene: Benchmark, digits: int) -> Ran:
        """Return the reference of a scene; its status says whether there is one."""
        key = (scene.name, digits)
        if key not in self.solved:
            limits = Limits(prepare=60.0, run=self._limit, budget=0.0)
            source = f"{reference.__name__}:contenders"
            self.solved[key] = run(self._child, source, reference.NAME, scene, float(digits), limits)
        return self.solved[key]

    def as_records(self) -> list[dict[str, Any]]:
        """Return what they took, as objects for JSON."""
        rows = []
        for (scene, digits), ran in self.solved.items():
            events = len(ran.outcome.kinds) if ran.outcome else None
            row = {"scene": scene, "digits": digits, "events": events, "seconds": ran.seconds}
            rows.append(row | {"status": ran.status.value, "note": ran.note})
        return rows


def run(child: Child, source: str, name: str, scene: Benchmark, setting: float, limits: Limits) -> Ran:
    """Run one setting and return what came of it; never raises for what a contender does."""
    request = {"source": source, "contender": name, "scene": scene_as_record(scene.scene), "setting": setting}
    child.ask(request | {"budget": limits.budget})
    told: dict[str, Any] = {}
    what, limit, deadline = "preparing", limits.prepare, Deadline(limits.prepare)
    last = "timed" if limits.budget > 0 else "ran"
    try:
        while last not in told:
            answer = child.answer(deadline.left())
            if answer["stage"] == "failed":
                return _ended(Status.FAILED, answer["reason"], told)
            told[answer["stage"]] = answer
            what, limit = ("running", limits.run) if "ran" not in told else ("repeating", limits.run + limits.budget)
            deadline = Deadline(limit)
    except Hung:
        return _ended(Status.STOPPED, f"stopped after {limit:g} s of {what}", told)
    except Died as error:
        return _ended(Status.FAILED, str(error), told)
    return _ended(Status.MEASURED, "", told)


def _ended(status: Status, note: str, told: dict[str, Any]) -> Ran:
    """Return what was told before the end; a first run that ended is a number, even if its repetition did not."""
    prepared, ran, timed = (told.get(stage) for stage in ("prepared", "ran", "timed"))
    if ran is not None:
        status = Status.MEASURED
    return Ran(
        status=status,
        note=note,
        prepare_seconds=prepared["seconds"] if prepared else None,
        seconds=timed["seconds"] if timed else (ran["seconds"] if ran else None),
        batches=timed["batches"] if timed else 0,
        outcome=Outcome(**ran["outcome"]) if ran else None,
    )


def not_tried(contender: Contender, scene: Benchmark, setting: float, note: str) -> Measurement:
    """Return that a setting was not tried, and why."""
    ran = Ran(Status.NOT_TRIED, note)
    return Measurement(contender.label, contender.ours, scene.name, contender.knob, setting, ran, None)


def measure(
    child: Child,
    references: References,
    contender: Contender,
    scene: Benchmark,
    settings: tuple[float, ...],
    limits: Limits,
    source: str = SOURCE,
) -> list[Measurement]:
    """Return a measurement for every setting, from coarse to fine; after one that was stopped no finer one is tried."""
    found: list[Measurement] = []
    stopped: str | None = None
    for setting in settings:
        if stopped is not None:
            found.append(not_tried(contender, scene, setting, f"a coarser setting was {stopped}"))
            continue
        ran = run(child, source, contender.label, scene, setting, limits)
        stopped = ran.note if ran.status is Status.STOPPED else None
        verdict = None
        if ran.outcome is not None:
            digits = reference.digits_for(contender.knob, setting)
            proved = references.get(scene, digits)
            if proved.outcome is not None:
                verdict = judge(ran.outcome, proved.outcome, digits, scene.scene)
            else:
                ran = Ran(Status.FAILED, f"no reference to judge it by: {proved.note}", seconds=ran.seconds)
        found.append(Measurement(contender.label, contender.ours, scene.name, contender.knob, setting, ran, verdict))
    return found
