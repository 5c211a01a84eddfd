"""`Audit.v` asks the kernel what every cited theorem says and rests on; `Audit.out` is its answer as people have read it.

The kernel is asked again, in the same words, by whoever relies on a theorem: an answer that differs proves nothing.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

from paper_checks.proofs.kernel import Compiled
from paper_checks.proofs.sources import AUDIT, FOLDER, LIBRARY

CLASSICAL_REALS = frozenset(
    {
        "ClassicalDedekindReals.sig_not_dec",
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)
"""The axioms of the classical real numbers in the standard library."""
MACHINE_INTEGERS = ("PrimInt63.", "Uint63.")
"""The kernel's machine integers, beneath the interval arithmetic of a few files."""

NOTE = (
    f"(** Every theorem that a claim cites: its id, what it says in words, and which others it uses; then the kernel's own answer.\n\
    Written by `python -m paper_checks.proofs audit`, with its output as it was last read, {AUDIT}.out. *)\n"
)
TIE = "tie-"
"""What the id of a tie begins with."""
_HEADER = f"""From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From {LIBRARY} Require %s.
Open Scope R_scope.
Set Printing Width 110.
Set Printing Depth 1000.
"""
_TITLE = re.compile(r"^== (.*)\n", re.MULTILINE)
_CITED = re.compile(
    r"^\(\*\* \[([\w.-]+)\] ((?:(?!\*\)).)*) \*\)\n(?:Theorem|Lemma|Corollary) ([\w']+)", re.MULTILINE | re.DOTALL
)
_AXIOM = re.compile(r"^(?:([A-Za-z_][\w.']*)\s*(?::|$)|(\S.*))", re.MULTILINE)
_AXIOMS = re.compile(r"^(?:Axioms:\n|Closed under the global context)", re.MULTILINE)


@dataclass(frozen=True)
class Theorem:
    """What is on record of a cited theorem."""

    statement: str
    uses: tuple[str, ...]
    """Ids of the cited theorems that its proof rests on directly, or through lemmas that are not cited."""
    axioms: tuple[str, ...]


@dataclass(frozen=True)
class Audit:
    """The record: cited theorems by id, and by name the definitions that their statements rest on, as the kernel prints them."""

    theorems: Mapping[str, Theorem]
    definitions: Mapping[str, str]

    @cached_property
    def definitions_of(self) -> Mapping[str, Mapping[str, str]]:
        """The definitions that each theorem's statement names, at any depth, in alphabetical order."""
        return {name: below(known.statement, self.definitions) for name, known in self.theorems.items()}

    def ties_of(self, name: str) -> tuple[str, ...]:
        """The ties of a theorem's definitions to `theory/`: those that speak of no others."""
        known = self.definitions_of.get(name, {}).keys()
        about = (
            (one, named.keys()) for one, named in self.definitions_of.items() if one.startswith(TIE) and one != name
        )
        return tuple(sorted(one for one, named in about if named and named <= known))


@cache
def recorded() -> Audit:
    """The record of the package."""
    return read((FOLDER / f"{AUDIT}.out").read_text("utf-8"))


@cache
def register() -> dict[str, tuple[str, str]]:
    """The kernel's name and the sentence of every theorem that may be cited, by the id that stands with it above the theorem.

    The sentence is for the reader and carries nothing.
    """
    return {
        one: (f"{path.stem}.{name}", " ".join(sentence.split()))
        for path in sorted(FOLDER.rglob("*.v"))
        for one, sentence, name in _CITED.findall(path.read_text("utf-8"))
    }


def below(text: str, printed: Mapping[str, str]) -> dict[str, str]:
    """The definitions that a printed text names, and those that they name, in alphabetical order."""
    known: dict[str, str] = {}
    waiting = [text]
    while waiting:
        for name in re.findall(r"\b[A-Z]\w*\.\w+'*", waiting.pop()):
            if name in printed and name not in known:
                known[name] = printed[name]
                waiting.append(printed[name])
    return dict(sorted(known.items()))


def script(files: Iterable[str], uses: Mapping[str, Iterable[str]], definitions: Iterable[str]) -> str:
    """The text of `Audit.v`, about the theorems of `uses`, which says what each uses."""
    lines = [NOTE + _HEADER % " ".join(files)]
    for one, used in uses.items():
        name, sentence = register()[one]
        words = f"{sentence}\nuses: {', '.join(used) or 'no other'}"
        # @: with what is implicit
        lines.append(titled(one, f"Check @{name}.", f"Print Assumptions {name}.", words=words))
    lines += [titled(name, f"Print {name}.") for name in definitions]
    return "\n\n".join(lines) + "\n"


