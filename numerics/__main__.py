"""Command line: python -m numerics solve SCENE [--digits N] [--arithmetic A] [--json | --csv | --npz F | --plot F]."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from numerics.cli.arguments import parser
from numerics.exits import FAILED, INTERRUPTED, OK, USAGE, drop_output, refuse, wrong_path


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    options = parser().parse_args(arguments)
    from numerics.errors import InvalidScene, NoForceHere, NumericsError
    from numerics.files import cache_refused

    if refused := cache_refused():
        print(refused, file=sys.stderr)

    files = {name: getattr(options, name, None) for name in ("npz", "proof", "resume", "out", "plot")}
    wrong = (wrong_path(one, f"--{name}" if name in options.figures else "") for name, one in files.items())
    try:
        said = next(filter(None, wrong), None)
        code: int = options.run(options) if said is None else refuse(said, USAGE)
        sys.stdout.flush()  # here a full disk or a reader that left can still be answered
        return code
    except (InvalidScene, NoForceHere) as error:
        return refuse(str(error), USAGE)
    except NumericsError as error:
        return refuse(str(error), FAILED)
    except BrokenPipeError:
        drop_output()  # the reader left; nothing more can be said
        return OK
    except OSError as error:
        file = error.filename2 or error.filename
        if file is None:
            drop_output()
        code = FAILED if file is None else USAGE
        return refuse(f"cannot write {file or 'the output'}: {error.strerror}", code)
    except KeyboardInterrupt:
        return refuse("interrupted; nothing was written", INTERRUPTED)


if __name__ == "__main__":
    sys.exit(main())
