# PYTHON_ARGCOMPLETE_OK
"""Command line: python -m numerics solve SCENE [--digits N] [--arithmetic A] [--json | --csv | --npz F | --plot F]."""

from __future__ import annotations

import argparse
import importlib.util
import sys
from collections.abc import Sequence

from numerics.cli.arguments import parser
from numerics.exits import (
    FAILED,
    INTERRUPTED,
    OK,
    USAGE,
    complete,
    drop_output,
    missing,
    open_streams,
    refuse,
    wrong_path,
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    open_streams()
    known = parser()
    complete(known)
    options = known.parse_args(arguments)
    from numerics.errors import InvalidScene, MissingTool, NoForceHere, NumericsError
    from numerics.files import cache_refused

    if refused := cache_refused():
        print(refused, file=sys.stderr)

    try:
        said = _wrong_path(options)
        for module in options.needs if said is None else ():
            if importlib.util.find_spec(module) is None:
                raise MissingTool(missing(module))
        code: int = options.run(options) if said is None else refuse(said, USAGE)
        sys.stdout.flush()  # here a full disk or a reader that left can still be answered
        return code
    except NumericsError as error:
        return refuse(str(error), USAGE if isinstance(error, (InvalidScene, NoForceHere)) else FAILED)
    except BrokenPipeError:
        drop_output()  # the reader left; nothing more can be said
        return OK
    except OSError as error:
        file = error.filename2 or error.filename
        if file is None:
            drop_output()
        code = FAILED if file is None else USAGE
        return refuse(f"cannot write {file or 'the output'}: {error.strerror}", code)
    except ModuleNotFoundError as error:
        if error.name is None or error.name.startswith("numerics"):
            raise
        return refuse(missing(error.name), FAILED)
    except KeyboardInterrupt:
        return refuse("interrupted; nothing was written", INTERRUPTED)


def _wrong_path(options: argparse.Namespace) -> str | None:
    """Return what is wrong with a file to be written; a figure needs matplotlib."""
    for name in ("npz", "proof", "resume", "out", "plot"):
        path, is_figure = getattr(options, name, None), name in options.figures
        if path is not None and is_figure:
            options.needs = (*options.needs, "matplotlib")
        said = wrong_path(path, f"--{name}" if is_figure else "")
        if said is not None:
            return said
    return None


if __name__ == "__main__":
    sys.exit(main())
