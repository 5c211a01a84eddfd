"""What a process that decides rows or draws figures may do wrong; importable by it, wherever it is started."""

import os
import signal
from multiprocessing.connection import Connection

from numerics.trade.recorded import Trade
from paper_checks.claims import claim_named
from paper_checks.reporting import parts
from paper_checks.running.plain import plain
from paper_checks.running.runner import Context, run


def dies_of_energy_rate(connection: Connection, context: Context) -> None:
    """Decide rows, and end without a word when asked for the row `energy-rate`."""
    while (name := connection.recv()) != "energy-rate":
        connection.send(plain(run([claim_named(name)], context)[0]))
    os._exit(7)


def tells_what_ctrl_c_does(connection: Connection, context: Context) -> None:
    """Answer each row with whether Ctrl-C was ignored before anything of ours ran in this process."""
    while connection.recv():
        connection.send(signal.getsignal(signal.SIGINT) is signal.SIG_IGN)


def dies_of_two_bodies(connection: Connection, trade: Trade) -> None:
    """Draw figures, and end without a word when asked for the figure `two-bodies`."""
    while (part := connection.recv()).name != "two-bodies":
        connection.send(dict(parts.made([part], trade))[part])
    os._exit(7)
