"""A trajectory as a theorem for the proof kernel: its events, proved for every motion of the scene (`solve --proof`).

Only modes and rough times are taken from the trajectory. Roots are found again here and bounded by intervals; nothing
of it is trusted: the kernel's program (Trajectory.v) accepts the file only if all of it is true.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

from mpmath.ctx_iv import MPIntervalContext
from mpmath.ctx_mp import MPContext

from numerics.errors import NoProof
from numerics.linear.modes import Mode
from numerics.scene import Law, Scene
from numerics.scene.decimals import decimal_text
from numerics.trajectory.closed_forms import ClosedForms, Value, Wave
from numerics.trajectory.export import arrays
from numerics.trajectory.solution import Solution

SHOWN = 12
"""Digits of the bounds in a theorem, of the greatest time, place or velocity."""
SIGN_BITS, DEPTH = 32, 30
"""In what precision the kernel shows that no event was passed, and how often it halves an interval for that."""
STATE_BITS = (64, 96, 128, 192, 256, 384, 512, 768, 1024)
"""The precisions of states that are tried."""


class _TooCoarse(Exception):
    """The boxes have grown too large: more bits are needed."""


class _State(NamedTuple):
    """Place of body 1 and both velocities, over points and over intervals."""

    points: tuple[Value, Value, Value]
    boxes: tuple[Value, Value, Value]


class _Places(NamedTuple):
    """How many decimal places are shown of a time (s), a place (m) and a velocity (m/s)."""

    time: int
    place: int
    speed: int


def theorem(trajectory: Solution) -> str:
    """Return the text of a proof file: the theorem `trajectory`, of every motion of the scene.

    Raises NoProof, in a sentence, for a scene that the checker does not cover, and for a run without certain events.
    """
    scene = trajectory.scene
    if reason := _uncovered(trajectory):
        raise NoProof(f"no theorem is written: {reason}")
    table = arrays(trajectory)
    greatest = float(scene.until), abs(table["y"][0]).max(), abs(table["y"][[1, 3]]).max()
    places = _Places(*(SHOWN - (math.ceil(math.log10(size)) if size else 0) for size in greatest))
    times = [float(one) for one in table["t"][1:]]
    for bits in STATE_BITS:
        try:
            return _Writer(scene, places, bits).text(trajectory.modes, times)
        except _TooCoarse:
            continue
    raise NoProof(f"no theorem is written: {STATE_BITS[-1]} bits are too few for {len(times)} events; shorten until")


def _uncovered(trajectory: Solution) -> str:
    """Return why the checker does not cover a trajectory, or nothing."""
    scene, at = trajectory.scene, trajectory.scene.initial
    if scene.is_forced:
        return "the checker does not cover a force, or a friction that is not one number b, yet"
    if scene.law is not Law.FILIPPOV:
        return 'the checker knows the law "filippov" only'
    if not trajectory.success:
        return f"the run {trajectory.message}"
    if at.v1 == at.v2 and at.v1 == scene.pair.a1 == 0 and abs(at.x1) == scene.pair.half_width:
        return "at rest on an edge of the sliding region the checker does not decide what follows"
    if scene.pair.a1 == 0 and at.v1 == at.v2 and scene.energy_excess == 0:
        return "with exactly the critical energy the checker does not decide what follows"
    return ""


class _Writer:
    """The proof file of one scene with states of so many bits."""

    def __init__(self, scene: Scene, places: _Places, bits: int) -> None:
        self.scene, self.places, self.bits = scene, places, bits
        self.points, self.boxes = MPContext(), MPIntervalContext()
        self.points.prec, self.boxes.prec = 2 * bits, bits
        self.sharp, self.wide = ClosedForms(self.points, scene.pair), ClosedForms(self.boxes, scene.pair)

    def text(self, modes: tuple[Mode, ...], times: list[float]) -> str:
        """Return the file; the last of the times is the end."""
        at = self._start()
        now, before, events, hints = self.boxes.mpf(0), 0.0, [], []
        for mode, after, time in zip(modes, modes[1:], times, strict=False):
            k = mode.sign or after.sign
            low, high = self._bracket(time - before, *self._guards(mode, k, at))
            at, now, before = self._moved(mode, k, at, low, high), now + self._between(low, high), time
            bounds = self._bounds((now, *at.boxes[:2]), self.places)
            events.append(f"Event {_said(mode)} {bounds}")
            hints.append(f"Hint {_number(low)} {_number(high)} {_truth(k > 0)}")
        left = self.wide.number(self.scene.until) - now
        if not left > 0:  # the last event may be at the end
            raise _TooCoarse
        least = _outward(left, int(self.bits * 0.3))[1]
        self._require_room(modes[-1], at, least)
        hints.append(f"Hint {_number(least)} {_number(least)} true")
        place, speed = self.places.place, self.places.speed
        ends = self._bounds(self._end(modes[-1], at, left), (place, speed, speed, speed))
        return TEXT.format(
            scene=" ".join(map(_number, self._numbers())),
            events=f"[\n  {events_text}]" if (events_text := ";\n  ".join(events)) else "[]",
            ending=f"Ending {_said(modes[-1])} {_number(self.scene.until)} {ends}",
            hints=";\n  ".join(hints),
            state=self.bits,
            sign=SIGN_BITS,
            depth=DEPTH,
        )

    def _numbers(self) -> Iterator[Fraction]:
        pair, at = self.scene.pair, self.scene.initial
        yield from (pair.m1, pair.m2, pair.a1, pair.a2, pair.b, at.x1, at.v1, at.v2)

    def _start(self) -> _State:
        at = self.scene.initial
        numbers = (at.x1, at.v1, at.v2)
        return _State(tuple(map(self.sharp.number, numbers)), tuple(map(self.wide.number, numbers)))

    def _guards(self, mode: Mode, k: int, at: _State) -> tuple[Wave, Wave]:
        """Return what is positive until a phase ends, over points and over intervals."""
        if mode is Mode.STICK:
            return self.sharp.grip(k, *at.points[:2]), self.wide.grip(k, *at.boxes[:2])
        return self.sharp.guard(k, *at.points), self.wide.guard(k, *at.boxes)

    def _bracket(self, guess: float, sharp: Wave, wide: Wave) -> tuple[Fraction, Fraction]:
        """Return decimals around the root of a falling wave, sure for every state of the boxes."""
        slope, root = sharp.slope(), self.points.mpf(guess)
        for _ in range(60):
            step = sharp(root) / slope(root)
            root -= step
            if abs(step) < abs(root) * self.points.mpf(2) ** (-1.8 * self.bits):
                break
        places = int(self.bits * 0.301) - math.floor(math.log10(guess))
        centre, steps = int(self.points.nint(root * self.points.mpf(10) ** places)), 1
        while True:
            if Fraction(steps, 10**places) > Fraction(1, 10**self.places.time):
                raise _TooCoarse
            low, high = (Fraction(centre + by, 10**places) for by in (-steps, steps))
            if wide(self.wide.number(low)) > 0 and wide(self.wide.number(high)) < 0:
                spare = Fraction((steps + 7) // 8, 10**places)  # the kernel's bounds are not these to the last bit
                return low - spare, high + spare
            steps += (steps + 3) // 4

    def _require_room(self, mode: Mode, at: _State, least: Fraction) -> None:
        """Raise _TooCoarse unless the last mode surely lasts to the end."""
        signs = (1, -1) if mode is Mode.STICK else (mode.sign,)
        guards = (self._guards(mode, k, at)[1](self.wide.number(least)) for k in signs)
        if not all(guard > 0 for guard in guards):
            raise _TooCoarse

    def _between(self, low: Fraction, high: Fraction) -> Value:
        ends = self.wide.number(low), self.wide.number(high)
        return self.boxes.mpf([ends[0].a, ends[1].b])

    def _moved(self, mode: Mode, k: int, at: _State, low: Fraction, high: Fraction) -> _State:
        """Return the state at the end of a phase."""
        found = []
        u = self.sharp.number((low + high) / 2), self._between(low, high)
        for forms, (x1, v1, v2), length in zip((self.sharp, self.wide), at, u, strict=True):
            if mode is Mode.STICK:
                v = forms.stuck(x1, v1).slope()(length)
                found.append((forms.edge(k, v), v, v))
            else:
                v = forms.driven(k, v2, length)
                found.append((forms.slide(k, x1, v1)(length), v, v))
        return _State(*found)

    def _end(self, mode: Mode, at: _State, left: Value) -> tuple[Value, ...]:
        """Return place, velocities and relative velocity at the end."""
        x1, v1, v2 = at.boxes
        if mode is Mode.STICK:
            path = self.wide.stuck(x1, v1)
            return path(left), path.slope()(left), path.slope()(left), self.boxes.mpf(0)
        path, k = self.wide.slide(mode.sign, x1, v1), mode.sign
        return path(left), path.slope()(left), self.wide.driven(k, v2, left), k * self.wide.guard(k, x1, v1, v2)(left)

    def _bounds(self, boxes: tuple[Value, ...], places: tuple[int, ...]) -> str:
        """Return decimal bounds of each box; raises _TooCoarse for one wider than the last place shown."""
        found = []
        for box, shown in zip(boxes, places, strict=True):
            low, high = _outward(box, shown)
            if high - low > Fraction(3, 10**shown):
                raise _TooCoarse
            found.append(f"({decimal_text(low)}, {decimal_text(high)})")
        return "\n    ".join((" ".join(found[:2]), " ".join(found[2:])))


def _outward(box: Any, places: int) -> tuple[Fraction, Fraction]:
    """Return decimals with so many places around an interval."""
    low, high = (Fraction((-1) ** sign * int(man)) * Fraction(2) ** exponent for sign, man, exponent, _ in box._mpi_)
    unit = Fraction(10) ** places
    return math.floor(low * unit) / unit, math.ceil(high * unit) / unit


def _number(value: Fraction) -> str:
    """Return an exact number in the kernel's words."""
    text = decimal_text(value)
    if "/" in text:
        return f"({value.numerator} # {value.denominator})"
    return text if text[0] != "-" else f"({text})"