def read(output: str) -> Audit:
    """What `Audit.v` has printed."""
    theorems: dict[str, Theorem] = {}
    definitions: dict[str, str] = {}
    for title, text in _answers(output).items():
        if title in register():
            _, _, said = text.partition("\nuses: ")
            used, _, printed = said.partition("\n")
            cut = _AXIOMS.search(printed)
            if cut is None:
                raise RuntimeError(f"the kernel's axioms of {title} cannot be read")
            names = tuple(one for one in used.split(", ") if one in register())
            statement = trimmed(register()[title][0], printed[: cut.start()])
            theorems[title] = Theorem(statement, names, axioms(printed[cut.start() :]))
        else:
            definitions[title] = trimmed(title, text)
    return Audit(theorems, definitions)


def asked(
    compiled: Compiled, groups: Iterable[Sequence[str]], definitions: Iterable[str]
) -> tuple[dict[str, str], dict[str, tuple[str, ...]]]:
    """What the kernel prints now of theorems and definitions by name, and by theorem the axioms behind its group.

    All at once, as going through proofs takes time. Raises RuntimeError, in one line, if the kernel does not answer.
    """
    lines, kept = [], list(groups)
    for number, names in enumerate(kept):
        together = f"@{names[0]}"
        for name in names[1:]:
            together = f"({together}, @{name})"
        lines += [titled(name, f"Check @{name}.") for name in names]
        lines += [f"Definition together_{number} := {together}."]
        lines += [titled(f"axioms {number}", f"Print Assumptions together_{number}.")]
    answers = run(compiled, [*lines, *(titled(name, f"Print {name}.") for name in definitions)])
    behind = {name: axioms(answers[f"axioms {number}"]) for number, names in enumerate(kept) for name in names}
    return {name: trimmed(name, text) for name, text in answers.items()}, behind


def allowed(axiom: str) -> bool:
    """Whether a proof may rest on this axiom."""
    return axiom in CLASSICAL_REALS or axiom.startswith(MACHINE_INTEGERS)


def run(compiled: Compiled, lines: Iterable[str]) -> dict[str, str]:
    """What the kernel prints below each title, with all that is compiled at hand. Raises RuntimeError where it refuses."""
    return _answers(output(compiled, "\n".join([_HEADER % " ".join(compiled.folders), *lines])))


def output(compiled: Compiled, text: str) -> str:
    """What the kernel prints of a file. Raises RuntimeError, in one line, where it refuses it."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "Ask.v").write_text(text, "utf-8")
        command = ["coqc", "-q", "-w", "none", *compiled.arguments(), "Ask.v"]
        done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        raise RuntimeError(f"the kernel does not answer: {' '.join(done.stderr.split())[-300:]}")
    return done.stdout


def answered(compiled: Compiled, text: str, jobs: int) -> str:
    """What the kernel prints of the whole of `Audit.v`, whose parts are asked in parallel."""
    head, *questions = re.split(r"\n\n(?=Goal True)", text)
    size = len(questions) // (4 * jobs) + 1
    parts = ["\n".join([head, *questions[at : at + size]]) for at in range(0, len(questions), size)]
    with ThreadPoolExecutor(jobs) as pool:  # each waits for a process of its own
        return "".join(pool.map(output, [compiled] * len(parts), parts))


def titled(title: str, *commands: str, words: str = "") -> str:
    """Commands whose output has a title."""
    text = f"== {title}\n{words}".rstrip().replace('"', '""')
    return "\n".join([f'Goal True. idtac "{text}". Abort.', *commands])


def _answers(output: str) -> dict[str, str]:
    parts = _TITLE.split(output)[1:]
    return dict(zip(parts[::2], parts[1::2], strict=True))


def axioms(text: str) -> tuple[str, ...]:
    """The names in what `Print Assumptions` prints; what is no name, such as "f is assumed to be guarded.", as it stands."""
    if text.startswith("Closed under the global context"):
        return ()
    if not text.startswith("Axioms:"):
        raise RuntimeError(f"the kernel's list of axioms cannot be read: {text[:200]!r}")
    return tuple(sorted(name or said for name, said in _AXIOM.findall(text.removeprefix("Axioms:\n"))))


def trimmed(name: str, text: str) -> str:
    """What is printed of a name, without it, the notes on arguments behind, and the indentation of the whole."""
    body = text.split("\n\nArguments ", maxsplit=1)[0].rstrip().removeprefix("@")
    body = body.removeprefix(f"{name} = ").removeprefix(name).lstrip("\n")
    if "..." in body:  # who compares it would not see what is left out
        raise RuntimeError(f"the kernel prints {name} in part only: its printing depth is too small")
    lines = body.splitlines()
    if lines and lines[0].lstrip().startswith(": "):  # a statement: "     : forall ...", further lines beneath "forall"
        indent = len(lines[0]) - len(lines[0].lstrip()) + 2
        lines = [lines[0].lstrip()[2:], *(line[indent:] for line in lines[1:])]
    return "\n".join(lines)
