"""What the proof kernel was asked: the notion of solution, the definitions that statements use, and the statements.

Statements and definitions are those on record, as the kernel prints them, in lines of fixed width.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from paper_checks.decide import kernel
from paper_checks.evidence.evidence import Evidence, EvidenceKind, closure
from paper_checks.proofs.audit import recorded
from paper_checks.report.content.blocks import Block, Code, Folded, Heading, Paragraph, Section
from paper_checks.running.runner import Row

ID, TITLE = "kernel", "What the kernel proved"
SOLUTION = (
    "What a solution is, in words. $x$, $v_1$, $v_2$ and $s$ are functions of time; $x$ and $v_1$ are continuous, $\\dot x=v_1$. $s$ is friction's direction, summed up "
    "over time: it is Lipschitz with the constant $1$, grows at the rate $1$ while $v_1>v_2$ and falls at the rate $1$ while $v_1<v_2$. "
    "$m_1v_1+bs$ has the rate $-a_2x-a_1v_1$, and $m_2v_2-bs$ never changes. So friction is $b\\dot s$: $\\pm b$ in slip, and while the bodies stick it is "
    "whatever holds them together, up to $b$. All derivatives are taken from the right, at every time."
)
FILIPPOV = (
    "This is Filippov's notion, by a theorem: three functions are, for some $s$, such a solution exactly if they are absolutely continuous "
    "and satisfy the differential inclusion, friction anywhere in $[-b,b]$ while $v_1=v_2$, at almost every time."
)
NAMES = (
    "Names without a dot are those of Coq's library of real numbers, `R` the numbers themselves, `Rabs` the size of one, `PI`, `sqrt`; and of Coquelicot: "
    "`is_lim f p_infty l` says that $f$ tends to $l$ at infinity. An arrow is an implication: all before the last one is assumed."
)
FILES = (
    "The statements and proofs are not printed here. They are the Coq files in `paper_checks/rocq` of the software; "
    "`python -m paper_checks.proofs` compiles them and compares each statement with the one on record."
)
SAME = "filippov-iff"
"""The theorem that says so."""
WORDS = {
    "Pair.solution": "A motion of the free pair, with the damper $a_1$.",
    "Forced.forced": "A motion under a force, which is given by its impulse $U(t)=\\int_0^tu$.",
    "Pair.energy": "The energy of a state.",
    "Dini.cont": "Continuous at every time from 0 on.",
    "Dini.little": "Small of higher order: below every multiple of $h$, for small $h>0$.",
    "Dini.rderiv": "The derivative of $f$ from the right at $t$ is $l$.",
    "Stick.L": "$L$, half the width of the sliding region.",
    "Stick.Ecr": "The critical energy.",
    "Stick.omega": "$\\Omega$, the frequency of the stuck pair.",
    "Stick.X": "The stuck motion: its position.",
    "Stick.V": "The stuck motion: its velocity.",
    "Cycle.o1": "$\\omega_1$, the frequency of body 1 alone.",
    "Cycle.ray": "The velocity on a ray whose excess energy is $q\\,u^2$.",
    "Cycle.on_ray": "At the time $t$ the pair is on the ray of side $k$, with that velocity.",
    "ReturnMap.hh": "$h$ at the angle $2p$.",
    "ReturnMap.depth": "$c$ at the angle $2p$: the depth of a slip.",
    "Filippov.filippov": "Absolutely continuous, and in the inclusion at almost every time.",
    "Filippov.included": "The velocity is in the inclusion.",
    "SharpLaw.small": "The relative excess $w=E/E_{cr}-1$ of an energy is small.",
    "ModeAtContact.load": "$\\Lambda$, the friction force on body 2 that sticking needs.",
}
"""The definitions that a reader meets first, in words; all others are shown without."""
_APPLIED = re.compile(r"\b([A-Z]\w*\.\w+)((?: [\w']+)+)")
_NAMED = re.compile(r"^(?:Record \w+|fun)((?: \([^)]*\)| [\w' ]+: \w+)+)")


def theorems(rows: Sequence[Row]) -> dict[str, Evidence]:
    """Return the kernel's theorems that the rows rest on, directly or not, by id."""
    steps = closure(step for row in rows for proof in row.proofs for step in (*proof.kernel, *proof.steps))
    found = {kernel.name_of(step): step for step in steps if step.kind is EvidenceKind.KERNEL}
    return dict(sorted(found.items()))


