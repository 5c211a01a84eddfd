"""The file of ties as the library needs it: its text kept between runs, and no tie judged by another one's fault."""

from __future__ import annotations

import re
from pathlib import Path

from paper_checks.proofs import kernel
from paper_checks.proofs.kernel import Compiled, Progress
from paper_checks.proofs.sources import Source
from paper_checks.store import Store, digest, version

TIES = "Tie"


def text(store: Path) -> tuple[str, str]:
    """The generated file, and why it is empty where a definition of `theory/` is none that Coq can read.

    Deriving it takes seconds, so its text is kept under a hash of all that it is made from.
    """
    import theory

    made_from = [*sorted(Path(theory.__file__).parent.rglob("*.py")), *sorted(Path(__file__).parent.glob("*.py"))]
    kept = Store("ties", digest(made_from, [f"sympy {version('sympy')}"]), store)
    if body := kept.get(f"{TIES}.v"):
        return body.decode(), ""
    from paper_checks.proofs import ties

    try:
        found = ties.text()
    except Exception as error:  # noqa: BLE001  whatever theory raises, no definition of the proofs is tied to it then
        return "", f"{TIES}: the ties to theory cannot be written: {type(error).__name__}: {error}"
    kept.put(f"{TIES}.v", found.encode())
    return found, ""


def compiled(
    sources: dict[str, Source], progress: Progress | None, jobs: int, store: Path
) -> tuple[Compiled, dict[str, str]]:
    """All files compiled; a tie that is not proved is taken out of its file, so that the others are judged by themselves.

    The second part says by name what is wrong with each that was taken out; `sources` then holds what was compiled.
    """
    untied: dict[str, str] = {}
    found = kernel.compile_all(sources, progress, jobs, store)
    while said := re.match(rf"{TIES}\.(\w+) is not proved", found.broken.get(TIES, "")):
        parts = re.split(r"(?=^\(\*\* )", sources[TIES].text, flags=re.MULTILINE)
        kept = [part for part in parts if not re.search(rf"\b{said[1]}\b", part)]
        untied[f"{TIES}.{said[1]}"] = found.broken[TIES]
        sources[TIES] = Source(TIES, "".join(kept))
        found = kernel.compile_all(sources, None, jobs, store)
    return found, untied
