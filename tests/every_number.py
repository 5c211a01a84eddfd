"""Every number that a run or a batch gives away, with its bound, held against the same scene in balls of more digits.

The names are those of the public attributes: one that is in no list here is an error, so that a new number cannot go
without its comparison.
"""

import math
from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from batch_numbers import row_numbers
from flint import arb
from oracle.holding import NAMES, as_printed
from reaching import LeftOut

from numerics import Batch, EventUndecided, NumericsError, Scene, Trajectory, sensitivities, solve, solve_scenes
from numerics.arithmetic.ball import Ball
from numerics.linear.record import AT
from numerics.trajectory.comparison import as_ball
from numerics.trajectory.digits import ROUNDING
from numerics.trajectory.export import as_record, knows_its_digits
from numerics.trajectory.run import run_scene

DIGITS, EVENTS, SHOWN = (60, 240, 1000), 40, 19
LEAST = arb("1e-322")
SIDES = "left", "right"
FLOWED = ("sol", "reduced")


def _names(text: str) -> set[str]:
    return set(text.split())


NO_NUMBERS = _names(
    """FORMAT ENERGIES EVENT_COLUMNS accuracy animate arithmetic bounded but certain check context digits
    end_bounds event_kinds event_rows final_mode floats frame has_critical_energy has_frame kept load
    message mode_at modes pictures pieces plot reached record restored right_digits save scene signs status success
    t_eval to_csv to_dataframe tried without_digits"""
)
"""What says how and with which digits, and what gives the numbers below once more."""
ROWS = _names(
    """row_at row_changes row_column row_excess row_excess_at row_flow row_lengths row_mode row_pieces
    row_signs row_states row_taken row_times row_values"""
)
"""Of what the numbers below are made."""
NUMBERS = _names(
    """dissipated end_numbers end_time energy energy_excess event_states event_times events final final_energy
    final_state initial ledger reduced segments sol t t_events units y y_events"""
)
NO_NUMBERS_OF_A_BATCH = _names(
    """ANSWERS certain digits event_mode inputs message mode plot results shape status success to_dataframe to_xarray
    values"""
)
NUMBERS_OF_A_BATCH = {"t", "y", "energy", "energy_excess", "dissipated", "event_t", "event_y", "events"}


class Compared(NamedTuple):
    """A number, its bound (0 for balls: their own), and the true one."""

    name: str
    value: Any
    bound: Any
    true: arb

    @property
    def ratio(self) -> float:
        """How many times its bound the error is: 0 where a ball overlaps the true one, or it is below all floats."""
        off = (as_ball(self.value) - as_ball(self.true)).abs_lower()
        if off < LEAST:
            return 0.0
        return float(off / as_ball(self.bound)) if self.bound > 0 else math.inf


def unlisted() -> set[str]:
    """The public attributes of a run and of a batch that stand in no list."""
    of_a_run = {name for name in dir(Trajectory) if name[0] != "_"} | {"arithmetic", "record", "bounded", "scene"}
    of_a_batch = {name for name in dir(Batch) if name[0] != "_" and not name.endswith("_error")}
    of_a_batch |= {name for name in Batch.__annotations__ if not name.endswith("_error")} | {"shape"}
    return of_a_run ^ (NO_NUMBERS | ROWS | NUMBERS) | of_a_batch ^ (NO_NUMBERS_OF_A_BATCH | NUMBERS_OF_A_BATCH)


Bounds = dict[str, list[float]]