def _known(rows: Sequence[Row]) -> dict[str, Evidence]:
    """Return those of the theorems whose statements are on record."""
    return {name: step for name, step in theorems(rows).items() if name in recorded().theorems}


def notion(rows: Sequence[Row]) -> tuple[Block, ...]:
    """Return in words what a solution is, what the kernel takes for granted, and where its statements and proofs are."""
    found = _known(rows).values()
    return tuple(map(Paragraph, (SOLUTION, FILIPPOV, f"{_axioms(found)} {FILES}"))) if found else ()


def section(rows: Sequence[Row]) -> Section:
    """Return the chapter; without any blocks where no row names a theorem of the kernel."""
    found = _known(rows)
    users: dict[str, list[str]] = {}
    for row in rows:
        for name in theorems([row]):
            users.setdefault(name, []).append(row.claim.id)
    if not found:
        return Section(ID, TITLE, ())
    notion = recorded().theorems[SAME]
    used = Counter(one for name in (SAME, *found) for one in recorded().definitions_of[name])
    others = tuple(block for name in sorted(used) if name not in WORDS for block in _definition(name))
    return Section(
        ID,
        TITLE,
        (
            Paragraph(SOLUTION),
            Heading(f"`{SAME}`", f"theorem-{SAME}"),
            Paragraph(FILIPPOV),
            Code(notion.statement),
            Paragraph(_axioms(found.values())),
            Paragraph(NAMES),
            Heading("Definitions that most statements use"),
            *(block for name in WORDS if name in used for block in _definition(name)),
            Folded(f"{len(used) - len(WORDS.keys() & used)} more definitions", others),
            Heading("Theorems"),
            *(block for name, step in found.items() if name != SAME for block in _theorem(name, step, users[name])),
        ),
    )


def _definition(name: str) -> Iterator[Block]:
    yield Heading(f"`{name}`", f"definition-{name}")
    if name in WORDS:
        yield Paragraph(WORDS[name])
    yield Code(recorded().definitions[name])


def _theorem(name: str, step: Evidence, users: Iterable[str]) -> Iterator[Block]:
    known = recorded().theorems[name]
    yield Heading(f"`{name}`", f"theorem-{name}")
    yield Paragraph(step.statement.partition("): ")[2] or step.statement)
    special = [f"`{one}` with ${letter}=0$" for one, letter in zeros(known.statement)]
    yield Code(known.statement)
    if special:
        yield Paragraph(f"It assumes {', '.join(special)}.", "Read")
    rests = f" It uses {', '.join(f'`{one}`' for one in known.uses)}." if known.uses else ""
    yield Paragraph(f"Claims: {', '.join(f'`{one}`' for one in users)}.{rests}")


def zeros(statement: str) -> list[tuple[str, str]]:
    """Return where a statement puts 0 for a letter of a definition: the definition and the letter, as LaTeX.

    >>> zeros("Pair.solution m1 m2 0 a2 b x v1 v2 s -> True")
    [('Pair.solution', 'a_1')]
    """
    found = []
    for name, given in _APPLIED.findall(statement):
        head = _NAMED.match(recorded().definitions.get(name, ""))
        letters = re.findall(r"[\w']+", re.sub(r":[^)]*", "", head[1])) if head else []
        places = zip(given.split(), letters, strict=False)
        found += [(name, re.sub(r"(\d+)$", r"_\1", letter)) for value, letter in places if value == "0"]
    return list(dict.fromkeys(found))


def _axioms(steps: Iterable[Evidence]) -> str:
    """Say what the kernel takes for granted."""
    axioms = Counter(axiom for step in steps for axiom in step.assumptions)
    most = max(axioms.values(), default=0)
    common = ", ".join(f"`{axiom}`" for axiom, count in sorted(axioms.items()) if count == most)
    others = sum(count != most for count in axioms.values())
    numbers = f"; and, for theorems with computed intervals, {others} axioms of machine integers" if others else ""
    return (
        f"The axioms behind these theorems: {common}{numbers}."
        if axioms
        else "The proof kernel was not run here: these are the statements as they were last accepted, and its axioms are not listed."
    )
