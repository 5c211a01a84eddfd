"""What the kernel says of cited theorems: their files are compiled, and its answers compared with those on record."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path

from paper_checks.proofs import audit, kernel
from paper_checks.proofs.audit import recorded, register
from paper_checks.proofs.kernel import Compiled, Progress
from paper_checks.proofs.sources import AUDIT, FOLDER, read


@dataclass(frozen=True)
class Proved:
    """A cited theorem and what the kernel says of it."""

    id: str
    name: str
    """File and name, as the kernel knows it."""
    sentence: str
    """What it proves, for a reader."""
    statement: str
    """What the kernel prints, as it is on record; empty where it is not."""
    uses: tuple[str, ...]
    """Ids of the cited theorems that its proof rests on directly, or through lemmas that are not cited."""
    ties: tuple[str, ...]
    """The theorems that tie its definitions to the expressions of `theory/`."""
    axioms: tuple[str, ...]
    """All axioms that its proof may rest on; empty without the kernel."""
    holds: bool | None
    """True: the kernel accepts the statement on record. None: the kernel was not run. False: `problem` says why."""
    problem: str = ""


_known: dict[str, Proved] = {}
_REPORT: ContextVar[Progress | None] = ContextVar("report", default=None)


def theorem(name: str) -> Proved:
    """A cited theorem by its id; asks the kernel on first use. Raises KeyError for an id that is not in the register.

    >>> theorem("contraction").name
    'Pair.contraction'
    """
    if name not in _known:
        prepare([name])
    return _known[name]


def prepare(ids: Iterable[str], jobs: int = 2) -> Mapping[str, Proved]:
    """Ask the kernel once about theorems, those that they use and their ties; return all that is known."""
    if missing := [one for one in ids if one not in _known]:
        know(prove(missing, _REPORT.get(), jobs))
    return _known


def know(proved: Mapping[str, Proved]) -> None:
    """Take over what another process has found."""
    _known.update(proved)


@contextmanager
def reported(progress: Progress) -> Iterator[None]:
    """Report to `progress` while a check inside compiles proofs, which it does only if it cites a theorem."""
    token = _REPORT.set(progress)
    try:
        yield
    finally:
        _REPORT.reset(token)


def kernel_name() -> str:
    """The kernel and its version, or why it is not run."""
    return kernel.why_not() or f"Coq {kernel.version(os.environ.get('PATH')).split()[0]}"


def prove(
    ids: Iterable[str],
    progress: Progress | None = None,
    jobs: int = 2,
    store: Path | None = None,
    folder: Path = FOLDER,
) -> dict[str, Proved]:
    """Compile what theorems, those that they use and their ties need, and say of each what the kernel says.

    Without the kernel none holds or fails: each is reported from the record, with the reason as its problem. A proof that
    is broken, an answer that is not the one on record and an axiom that is not allowed come out as problems, by name.
    """
    wanted = _with_what_they_need(ids)
    if reason := kernel.why_not():
        return {one: _proved(one, None, reason) for one in wanted}
    sources = read(folder)
    files = dict.fromkeys(_file(one) for one in wanted)
    compiled = kernel.compile_files([one for one in files if one in sources], sources, progress, jobs, store)
    problems = {one: why for one in wanted if (why := _not_compiled(one, compiled))}
    problems |= _differing([one for one in wanted if one not in problems], compiled)
    return {one: _proved(one, one not in problems, problems.get(one, "")) for one in wanted}


def _with_what_they_need(ids: Iterable[str]) -> tuple[str, ...]:
    wanted: dict[str, None] = {}
    waiting = list(ids)
    while waiting:
        one = waiting.pop()
        if one not in register():
            raise KeyError(one)
        if one not in wanted:
            wanted[one] = None
            known = recorded().theorems.get(one)
            waiting += (*(known.uses if known else ()), *recorded().ties_of(one))
    return tuple(sorted(wanted))


def _file(one: str) -> str:
    return register()[one][0].split(".")[0]


def _not_compiled(one: str, compiled: Compiled) -> str:
    name, file = register()[one][0], _file(one)
    if file in compiled.folders:
        return ""
    why = compiled.broken.get(file, f"there is no {file}.v")
    return why if why.startswith(name) else f"{name}: {why}"


def _differing(ids: Sequence[str], compiled: Compiled) -> dict[str, str]:
    """Say what is wrong with what the kernel prints of theorems; nothing of those about which it prints what is on record.

    It is asked about all at once; where its answer cannot be right for one of them, about both halves.
    """
    groups: dict[tuple[str, ...], list[str]] = {}
    for one in ids:
        record = recorded().theorems.get(one)
        groups.setdefault(record.axioms if record else (one,), []).append(register()[one][0])
    definitions = sorted({name for one in ids for name in recorded().definitions_of.get(one, ())})
    present = [name for name in definitions if name.split(".")[0] in compiled.folders]
    half = len(ids) // 2
    try:
        printed, behind = audit.asked(compiled, groups.values(), present)
    except RuntimeError as error:
        if not half:
            return {one: f"{register()[one][0]}: {error}" for one in ids}
    else:
        if not half or all(set(behind[name]) <= set(axioms) for axioms, names in groups.items() for name in names):
            return {one: why for one in ids if (why := difference(one, printed, behind[register()[one][0]]))}
    return _differing(ids[:half], compiled) | _differing(ids[half:], compiled)


def difference(one: str, printed: Mapping[str, str], axioms: Iterable[str]) -> str:
    """What is wrong with what the kernel prints of a theorem and its definitions, and with its axioms; empty if nothing is."""
    name, record = register()[one][0], recorded().theorems.get(one)
    if wrong := [axiom for axiom in axioms if not audit.allowed(axiom)]:
        return f"{name} rests on {', '.join(wrong)}, which nobody has proved"
    if record is None:
        return f"{name} is not in {AUDIT}.out: python -m paper_checks.proofs audit asks about it"
    if more := set(axioms) - set(record.axioms):
        return f"{name} rests on {', '.join(sorted(more))}, more than in {AUDIT}.out"
    if printed[name] != record.statement:
        return f"{name} does not say what is in {AUDIT}.out"
    changed = [other for other, text in recorded().definitions_of[one].items() if printed.get(other) != text]
    return f"{name} rests on {changed[0]}, which is not defined as in {AUDIT}.out" if changed else ""


def _proved(one: str, holds: bool | None, problem: str) -> Proved:
    (name, sentence), record = register()[one], recorded().theorems.get(one)
    if record is None:
        return Proved(one, name, sentence, "", (), (), (), holds, problem)
    axioms = record.axioms if holds else ()
    return Proved(one, name, sentence, record.statement, record.uses, recorded().ties_of(one), axioms, holds, problem)
