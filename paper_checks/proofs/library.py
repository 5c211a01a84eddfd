"""The whole: compile the files, ask the kernel, compare with the pins, and say of each cited theorem what it stands on."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import asdict, dataclass, field
from functools import cache
from pathlib import Path

from paper_checks.proofs import graph, kernel, questions, signed, tied
from paper_checks.proofs.cited import CITED
from paper_checks.proofs.kernel import Compiled, Progress
from paper_checks.proofs.pins import Pin, Pins, pinned
from paper_checks.proofs.sources import FOLDER, Source, all_required, digest, keys, read
from paper_checks.proofs.tied import TIES
from paper_checks.store import Store


@dataclass(frozen=True)
class Proved:
    """A cited theorem and what the kernel says of it."""

    id: str
    name: str
    """File and name, as the kernel knows it."""
    sentence: str
    """What it proves, for a reader."""
    statement: str
    """What the kernel prints; without the kernel, what is pinned."""
    definitions: Mapping[str, str]
    """Each definition that the statement rests on, at any depth, as printed (or pinned)."""
    uses: tuple[str, ...]
    """Ids of the cited theorems that its proof rests on directly, or through lemmas that are not cited."""
    ties: tuple[str, ...]
    """The theorems that tie its definitions to the expressions of `theory/`."""
    axioms: tuple[str, ...]
    """All axioms that its proof may rest on; empty without the kernel."""
    holds: bool | None
    """True: the kernel accepts the pinned statement. None: the kernel was not run. False: `problem` says why."""
    problem: str = ""

    @property
    def file(self) -> str:
        """The proof file."""
        return f"{self.name.split('.')[0]}.v"


@dataclass(frozen=True)
class Built:
    """All cited theorems, and everything that is wrong with the proofs, one line each."""

    kernel: str
    """The kernel's version, or why it was not run."""
    ran: bool
    theorems: Mapping[str, Proved]
    problems: tuple[str, ...] = ()
    compiled_anew: int = 0

    def theorem(self, name: str) -> Proved:
        """A cited theorem by its id. Raises KeyError for an id that is not in the register."""
        return self.theorems[name]

    def ties(self, name: str) -> tuple[Proved, ...]:
        """The ties of a theorem's definitions to `theory/`: where one does not hold, it is a theorem about something else."""
        return tuple(self.theorems[one] for one in self.theorems[name].ties)


@dataclass(frozen=True)
class _Facts:
    """What compiling and asking has found; kept in the cache under the keys of all files."""

    printed: dict[str, str] = field(default_factory=dict)
    axioms: dict[str, tuple[str, ...]] = field(default_factory=dict)
    references: dict[str, tuple[str, ...]] = field(default_factory=dict)


def build(progress: Progress | None = None, jobs: int = 2, store: Path | None = None, folder: Path = FOLDER) -> Built:
    """Compile what is not in the cache and say what is proved.

    Without the kernel no theorem holds or fails: each is reported from its pin, with the reason in `kernel`. A proof that
    is broken, a statement that is not the pinned one, an axiom that is not allowed and anything admitted come out as
    problems, by name; nothing is raised for them.
    """
    pins = pinned()
    store = kernel.cache_folder() if store is None else store
    if reason := kernel.why_not(os.environ.get("PATH")) or kernel.cannot_keep(store):
        return _not_run(reason, pins)
    with kernel.locked(store, progress):
        sources, unwritten = _sources(folder, store)
        compiled, untied = tied.compiled(sources, progress, jobs, store)
        facts, silence = _answers(compiled, sources, store)
    broken = compiled.broken | untied | unwritten
    theorems = {one: _judged(one, broken, facts, pins) for one in names()}
    problems = [line for source in sources.values() for line in source.unproved()]
    problems += [*broken.values(), *silence]
    problems += [proved.problem for proved in theorems.values() if not proved.holds]
    version = kernel.version(os.environ.get("PATH")).split()[0]
    if problems and not version.startswith(kernel.TESTED_VERSION):
        problems.append(f"this is Coq {version}, the proofs are written for {kernel.TESTED_VERSION}: that may be all")
    return Built(f"Coq {version}", True, theorems, tuple(dict.fromkeys(problems)), compiled.anew)


@cache
def theorem(name: str) -> Proved:
    """A cited theorem by its id; builds on first use. Raises KeyError for an id that is not in the register.

    >>> theorem("contraction").name
    'Pair.contraction'
    """
    return _built().theorem(name)


_REPORT: ContextVar[Progress | None] = ContextVar("report", default=None)


@contextmanager
def reported(progress: Progress) -> Iterator[None]:
    """Report to `progress` while a check inside compiles the proofs, which it does only if it cites a theorem."""
    token = _REPORT.set(progress)
    try:
        yield
    finally:
        _REPORT.reset(token)


@cache
def _built() -> Built:
    return build(_REPORT.get())


@cache
def names() -> dict[str, str]:
    """The kernel's name of every cited theorem, the ties among them, by id."""
    ties = {name.replace("_", "-"): f"{TIES}.{name}" for name in pinned().ties}
    return {one: name for one, (name, _sentence) in CITED.items()} | ties


def _sources(folder: Path, store: Path) -> tuple[dict[str, Source], dict[str, str]]:
    found, (text, problem) = read(folder), tied.text(store)
    found[TIES] = Source(TIES, text)
    return found, {TIES: problem} if problem else {}


