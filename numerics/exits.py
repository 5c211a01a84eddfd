"""Exit codes of the commands, and the one way to refuse; what is wrong with the name of a file to be written."""

from __future__ import annotations

import argparse
import importlib
import os
import re
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from numerics.errors import MissingTool
from numerics.habits import right_word

OK, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130
"""Done; undecided, out of reach or a tool that is missing; bad usage or an invalid scene; stopped by the user."""
FIGURES = (".svg", ".pdf", ".png")
"""How the name of a figure may end."""


def refuse(message: str, code: int) -> int:
    """Print one error line on stderr and return the exit code; a remedy names the flag, not the argument in Python."""
    said = re.sub(r"(?<!-)\bmax_(digits|events|steps)\b", r"--max-\1", " ".join(message.split()))
    said = re.sub(r'\b(arithmetic|least)="(.+?)"', r"--\1 \2", said)
    said = said.replace("give amplitude and omega", "give --amplitude and --omega").replace("digits=N", "--digits N")
    print(f"error: {said}", file=sys.stderr)
    return code


def drop_output() -> None:
    """Send what is still buffered for stdout nowhere, so that the interpreter's last flush does not fail again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def open_streams() -> None:
    """Give a program that was started with a closed stream an empty one in its place."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode))  # noqa: SIM115 - open until the program ends


def path(text: str) -> Path:
    """Return the path that a flag names; "" would be the current folder, which nobody means by it."""
    if not text:
        raise argparse.ArgumentTypeError("the name is empty; give a file name")
    return Path(text)


def wrong_path(path: Path | None, figure_flag: str = "") -> str | None:
    """Return what is wrong with a path to write to, or None; a figure is named by the flag that asked for it."""
    if path is None:
        return None
    if path.is_dir():
        return f"{str(path)!r} is a folder; give a file in it"
    if not path.parent.is_dir():
        return f"folder {str(path.parent)!r} does not exist; create it, or write elsewhere"
    if figure_flag and path.suffix not in FIGURES:
        return f"{figure_flag} {path.name}: the name must end in one of {', '.join(FIGURES)}"
    is_device = path.exists() and not path.is_file()
    return None if is_device else wrong_folder(path.parent)


def wrong_folder(path: Path) -> str | None:
    """Return why a folder, made if need be, cannot take files; None if it can."""
    there = next((one for one in (path, *path.parents) if one.exists()), path)
    if not there.is_dir():
        return f"{str(there)!r} is a file; choose another folder"
    try:
        with tempfile.TemporaryFile(dir=there):
            return None
    except OSError as error:
        return f"folder {str(there)!r} cannot be written to: {error.strerror}; choose another one"


def program_name(script: str, module: str) -> str:
    """Return how a program was called: as the installed script, or as a module."""
    return script if Path(sys.argv[0]).stem == script else f"python -m {module}"


def complete(parser: argparse.ArgumentParser) -> None:
    """Answer a shell that asks what may follow; argcomplete, if it is installed, does that."""
    if "_ARGCOMPLETE" in os.environ:
        try:
            import argcomplete
        except ImportError:
            return
        argcomplete.autocomplete(parser)


def missing(module: str) -> str:
    """Return the sentence that says that a module is not installed, and what to do."""
    own = {"matplotlib": "'inertial-pair[plot]'", "pandas": "pandas", "xarray": "xarray"}
    how = own.get(module, "'inertial-pair[checks]'")
    return f"this needs {module}, which is not installed; python -m pip install {how}"


def tool(module: str) -> ModuleType:
    """Return an optional module, or one of this package that needs some. Raises MissingTool."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise MissingTool(missing(str(error.name))) from None


class Version(argparse.Action):
    """`--version`: the version of the installed package, looked up when it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        """Print the version and exit."""
        found = version()
        print(f"inertial-pair {found}" if found else "inertial-pair, not installed (running from its sources)")
        parser.exit(OK)


def version() -> str:
    """Return the version of the installed package, "" where it runs from its sources."""
    from importlib import metadata

    try:
        return metadata.version("inertial-pair")
    except metadata.PackageNotFoundError:
        return ""


class OneLineParser(argparse.ArgumentParser):
    """A parser, with its subparsers, that reports bad usage in one line on stderr; --help shows the usage.

    What begins with a minus and a digit is a number, also where it has an exponent: no flag is named so.
    """

    def __init__(self, *given: Any, **named: Any) -> None:
        """Take what argparse takes."""
        super().__init__(*given, **named)
        self._negative_number_matcher = re.compile(r"-\.?\d")

    def _flags(self) -> list[str]:
        """Return the flags of all commands."""
        commands = [one.choices for one in self._actions if isinstance(one, argparse._SubParsersAction)]
        flags = (flag for some in commands for one in some.values() for flag in one._option_string_actions)
        return sorted({f"--{flag.strip('-')}" for flag in flags})

    def error(self, message: str) -> NoReturn:
        """Print the one error line, with the nearest word for one that is mistyped, and exit with USAGE."""
        more = "--help lists the options"
        if found := re.search(r"invalid choice: '([^']*)' \(choose from (.*)\)", message):
            word, known = found[1], re.findall(r"[\w-]+", found[2])
            message = f"{word!r} is not known; {right_word(word, known, more)}"
        elif found := re.match(r"unrecognized arguments: --([\w-]+)", message):
            word, known = found[1], self._flags()
            right = more if f"--{word}" in known else right_word(word.replace("-", "_"), known, more)
            message = f"--{word} is {'no option of this command' if right == more else 'not known'}: {right}"
        elif "not allowed with" in message:
            message += "; leave one of them out"
        elif message.startswith(("the following", "unrecognized")) or "expected" in message:
            message += f"; {more}"
        self.exit(refuse(message, USAGE))
