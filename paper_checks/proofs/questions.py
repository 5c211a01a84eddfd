"""What is asked of the kernel once the files are compiled: statements, definitions, and the axioms behind the theorems."""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from paper_checks.proofs.kernel import Compiled
from paper_checks.proofs.sources import LIBRARY

# the classical real numbers of the standard library
CLASSICAL_REALS = frozenset(
    {
        "ClassicalDedekindReals.sig_not_dec",
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)
# the kernel's machine integers, beneath the interval arithmetic of a few files
MACHINE_INTEGERS = ("PrimInt63.", "Uint63.")

_MARK = re.compile(r"^@@ (.*)\n", re.MULTILINE)
_AXIOM = re.compile(r"^(?:([A-Za-z_][\w.']*)\s*(?::|$)|(\S.*))", re.MULTILINE)
_VALUE = re.compile(r"\s*= (.*?)(?:%\w+)?\s*: .*", re.DOTALL)
_HEADER = f"""From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From {LIBRARY} Require %s.
Open Scope R_scope.
Set Printing Width 110.
Set Printing Depth 1000.
"""


@dataclass(frozen=True)
class Answers:
    """What the kernel printed: each name's statement or definition, and the axioms of each group of theorems."""

    printed: Mapping[str, str]
    axioms: Mapping[str, tuple[str, ...]]
    """By theorem: the axioms of the group that it was asked about with."""


def allowed(axiom: str) -> bool:
    """Whether a proof may rest on this axiom."""
    return axiom in CLASSICAL_REALS or axiom.startswith(MACHINE_INTEGERS)


def ask(
    compiled: Compiled, theorems: Sequence[str], definitions: Iterable[str], groups: Iterable[Sequence[str]]
) -> Answers:
    """Print every theorem and definition, and the axioms of each group: all at once, as going through proofs takes time.

    Where a group rests on an axiom that is not allowed, each of its theorems is asked alone, so that the right ones are
    named. Raises RuntimeError, in one line, if the kernel does not answer.
    """
    filled = [tuple(group) for group in groups if group]
    lines = [_said(name, f"Check @{name}.") for name in theorems]  # @: with what is implicit
    lines += [_said(name, f"Print {name}.") for name in definitions]
    with ThreadPoolExecutor(2) as pool:  # each waits for a process of its own
        together = [pool.submit(_run, compiled, [_assumptions("all", group)]) for group in filled]
        printed = pool.submit(_run, compiled, lines).result()
    axioms: dict[str, tuple[str, ...]] = {}
    for group, answer in zip(filled, together, strict=True):
        found = _axioms(answer.result()["all"])
        if all(allowed(one) for one in found):
            axioms |= dict.fromkeys(group, found)
        else:
            alone = _run(compiled, [_assumptions(name, [name]) for name in group])
            axioms |= {name: _axioms(text) for name, text in alone.items()}
    return Answers({name: _trimmed(name, text) for name, text in printed.items()}, axioms)


def taken(
    compiled: Compiled, theorem: str, statement: str, terms: Mapping[str, str]
) -> tuple[tuple[str, ...], dict[str, str]]:
    """The axioms behind a theorem, taken to say what `statement` does, and the value of each term, as the kernel prints it.

    Raises RuntimeError, in one line, if the theorem does not say that.
    """
    lines = [f"Definition taken : {statement} := {theorem}.", _said("taken", "Print Assumptions taken.")]
    lines += ["From Coq Require Import QArith."]  # from here on rational numbers are printed as decimals
    answers = _run(compiled, lines + [_said(name, f"Eval cbv in {term}.") for name, term in terms.items()])
    return _axioms(answers["taken"]), {name: _VALUE.sub(r"\1", answers[name]) for name in terms}


def _said(mark: str, command: str) -> str:
    return f'Goal True. idtac "@@ {mark}". Abort.\n{command}'


def _assumptions(mark: str, names: Sequence[str]) -> str:
    together = f"@{names[-1]}"
    for name in reversed(names[:-1]):
        together = f"(@{name}, {together})"
    label = re.sub(r"\W", "_", mark)
    return f"Definition together_{label} := {together}.\n" + _said(mark, f"Print Assumptions together_{label}.")


def _run(compiled: Compiled, lines: Sequence[str]) -> dict[str, str]:
    with tempfile.TemporaryDirectory() as folder:
        text = _HEADER % " ".join(compiled.folders) + "\n".join(lines)
        Path(folder, "Questions.v").write_text(text, "utf-8")
        command = ["coqc", "-q", "-w", "none", *compiled.arguments(), "Questions.v"]
        done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        raise RuntimeError(f"the kernel does not answer: {' '.join(done.stderr.split())[-300:]}")
    pieces = _MARK.split(done.stdout)[1:]
    return dict(zip(pieces[::2], pieces[1::2], strict=True))


def _axioms(text: str) -> tuple[str, ...]:
    if text.startswith("Closed under the global context"):
        return ()
    if not text.startswith("Axioms:"):
        raise RuntimeError(f"the kernel's list of axioms cannot be read: {text[:200]!r}")
    # what is no name and type counts as it stands, such as "f is assumed to be guarded."
    return tuple(sorted(name or said for name, said in _AXIOM.findall(text.removeprefix("Axioms:\n"))))


def _trimmed(name: str, text: str) -> str:
    """Without the name in front, the notes on arguments behind, and the indentation of the whole."""
    body = (
        text.split("\n\nArguments ", maxsplit=1)[0]
        .rstrip()
        .removeprefix("@")
        .removeprefix(f"{name} = ")
        .removeprefix(name)
        .lstrip("\n")
    )
    if "..." in body:  # a pin of it would not see what is left out
        raise RuntimeError(f"the kernel prints {name} in part only: its printing depth is too small")
    lines = body.splitlines()
    if lines and lines[0].lstrip().startswith(": "):  # a statement: "     : forall ...", further lines beneath "forall"
        indent = len(lines[0]) - len(lines[0].lstrip()) + 2
        lines = [lines[0].lstrip()[2:], *(line[indent:] for line in lines[1:])]
    return "\n".join(lines)