class Bounded:
    """What the bounds of the states of a run in floats make of all that is formed from them; in binary64.

    Between events N (linear/kernel.py), a bound on the error of the row before, does not grow, and roundings are those
    of the terms of state and force; an integral over the motion is off by N and by roundings of the largest energy.
    """

    def __init__(self, run: Any) -> None:
        """Read them off the record."""
        self.run, rows, end, pair = run, run.record.rows, run.record.end, run.scene.pair
        self.u, self.m1, self.m2, self.a1, self.a2 = ROUNDING, *map(float, (pair.m1, pair.m2, pair.a1, pair.a2))
        self.length, self.rate, self.critical = run.floats(list(run.units))
        errors = slice(AT["x1_error"], AT["x1_error"] + 4)
        states = np.abs(run.floats(run.row_states))
        self.rows, self.late = rows[:, errors].T.copy(), rows[:, AT["late"]]
        self.rows[:, 0] = 2 * self.u * states[:, 0]
        at = [0, *run.event_rows]
        self.t, self.y, self.w = np.array([0.0, *run.accuracy.t]), self.rows[:, at], rows[at, AT["speed_error"]]
        if run.reached:
            states = np.column_stack([states, np.abs(run.floats(list(run.final_state)))])
            self.t, self.w = np.append(self.t, run.end_bounds()[0]), np.append(self.w, end[AT["speed_error"]])
            self.y = np.column_stack([self.y, run.accuracy.final])
        self.sizes, self.weights = states.max(axis=1), np.array([self.a2, self.m1, 0.0, self.m2])
        self.push = max((self._height(one) for one in run.pieces), default=0.0)
        self.held, self.lighter = max(float(one.b) for one in run.pieces), min(self.m1, self.m2)
        pull = self.a2 * self.sizes[0] + self.a1 * self.sizes[1] + self.push
        fast = (pull + self.held) / self.lighter
        self.speeds = np.array([[self.sizes[1]], [fast], [self.sizes[3]], [fast]])
        off = self.rows + self.late * self.speeds
        self.norms, self.places = np.sqrt(self.weights) @ off, off[0] + off[2]
        self.kappa = math.sqrt((self.m1 + self.m2) / self.m1 / self.m2)

    @staticmethod
    def _height(piece: Any) -> float:
        """A bound on |u| in a piece, N."""
        powers = (abs(c) * piece.length**k for k, c in enumerate(piece.polynomial))
        return float(sum(powers, sum((abs(one.amplitude) for one in piece.sines), Fraction(0))))

    def energies(self, y: Any, off: Any) -> Any:
        """Of energies of states (4, n) that are off by so much."""
        y = np.abs(self.run.floats(y))
        return self.weights @ (off * (y + off / 2) + 4 * self.u * y * y) + 1e-322

    def excesses(self, y: Any, off: Any, carried: Any) -> Any:
        """Of E/E_cr - 1 of states, carried or formed from them."""
        ratio = self.weights @ np.square(self.run.floats(y)) / 2 / self.critical
        if self.run.row_excess is None:
            return self.energies(y, off) / self.critical + 8 * self.u * (1 + ratio)
        return carried + 4 * self.u * np.abs(ratio - 1) + 1e-322

    def reduced(self, y: Any, off: Any, w: float) -> list[float]:
        """Of X, V1, V2, Z and w of a state."""
        x1, v1, x2, v2 = off + 8 * self.u * np.abs(self.run.floats(y))
        speed = self.length * self.rate
        return [x1 / self.length, v1 / speed, v2 / speed, (x1 + x2) / self.length, w]

    def flowed(self, t: Any, side: str) -> Any:
        """Of the states at times, (4, n)."""
        rows, t = self.run.row_at(t, side), np.asarray(t, float)
        starts = self.run.floats(self.run.row_times)
        since, after = t - starts[rows], np.minimum(rows + 1, len(starts) - 1)
        # at a time that the bound of an event's time reaches, the true motion may be behind the event
        is_near = (after > rows) & (starts[after] - t <= self.late[after])
        late = np.where(is_near, self.late[after], 0.0)
        pushed = self.push / self.a2 * np.array([1.0, self.rate, 1.0, self.rate])
        norm, rounding = self.norms[rows], 64 * self.u * ((self.sizes + pushed)[:, None] + 0 * t)
        moved = (8 * self.u * t + late) * self.speeds
        found = norm / np.sqrt(np.maximum(self.weights, 1e-320))[:, None] + rounding + moved
        found[2] = found[0] + self.places[rows] + self.kappa * norm * since + rounding[2] + moved[2]
        return found

    @property
    def taken(self) -> float:
        """Of friction, viscosity and work over the run, and of what is left over."""
        ledger, time, energy = self.run.ledger, float(self.run.end_time), self.energies(self.run.y, self.y).max()
        friction, viscous, work = (abs(float(one)) for one in (ledger.friction, ledger.viscous, ledger.work))
        largest = max(abs(float(ledger.initial)), abs(float(ledger.final)), friction, viscous, work)
        off, N = time / math.sqrt(self.m1), self.norms.max()
        damped = 2 * math.sqrt(viscous * self.a1 * time) * N / math.sqrt(self.m1) + self.a1 * off * off * N * N
        fastest = self.rate + self.a1 / self.lighter
        turned = 1 + fastest * time / len(self.run.record.rows)
        rounding = self.u * (largest + self.push * (self.sizes[0] + self.sizes[2])) * (64 + 8 * math.log2(turned))
        return self.push * N * off + 2 * self.held * self.kappa * N * time + damped + rounding + energy + 1e-322


