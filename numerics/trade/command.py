"""What `python -m numerics trade` does; all heavy imports happen here, when it runs."""

from __future__ import annotations

import argparse
import json
import sys

from numerics.exits import OK, USAGE, refuse, wrong_path


def measure_trade(options: argparse.Namespace) -> int:
    """Measure speed against accuracy, or the interface alone; print tables or JSON, write the figures."""
    from numerics.trade.plan import NoSuchContender, trade
    from numerics.trade.table import as_record, print_trade

    if wrong := wrong_path(options.out, "--out"):
        return refuse(wrong, USAGE)
    width = None if sys.stdout.isatty() else 200
    if options.interface:
        return _tell_interface(options.json, width)
    shown = sys.stderr.isatty()
    try:
        found = trade(options.size, options.only, _told if shown else lambda _: None)
    except NoSuchContender as error:
        return refuse(str(error), USAGE)
    finally:
        if shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
    if options.out is not None:
        from numerics.trade.figure import write_figures

        write_figures(found, options.out)
    if options.json:
        print(json.dumps(as_record(found), indent=1))
    else:
        print_trade(found, width)
    return OK


def _tell_interface(as_json: bool, width: int | None) -> int:
    from numerics.trade.interface import interface
    from numerics.trade.table import print_interface

    found = interface(0.3, compilation=True)
    if as_json:
        print(json.dumps([one.as_record() for one in found], indent=1))
    else:
        print_interface(found, width)
    return OK


def _told(what: str) -> None:
    print(f"\r\033[K{what}", end="", file=sys.stderr, flush=True)
