"""The notebooks as pages: run, with what they print and draw, into docs/notebooks/ (conf.py calls it for the site)."""

from __future__ import annotations

import base64
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
SOURCES, PAGES = HERE.parent / "notebooks", HERE / "notebooks"
PICTURES = {"image/svg+xml": "svg", "image/png": "png"}


def render() -> None:
    """Write the page of every notebook that has none, or an older one; without jupyter, only its text and code."""
    PAGES.mkdir(exist_ok=True)
    for source in sorted(SOURCES.glob("*.py")):
        page = PAGES / f"{source.stem}.md"
        if not page.exists() or page.stat().st_mtime < source.stat().st_mtime:
            page.write_text("\n\n".join(lines_of(source)) + "\n", "utf-8")


def lines_of(source: Path) -> list[str]:
    """Return the blocks of a page in Markdown; pictures are files beside it."""
    import jupytext

    book, blocks = jupytext.read(source), []
    try:
        from nbclient import NotebookClient
    except ImportError:
        pass
    else:
        at = {"metadata": {"path": str(SOURCES)}}
        NotebookClient(book, timeout=600, kernel_name="python3", resources=at).execute()
    for number, cell in enumerate(book.cells):
        if cell.cell_type == "markdown":
            blocks.append(cell.source)
            continue
        code = "\n".join(line for line in cell.source.split("\n") if not line.startswith("%"))
        blocks.append(f"```python\n{code}\n```")
        for k, output in enumerate(cell.get("outputs", ())):
            blocks += shown(output, f"{source.stem}-{number}-{k}")
    head, *rest = blocks
    name = source.name
    return [
        head,
        f"*`notebooks/{name}`, run when these pages were built; open it by `jupytext --to ipynb {name}`.*",
        *rest,
    ]


def shown(output: Any, name: str) -> list[str]:
    """Return an output of a cell as Markdown."""
    data = output.get("data", {})
    for kind, suffix in PICTURES.items():
        if kind in data:
            file = PAGES / f"{name}.{suffix}"
            file.write_bytes(data[kind].encode() if suffix == "svg" else base64.b64decode(data[kind]))
            return [f"![What the cell above draws]({file.name})"]
    for kind in ("text/markdown", "text/latex"):
        if kind in data:
            return [data[kind].replace("$\\displaystyle", "$").replace("$$$$", "$$\n\n$$")]  # formulas side by side
    text = data.get("text/plain", output.get("text", "") if output.get("name") != "stderr" else "")
    return [f"```text\n{text.rstrip()}\n```"] if text.strip() else []
