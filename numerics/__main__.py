# PYTHON_ARGCOMPLETE_OK
"""Command line: python -m numerics solve SCENE [--digits N] [--arithmetic A] [--json | --csv | --npz F | --plot F]."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

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
    tool,
    wrong_path,
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    open_streams()
    known = parser()
    complete(known)
    options = known.parse_args(arguments)
    from numerics.errors import InvalidScene, NoForceHere, NumericsError
    from numerics.files import cache_refused

    if refused := cache_refused():
        print(refused, file=sys.stderr)
    needs = {"matplotlib": getattr(options, options.figure or "", None), "rich": options.command == "trade"}
    try:
        for name, given in vars(options).items():
            if isinstance(given, Path) and (wrong := wrong_path(given, f"--{name}" if name == options.figure else "")):
                known.error(wrong)
        for module, is_needed in needs.items():
            if is_needed:
                tool(module)
        code: int = options.run(options)
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
        return refuse("interrupted; no file was written", INTERRUPTED)


if __name__ == "__main__":
    sys.exit(main())
