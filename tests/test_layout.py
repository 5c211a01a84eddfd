"""The repository layout: which package may import which, and that the tests see the repository's own packages."""

import ast
import graphlib
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
COMPILED = ROOT / "numerics" / "arithmetic" / "compiled.py"
FORBIDDEN = {
    "theory": {"numerics", "paper_checks", "flint", "mpmath", "numpy", "matplotlib"},
    "numerics": {"theory", "paper_checks", "sympy"},
    "paper_checks": {"tests", "notebooks"},
}
EXACT = ROOT / "theory" / "fraction.py"
"""It takes polynomials from flint, and none of its balls."""


@cache
def imported_modules(path: Path) -> set[str]:
    """Return the modules that a module imports, lazily or not, by their full names; of `from a import b` a and a.b."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{path}: a relative import"
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return found


@pytest.mark.parametrize("package", sorted(FORBIDDEN))
def test_imports_point_one_way(package):
    offenders = {
        str(path.relative_to(ROOT)): sorted(wrong)
        for path in (ROOT / package).rglob("*.py")
        if (
            wrong := {one.split(".")[0] for one in imported_modules(path)}
            & FORBIDDEN[package] - {path == EXACT and "flint"}
        )
    }
    assert not offenders


LAYERS = {
    "numerics": """errors < habits < exits files tasks < shown meter < scene < arithmetic < linear < free < trajectory
        < plane < solver < control < trade < cli < __main__""",
    "paper_checks": """errors atomic < store < evidence proofs < decide < claims < derivation < running
        < drawing explore < report < __main__""",
    "paper_checks.report": "mathematics < content < formats < output",
}
"""The subpackages, lowest layer first; each imports only from lower layers and from itself."""


def climbing(path: Path, package: str, subpackage: str) -> set[str]:
    """Return what a file imports from its own layer, other than its own subpackage, or from a higher one."""
    layer = {name: number for number, names in enumerate(LAYERS[package].split("<")) for name in names.split()}
    modules = [one.removeprefix(f"{package}.") for one in imported_modules(path) if one.startswith(f"{package}.")]
    used = {one.split(".")[0] for one in modules} & layer.keys()
    return {one for one in used - {subpackage} if layer[one] >= layer[subpackage]}


def files_of(package: str) -> list[tuple[str, Path]]:
    """Return every file with its subpackage; numerics/__init__ imports from all layers."""
    base = ROOT.joinpath(*package.split("."))
    files = [path for path in base.rglob("*.py") if path != base / "__init__.py"]
    return [(path.relative_to(base).parts[0].removesuffix(".py"), path) for path in files]


@pytest.mark.parametrize("package", LAYERS)
def test_every_subpackage_imports_lower_layers_only(package):
    assert len(files_of(package)) > 20
    assert not {str(path): found for name, path in files_of(package) if (found := climbing(path, package, name))}


@pytest.mark.parametrize("package", LAYERS)
def test_no_two_files_import_each_other(package):
    graph = {}
    for _, path in files_of(package):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        graph[name] = {one for one in imported_modules(path) if one.startswith(f"{package}.") and one != name}
    graph = {name: used & set(graph) for name, used in graph.items()}
    assert graphlib.TopologicalSorter(graph).prepare() is None  # raises CycleError


@pytest.mark.parametrize("package", LAYERS)
def test_no_file_is_longer_than_a_few_screens(package):
    lengths = {str(path): len(path.read_text("utf-8").splitlines()) for _, path in files_of(package)}
    assert not {path: lines for path, lines in lengths.items() if lines > 400}


def test_what_numba_compiles_lives_where_the_cache_looks():
    """numba's cache is named after the sources of these subpackages; a change elsewhere would be missed."""
    subpackages = {name for name, path in files_of("numerics") if "@compilable" in path.read_text("utf-8")}
    listed = set(re.findall(r'"(\w+)"', re.search(r"_FOLDERS = \(([^)]*)\)", COMPILED.read_text("utf-8")).group(1)))
    assert {"arithmetic", "linear"} <= subpackages <= listed


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


HELD = re.compile(r"\b(precision|series_terms|mpmath_precision|context|fine|terms)\(")
SET = re.compile(
    r"\.(?:prec|dps|cap)\b[^=()\n]*=(?!=)|\b(?:work|extra)(?:prec|dps)\b|functools import [^.]*cached_property"
)


def outside_the_lock(path: Path) -> list[str]:
    """Return where a file sets a precision, holds one across a `yield`, or takes a cached_property that locks."""
    text = path.read_text("utf-8")
    functions = [one for one in ast.walk(ast.parse(text)) if isinstance(one, ast.FunctionDef)]
    held = (
        block
        for one in functions
        if "contextmanager" not in map(ast.unparse, one.decorator_list)
        for block in ast.walk(one)
        if isinstance(block, ast.With) and HELD.search(ast.unparse(block.items))
    )
    yields = [one for block in held for one in ast.walk(block) if isinstance(one, ast.Yield | ast.YieldFrom)]
    return SET.findall(text) + [f"line {one.lineno}: yields within a precision" for one in yields]


def test_every_precision_is_set_under_one_lock():
    files = [path for _, path in files_of("numerics") if path.name != "precision.py"]
    assert not {str(path): found for path in files if (found := outside_the_lock(path))}


@pytest.mark.parametrize(
    "line",
    [
        "ctx.prec = 100",
        "flint.ctx.cap, x = 3, 4",
        "mpmath.mp.dps = 50",
        "with mpmath.workdps(50): pass",
        "def f():\n    with run.context():\n        yield 1",
        "from functools import cached_property",
        "from numerics.solver.solve import solve",
    ],
)
def test_a_precision_that_is_set_elsewhere_and_an_import_from_a_higher_layer_are_found_out(tmp_path, line):
    (tmp_path / "loose.py").write_text(line, "utf-8")
    assert outside_the_lock(tmp_path / "loose.py") or climbing(tmp_path / "loose.py", "numerics", "trajectory")
