"""The work on one chunk of a batch: prepare its rows, run the kernels that each of them needs, collect the answers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from numerics.errors import OutOfRange
from numerics.kernel import packed, prepare, viscous_motion, viscous_packed, viscous_prepare
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.state import COLUMNS, OUT_OF_RANGE, ROWS_FULL, End
from numerics.motion.frame import Frame
from numerics.old.binary64 import kernel_start
from numerics.old.binary64_viscous import viscous_start
from numerics.scene import Law, Pair, Scene, State

Table = NDArray[np.float64]
ANSWERS = (*End._fields, "events", "how", "tau", "damped", "damped_error")
"""The columns of the answers, undamped or not."""
EVENTS = ("mode", "tau", "X", "V", "Z", "late", "x", "v", "place")
"""The columns of the kept events."""
ROW_ORDER = ("m1", "m2", "a2", "b", "x1", "v1", "x2", "v2", "until", "a1")
"""The columns of a table of scenes, as the kernels that prepare them want them."""


class Engine(NamedTuple):
    """The kernels for undamped or for viscous scenes, and what their rows are."""

    prepare_all: Callable[..., None]
    run_keeping: Callable[..., None]
    advance: Callable[..., int]
    answer: Callable[..., None]
    start: Callable[[Scene], tuple[Frame, Any, Table]]
    answers: int
    columns: tuple[str, ...]


UNDAMPED = Engine(
    prepare.prepare_all,
    packed.run_keeping,
    packed.advance,
    packed.answer,
    kernel_start,
    packed.ANSWER,
    COLUMNS,
)
VISCOUS = Engine(
    viscous_prepare.prepare_all,
    viscous_packed.run_keeping,
    viscous_packed.advance,
    viscous_packed.answer,
    viscous_start,
    viscous_packed.DAMPED_ANSWER,
    viscous_motion.COLUMNS,
)


class Solved(NamedTuple):
    """A chunk that is done: its first row, answers (n, ANSWERS), kept events (n, k, EVENTS), units (3, n).

    The units are length (m), rate (1/s) and critical energy (J).
    """

    first: int
    answers: Table
    kept: Table
    units: Table


def solve_table(chunk: tuple[int, Table], *, literal: bool, max_events: int, keep: int) -> Solved:
    """Solve a table of binary64 numbers (n, ROW_ORDER)."""
    first, table = chunk
    solved = _empty(first, len(table), keep)
    viscous = table[:, ROW_ORDER.index("a1")] > 0
    for engine, rows in ((UNDAMPED, np.flatnonzero(~viscous)), (VISCOUS, np.flatnonzero(viscous))):
        if len(rows):
            states = np.zeros((len(rows), packed.STATE))
            compiled(engine.prepare_all)(np.ascontiguousarray(table[rows]), literal, states)
            for index in np.flatnonzero(states[:, packed.HOW] < 0):
                _prepare_exactly(engine, _scene(table[rows[index]], literal), states[index])
            _run(engine, states, max_events, solved, rows)
    m1, m2, a2, b = table.T[:4]
    with np.errstate(all="ignore"):
        width = b * (m1 + m2) / (a2 * m2)
        solved.units[:] = width, np.sqrt(a2 / (m1 + m2)), 0.5 * a2 * width * width
    return solved


def solve_exact(chunk: tuple[int, Sequence[Scene]], *, max_events: int, keep: int) -> Solved:
    """Solve scenes of exact decimals."""
    first, scenes = chunk
    solved = _empty(first, len(scenes), keep)
    viscous = np.array([scene.pair.a1 > 0 for scene in scenes])
    for engine, rows in ((UNDAMPED, np.flatnonzero(~viscous)), (VISCOUS, np.flatnonzero(viscous))):
        states = np.zeros((len(rows), packed.STATE))
        for index, row in enumerate(rows):
            frame = _prepare_exactly(engine, scenes[int(row)], states[index])
            if frame is not None:
                solved.units[:, row] = frame.length, frame.rate, frame.critical_energy
        _run(engine, states, max_events, solved, rows)
    return solved


def _empty(first: int, count: int, keep: int) -> Solved:
    answers = np.full((count, len(ANSWERS)), np.nan)
    return Solved(first, answers, np.full((count, keep, len(EVENTS)), np.nan), np.full((3, count), np.nan))


def _scene(row: Table, literal: bool) -> Scene:
    m1, m2, a2, b, x1, v1, x2, v2, until, a1 = (Fraction(float(number)) for number in row)
    law = Law.THREE_VALUED_SGN if literal else Law.FILIPPOV
    return Scene(Pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, law)


def _prepare_exactly(engine: Engine, scene: Scene, state: Table) -> Frame | None:
    """Write the start of a scene by exact rationals and return its frame; None where float64 cannot hold it."""
    try:
        frame, _, state[:] = engine.start(scene)
    except OutOfRange:
        state[packed.HOW] = -1.0
        return None
    return frame


def _run(engine: Engine, states: Table, max_events: int, solved: Solved, rows: NDArray[np.intp]) -> None:
    """Run all rows of an engine and write their answers and kept events to these rows of the chunk."""
    answers = np.full((len(states), engine.answers), np.nan)
    kept = np.full((len(states), solved.kept.shape[1], len(engine.columns)), np.nan)
    nothing = np.empty((0, len(engine.columns)))
    if can_compile():
        compiled(engine.run_keeping)(states, max_events, answers, kept, nothing)
    else:
        for index in np.flatnonzero(states[:, packed.HOW] >= 0):
            _run_plainly(engine, states[index].tolist(), max_events, answers[index], kept[index], nothing)
    out = np.isnan(answers[:, ANSWERS.index("how")])
    answers[out, ANSWERS.index("certain")] = answers[out, ANSWERS.index("events")] = 0.0
    answers[out, ANSWERS.index("how")] = OUT_OF_RANGE
    solved.answers[rows, : engine.answers] = answers
    if engine is UNDAMPED:
        solved.answers[rows, engine.answers :] = 0.0
    solved.kept[rows] = kept[:, :, [engine.columns.index(name) for name in EVENTS]]


def _run_plainly(
    engine: Engine, state: list[float], max_events: int, answer: Table, kept: Table, nothing: Table
) -> None:
    """Run one row without numba; plain Python raises where compiled code has nan, and the row is out of range too."""
    end = [0.0] * engine.answers
    try:
        engine.advance(state, max_events, kept)
        if state[packed.HOW] == ROWS_FULL:
            engine.advance(state, max_events, nothing)
        engine.answer(state, end)
    except (ArithmeticError, ValueError):
        return
    answer[:] = end
