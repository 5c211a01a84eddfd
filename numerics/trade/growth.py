"""How cost grows: with digits, with the number of events, with the size of a batch and the cores, with the mass ratio.

Only our own methods are followed here; solve_many by the size of its batches. Beside the digits stands the cost of one
arb.sin_cos at the same precision, the least that a transcendental event could cost.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.telling import can_compile
from numerics.batch.parallel import available_cores
from numerics.trade import ours
from numerics.trade.child import Child, Deadline
from numerics.trade.clock import compiled_pair_seconds, timed
from numerics.trade.contender import Contender
from numerics.trade.judge import first_difference
from numerics.trade.measure import Limits, Ran, References, run
from numerics.trade.reference import POINT_DIGITS
from numerics.trade.scenes import Benchmark, of_length, of_mass_ratio, paper_scenes

PLAIN_DIGITS = 10.0
"""Digits of mpmath and balls where something else than digits grows."""


@dataclass(frozen=True)
class Growth:
    """One point of a growth curve."""

    axis: str
    """what grows: digits, events, batch, m1/m2"""
    contender: str
    x: float
    events: int | None
    seconds_per_event: float | None
    """of a batch: s per scene and core"""
    note: str = ""
    sine_cosine_seconds: float | None = None
    """along digits: one arb.sin_cos at so many digits; of the compiled path: one compiled sine-cosine pair"""
    cores: int = 1

    def as_record(self) -> dict[str, Any]:
        """Return it as the object that JSON carries."""
        record = asdict(self)
        if self.sine_cosine_seconds and self.seconds_per_event:
            record["sine_cosines_per_event"] = self.seconds_per_event / self.sine_cosine_seconds
        return record


@dataclass(frozen=True)
class Extent:
    """How far each curve is followed."""

    digits: tuple[float, ...]
    excursions: tuple[int, ...]
    batch: tuple[int, ...]
    mass_exponents: tuple[int, ...]


def sine_cosine_seconds(digits: float) -> float:
    """Return the time of one arb.sin_cos of a full-length argument, 1/sqrt(2), at so many working digits."""
    with Ball(int(digits)).context():
        angle = arb(2).rsqrt().mid()
        return timed(angle.sin_cos).seconds


def along_digits(
    child: Child, contenders: Sequence[Contender], extent: Extent, limits: Limits, source: str
) -> Iterator[Growth]:
    """Yield the time per event of the headline scene for more and more digits."""
    scene = paper_scenes()[-1]
    for contender in contenders:
        for digits in extent.digits if contender.knob == "digits" else ():
            ran = run(child, source, contender.label, scene, digits, limits)
            yield _growth("digits", contender, digits, ran, sine_cosine=sine_cosine_seconds(digits))
            if ran.seconds is None:
                break


def along_scenes(
    child: Child,
    references: References,
    axis: str,
    contenders: Sequence[Contender],
    extent: Extent,
    limits: Limits,
    source: str,
) -> Iterator[Growth]:
    """Yield the time per event along scenes with more and more events, or with one mass ratio after another."""
    scenes = list(_scenes(axis, extent))
    for contender in contenders:
        pair = compiled_pair_seconds() if contender.label == ours.COMPILED else None
        setting = PLAIN_DIGITS if contender.knob == "digits" else contender.settings[-1]
        for x, scene in scenes:
            ran = run(child, source, contender.label, scene, setting, limits)
            note = ""
            if axis == "m1/m2" and ran.outcome is not None:
                proved = references.get(scene, POINT_DIGITS)
                note = proved.note if proved.outcome is None else first_difference(ran.outcome, proved.outcome) or ""
            yield _growth(axis, contender, x, ran, note, pair)
            if axis == "events" and ran.seconds is None:
                break


def _scenes(axis: str, extent: Extent) -> Iterator[tuple[float, Benchmark]]:
    if axis == "events":
        yield from ((float(excursions), of_length(excursions)) for excursions in extent.excursions)
    else:
        yield from ((10.0**e, of_mass_ratio(Fraction(10) ** e)) for e in extent.mass_exponents)


def _growth(
    axis: str, contender: Contender, x: float, ran: Ran, note: str = "", sine_cosine: float | None = None
) -> Growth:
    events = len(ran.outcome.kinds) if ran.outcome else None
    each = ran.seconds / max(1, events) if ran.seconds is not None and events is not None else None
    # along the events, their true number is the abscissa
    x = float(events) if axis == "events" and events is not None else x
    return Growth(axis, contender.label, x, events, each, note or ran.note, sine_cosine)


def along_batches(extent: Extent) -> Iterator[Growth]:
    """Yield the time per scene of bigger and bigger batches, on one core and on all; nothing without numba."""
    scene = paper_scenes()[-1].scene
    for cores in sorted({1, available_cores()}) if can_compile() else ():
        for size in extent.batch:
            each = timed(ours.batch_call(scene, size, cores), budget=0.3).seconds / size
            note = "1 core" if cores == 1 else f"{cores} cores"
            yield Growth("batch", ours.MANY, float(size), None, each, note, cores=cores)


def growth(
    child: Child,
    references: References,
    contenders: Sequence[Contender],
    extent: Extent,
    limits: Limits,
    progress: Callable[[str], None],
    source: str,
    deadline: Deadline,
) -> Iterator[Growth]:
    """Yield every curve of the contenders that are ours, as long as there is time."""
    own = [one for one in contenders if one.ours and one.label != ours.MANY]
    curves = {
        "digits": along_digits(child, own, extent, limits, source),
        "events": along_scenes(child, references, "events", own, extent, limits, source),
        "m1/m2": along_scenes(child, references, "m1/m2", own, extent, limits, source),
        "batches": along_batches(extent),
    }
    for axis, curve in curves.items() if own else ():
        progress(f"growth along {axis}")
        while deadline.left() > 0 and (point := next(curve, None)) is not None:
            yield point
