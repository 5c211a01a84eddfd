"""The report as LaTeX source: an appendix that also compiles by itself."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from paper_checks.evidence import Evidence
from paper_checks.report import blocks
from paper_checks.report.mathematics import latex
from paper_checks.report.summary import OUTCOMES, PAPER, TITLE, findings_first, kind, speaker
from paper_checks.runner import Row

PREAMBLE = r"""\documentclass[10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage[a4paper,margin=25mm]{geometry}
\usepackage{amsmath,amssymb,array,graphicx,longtable}
\usepackage[hidelinks,pdfcreator={},pdfproducer={}]{hyperref}
\pdfinfoomitdate=1 \pdftrailerid{} \pdfsuppressptexinfo=-1
\setlength{\emergencystretch}{3em}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
"""


def render(rows: Sequence[Row], figures: Mapping[str, str], after: Sequence[blocks.Section] = ()) -> str:
    """Return the source, with the sections of `after` behind the claims.

    `figures` maps a figure's name to the file, beside the source, that holds it.
    """
    parts = [
        PREAMBLE + r"\begin{document}",
        rf"\section*{{{latex(TITLE)}}}",
        latex(PAPER),
        _findings(rows),
        _table(rows),
        r"\subsection*{Claim by claim}",
        *(_claim(row, figures) for row in rows),
        *(blocks.latex(one, figures) for one in after),
        r"\end{document}",
    ]
    return "\n\n".join(parts) + "\n"


def _identifier(row: Row) -> str:
    name = row.claim.id.replace("-", r"-\allowbreak{}")
    return rf"\hyperref[{row.claim.id}]{{\texttt{{{name}}}}}"


def _findings(rows: Sequence[Row]) -> str:
    lists = [
        _list(f"{heading}.", "itemize", [f"{_identifier(row)}: {latex(sentence)}" for row, sentence in chosen])
        for _, heading, chosen in findings_first(rows)
    ]
    return "\n\n".join([r"\subsection*{Findings}", *lists])


def _list(title: str, environment: str, items: Iterable[str]) -> str:
    lines = "\n".join(rf"\item {item}" for item in items)
    return rf"\textbf{{{title}}}" + f"\n\\begin{{{environment}}}\n{lines}\n\\end{{{environment}}}"


def _table(rows: Sequence[Row]) -> str:
    lines = "\n".join(
        rf"{_identifier(row)} & {latex(row.claim.section)}: {latex(row.claim.where)} & "
        rf"{row.finding.verdict.value} & {latex(kind(row))} \\"
        for row in rows
    )
    return (
        "\\subsection*{Claims}\n\\begin{longtable}{@{}p{0.35\\textwidth}p{0.25\\textwidth}ll@{}}\n"
        f"Claim & Where & Verdict & Established by \\\\ \\hline \\endhead\n{lines}\n\\end{{longtable}}"
    )


def _claim(row: Row, figures: Mapping[str, str]) -> str:
    claim, finding = row.claim, row.finding
    texts = {
        speaker(claim): claim.statement,
        "Reason": finding.reason,
        "Counterexample": finding.counterexample,
        "Corrected statement": finding.corrected,
        "Missing for a proof": finding.missing,
    }
    heading = rf"\phantomsection\label{{{claim.id}}}\subsubsection*{{{_identifier(row)}: {finding.verdict.value}}}"
    parts = [heading, *(rf"\textbf{{{latex(title)}.}} {latex(text)}" for title, text in texts.items() if text)]
    if finding.evidence:
        parts.append(_list("Evidence.", "itemize", map(_evidence, finding.evidence)))
    if finding.derivation:
        parts.append(_list("Derivation.", "enumerate", map(latex, finding.derivation)))
    if finding.figure and finding.figure in figures:
        parts.append(rf"\begin{{center}}\includegraphics[width=\textwidth]{{{figures[finding.figure]}}}\end{{center}}")
    parts.append(rf"\textbf{{Run it again.}} \texttt{{python -m paper\_checks run {claim.id}}}")
    return "\n\n".join(parts)


def _evidence(item: Evidence) -> str:
    about = "" if item.about.value == "claim" else f"{item.about.value}, "
    cases = f", {item.cases} cases" if item.cases != 1 else ""
    given = f" Given {latex(', '.join(item.assumptions))}." if item.assumptions else ""
    value = f" ({latex(item.value)})" if item.value else ""
    head = rf"\emph{{{item.kind.value}}} ({latex(item.engine)}{cases}), {about}{OUTCOMES[item.passed]}"
    return f"{head}: {latex(item.statement)}.{given}{value}".replace("..", ".")
