"""The plan of the house: which package may import which, and that the tests see the repository's own packages."""

from __future__ import annotations

import ast
import importlib
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FORBIDDEN = {
    "theory": {"numerics", "paper_checks", "flint", "mpmath", "numpy", "matplotlib"},
    "numerics": {"theory", "paper_checks", "sympy"},
    "paper_checks": {"tests", "notebooks"},
}


def imported_packages(path: Path) -> set[str]:
    """Return the top-level packages that a module imports, lazily or not."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            found.add(node.module.split(".")[0])
    return found


@pytest.mark.parametrize("package", sorted(FORBIDDEN))
def test_imports_point_one_way(package):
    offenders = {
        str(path.relative_to(ROOT)): sorted(wrong)
        for path in (ROOT / package).rglob("*.py")
        if (wrong := imported_packages(path) & FORBIDDEN[package])
    }
    assert not offenders


def imported_modules(path: Path) -> set[str]:
    """Return the modules that a module imports, by their full names; of `from a import b` both a and a.b."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{path}: a relative import"
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return found


def within(module: str, package: str) -> bool:
    return module == package or module.startswith(f"{package}.")


def strangers(path: Path) -> set[str]:
    """Return what a kernel imports although numba need not compile it, or would not notice that it has changed."""
    if path.name == "compilation.py":
        allowed = sys.stdlib_module_names | {"numba"}
    else:
        allowed = {"__future__", "math", "typing", "fractions", "functools", "numerics.kernel"}
    modules = imported_modules(path) - {"numerics"}
    return {one for one in modules if not any(within(one, package) for package in allowed)}


def test_kernels_stand_on_kernels_alone():
    sources = list((ROOT / "numerics" / "kernel").glob("*.py"))
    assert len(sources) > 10
    assert not {path.name: sorted(wrong) for path in sources if (wrong := strangers(path))}


@pytest.mark.parametrize("line", ["import numpy", "from numerics.scene import Pair", "from numerics import scene"])
def test_a_kernel_that_leans_on_others_is_found_out(tmp_path, line):
    (tmp_path / "motion.py").write_text(f"import math\nfrom numerics.kernel.state import End\n{line}\n", "utf-8")
    assert strangers(tmp_path / "motion.py")


def judged(path: Path) -> bool:
    """Return whether a module imports the trade, which sets up and judges the comparisons."""
    return any(within(one, "numerics.trade") for one in imported_modules(path))


def test_comparisons_do_not_know_the_trade():
    sources = list((ROOT / "numerics" / "trade" / "comparisons").glob("*.py"))
    assert len(sources) > 5
    assert not [path.name for path in sources if judged(path)]


@pytest.mark.parametrize("line", ["import numerics.trade.judge", "from numerics import trade"])
def test_a_comparison_that_knows_the_trade_is_found_out(tmp_path, line):
    (tmp_path / "peer.py").write_text(line, "utf-8")
    assert judged(tmp_path / "peer.py")


@pytest.mark.parametrize("package", sorted(FORBIDDEN))
def test_imported_packages_are_those_of_the_repository(package):
    assert Path(importlib.import_module(package).__file__).resolve().parent == ROOT / package


@pytest.mark.parametrize("package", ["numerics", "paper_checks"])
def test_help_answers_without_heavy_imports(package):
    heavy = ["sympy", "flint", "mpmath", "numpy", "matplotlib", "z3", "cvc5"]
    code = (
        "import runpy, sys; sys.argv=[sys.argv[0], '--help']\n"
        f"try: runpy.run_module({package!r}, run_name='__main__', alter_sys=True)\n"
        f"finally: print([name for name in {heavy!r} if name in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.returncode == 0, done.stderr
    assert "usage:" in done.stdout
    assert done.stderr.strip().splitlines()[-1] == "[]"


def test_version_is_said_once_and_the_same_everywhere():
    version = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["version"]
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    assert f"version: {version}" in citation


def test_readme_names_two_commands_that_set_everything_up():
    commands = re.findall(r"^python3 -m venv .*$", (ROOT / "README.md").read_text("utf-8"), flags=re.MULTILINE)
    assert [command.split("-m ")[-1] for command in commands] == ["paper_checks", "pytest"]


def test_the_readmes_examples_run():
    code = "\n".join(re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), flags=re.DOTALL))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.returncode == 0, done.stderr
    assert "SLIP_PLUS" in done.stdout
