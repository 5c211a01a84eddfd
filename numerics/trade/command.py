"""What `python -m numerics trade` does; all heavy imports happen here, when it runs."""

from __future__ import annotations

import argparse
import json
import sys

from numerics.faces.commands import OK, USAGE, refuse


def measure_trade(options: argparse.Namespace) -> int:
    """Measure speed against accuracy; print tables or JSON, write the figures."""
    from numerics.faces import plot
    from numerics.trade.plan import NoSuchContender, trade
    from numerics.trade.table import as_record, print_trade

    out = options.out
    if out is not None and not out.parent.is_dir():
        return refuse(f"folder {str(out.parent)!r} does not exist; make it, or write elsewhere", USAGE)
    if out is not None and out.suffix not in plot.FORMATS:
        return refuse(f"--out {out.name}: the name must end in one of {', '.join(plot.FORMATS)}", USAGE)
    shown = sys.stderr.isatty()
    try:
        found = trade(options.size, options.only, _told if shown else lambda _: None)
    except NoSuchContender as error:
        return refuse(str(error), USAGE)
    finally:
        if shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
    if out is not None:
        from numerics.trade.figure import write_figures

        write_figures(found, out)
    if options.json:
        print(json.dumps(as_record(found), indent=1))
    else:
        print_trade(found, None if sys.stdout.isatty() else 200)
    return OK


def _told(what: str) -> None:
    print(f"\r\033[K{what}", end="", file=sys.stderr, flush=True)
