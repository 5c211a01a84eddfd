"""Evidence: what was checked, how strong that is, and what it rests on. It is a node of the graph of a proof."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property

_NON_FINITE = re.compile(r"(?<![\w\\])[+-]?(?:nan|inf|infinity)(?!\w)", re.IGNORECASE)


INFERRING = re.compile(
    r"\b(so|hence|thus|therefore|then|because|since|implies|imply|follows?|consequently|whence|proves?|shows?)\b",
    re.IGNORECASE,
)
"""Words of an inference, which has no place in a reading."""


def one_line(text: str) -> str:
    """Return prose, which may be written over several lines, with single spaces."""
    return " ".join(text.split())


class EvidenceKind(Enum):
    """How strong a piece of evidence is, strongest first."""

    KERNEL = "kernel"
    """A proof assistant's kernel accepted the proof."""
    SMT = "smt"
    """Two solvers, and a satisfiable control."""
    EXACT = "exact"
    """A symbolic identity."""
    ENCLOSURE = "enclosure"
    """Ball arithmetic: holds for every point of a stated set."""
    ARGUMENT = "argument"
    """A written inference over checked steps, which names the theorem that it cites."""
    PROPERTY = "property"
    """Random cases in a stated number."""
    SIMULATION = "simulation"
    """One computed trajectory, without a proven error."""
    READING = "reading"
    """What words of the paper are taken to say; it infers nothing, and settles nothing."""

    @cached_property
    def strength(self) -> int:
        """Rank, dimensionless; larger is stronger."""
        return -list(EvidenceKind).index(self)

    @property
    def decisive(self) -> bool:
        """Whether this kind can settle a claim; samples cannot."""
        return self.strength >= EvidenceKind.ARGUMENT.strength


class Subject(Enum):
    """What a piece of evidence speaks about."""

    CLAIM = "claim"
    """The paper's statement itself, or a step of its proof."""
    COUNTEREXAMPLE = "counterexample"
    """That the counterexample is real and violates the paper's statement."""
    CORRECTION = "correction"
    """The corrected statement, or a step of its proof."""


@dataclass(frozen=True)
class Evidence:
    """One checked statement.

    `passed` is True (the statement was found true), False (found false) or None (no answer). With no cases,
    or with a `value` that is not finite, nothing was checked: `passed` becomes None, never a pass.
    """

    kind: EvidenceKind
    engine: str
    statement: str
    passed: bool | None
    cases: int = 1
    value: str = ""
    assumptions: tuple[str, ...] = ()
    about: Subject = Subject.CLAIM
    rests_on: Steps = ()
    """The steps that an inference is made from, or the theorems that one of the kernel uses."""
    cites: tuple[str, ...] = ()
    """Theorems of others that an argument uses."""
    supports: bool = False
    """Whether it stands beside a proof without being a step of it."""
    counted: str = "cases"
    """What its cases are."""

    def __post_init__(self) -> None:
        """Take the pass from evidence that is vacuous or not finite; what cannot settle a claim only supports it."""
        object.__setattr__(self, "statement", one_line(self.statement))
        if not isinstance(self.passed, bool | None):
            raise TypeError(f"passed is {self.passed!r}; it must be True, False or None: decide it before")
        if self.passed and (self.cases < 1 or _NON_FINITE.search(self.value)):
            object.__setattr__(self, "passed", None)
        if not self.kind.decisive:
            object.__setattr__(self, "supports", True)

    def __hash__(self) -> int:
        """Hash what is said: all that it rests on would be hashed again for each step above it."""
        return hash(self.statement)

    @property
    def decides(self) -> bool:
        """Whether it passed and is a step that can settle a claim."""
        return self.passed is True and not self.supports

    def as_support(self) -> Evidence:
        """Return the same evidence, as what stands beside a proof and is no step of it."""
        return replace(self, supports=True)

    def as_counterexample(self) -> Evidence:
        """Return the same evidence, as evidence that the counterexample is real."""
        return self.about_(Subject.COUNTEREXAMPLE)

    def as_correction(self) -> Evidence:
        """Return the same evidence, as evidence for the corrected statement."""
        return self.about_(Subject.CORRECTION)

    def about_(self, subject: Subject) -> Evidence:
        """Return the same evidence, as evidence about another subject, with all that it rests on."""
        return replace(self, about=subject, rests_on=tuple(step.about_(subject) for step in self.rests_on))


Steps = tuple[Evidence, ...]
"""Steps of a proof, in their order."""
Named = Evidence | Sequence[Evidence] | Callable[[], Evidence | Sequence[Evidence]]
"""How steps are named where others rest on them: themselves, or the function that returns them."""


def steps(*named: Named) -> Steps:
    """Return the steps that are named, in their order."""
    made = (one() if callable(one) else one for one in named)
    return tuple(step for one in made for step in ((one,) if isinstance(one, Evidence) else one))


def argument(statement: str, *named: Named, cites: tuple[str, ...] = ()) -> Evidence:
    """Return a written inference: as good as the steps that it rests on.

    Raises ValueError where it rests on nothing and cites nothing.
    """
    rests_on = steps(*named)
    if not (rests_on or cites):
        raise ValueError(f"an argument rests on steps, or cites a theorem: {statement}")
    outcomes = {step.passed for step in rests_on if not step.supports}
    passed = False if False in outcomes else None if None in outcomes else True
    return Evidence(EvidenceKind.ARGUMENT, "written inference", statement, passed, rests_on=rests_on, cites=cites)


def reading(words: str, meaning: str) -> Evidence:
    """Return that words of the paper are read as what `meaning` names, a formula among it: "We read “words” as meaning."

    It stands beside a claim and carries no clause of it. Raises ValueError where it infers, where it is more than
    one sentence, or where it names no formula.

    >>> reading("they stick", "$v_1=v_2$ on an interval of time").statement
    'We read “they stick” as $v_1=v_2$ on an interval of time.'
    """
    said = f"We read “{one_line(words)}” as {one_line(meaning)}."
    if inferred := INFERRING.search(said):
        raise ValueError(f"a reading infers nothing, but this one has “{inferred[0]}”: {said}")
    if re.search(r"[.;:?!](?=\s)", said):
        raise ValueError(f"a reading is one sentence: {said}")
    if not re.search(r"\$[^$]+\$", meaning):
        raise ValueError(f"a reading names the formula that the words are read as: {said}")
    return Evidence(EvidenceKind.READING, "reading", said, True)


def enclosed(
    statement: str,
    passed: bool | None,
    value: str,
    cases: int = 1,
    *,
    engine: str = "python-flint",
    supports: bool = False,
) -> Evidence:
    """Return what balls showed: a statement about every point of them."""
    return Evidence(EvidenceKind.ENCLOSURE, engine, statement, passed, cases, value, supports=supports)


def closure(steps: Iterable[Evidence]) -> Steps:
    """Return the steps and all that they rest on, each once, those that others rest on first."""
    found: dict[Evidence, None] = {}

    def visit(step: Evidence) -> None:
        if step not in found:
            for below in step.rests_on:
                visit(below)
            found[step] = None

    for step in steps:
        visit(step)
    return tuple(found)


def weakest(steps: Iterable[Evidence]) -> EvidenceKind | None:
    """Return the weakest kind among the steps and all that they rest on, but for what merely supports."""
    kinds = [step.kind for step in closure(steps) if not step.supports]
    return min(kinds, key=lambda kind: kind.strength, default=None)
