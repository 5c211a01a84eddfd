"""A trajectory as a theorem for the proof kernel: its events, proved for every motion of the scene (`solve --proof`).

Only modes and rough times are taken from the trajectory. Roots are found again, bounded by balls (closed_forms.py).
Nothing of it is trusted: the kernel's program (Trajectory.v) accepts the file only if all of it is true.

Boxes forget how a state's numbers hang together, so they grow by some bits an event, while no two motions of a scene
move apart in the energy norm. In a long run the box is therefore replaced, now and then, by a ball about another motion
from a state known exactly: its radius grows only by how far that motion, when its part ends, is from the next one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from flint import arb

from numerics.arithmetic.ball import exact_middle, widened
from numerics.arithmetic.precision import precision
from numerics.errors import NoProof
from numerics.linear.modes import Mode
from numerics.scene import Law, Scene
from numerics.scene.decimals import decimal_text
from numerics.scene.model import PLAIN
from numerics.trajectory.closed_forms import (
    SPARE,
    SPARE_SIGN_BITS,
    EnclosedState,
    Spell,
    Steady,
    TheoremRun,
    TooCoarse,
    Unseen,
    ends_of,
    number,
    outward,
    spells,
)
from numerics.trajectory.export import arrays
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory

SHOWN = 12
"""Digits of the bounds in a theorem, of the greatest time, place or velocity."""
TRIES = (64, 96, 128, 192, 256, 384, 512, 768)
"""The precisions of the first state that are tried."""
SPARE_BITS, STEP_BITS = 32, 16
"""With how many bits more than it is known to a state is computed with, and in what steps these become fewer."""
KERNEL_BITS = 8
"""With how many bits more the kernel computes, which rounds elsewhere."""
WORN = 4.0**8
"""How many times as large the square of a box becomes before it is replaced by a ball."""
DOUBLINGS = 24
"""How often the time is doubled after which a damped stick is seen to be for ever."""
DEPTH = 64
"""How often the kernel halves an interval to show that no event was passed."""


def theorem(trajectory: Trajectory) -> str:
    """Return the text of a proof file: the theorem `trajectory`, of every motion of the scene.

    Raises NoProof, in a sentence, for a scene that the checker does not cover, and for a run without certain events.
    """
    scene = trajectory.scene
    if reason := _uncovered(trajectory):
        raise NoProof(f"no theorem is written: {reason}")
    table = arrays(trajectory)
    greatest = float(scene.until), abs(table["y"][[0, 2]]).max(), abs(table["y"][[1, 3]]).max()
    places = [SHOWN - (math.ceil(math.log10(size)) if size else 0) for size in greatest]
    times = table["t"][1:].tolist()
    for bits in TRIES:
        writer = _Writer(scene, places, bits)
        try:
            return writer.text(trajectory, times)
        except TooCoarse as error:
            reason = f"{bits} bits are too few for {len(times)} events; shorten until"
            if isinstance(error, Unseen):
                since = f"after t = {writer.run.time:.6g} s the checker does not see that the pair keeps its mode"
                reason = (
                    f"{since}, as it does not at a graze, or exactly at an edge or the critical energy; shorten until"
                )
    raise NoProof(f"no theorem is written: {reason}")


def _uncovered(trajectory: Trajectory) -> str:
    """Return why the checker does not cover a trajectory, or nothing."""
    scene, at = trajectory.scene, trajectory.scene.initial
    if scene.law is not Law.FILIPPOV:
        return f'the checker knows no law = "{scene.law.value}"; leave the law out, for "filippov"'
    if scene.extra:
        return f"the checker does not cover {scene.extra}; {PLAIN}"
    if not trajectory.success:
        return f"the run {trajectory.message}"
    if scene.energy_excess == 0 and at.v1 == at.v2 and scene.pair.a1 == 0 and not scene.is_forced:
        return "with exactly the critical energy the checker does not decide what follows; move the start off it"
    return ""


def _written(*values: Mode | bool | Fraction) -> str:
    """Return modes, truth values and exact numbers in the words of the kernel."""
    found = []
    for one in values:
        if isinstance(one, Mode):
            found.append("Stick" if one is Mode.STICK else f"(Slip {_written(one is Mode.SLIP_PLUS)})")
        elif isinstance(one, bool):
            found.append(str(one).lower())
        elif "/" in (text := decimal_text(one)):
            found.append(f"({one.numerator} # {one.denominator})")
        else:
            found.append(f"({text})" if one < 0 else text)
    return " ".join(found)


def _list(items: Iterable[str], between: str = ";\n  ") -> str:
    return f"[{between.join(items)}]"


def _steady(force: Steady) -> str:
    tones = _list((f"Tone {_written(*one)}" for one in force.tones), "; ")
    return f"Steady {_written(force.since)} {_list(map(_written, force.polynomial), '; ')} {tones}"


def _edge(scene: Scene, spell: Spell) -> int:
    """Return k if a pair starts in contact on the edge towards k, as far as the kernel decides that; or 0."""
    pair, at, force = scene.pair, scene.initial, spell.force
    if at.v1 != at.v2 or any(one.phase for one in force.tones):
        return 0
    load = pair.m2 * (pair.a2 * at.x1 + pair.a1 * at.v1 - sum(force.polynomial[:1]))
    edge = spell.friction * pair.mass
    return {-edge: 1, edge: -1}.get(load, 0)


class _Writer:
    """The proof file of a scene, from event to event; `most` are the bits of the first state.

    `places`: how many decimal places are shown of a time (s), a place (m) and a velocity (m/s).
    """

    def __init__(self, scene: Scene, places: list[int], most: int) -> None:
        self.scene, self.most, self.bits, self.hints = scene, most, most, list[str]()
        self.places = dict(zip("txv", places, strict=True))
        self.spells, at = list(spells(scene)), scene.initial
        first, *self.later = self.spells
        with precision(most):
            state = EnclosedState(*map(number, (Fraction(0), *at)))
            self.run = TheoremRun(scene.pair, first, 12 + most // 8, state, at.v1 == at.v2, _edge(scene, first))
        self.fresh, self.radius = self._size(), Fraction(0)
        self.close: TheoremRun | None = None
        self.steps: list[str] = []

    def text(self, trajectory: Trajectory, times: list[float]) -> str:
        """Return the file; the last of the times is the end."""
        events, last = [], trajectory.final_mode
        for event, time in zip(trajectory.events, times, strict=False):
            since = [one.since for one in self.later]
            if event.cause == "jump":  # the float of its time may lie in front of it
                self._pass(event.before, 1 + min(range(len(since)), key=lambda k: abs(since[k] - time)), "Breaks")
            else:
                self._pass(event.before, sum(one <= time for one in since))
                self._hit(event.before, event.before.sign or event.after.sign, time)
            t, x1, v1, x2, _ = self.run.at
            events.append(f"Event {_written(event.before)} {self._bounds((t, x1, x2, v1), 'txxv')}")
        self._pass(last, len(self.later))
        relative = self._rest(last, self.scene.until, "Last {bits} {least}")
        ends = self._bounds((*self.run.at[1:], relative), "xvxvv")
        ever = trajectory.status is Status.STUCK_FOR_EVER and self._for_ever()
        pair, at, table = self.scene.pair, self.scene.initial, ";\n  ".join(events)
        acting = [f"(Spell {_written(one.since, one.friction)} ({_steady(one.force)}))" for one in self.spells]
        return TEXT.format(
            scene=_written(pair.m1, pair.m2, pair.a1, pair.a2, *at),
            first=acting[0],
            later=_list(acting[1:]),
            events=f"[\n  {table}]" if table else "[]",
            ending=f"Ending {_written(last, self.scene.until)} {ends} {_written(ever)}",
            answers=_list(f"({_steady(one.alone)}, {_steady(one.together)})" for one in self.spells),
            hints=";\n  ".join(self.hints),
            state=self.most + KERNEL_BITS,
            sign=self.run.signs + SPARE_SIGN_BITS,
            depth=DEPTH,
        )

    def _pass(self, mode: Mode, count: int, at_last: str = "Goes") -> None:
        """Go on in a mode to the end of so many spells; what is said of the last may be that a stick breaks there."""
        for left in reversed(range(count)):
            which = "Goes" if left else at_last
            self._rest(mode, self.later[0].since, f"Rest {{bits}} {{until}} {{least}} {which}")
            self.run.spell = self.later.pop(0)

    def _size(self) -> float:
        """Return how large the box is, and what rounding adds, in the energy norm; squared."""
        at, energy = self.run.at[1:], self.scene.pair.energy
        sizes = energy([one.rad() for one in at], number), energy([one.mid() for one in at], number) / 4**self.most
        return sum(map(float, sizes))

    def _narrow(self) -> int:
        """Compute with no more bits than the state deserves; return with how many the kernel does."""
        known = min((one.rel_accuracy_bits() for one in self.run.at if not one.contains(0)), default=self.most)
        self.bits = min(self.bits, STEP_BITS * math.ceil((min(known, self.most) + SPARE_BITS) / STEP_BITS))
        return self.bits + KERNEL_BITS

    def _hit(self, mode: Mode, k: int, time: float) -> None:
        """Go to the next event, with the motion that is close."""
        now = self.run.time
        if self._size() > WORN * self.fresh:
            self._renew(mode, Fraction(f"{(now + time) / 2:.{max(0, 2 - math.floor(math.log10(time - now)))}f}"))
        bits = self._narrow()
        with precision(self.bits):
            low, high = self.run.hit(mode, k, time)
            self.hints.append(f"Hit {bits} {_written(low, high, k > 0)}")
            if self.close:
                low, high = self.close.hit(mode, k, time)
                self.steps.append(f"({_written(mode)}, {_written(low)}, {_written(high)}, {_written(k > 0)})")

    def _rest(self, mode: Mode, time: Fraction, hint: str) -> arb:
        """Go on in a mode to a time, and return v1 - v2 there."""
        bits = self._narrow()
        with precision(self.bits):
            least, relative = self.run.rest(mode, time)
        self.hints.append(hint.format(bits=bits, until=_written(time), least=_written(least)))
        self.close, self.radius, self.steps = None, Fraction(0), []
        return relative

    def _renew(self, mode: Mode, time: Fraction) -> None:
        """Go on to a time and replace the box by a ball about a new motion, if the mode is sure to go on there."""
        bits, pair = self._narrow(), self.scene.pair
        run, other = replace(self.run), replace(self.close or self.run)
        with precision(self.bits):
            try:
                least = max(one.rest(mode, time)[0] for one in (run, other))
            except TooCoarse:
                return
            x1, v1, _, v2 = (exact_middle(one) for one in other.at[1:])
            centre = run.start(time, x1, v1, Fraction(0), v2)
            away: Any = pair.energy([one - at for one, at in zip(other.at[1:], centre.at[1:], strict=True)], number)
            radius = self.radius + Fraction(f"{SPARE * math.sqrt(float(away.upper())):.2e}")
            for name, weight in (("x1", pair.a2), ("v1", pair.m1), ("v2", pair.m2)):
                arm = number(radius) * number(2 / weight).sqrt()
                run.at = run.at._replace(**{name: widened(getattr(centre.at, name), arm)})
            if not all(run.guard(mode, k)(arb(0)) > 0 for k in ends_of(mode)):
                return
        renews = f"(Renews {_list(self.steps, '; ')}\n    (Close {_written(time, x1, v1, v2, radius)}))"
        self.hints.append(f"Rest {bits} {_written(time, least)} {renews}")
        self.run, self.close, self.radius, self.steps = run, centre, radius, []
        self.fresh = self._size()

    def _for_ever(self) -> bool:
        """Go on in a stick that does not end until its energy shows that; return whether that is shown."""
        scene, force = self.scene, self.run.spell.force
        if force.tones or any(force.polynomial[1:]):
            return False
        least = Fraction(f"{math.sqrt(scene.pair.mass / scene.pair.a2) / 8:.1g}")
        for doubling in range(DOUBLINGS if scene.pair.a1 else 1):
            left = least * 2**doubling
            with precision(self.bits):
                is_kept = self.run.is_kept(number(left))
            if is_kept:
                self._rest(Mode.STICK, scene.until + left, "Ever {bits} {until} {least}")
                return True
        return False

    def _bounds(self, boxes: tuple[arb, ...], kinds: str) -> str:
        """Return decimal bounds of each box, a time, place or velocity; raises TooCoarse for one that is too wide."""
        found = []
        for box, kind in zip(boxes, kinds, strict=True):
            low, high = outward(box, self.places[kind])
            if high - low > 3 * Fraction(10) ** -self.places[kind]:
                raise TooCoarse
            found.append(f"({decimal_text(low)}, {decimal_text(high)})")
        return "\n    ".join((" ".join(found[:2]), " ".join(found[2:])))


TEXT = """(** Written by `python -m numerics solve --proof`: the events of a scene, proved for every motion of it. *)
From Coq Require Import Reals QArith List.
From Interval.Float Require Import Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From InertialPair Require Import Waves Trajectory.
Import ListNotations.
Module F := SpecificFloat StdZRadix2.
Module I := FloatIntervalFull F.
Module C := Check I.
Local Open Scope Q_scope.

(** m1, m2, a1 and a2; x1, v1, x2 and v2 at the time 0; from when on what friction and what force act *)
Definition the_scene := Scene {scene}
  {first} {later}.

(** its events: the mode until then; bounds of the time, of both places, and of the common velocity *)
Definition the_events : list event := {events}.

(** its end: the mode and the time; bounds of x1, v1, x2 and v2, and of v1 - v2; whether it sticks for ever *)
Definition the_ending := {ending}.

(** how body 1 and both bodies answer to the force *)
Definition answers := {answers}.

(** what helps the program: in how many bits to compute, bounds of the time since the event before, which way a stick
    ends; until when a mode lasts, for how long at least, and which motion is close then; until when a stick that is for
    ever is followed *)
Definition hints := [
  {hints}].

(** the program accepts it *)
Lemma accepted :
  C.check F.PtoP (F.PtoP {sign}) {depth} the_scene {state} answers the_events the_ending hints = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** so every motion of the scene runs through these events *)
Theorem trajectory x v1 x2 v2 : motion the_scene x v1 x2 v2 -> unfolds x v1 x2 v2 0 the_events the_ending.
Proof. exact (C.sound _ _ _ _ _ _ _ _ _ accepted x v1 x2 v2). Qed.
"""