def _said(mode: Mode) -> str:
    return "Stick" if mode is Mode.STICK else f"(Slip {_truth(mode is Mode.SLIP_PLUS)})"


def _truth(value: bool) -> str:
    return "true" if value else "false"


TEXT = """(** Written by `python -m numerics solve --proof`: the events of a scene, proved for every motion of it. *)
From Coq Require Import Reals QArith List.
From Interval.Float Require Import Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From InertialPair Require Import Trajectory.
Import ListNotations.
Module F := SpecificFloat StdZRadix2.
Module I := FloatIntervalFull F.
Module C := Check I.
Local Open Scope Q_scope.

(** m1, m2, a1, a2 and b; x1, v1 and v2 at the time 0 *)
Definition the_scene := Scene {scene}.

(** its events: the mode until then; bounds of the time and of the place, and of the common velocity *)
Definition the_events : list event := {events}.

(** its end: the mode and the time; bounds of the place, of v1, of v2 and of v1 - v2 *)
Definition the_ending := {ending}.

(** what helps the program: bounds of the time since the event before, and which way a stick ends *)
Definition hints := [
  {hints}].

(** the program accepts it *)
Lemma accepted : C.check (F.PtoP {state}) (F.PtoP {sign}) {depth} the_scene the_events the_ending hints = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** so every motion of the scene runs through these events *)
Theorem trajectory x v1 v2 s : motion the_scene x v1 v2 s -> unfolds x v1 v2 0 the_events the_ending.
Proof. exact (C.sound _ _ _ _ _ _ _ accepted x v1 v2 s). Qed.
"""
