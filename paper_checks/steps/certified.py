"""The certificate of the critical mass ratio and of the bands, gone through by its own checker."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

from paper_checks.certificates import checker
from paper_checks.evidence.evidence import Evidence, EvidenceKind


def certificate(part: str, path: Path = checker.CERTIFICATE) -> Evidence:
    """Have the independent checker go through the certificate; `part` is what the evidence speaks of."""
    text = path.read_text("utf-8")
    found = checker.objections(text)
    statements = {
        "threshold": r"a certificate, cell by cell: $K$ is positive, falling, negative on $(0,\pi)$; bounds of $\varphi^*$, $r^*$, $m_1/m_2$, "
        r"$m_2/m_1$; and every slip from $S$ ends above $E_{cr}$ for $m_2/M\leqslant 557/1000$",
        "bands": "a certificate of boxes in $(m_2/M,w)$ about $m_2/M=3/5$, $7/10$, $4/5$, $9/10$, below, in and beyond the first interval, each followed slip by slip until the pair has merged or is "
        "below the level of no-merging-near-critical",
    }
    cases, value = _content(text, part) if not found else (1, found[0])
    return Evidence(
        EvidenceKind.ENCLOSURE, "certificate checker, python-flint", statements[part], not found, cases, value
    )


def _content(text: str, part: str) -> tuple[int, str]:
    """Return the number of cells of a part and a sentence on it."""
    data = json.loads(text)
    if part == "bands":
        ends = [tuple(slip[2] for slip in band["slips"]) for band in data["bands"]]
        later = [names for names in ends if len(names) > 1]
        merged = sum(names[-1] == "merges" for names in later)
        direct = sum(names == ("merges",) for names in ends)
        return len(ends), (
            f"{len(ends)} boxes: {direct} merge at the first re-entry, {merged} after up to {max(map(len, ends))} slips; "
            f"{len(ends) - direct - merged} creep"
        )
    cells = len(data["turning"]) + len(data["surface"]["cells"])
    (low, high), share_bounds = data["constants"]["m1_over_m2"], data["constants"]["share"]
    width = Fraction(high) - Fraction(low)
    return cells, (
        f"{cells} cells; m1/m2 > {_decimal(low)} and r* > {_decimal(share_bounds[0])}, bounds {float(width):.1g} apart"
    )


def _decimal(fraction: str) -> str:
    value = Fraction(fraction)
    return f"0.{int(value * 10**55):055d}"