def bounds_of(run: Any, times: Any) -> Bounds:
    """The bounds of `numbers_of` a run in floats."""
    own, u, y = Bounded(run), ROUNDING, run.y
    energies, excesses = own.energies(y, own.y), own.excesses(y, own.y, own.w)
    reduced = [own.reduced(*one) for one in zip(y.T, own.y.T, excesses, strict=True)]
    count = len(run.event_times)
    inner = slice(1, count + 1)
    events = [[t, *y, *r] for t, y, r in zip(own.t[inner], own.y.T[inner], reduced[inner], strict=True)]
    t_events, y_events = (run._by_kind(one) for one in (own.t[inner], own.y.T[inner]))
    late = 2 * own.late.max() + 16 * u * len(run.record.rows) * float(run.end_time)
    end = [own.y[:, -1], [energies[-1]], [excesses[-1]]]
    taken = own.taken
    each = min(taken, run.ledger.error + 1e-322)
    return {
        "t": own.t,
        "y": own.y.ravel(),
        "energy": energies,
        "energy_excess": excesses,
        "event_times": own.t[inner],
        "event_states": own.y[:, inner].ravel(),
        "t_events": np.concatenate(t_events),
        "y_events": np.concatenate([one.ravel() for one in y_events]),
        "events": np.array(events).ravel(),
        "end_time": own.t[-1:],
        "final_state": own.y[:, -1],
        "final_energy": energies[-1:],
        "final": own.y[:, -1],
        "initial": own.y[:, 0],
        "end_numbers": np.concatenate(end),
        "dissipated": [run.accuracy.dissipated],
        "ledger": [taken, taken, each, each, 6 * taken, 4 * each, each, each, each, each],
        "units": [8 * u * one for one in (own.length, own.rate, own.critical)],
        "segments": [one for segment in run.segments for one in (late, late, late, taken, taken)],
        "sol": np.concatenate([own.flowed(times, side).ravel() for side in SIDES]),
        "reduced": np.concatenate([_reduced(own, times, side) for side in SIDES]),
    }


def _reduced(own: Bounded, times: Any, side: str) -> list[float]:
    found: list[float] = []
    off, carried = own.flowed(times, side), np.nanmax(own.w, initial=0.0)
    y = own.run.floats(own.run.sol(times, side))
    ws = own.excesses(y, off, carried + own.taken / own.critical)
    for one in zip(y.T, off.T, ws, strict=True):
        found += own.reduced(*one)
    return found


def numbers_of(run: Any, times: Any) -> dict[str, list[Any]]:
    """All numbers of a run by the names of its attributes, flat; `sol` and `reduced` at times, from both sides."""
    with run.context():
        found = {name: getattr(run, name) for name in sorted(NUMBERS)} | {
            "end_numbers": run.end_numbers(),
            "sol": [run.sol(times, side) for side in SIDES],
            "reduced": [run.reduced(t, side) for side in SIDES for t in times],
            "segments": [(one.start, one.end, one.length, *one.losses()) for one in run.segments],
            "events": [(one.t, one.y, one.reduced) for one in run.events],
            "ledger": [getattr(run.ledger, one) for one in run.ledger.__slots__ if one != "error"],
        }
        return {name: list(_flat(one)) for name, one in found.items()}


def _flat(given: Any) -> Any:
    if isinstance(given, tuple | list | np.ndarray):
        for one in given.ravel() if isinstance(given, np.ndarray) else given:
            yield from _flat(one)
    else:
        yield given


