"""A trajectory as a theorem for the proof kernel: its events, proved for every motion of the scene (`solve --proof`).

Only modes and rough times are taken from the trajectory. Roots are found again and bounded by intervals (phases.py).
Nothing of it is trusted: the kernel's program (Trajectory.v) accepts the file only if all of it is true.

Boxes forget how a state's numbers hang together, so they grow by some bits an event, while no two motions of a scene
move apart in the energy norm. In a long run the box is therefore replaced, now and then, by a ball about another motion
from a state known exactly: its radius grows only by how far that motion, when its part ends, is from the next one.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

from numerics.errors import NoProof
from numerics.linear.modes import Mode
from numerics.scene import Law, Scene
from numerics.scene.decimals import decimal_text
from numerics.trajectory import gallina
from numerics.trajectory.closed_forms import SPARE_SIGN_BITS, Forms, State, TooCoarse, Unseen, Value, spells
from numerics.trajectory.export import arrays
from numerics.trajectory.phases import Run, ends_of, moved, outward
from numerics.trajectory.solution import Solution
from numerics.trajectory.status import Status

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


def theorem(trajectory: Solution) -> str:
    """Return the text of a proof file: the theorem `trajectory`, of every motion of the scene.

    Raises NoProof, in a sentence, for a scene that the checker does not cover, and for a run without certain events.
    """
    scene = trajectory.scene
    if reason := _uncovered(trajectory):
        raise NoProof(f"no theorem is written: {reason}")
    table = arrays(trajectory)
    greatest = float(scene.until), abs(table["y"][[0, 2]]).max(), abs(table["y"][[1, 3]]).max()
    places = [SHOWN - (math.ceil(math.log10(size)) if size else 0) for size in greatest]
    times = [float(one) for one in table["t"][1:]]
    for bits, renewing in TRIES:
        writer = _Writer(scene, places, bits, renewing=renewing)
        try:
            return writer.text(trajectory, times)
        except TooCoarse as error:
            unseen = isinstance(error, Unseen)
    if unseen:
        since = f"after t = {writer.run.time:.6g} s the checker does not see that the pair keeps its mode"
        raise NoProof(
            f"no theorem is written: {since}, as it does not at a graze, or exactly at an edge or the critical energy"
        )
    raise NoProof(f"no theorem is written: {TRIES[-1][0]} bits are too few for {len(times)} events; shorten until")


def _uncovered(trajectory: Solution) -> str:
    """Return why the checker does not cover a trajectory, or nothing."""
    scene, at = trajectory.scene, trajectory.scene.initial
    if scene.law is not Law.FILIPPOV or scene.friction.weakening is not None:
        return 'the checker knows the law "filippov" only, and no friction that depends on speed or place'
    if not trajectory.success:
        return f"the run {trajectory.message}"
    if scene.is_forced or at.v1 != at.v2 or scene.pair.a1 != 0:
        return ""
    if at.v1 == 0 and abs(at.x1) == scene.pair.half_width:
        return "at rest on an edge of the sliding region the checker does not decide what follows"
    if scene.energy_excess == 0:
        return "with exactly the critical energy the checker does not decide what follows"
    return ""


class _Writer:
    """The proof file of a scene, from event to event; `most` are the bits of the first state.

    `places`: how many decimal places are shown of a time (s), a place (m) and a velocity (m/s).
    """

    def __init__(self, scene: Scene, places: list[int], most: int, *, renewing: bool) -> None:
        self.scene, self.places, self.most, self.renewing = scene, places, most, renewing
        self.spells, self.hints = list(spells(scene)), list[str]()
        self.forms = Forms(scene.pair, most)
        self._begin(0)
        at = scene.initial
        self.run = Run.start(self.forms, (Fraction(0), at.x1, at.v1, at.x2, at.v2), self._edge())
        self.close: Run | None = None
        self.radius, self.steps, self.fresh = Fraction(0), list[str](), self._size()

    def _begin(self, index: int) -> None:
        """Begin a spell."""
        self.index = index
        self.forms.begin(self.spells[index])

    def _edge(self) -> int:
        """Return k if the pair starts in contact on the edge towards k, as far as the kernel decides that; or 0."""
        pair, at, force, friction = self.scene.pair, self.scene.initial, self.spells[0].force, self.spells[0].friction
        if at.v1 != at.v2 or any(one.phase for one in force.tones):
            return 0
        pushed = sum((one * (-force.since) ** n for n, one in enumerate(force.polynomial)), Fraction(0))
        load = pair.m2 * (pair.a2 * at.x1 + pair.a1 * at.v1 - pushed - sum(one.in_cosine for one in force.tones))
        return {-friction * pair.mass: 1, friction * pair.mass: -1}.get(load, 0)

    def text(self, trajectory: Solution, times: list[float]) -> str:
        """Return the file; the last of the times is the end."""
        events, last, (time_shown, place, speed) = [], trajectory.final_mode, self.places
        for event, time in zip(trajectory.events, times, strict=False):
            jump = event.cause == "jump"
            self._rest_before(time, event.before, jump=jump)
            if jump:
                self._rest(event.before, self.spells[self.index + 1].since, "Rest {bits} {until} {least} Breaks")
                self._begin(self.index + 1)
            else:
                self._hit(event.before, event.before.sign or event.after.sign, time)
            t, x1, v1, x2, _ = self.run.at
            bounds = self._bounds((t, x1, x2, v1), (time_shown, place, place, speed))
            events.append(f"Event {gallina.mode(event.before)} {bounds}")
        self._rest_before(math.inf, last, jump=False)
        relative = self._rest(last, self.scene.until, "Last {bits} {least}")
        _, x1, v1, x2, v2 = self.run.at
        ends = self._bounds((x1, v1, x2, v2, relative), (place, speed, place, speed, speed))
        ever = gallina.truth(trajectory.status is Status.STUCK_FOR_EVER and self._for_ever())
        ending = f"Ending {gallina.mode(last)} {gallina.number(self.scene.until)} {ends} {ever}"
        bits = self.most + KERNEL_BITS, self.forms.sign_bits + SPARE_SIGN_BITS
        return gallina.proof_file(self.scene, self.spells, events, ending, self.hints, bits)

    def _rest_before(self, time: float, mode: Mode, *, jump: bool) -> None:
        """Go through the spells that end before a time; if there is a jump, the one that ends with it stays."""
        ending = [one.since for one in self.spells[self.index + 1 :] if one.since <= time]
        for since in ending[: len(ending) - jump]:
            if not (self.close and self._renewed(mode, since)):
                self._rest(mode, since, "Rest {bits} {until} {least} Goes")
            self._begin(self.index + 1)

    def _narrow(self) -> None:
        """Compute with no more bits than the state deserves."""
        widths = [(float(one.delta.b), float(abs(one).b)) for one in self.run.at]
        known = min((-math.log2(width / size) for width, size in widths if width and size), default=math.inf)
        self.forms.narrow(STEP_BITS * math.ceil((min(known, self.most) + SPARE_BITS) / STEP_BITS))

    def _hit(self, mode: Mode, k: int, time: float) -> None:
        """Go to the next event, with the motion that is close."""
        if self.renewing and self._size() > WORN * self.fresh:
            now = self.run.time
            self._renewed(mode, Fraction(f"{(now + time) / 2:.{max(0, 2 - math.floor(math.log10(time - now)))}f}"))
        self._narrow()
        bits, ahead = self.forms.bits + KERNEL_BITS, gallina.truth(k > 0)
        low, high = map(gallina.number, self.run.hit(mode, k, time, self.places[0]))
        self.hints.append(f"Hit {bits} {low} {high} {ahead}")
        if self.close:
            low, high = map(gallina.number, self.close.hit(mode, k, time, self.places[0]))
            self.steps.append(f"({gallina.mode(mode)}, {low}, {high}, {ahead})")

    def _rest(self, mode: Mode, time: Fraction, hint: str) -> Value:
        """Go on in a mode to a time, and return v1 - v2 there."""
        self._narrow()
        least, relative = self.run.rest(mode, time)
        until, lasting = gallina.number(time), gallina.number(least)
        self.hints.append(hint.format(bits=self.forms.bits + KERNEL_BITS, until=until, least=lasting))
        self.close, self.radius, self.steps = None, Fraction(0), []
        return relative

    def _norm(self, at: State) -> Value:
        """Return the energy norm of a difference, sqrt(J)."""
        pair, number = self.scene.pair, self.forms.number
        parts = (pair.a2, at.x1), (pair.m1, at.v1), (pair.m2, at.v2)
        return self.forms.on.sqrt(sum(number(weight) * one**2 for weight, one in parts) / 2)

    def _size(self) -> float:
        """Return how large the box is, and what rounding adds, in the energy norm."""
        widths = State(*(one.delta for one in self.run.at))
        return float(self._norm(widths).b) + float(self._norm(self.run.at).b) * 2.0**-self.most

    def _renewed(self, mode: Mode, time: Fraction) -> bool:
        """Go on to a time and replace the box by a ball about a new motion; return whether that is possible there."""
        self._narrow()
        run, other = replace(self.run), replace(self.close or self.run)
        try:
            least = max(one.rest(mode, time)[0] for one in (run, other))
        except TooCoarse:
            return False
        number, box = self.forms.number, (other.at.x1, other.at.v1, other.at.v2)
        places = 1 - math.floor(math.log10(min(float(one.delta.b) for one in box) or 2.0**-self.most))
        x1, v1, v2 = (sum(outward(one, places), Fraction(0)) / 2 for one in box)
        centre = Run.start(self.forms, (time, x1, v1, Fraction(0), v2))
        away = self._norm(State(*(one - at for one, at in zip(other.at, centre.at, strict=True))))
        radius = self.radius + Fraction(f"{1.25 * float(away.b):.2e}")
        weights = self.scene.pair.a2, self.scene.pair.m1, self.scene.pair.m2
        arms = [number(radius) * self.forms.on.sqrt(2 / number(one)) for one in weights]
        x, v, w = (arm * self.forms.on.mpf([-1, 1]) for arm in arms)
        run.at = run.at._replace(x1=centre.at.x1 + x, v1=centre.at.v1 + v, v2=centre.at.v2 + w)
        if not all(run.guard(mode, k)(number(Fraction(0))) > 0 for k in ends_of(mode)):
            return False
        new = " ".join(map(gallina.number, (time, x1, v1, v2, radius)))
        until, lasting = gallina.number(time), gallina.number(least)
        renews = f"(Renews [{'; '.join(self.steps)}]\n    (Close {new}))"
        self.hints.append(f"Rest {self.forms.bits + KERNEL_BITS} {until} {lasting} {renews}")
        self.run, self.close, self.radius, self.steps = run, centre, radius, []
        self.fresh = self._size()
        return True

    def _for_ever(self) -> bool:
        """Go on in a stick that does not end until its energy shows that; return whether that is shown."""
        scene, force, forms = self.scene, self.spells[self.index].force, self.forms
        changes = max((*scene.force.starts, *scene.friction.starts), default=Fraction(0)) >= scene.until
        if changes or force.tones or any(force.polynomial[1:]):
            return False
        least = Fraction(f"{math.sqrt(scene.pair.mass / scene.pair.a2) / 8:.1g}")
        for doubling in range(DOUBLINGS if scene.pair.a1 else 1):
            left = least * 2**doubling
            if forms.spare(moved(forms, Mode.STICK, 0, self.run.at, forms.number(left), ends=False)) > 0:
                self._rest(Mode.STICK, scene.until + left, "Ever {bits} {until} {least}")
                return True
        return False

    def _bounds(self, boxes: tuple[Value, ...], places: tuple[int, ...]) -> str:
        """Return decimal bounds of each box; raises _TooCoarse for one wider than the last place shown."""
        found = []
        for box, shown in zip(boxes, places, strict=True):
            low, high = outward(box, shown)
            if high - low > 3 * Fraction(10) ** -shown:
                raise TooCoarse
            found.append(f"({decimal_text(low)}, {decimal_text(high)})")
        return "\n    ".join((" ".join(found[:2]), " ".join(found[2:])))
