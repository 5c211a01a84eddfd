"""Every notebook runs from a fresh kernel without a warning, shows something, and imports instead of defining."""

import ast
from pathlib import Path

import jupytext
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
NOTEBOOKS = sorted(path.name for path in FOLDER.glob("*.py"))
SHOWN = {"image/png", "image/svg+xml", "text/latex"}
COMPILES = "numba compiles the solver, once for this version\n"
"""What a first run says, and no warning."""
LONGEST_LAMBDA = 80
"""Characters; a longer lambda is a function in disguise."""


@pytest.fixture
def fresh_kernel(monkeypatch, tmp_path):
    """Keep the reader's own kernels, start-up files and plotting back end out of the run."""
    monkeypatch.setenv("JUPYTER_PREFER_ENV_PATH", "1")
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    monkeypatch.delenv("MPLBACKEND", raising=False)


def seen(notebook):
    """Run all cells in a new kernel; return whether one shows a figure or a formula, and what is written to stderr.

    Warnings, above all. Raises CellExecutionError.
    """
    NotebookClient(
        notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}
    ).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    shown = any(SHOWN & set(output.get("data", {})) for output in outputs)
    told = [output.text for output in outputs if output.get("name") == "stderr"]
    return shown, [one for one in told if one != COMPILES]


def definitions(source):
    """Return the functions and classes that a notebook defines, and its lambdas of substance."""
    return [
        ast.unparse(node)
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)
        or (isinstance(node, ast.Lambda) and len(ast.unparse(node)) > LONGEST_LAMBDA)
    ]


@pytest.mark.long
@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebook_runs_and_shows_something(name, fresh_kernel):
    assert seen(jupytext.read(FOLDER / name)) == (True, [])


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebook_imports_and_never_defines_and_is_a_bare_percent_source(name):
    assert definitions((FOLDER / name).read_text("utf-8")) == []
    notebook = jupytext.read(FOLDER / name)
    assert notebook.metadata.kernelspec.name == "python3"
    assert notebook.metadata.jupytext.text_representation.format_name == "percent"
    assert notebook.cells[0].cell_type == "markdown"


def test_a_definition_in_a_notebook_is_found():
    assert definitions("def f(x):\n    return x\n\nclass A:\n    pass\n\ng = lambda x: x") == [
        "def f(x):\n    return x",
        "class A:\n    pass",
    ]
    assert definitions(f"f = lambda: {' + '.join('x' * LONGEST_LAMBDA)}")


@pytest.mark.long
def test_what_a_notebook_writes_and_raises_is_seen(fresh_kernel):
    silent = jupytext.reads("# %%\nimport sys\nprint(1)\nprint('!', file=sys.stderr)\n", fmt="py:percent")
    assert seen(silent) == (False, ["!\n"])
    with pytest.raises(CellExecutionError):
        seen(jupytext.reads("# %%\n1 / 0\n", fmt="py:percent"))