def compared(scene: Scene, arithmetic: str) -> tuple[Trajectory, list[Compared]]:
    """A run, and every number of it and of a batch against the true ones.

    Raises LeftOut where nothing is sure, and where there are no reduced coordinates.
    """
    try:
        run = solve(scene, arithmetic=arithmetic, max_events=EVENTS)
    except NumericsError:
        raise LeftOut from None
    if not (run.certain and run.has_frame):
        raise LeftOut
    rows = against(run, truth := solved_truly(scene))
    if arithmetic == "float64":
        with truth.context():
            batch = solve_scenes([scene], max_events=EVENTS, keep_events=EVENTS)
            rows += claimed(run, batch_held(batch, 0, truth))
    return run, rows


def against(run: Trajectory, truth: Trajectory) -> list[Compared]:
    """Every number of a run against the true ones, at times between and at the events."""
    assert (run.modes, run.event_kinds) == (truth.modes, truth.event_kinds)
    end = Fraction(min(float(one.floats(one.end_time)) for one in (run, truth)))
    events = [Fraction(t) for t in run.floats(run.event_times)[:SHOWN].tolist()]
    shares = [Fraction(k, 7) * end for k in range(8)]
    times = [t for t in sorted([*shares, *events]) if t <= min(end, run.scene.until)]
    with truth.context(), np.errstate(all="ignore"):
        rows = held(run, truth, times)
    return claimed(run, rows)


def claimed(run: Trajectory, rows: list[Compared]) -> list[Compared]:
    """Those that claim something: a bound that is infinite, or no number, does not.

    Such a run has no right digit, or what is bounded is the state at a time within the error of an event.
    """
    claims_nothing = {row for row in FLOWED if run.bounded} | {row.name for row in rows if run.without_digits}
    return [one for one in rows if not (one.name in claims_nothing and not one.bound < math.inf)]


def solved_truly(scene: Scene) -> Trajectory:
    """A scene in balls of as many digits as decide its events. Raises LeftOut where none do."""
    for digits in DIGITS:
        with suppress(EventUndecided):
            return run_scene(scene, Ball(digits), EVENTS)
    raise LeftOut


def held(run: Any, truth: Any, times: Any) -> list[Compared]:
    """Every number of a run against the true ones; of printed numbers the text is held, in units of its last place."""
    found, true = numbers_of(run, times), numbers_of(truth, times)
    bounds = bounds_of(run, times) if run.bounded else {name: [0.0] * len(one) for name, one in found.items()}
    assert {name: len(one) for name, one in found.items()} == {name: len(one) for name, one in true.items()}
    rows = [Compared(name, *one) for name in found for one in zip(found[name], bounds[name], true[name], strict=True)]
    return rows + (list(_printed(as_record(run), truth)) if knows_its_digits(run) else [])


def _printed(record: dict[str, Any], truth: Any) -> Iterator[Compared]:
    """The numbers of a JSON record, of which all others that are printed are made."""
    with truth.context():
        true = [(one.t, *one.y) for one in truth.events] + [(truth.end_time, *truth.end_numbers())]
    for row, its in zip((*record["events"], record["final"]), true, strict=True):
        for name, value in zip(NAMES, its, strict=False):
            yield Compared(f"printed {name}", *as_printed(row, name), value)


def derivatives(run: Any, truth: Any) -> list[Compared]:
    """Every derivative, right to the digits of its arithmetic, relative to the largest of its kind."""
    found, true, rows = sensitivities(run), sensitivities(truth), []
    assert found.wrt == true.wrt
    for name in ("t", "y", "final", "energy"):
        got, its = getattr(found, name), getattr(true, name)
        rows += [Compared(f"derivative of {name}", *one) for one in _paired(run, got, its)]
    return rows


def _paired(run: Any, got: Any, its: Any) -> Any:
    if not got.size:
        return []
    sizes = np.vectorize(lambda one: float(abs(one).upper()), otypes=[float])(its)
    largest = np.broadcast_to(sizes.max(axis=0) if sizes.ndim > 1 else sizes, sizes.shape)
    unit = 0.0 if run.arithmetic.name == "ball" else 10.0 ** -min(run.arithmetic.digits, 31)
    return zip(got.ravel(), unit * largest.ravel(), its.ravel(), strict=True)


def batch_held(batch: Batch, row: int, truth: Any) -> list[Compared]:
    """Every number of a row of a batch."""
    if not batch.certain[row]:
        return []
    return [Compared(f"{name} of a batch", *rest) for name, *rest in row_numbers(batch, row, truth)]
