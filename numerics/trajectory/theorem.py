"""A trajectory as a theorem for the proof kernel: its events, proved for every motion of the scene (`solve --proof`).

Only modes and rough times are taken from the trajectory. Roots are found again here and bounded by intervals; nothing
of it is trusted: the kernel's program (Trajectory.v) accepts the file only if all of it is true.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, NamedTuple

from mpmath.ctx_iv import MPIntervalContext
from mpmath.ctx_mp import MPContext

from numerics.errors import NoProof
from numerics.linear.modes import Mode
from numerics.scene import Law, Scene
from numerics.scene.decimals import decimal_text
from numerics.trajectory import gallina
from numerics.trajectory.closed_forms import ClosedForms, State, Value, Wave
from numerics.trajectory.export import arrays
from numerics.trajectory.solution import Solution
from numerics.trajectory.spells import spells
from numerics.trajectory.status import Status

SHOWN = 12
"""Digits of the bounds in a theorem, of the greatest time, place or velocity."""
STATE_BITS = (64, 96, 128, 192, 256, 384, 512, 768, 1024)
"""The precisions of the first state that are tried."""
SPARE_BITS, STEP_BITS = 32, 16
"""With how many bits more than it is known to a state is computed with, and in what steps these become fewer."""
KERNEL_BITS = 8
"""With how many bits more the kernel computes, which rounds elsewhere than mpmath."""
DOUBLINGS = 24
"""How often the time is doubled after which a damped stick is seen to be for ever."""


class _TooCoarse(Exception):
    """The boxes have grown too large: more bits are needed."""


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
    greatest = float(scene.until), abs(table["y"][[0, 2]]).max(), abs(table["y"][[1, 3]]).max()
    places = _Places(*(SHOWN - (math.ceil(math.log10(size)) if size else 0) for size in greatest))
    times = [float(one) for one in table["t"][1:]]
    for bits in STATE_BITS:
        try:
            return _Writer(scene, places, bits).text(trajectory, times)
        except _TooCoarse:
            continue
    raise NoProof(f"no theorem is written: {STATE_BITS[-1]} bits are too few for {len(times)} events; shorten until")


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
    """The proof file of a scene, from event to event; `most` are the bits of the first state."""

    def __init__(self, scene: Scene, places: _Places, most: int) -> None:
        self.scene, self.places, self.most, self.bits = scene, places, most, most
        self.points, self.boxes = MPContext(), MPIntervalContext()
        self.points.prec, self.boxes.prec = 2 * most, most
        self.spells, self.hints = list(spells(scene)), list[str]()
        self._begin(0)
        at = scene.initial
        numbers = (Fraction(0), at.x1, at.v1, at.x2, at.v2)
        self.at_points, self.at = (State(*map(forms.number, numbers)) for forms in (self.sharp, self.wide))

    def _begin(self, index: int) -> None:
        """Begin a spell."""
        self.index, spell = index, self.spells[index]
        self.sharp, self.wide = (ClosedForms(on, self.scene.pair, spell) for on in (self.points, self.boxes))

    def text(self, trajectory: Solution, times: list[float]) -> str:
        """Return the file; the last of the times is the end."""
        events, last, (time_shown, place, speed) = [], trajectory.final_mode, self.places
        for event, time in zip(trajectory.events, times, strict=False):
            jump = event.cause == "jump"
            self._rest_before(time, event.before, jump=jump)
            if jump:
                self._rest(event.before, self.spells[self.index + 1].since, "Rest {bits} {until} {least} true")
                self._begin(self.index + 1)
            else:
                self._hit(event.before, event.before.sign or event.after.sign, time)
            t, x1, v1, x2, _ = self.at
            bounds = self._bounds((t, x1, x2, v1), (time_shown, place, place, speed))
            events.append(f"Event {gallina.mode(event.before)} {bounds}")
        self._rest_before(math.inf, last, jump=False)
        relative = self._rest(last, self.scene.until, "Last {bits} {least}")
        _, x1, v1, x2, v2 = self.at
        ends = self._bounds((x1, v1, x2, v2, relative), (place, speed, place, speed, speed))
        ever = gallina.truth(trajectory.status is Status.STUCK_FOR_EVER and self._for_ever())
        ending = f"Ending {gallina.mode(last)} {gallina.number(self.scene.until)} {ends} {ever}"
        return gallina.proof_file(self.scene, self.spells, events, ending, self.hints, self.most + KERNEL_BITS)

    def _rest_before(self, time: float, mode: Mode, *, jump: bool) -> None:
        """Go through the spells that end before a time; if there is a jump, the one that ends with it stays."""
        ending = [one.since for one in self.spells[self.index + 1 :] if one.since <= time]
        for since in ending[: len(ending) - jump]:
            self._rest(mode, since, "Rest {bits} {until} {least} false")
            self._begin(self.index + 1)

    def _narrow(self) -> None:
        """Compute with no more bits than the state deserves."""
        widths = [(float(one.delta.b), float(abs(one).b)) for one in self.at]
        known = min((-math.log2(width / size) for width, size in widths if width and size), default=math.inf)
        steps = math.ceil((min(known, self.most) + SPARE_BITS) / STEP_BITS)
        self.bits = min(self.bits, STEP_BITS * steps)
        self.boxes.prec = self.bits

    def _guards(self, mode: Mode, k: int) -> tuple[Wave, Wave]:
        """Return what is positive until a phase ends, over points and over intervals."""
        if mode is Mode.STICK:
            return self.sharp.grip(k, self.at_points), self.wide.grip(k, self.at)
        return self.sharp.guard(k, self.at_points), self.wide.guard(k, self.at)

    def _hit(self, mode: Mode, k: int, time: float) -> None:
        """Go to the next event."""
        self._narrow()
        low, high = self._bracket(time - float(self.at_points.t), *self._guards(mode, k))
        between = self.boxes.mpf([self.wide.number(low).a, self.wide.number(high).b])
        self.at_points = _moved(self.sharp, mode, k, self.at_points, self.sharp.number((low + high) / 2), ends=True)
        self.at = _moved(self.wide, mode, k, self.at, between, ends=True)
        bits, ahead = self.bits + KERNEL_BITS, gallina.truth(k > 0)
        self.hints.append(f"Hit {bits} {gallina.number(low)} {gallina.number(high)} {ahead}")

    def _for_ever(self) -> bool:
        """Go on in a stick that does not end until its energy shows that; return whether that is shown."""
        scene, force = self.scene, self.spells[self.index].force
        changes = max((*scene.force.starts, *scene.friction.starts), default=Fraction(0)) >= scene.until
        if changes or force.tones or any(force.polynomial[1:]):
            return False
        least = Fraction(f"{math.sqrt(scene.pair.mass / scene.pair.a2) / 8:.1g}")
        for doubling in range(DOUBLINGS if scene.pair.a1 else 1):
            left = least * 2**doubling
            if self.wide.spare(_moved(self.wide, Mode.STICK, 0, self.at, self.wide.number(left), ends=False)) > 0:
                self._rest(Mode.STICK, scene.until + left, "Ever {bits} {until} {least}")
                return True
        return False

    def _rest(self, mode: Mode, time: Fraction, hint: str) -> Value:
        """Go on in a mode to a time, and return v1 - v2 there."""
        self._narrow()
        left = self.wide.number(time) - self.at.t
        if not left > 0:  # the last event may be at the end
            raise _TooCoarse
        least = _outward(left, int(self.bits * 0.3))[1]
        signs = (1, -1) if mode is Mode.STICK else (mode.sign,)
        guards = [self._guards(mode, k)[1] for k in signs]
        if not all(guard(self.wide.number(least)) > 0 for guard in guards):
            raise _TooCoarse
        relative = mode.sign * guards[0](left)
        since = self.sharp.number(time) - self.at_points.t
        self.at_points = _moved(self.sharp, mode, mode.sign, self.at_points, since, ends=False)
        self.at = _moved(self.wide, mode, mode.sign, self.at, left, ends=False)._replace(t=self.wide.number(time))
        until, lasting = gallina.number(time), gallina.number(least)
        self.hints.append(hint.format(bits=self.bits + KERNEL_BITS, until=until, least=lasting))
        return relative

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

    def _bounds(self, boxes: tuple[Value, ...], places: tuple[int, ...]) -> str:
        """Return decimal bounds of each box; raises _TooCoarse for one wider than the last place shown."""
        found = []
        for box, shown in zip(boxes, places, strict=True):
            low, high = _outward(box, shown)
            if high - low > Fraction(3, 10**shown):
                raise _TooCoarse
            found.append(f"({decimal_text(low)}, {decimal_text(high)})")
        return "\n    ".join((" ".join(found[:2]), " ".join(found[2:])))


def _moved(forms: ClosedForms, mode: Mode, k: int, at: State, u: Value, *, ends: bool) -> State:
    """Return the state a time later; both velocities are equal where a mode ends."""
    t = at.t + u
    if mode is Mode.STICK:
        path = forms.stuck(at)
        x1, v1 = path(u), path.slope()(u)
        return State(t, forms.edge(k, t, v1) if ends else x1, v1, at.x2 + (x1 - at.x1), v1)
    path, v2 = forms.slide(k, at), forms.driven(k, at.v2, u)
    return State(t, path(u), v2 if ends else path.slope()(u), at.x2 + (at.v2 + v2) / 2 * u, v2)


def _outward(box: Any, places: int) -> tuple[Fraction, Fraction]:
    """Return decimals with so many places around an interval."""
    low, high = (Fraction((-1) ** sign * int(man)) * Fraction(2) ** exponent for sign, man, exponent, _ in box._mpi_)
    unit = Fraction(10) ** places
    return math.floor(low * unit) / unit, math.ceil(high * unit) / unit
