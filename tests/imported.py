"""What a source file imports."""

import ast
from functools import cache
from pathlib import Path


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
