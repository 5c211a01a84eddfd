"""How to cite: this software, by what its package says of itself, and the paper that it checks, as BibTeX entries."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, metadata
from textwrap import fill

from paper_checks.claims import source

SOFTWARE = "inertial-pair"
DATE = "2026-11-28"
"""Of this version: year, month, day."""


def of_package(field: str) -> str:
    """Return a field of the installed package's metadata, such as Version or Author."""
    try:
        return metadata(SOFTWARE)[field]
    except PackageNotFoundError:
        return "unknown, as it is not installed"


def bibtex() -> str:
    """Return the entries of the software and of the paper."""
    of_software = {
        "author": f"{{{of_package('Author')}}}",
        "title": f"{{{SOFTWARE}: {of_package('Summary')}}}",
        "year": DATE[:4],
        "note": f"Version {of_package('Version')}",
    }
    of_paper = {
        "author": " and ".join(source.AUTHORS),
        "title": f"{{{source.TITLE}}}",
        "year": source.YEAR,
        "eprint": source.ARXIV,
        "archivePrefix": "arXiv",
    }
    return f"{_entry(SOFTWARE, of_software)}\n\n{_entry('ruderman-inertial-pair', of_paper)}"


def _entry(key: str, fields: dict[str, str]) -> str:
    lines = (fill(f"  {name} = {{{text}}},", 88, subsequent_indent="    ") for name, text in fields.items())
    return "\n".join([f"@misc{{{key},", *lines, "}"])
