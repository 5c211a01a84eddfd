"""A trajectory as a theorem for the proof kernel: its events, proved for every motion of the scene (`solve --proof`).

Only modes and rough times are taken from the trajectory. Roots are found again, bounded by intervals (closed_forms.py).
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

from flint import arb

from numerics.arithmetic.precision import precision
from numerics.errors import NoProof
from numerics.linear.modes import Mode
from numerics.linear.pieces import pieces_of, polynomial_at
from numerics.scene import Law, Scene
from numerics.scene.decimals import decimal_text
from numerics.trajectory.export import arrays
from numerics.trajectory.status import Status
from numerics.trajectory.theorem_box import (
    SPARE_SIGN_BITS,
    Box,
    Program,
    Steady,
    TooCoarse,
    Unseen,
    ends_of,
    number,
    outward,
)
from numerics.trajectory.trajectory import Trajectory

SHOWN = 12
"""Digits of the bounds in a theorem, of the greatest time, place or velocity."""
TRIES = ((64, False), (96, False), (72, True), (80, True), (96, True), (128, True), (256, True), (768, True))
"""The precisions of the first state that are tried, with boxes that grow or with balls about other motions."""
SPARE_BITS, STEP_BITS = 32, 16
"""With how many bits more than it is known to a state is computed with, and in what steps these become fewer."""
KERNEL_BITS = 8
"""With how many bits more the kernel computes, which rounds elsewhere than mpmath."""
WORN = 2.0**6
"""How many times as large a box becomes before it is replaced by a ball."""
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
    for bits, renewing in TRIES:
        try:
            with precision(bits):
                writer = _Writer(scene, places, bits, renewing=renewing)
                return writer.text(trajectory, times)
        except TooCoarse as error:
            reason = f"{TRIES[-1][0]} bits are too few for {len(times)} events; shorten until"
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
        return f"the checker does not cover {scene.extra}; leave that out"
    if scene.friction.weakening is not None:
        return "the checker knows no friction that depends on speed or place; leave [weakening] out"
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


def _steady(given: Steady) -> str:
    tones = _list((f"Tone {_written(*one)}" for one in given.tones), "; ")
    return f"Steady {_written(given.since)} {_list(map(_written, given.polynomial), '; ')} {tones}"


class _Writer:
    """The proof file of a scene, from event to event; `most` are the bits of the first state.

    `places`: how many decimal places are shown of a time (s), a place (m) and a velocity (m/s).
    """

    def __init__(self, scene: Scene, places: list[int], most: int, *, renewing: bool) -> None:
        self.scene, self.most, self.renewing = scene, most, renewing
        self.places = dict(zip("txv", places, strict=True))
        self.pieces, self.index, self.hints = pieces_of(scene), 0, list[str]()
        self.program = Program(scene.pair, self.pieces[0], most)
        at = scene.initial
        self.run = Box.start(self.program, Fraction(0), (at.x1, at.v1, at.x2, at.v2), self._edge())
        self.close: Box | None = None
        self.radius, self.steps, self.fresh = Fraction(0), list[str](), self._size()

    def _begin(self, index: int) -> None:
        """Begin a piece."""
        self.index = index
        self.program.begin(self.pieces[index])

    def _edge(self) -> int:
        """Return k if the pair starts in contact on the edge towards k, as far as the kernel decides that; or 0."""
        pair, at, piece = self.scene.pair, self.scene.initial, self.pieces[0]
        if at.v1 != at.v2 or any(one.phase for one in piece.sines):
            return 0
        load = pair.m2 * (pair.a2 * at.x1 + pair.a1 * at.v1 - polynomial_at(piece.polynomial, Fraction(0)))
        return {-piece.b * pair.mass: 1, piece.b * pair.mass: -1}.get(load, 0)

    def text(self, trajectory: Trajectory, times: list[float]) -> str:
        """Return the file; the last of the times is the end."""
        events, last = [], trajectory.final_mode
        for event, time in zip(trajectory.events, times, strict=False):
            jump = event.cause == "jump"
            self._rest_before(time, event.before, jump=jump)
            if jump:
                self._rest(event.before, self.pieces[self.index + 1].start, "Rest {bits} {until} {least} Breaks")
                self._begin(self.index + 1)
            else:
                self._hit(event.before, event.before.sign or event.after.sign, time)
            x1, v1, x2, _ = self.run.state
            events.append(f"Event {_written(event.before)} {self._bounds((self.run.t, x1, x2, v1), 'txxv')}")
        self._rest_before(math.inf, last, jump=False)
        relative = self._rest(last, self.scene.until, "Last {bits} {least}")
        ends = self._bounds((*self.run.state, relative), "xvxvv")
        ever = trajectory.status is Status.STUCK_FOR_EVER and self._for_ever()
        pair, at, table = self.scene.pair, self.scene.initial, ";\n  ".join(events)
        forces = [Steady.force(self.scene.force.piece_at(one.start)) for one in self.pieces]
        acting = [
            f"(Spell {_written(one.start, one.b)} ({_steady(force)}))"
            for one, force in zip(self.pieces, forces, strict=True)
        ]
        answers = [[_steady(one.answer(pair, mass)) for mass in (pair.m1, pair.mass)] for one in forces]
        return TEXT.format(
            scene=_written(pair.m1, pair.m2, pair.a1, pair.a2, at.x1, at.v1, at.x2, at.v2),
            first=acting[0],
            later=_list(acting[1:]),
            events=f"[\n  {table}]" if table else "[]",
            ending=f"Ending {_written(last, self.scene.until)} {ends} {_written(ever)}",
            answers=_list(f"({alone}, {together})" for alone, together in answers),
            hints=";\n  ".join(self.hints),
            state=self.most + KERNEL_BITS,
            sign=self.program.sign_bits + SPARE_SIGN_BITS,
            depth=DEPTH,
        )

    def _rest_before(self, time: float, mode: Mode, *, jump: bool) -> None:
        """Go through the pieces that end before a time; if there is a jump, the one that ends with it stays."""
        ending = [one.start for one in self.pieces[self.index + 1 :] if one.start <= time]
        for start in ending[: len(ending) - jump]:
            if not (self.close and self._renewed(mode, start)):
                self._rest(mode, start, "Rest {bits} {until} {least} Goes")
            self._begin(self.index + 1)

    def _narrow(self) -> int:
        """Compute with no more bits than the state deserves; return with how many the kernel does."""
        numbers = (self.run.t, *self.run.state)
        known = min((one.rel_accuracy_bits() for one in numbers if not one.contains(0)), default=self.most)
        bits = STEP_BITS * math.ceil((min(known, self.most) + SPARE_BITS) / STEP_BITS)
        self.program.bits = min(self.program.bits, bits)
        return self.program.bits + KERNEL_BITS

    def _hit(self, mode: Mode, k: int, time: float) -> None:
        """Go to the next event, with the motion that is close."""
        if self.renewing and self._size() > WORN * self.fresh:
            now = self.run.time
            self._renewed(mode, Fraction(f"{(now + time) / 2:.{max(0, 2 - math.floor(math.log10(time - now)))}f}"))
        bits = self._narrow()
        self.run, *between = self.run.hit(mode, k, time, self.places["t"])
        self.hints.append(f"Hit {bits} {_written(*between, k > 0)}")
        if self.close:
            self.close, low, high = self.close.hit(mode, k, time, self.places["t"])
            self.steps.append(f"({_written(mode)}, {_written(low)}, {_written(high)}, {_written(k > 0)})")

    def _rest(self, mode: Mode, time: Fraction, hint: str) -> arb:
        """Go on in a mode to a time, and return v1 - v2 there."""
        bits = self._narrow()
        self.run, least, relative = self.run.rest(mode, time)
        self.hints.append(hint.format(bits=bits, until=_written(time), least=_written(least)))
        self.close, self.radius, self.steps = None, Fraction(0), []
        return relative

    def _norm(self, state: Iterable[arb]) -> arb:
        """Return the energy norm of a difference, sqrt(J); of one in x2 it is 0."""
        pair, (x1, v1, _, v2) = self.scene.pair, state
        parts = (pair.a2, x1), (pair.m1, v1), (pair.m2, v2)
        return sum((number(weight / 2) * one * one for weight, one in parts), arb(0)).abs_upper().sqrt()

    def _size(self) -> float:
        """Return how large the box is, and what rounding adds, in the energy norm."""
        own = self._norm(one.rad() for one in self.run.state)
        return float(2 * own + self._norm(self.run.state) * arb((1, -self.most)))

    def _renewed(self, mode: Mode, time: Fraction) -> bool:
        """Go on to a time and replace the box by a ball about a new motion; return whether that is possible there."""
        bits, pair = self._narrow(), self.scene.pair
        try:
            run, least, _ = self.run.rest(mode, time)
            other, enough, _ = (self.close or self.run).rest(mode, time)
        except TooCoarse:
            return False
        x1, v1, _, v2 = other.state
        places = 1 - math.floor(math.log10(min(float(2 * one.rad()) for one in (x1, v1, v2)) or 2.0**-self.most))
        x1, v1, v2 = (sum(outward(one, places), Fraction(0)) / 2 for one in (x1, v1, v2))
        centre = Box.start(self.program, time, (x1, v1, Fraction(0), v2))
        away = self._norm(one - at for one, at in zip(other.state, centre.state, strict=True))
        radius = self.radius + Fraction(f"{1.5 * float(away):.2e}")
        arms = (arb(0, number(radius) * number(2 / weight).sqrt()) for weight in (pair.a2, pair.m1, pair.m2))
        x1_box, v1_box, v2_box = (number(one) + arm for one, arm in zip((x1, v1, v2), arms, strict=True))
        run = replace(run, state=(x1_box, v1_box, run.state[2], v2_box))
        if not all(run.guard(mode, k)(Fraction(0)) > 0 for k in ends_of(mode)):
            return False
        renews = f"(Renews {_list(self.steps, '; ')}\n    (Close {_written(time, x1, v1, v2, radius)}))"
        self.hints.append(f"Rest {bits} {_written(time, max(least, enough))} {renews}")
        self.run, self.close, self.radius, self.steps = run, centre, radius, []
        self.fresh = self._size()
        return True

    def _for_ever(self) -> bool:
        """Go on in a stick that does not end until its energy shows that; return whether that is shown."""
        scene, force = self.scene, self.pieces[self.index]
        if scene.changes_later or force.sines or any(force.polynomial[1:]):
            return False
        least = Fraction(f"{math.sqrt(scene.pair.mass / scene.pair.a2) / 8:.1g}")
        for doubling in range(DOUBLINGS if scene.pair.a1 else 1):
            left = least * 2**doubling
            if self.run.moved(Mode.STICK, number(left)).sticks_for_ever():
                self._rest(Mode.STICK, scene.until + left, "Ever {bits} {until} {least}")
                return True
        return False

    def _bounds(self, balls: tuple[arb, ...], kinds: str) -> str:
        """Return decimal bounds of each ball, a time, place or velocity; raises TooCoarse for one that is too wide."""
        found = []
        for ball, kind in zip(balls, kinds, strict=True):
            margin = ball.rad() + arb(10) ** -(self.places[kind] + 3)  # the kernel's box is another one
            low, high = outward(ball + arb(0, margin), self.places[kind])
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
