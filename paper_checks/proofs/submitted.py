"""A proof file from outside, as `python -m numerics solve --proof` writes it: does the kernel accept its trajectory?

The file is compiled on top of the library. What it calls its theorem does not count: the kernel is asked whether
`trajectory` says of `the_scene`, `the_events` and `the_ending` what Trajectory.v means by these words, and on which axioms
it rests.
"""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path

from paper_checks.proofs import audit, kernel
from paper_checks.proofs.sources import LIBRARY, Source, needed, read

NAME = "Submitted"
"""What the file is called while it is judged, whatever its own name is."""
_STATEMENT = (
    f"forall x v1 x2 v2, Trajectory.motion {NAME}.the_scene x v1 x2 v2 -> "
    f"Trajectory.unfolds x v1 x2 v2 0 {NAME}.the_events {NAME}.the_ending"
)
_NUMBERS = {
    name.replace("_0", "(0)"): f"Trajectory.{name} {NAME}.the_scene"
    for name in ("m1", "m2", "a1", "a2", "x_0", "v1_0", "x2_0", "v2_0")
} | {"b": f"Trajectory.friction (Trajectory.first_spell {NAME}.the_scene)"}
_FIRST_FORCE = f"(Trajectory.push (Trajectory.first_spell {NAME}.the_scene))"
_TOLD = _NUMBERS | {
    "count": f"List.length {NAME}.the_events",
    "last": f"Trajectory.last {NAME}.the_ending",
    "ever": f"Trajectory.for_ever {NAME}.the_ending",
    "terms": f"(List.length (Waves.poly {_FIRST_FORCE}) + List.length (Waves.tones {_FIRST_FORCE}))%nat",
    "later": f"List.length (Trajectory.later_spells {NAME}.the_scene)",
}


_VALUE = re.compile(r"\s*= (.*?)(?:%\w+)?\s*: .*", re.DOTALL)
VERDICT = "Verdict"
_VERDICT = f"""(** What the kernel has accepted, in the words of Trajectory.v, and the axioms that it rests on. *)
From Coq Require Import Reals.
From {LIBRARY} Require Trajectory {NAME}.
Open Scope R_scope.
Check ({NAME}.trajectory : {_STATEMENT}).
Print {NAME}.the_scene.
Print Assumptions {NAME}.trajectory.
"""


@dataclass(frozen=True)
class Judged:
    """What the kernel says of a file: True (accepted), False (refused) or None (the kernel was not run), and why."""

    holds: bool | None
    reason: str


def judged(path: Path, store: Path | None = None, jobs: int = 2) -> Judged:
    """Compile a file with all that it rests on, and ask what its theorem says. Raises OSError, ValueError for no text."""
    file = Source(NAME, path.read_text("utf-8"))
    if reason := kernel.why_not():
        return Judged(None, reason)
    library = read()
    if missing := [one for one in file.requires if one not in library]:
        return Judged(False, f"it requires {missing[0]}, which is not a file of the library")
    compiled = kernel.compile_files([NAME], library | {NAME: file}, None, jobs, store)
    if compiled.broken:
        return Judged(False, next(iter(compiled.broken.values())))
    return _asked(compiled)


def write(path: Path, folder: Path) -> str:
    """Write a file with all that it rests on into an empty folder; return the commands that judge it by `coqc` alone.

    The last file prints the statement and its axioms. Raises OSError, ValueError for no text or a folder that is in use.
    """
    sources = read() | {NAME: Source(NAME, path.read_text("utf-8")), VERDICT: Source(VERDICT, _VERDICT)}
    folder.mkdir(parents=True, exist_ok=True)
    if any(folder.iterdir()):
        raise ValueError(f"{folder} is not empty: name a new folder")
    names = [f"{one}.v" for one in needed([VERDICT], sources)]
    for name in names:
        (folder / name).write_text(sources[name.removesuffix(".v")].text, "utf-8")
    (folder / "_CoqProject").write_text("\n".join([f"-Q . {LIBRARY}", *names, ""]), "utf-8")
    return f"cd {shlex.quote(str(folder))}\nfor file in {' '.join(names)}; do coqc -w none -Q . {LIBRARY} $file || break; done"


def _asked(compiled: kernel.Compiled) -> Judged:
    lines = [f"Definition taken : {_STATEMENT} := {NAME}.trajectory."]
    lines += [audit.titled("taken", "Print Assumptions taken.")]
    lines += ["From Coq Require Import QArith."]  # from here on rational numbers are printed as decimals
    lines += [audit.titled(name, f"Eval cbv in {term}.") for name, term in _TOLD.items()]
    try:
        answers = audit.run(compiled, lines)
    except RuntimeError as error:
        return Judged(False, f"its `trajectory` is no theorem of `the_scene`, `the_events` and `the_ending`: {error}")
    if beyond := sorted(set(audit.axioms(answers.pop("taken"))) - audit.CLASSICAL_REALS):
        return Judged(False, f"its theorem rests on {', '.join(beyond)}, beyond the classical reals")
    told = {name: _VALUE.sub(r"\1", answer) for name, answer in answers.items()}
    numbers = ", ".join(f"{one} = {told[one]}" for one in _NUMBERS)
    changes = f", and {told['later']} changes of force or friction" if told["later"] != "0" else ""
    force = "" if told["terms"] == "0" else ", under a force"
    ever = ", sticking for ever then" if told["ever"] == "true" else ""
    return Judged(
        True,
        f"{told['count']} events until t = {told['last']}{ever}, of every motion with {numbers} (SI units)"
        f"{force}{changes}",
    )
