"""A viscous run in one row of an array, as packed.py has it for undamped ones: same places for what both have.

Columns of a state: 0-7 the pair, 8-19 the start of the present motion, 20-27 its errors, 34 the worst relative error,
35 the reduced horizon, 36 the events so far, 37 how the run ended. Columns of an answer: those of packed.py; where the
row is longer, what viscosity has taken from E/E_cr and a bound on its error follow.
"""

from __future__ import annotations

import math
from typing import Any

from numerics.kernel.compilation import kernel
from numerics.kernel.packed import ANSWER, EVENTS, HORIZON, HOW, WORST
from numerics.kernel.state import EVENT_LIMIT, OUT_OF_RANGE, ROWS_FULL
from numerics.kernel.viscous_bounds import Errors
from numerics.kernel.viscous_end import at_event, at_horizon
from numerics.kernel.viscous_motion import run
from numerics.kernel.viscous_oscillator import oscillator
from numerics.kernel.viscous_state import Start, ViscousPair

DAMPED_ANSWER = ANSWER + 2
"""Length of an answer with viscosity in it."""


@kernel
def viscous_pair(
    q: float,
    r: float,
    two_zeta: float,
    literal: bool,
    stick: tuple[int, float],
    slip: tuple[int, float],
) -> ViscousPair:
    """Return the pair with (regime, frequency) of both oscillators, the rest of which follows (viscous.py)."""
    stick_oscillator = oscillator(two_zeta / 2, 1.0, stick[0], stick[1])
    slip_oscillator = oscillator(two_zeta / 2 / q, 1 / q, slip[0], slip[1])
    return ViscousPair(q, r, two_zeta, literal, stick_oscillator, slip_oscillator)


@kernel
def pack(s: Any, pair: ViscousPair, start: Start, errors: Errors, worst: float) -> None:
    """Write a run into a row; horizon, events and ending are left as they are."""
    s[0], s[1], s[2], s[3] = pair.q, pair.r, pair.two_zeta, 1.0 if pair.literal else 0.0
    s[4], s[5] = pair.stick.regime, pair.stick.frequency
    s[6], s[7] = pair.slip.regime, pair.slip.frequency
    s[8], s[9], s[10], s[11], s[12], s[13] = start.mode, start.X, start.V1, start.V2, start.Z, start.w
    s[14], s[15] = 1.0 if start.rising else 0.0, 1.0 if start.level else 0.0
    s[16], s[17], s[18], s[19] = start.tau, start.rest, start.spent, start.damped
    s[20], s[21], s[22], s[23] = errors.late, errors.norm, errors.x, errors.v
    s[24], s[25], s[26], s[27] = errors.place, errors.w, errors.slide, errors.damped
    s[WORST] = worst


@kernel
def pair_of(s: Any) -> ViscousPair:
    """Return the pair of a row."""
    literal, stick, slip = s[3] != 0.0, (int(s[4]), float(s[5])), (int(s[6]), float(s[7]))
    return viscous_pair(float(s[0]), float(s[1]), float(s[2]), literal, stick, slip)


@kernel
def start_of(s: Any) -> Start:
    """Return the start of the present motion of a row."""
    mode, rising, level = int(s[8]), s[14] != 0.0, s[15] != 0.0
    X, V1, V2, Z, w = float(s[9]), float(s[10]), float(s[11]), float(s[12]), float(s[13])
    return Start(mode, X, V1, V2, Z, w, rising, level, float(s[16]), float(s[17]), float(s[18]), float(s[19]))


@kernel
def errors_of(s: Any) -> Errors:
    """Return the errors at the start of the present motion of a row."""
    late, norm, x, v = float(s[20]), float(s[21]), float(s[22]), float(s[23])
    return Errors(late, norm, x, v, float(s[24]), float(s[25]), float(s[26]), float(s[27]))


@kernel
def advance(s: Any, max_events: int, rows: Any) -> int:
    """Run a row until it ends or `rows` is full; return how many rows were written (viscous_motion.run)."""
    pair, start, errors = pair_of(s), start_of(s), errors_of(s)
    left = max_events - int(s[EVENTS])
    how, count, start, errors, worst = run(pair, start, errors, float(s[HORIZON]), left, rows, float(s[WORST]))
    pack(s, pair, start, errors, worst)
    s[EVENTS] += count
    s[HOW] = how
    return count


@kernel
def answer(s: Any, end: Any) -> None:
    """Write the end of a run that is over; nan where it left the range."""
    how, start, errors, horizon, worst = int(s[HOW]), start_of(s), errors_of(s), float(s[HORIZON]), float(s[WORST])
    if how in (EVENT_LIMIT, ROWS_FULL):
        found, tau = at_event(pair_of(s), start, errors, worst), start.tau
    else:
        found, tau = at_horizon(pair_of(s), start, errors, horizon, worst), horizon
    at = found.end
    end[0], end[1], end[2], end[3], end[4], end[5], end[6] = at.mode, at.X, at.V1, at.V2, at.Z, at.w, at.spent
    end[7], end[8], end[9], end[10] = at.x_error, at.v1_error, at.v2_error, at.place_error
    end[11], end[12], end[13] = at.w_error, at.spent_error, at.worst
    if len(end) >= DAMPED_ANSWER:
        end[18], end[19] = found.damped, found.damped_error
    if how == OUT_OF_RANGE:
        for column in range(len(end)):
            end[column] = math.nan
    end[14], end[15], end[16], end[17] = 1.0 if at.certain and how != OUT_OF_RANGE else 0.0, s[EVENTS], how, tau


@kernel
def run_keeping(states: Any, max_events: int, answers: Any, kept: Any, nothing: Any) -> None:
    """Run every row of `states` to its end and keep its first events in `kept` (rows, events, COLUMNS).

    `nothing` is an empty array of rows.
    """
    for index in range(len(states)):
        if states[index, HOW] >= 0.0:  # a row that could not be prepared has -1
            advance(states[index], max_events, kept[index])
            if states[index, HOW] == ROWS_FULL:
                advance(states[index], max_events, nothing)
            answer(states[index], answers[index])
