"""Write the page of the derivation from its lines, as the report has them: python docs/derivation.py."""

from __future__ import annotations

from pathlib import Path

from paper_checks.report.content.derivation import markdown

HERE = Path(__file__).resolve().parent
NOTE = (
    "This page is written by `python docs/derivation.py`. Each check named here passed when it was written. Theorems "
    "of the kernel are named for reference; the report says whether the kernel accepted them, and links every claim."
)


def page() -> str:
    """Return the page in Markdown, with the pictures that these pages have."""
    title, opening, rest = markdown(pictures=[path.stem for path in HERE.glob("*.svg")]).split("\n\n", 2)
    return f"{title}\n\n{opening}\n\n{NOTE}\n\n{rest}"


if __name__ == "__main__":
    (HERE / "derivation.md").write_text(page(), encoding="utf-8")