def _answers(compiled: Compiled, sources: Mapping[str, Source], store: Path) -> tuple[_Facts, tuple[str, ...]]:
    """The facts; or none, and why: a file of the cache that was damaged after it was compiled."""
    try:
        return _facts(compiled, sources, store), ()
    except RuntimeError as error:
        return _Facts(), (f"{error}; remove {store} and try again",)


def _facts(compiled: Compiled, sources: Mapping[str, Source], store: Path) -> _Facts:
    """Ask the kernel about all that compiled, or take its answers from the cache."""
    named = keys(sources, kernel.identity(os.environ.get("PATH")))
    asked = {one: name for one, name in names().items() if name.split(".")[0] in compiled.folders}
    wording = [Path(one).read_text("utf-8") for one in (questions.__file__, graph.__file__, __file__)]
    title = digest([*wording, *sorted(asked.values()), *(named[file] for file in sorted(compiled.folders))])
    kept = Store("answers", title, store)
    if body := kept.get("answers.json"):
        return _Facts(**json.loads(body))
    references, definitions = graph.references(compiled.folders)
    present = [name for name in asked.values() if name in references]
    by_integers = [name for name in present if _by_intervals(name.split(".")[0], sources)]
    plain = [name for name in present if name not in by_integers]
    answers = questions.ask(compiled, present, sorted(definitions), [plain, by_integers])
    facts = _Facts(
        dict(answers.printed),
        dict(answers.axioms),
        {name: graph.nearest(name, present, references) for name in present},
    )
    kept.put("answers.json", json.dumps(asdict(facts)).encode())
    return facts


def _by_intervals(file: str, sources: Mapping[str, Source]) -> bool:
    """Whether a file rests on the tactic for interval arithmetic, which computes with machine integers."""
    return any(
        "From Interval Require Import Tactic" in sources[one].text for one in {file, *all_required(file, sources)}
    )


def _judged(one: str, broken: Mapping[str, str], facts: _Facts, pins: Pins) -> Proved:
    name = names()[one]
    if name not in facts.printed:
        why = broken.get(name) or broken.get(name.split(".")[0]) or f"there is no {name}"
        return _proved(one, pins.theorems.get(one), {}, (), False, why if why.startswith(name) else f"{name}: {why}")
    statement = facts.printed[name]
    definitions = definitions_of(statement, facts.printed)
    ids = {kernel_name: other for other, kernel_name in names().items()}
    pin = Pin(statement, tuple(definitions), tuple(sorted(ids[other] for other in facts.references[name])))
    axioms = tuple(facts.axioms[name])
    problem = _problem(name, pin, definitions, axioms, pins, one)
    return _proved(one, pin, definitions, axioms, not problem, problem)


def _problem(
    name: str, found: Pin, definitions: Mapping[str, str], axioms: tuple[str, ...], pins: Pins, one: str
) -> str:
    if wrong := [axiom for axiom in axioms if not questions.allowed(axiom)]:
        return f"{name} rests on {', '.join(wrong)}, which nobody has proved"
    if one not in pins.theorems:
        return f"{name} is not pinned; python -m paper_checks.proofs pin writes what it says into pins.json"
    if found.statement != pins.theorems[one].statement:
        return f"{name} does not say what is pinned"
    changed = [other for other, text in definitions.items() if pins.definitions.get(other) != text]
    if changed:
        return f"{name} rests on {changed[0]}, which is not defined as pinned"
    return _unsigned(one, found, definitions)


def _unsigned(one: str, pin: Pin, definitions: Mapping[str, str]) -> str:
    """Say that the sentence of a cited theorem was not read beside what is pinned; of a tie nobody reads one."""
    if one not in CITED or signed.is_signed(one, signed.of_theorem(CITED[one][1], pin.statement, definitions)):
        return ""
    return f"{names()[one]} and its sentence were not signed together: python -m paper_checks sign {one}"


def definitions_of(text: str, printed: Mapping[str, str]) -> dict[str, str]:
    """The definitions of this library that a printed text names, and those that they name, in alphabetical order."""
    found: dict[str, str] = {}
    waiting = [text]
    while waiting:
        for name in re.findall(r"\b[A-Z]\w*\.\w+'*", waiting.pop()):
            if name in printed and name not in found:
                found[name] = printed[name]
                waiting.append(printed[name])
    return dict(sorted(found.items()))


def _not_run(reason: str, pins: Pins) -> Built:
    def proved(one: str) -> Proved:
        pin = pins.theorems.get(one)
        definitions = {name: pins.definitions[name] for name in pin.definitions} if pin else {}
        problem = _unsigned(one, pin, definitions) if pin else ""
        return _proved(one, pin, definitions, (), False if problem else None, problem or reason)

    theorems = {one: proved(one) for one in names()}
    return Built(reason, False, theorems, tuple(one.problem for one in theorems.values() if one.holds is False))


def _proved(
    one: str, pin: Pin | None, definitions: Mapping[str, str], axioms: tuple[str, ...], holds: bool | None, problem: str
) -> Proved:
    name = names()[one]
    sentence = CITED[one][1] if one in CITED else pinned().ties[name.split(".")[1]]
    statement, uses = (pin.statement, pin.uses) if pin else ("", ())
    tied = [tie for tie, defined in pinned().tied.items() if set(defined) & set(definitions)]
    return Proved(one, name, sentence, statement, definitions, uses, tuple(sorted(tied)), axioms, holds, problem)
