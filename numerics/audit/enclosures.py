"""Enclosures tried against the truth: every ball function and whole ball trajectories, at N digits and at 3 N.

A trial draws an exact point, a ball around it, and compares the enclosure over the ball at N digits with the value at
the point at 3 N digits: they must meet. The second is a ball too, 10^-2N as wide; that it encloses is what is tried
with N three times as large.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from flint import arb

from numerics.arithmetic import ball_words
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import BALL
from numerics.arithmetic.protocol import Number
from numerics.audit.draws import KINDS, damping, decimal, masses, signed
from numerics.audit.table import Progress, Row, counted
from numerics.contact.free import first_contact
from numerics.contact.surface import contact
from numerics.errors import NumericsError
from numerics.flows.oscillator import first_zero, integral_of_square, overdamped_jerk_zero, propagate
from numerics.flows.slip import Variables, guard_and_gap, push_at, slid_at
from numerics.motion import undamped
from numerics.motion.begin import begin
from numerics.motion.codes import MOVING, STICK
from numerics.motion.frame import Frame
from numerics.motion.tellings import motion_telling
from numerics.run.one import run_scene
from numerics.scene import Scene
from numerics.trajectory.trajectory import Trajectory

_DIGITS = (10, 15, 25, 50)
_MAX_EVENTS = 30
_KEPT = 5
_TOLD = motion_telling(BALL, is_damped=False)
_LATE = 10**9
"""Decay times within which a damped motion is asked for its zeros."""

Points = tuple[Fraction, ...]
Numbers = tuple[Number, ...]


@dataclass(frozen=True)
class Enclosed:
    """A function of ball arithmetic and how its exact arguments are drawn; `scene` hands it a pair as well."""

    name: str
    draw: Callable[[Random], Points]
    value: Callable[..., Numbers]
    scene: Callable[[Random], Scene] | None = None


def functions() -> tuple[Enclosed, ...]:
    """Return every function that ball trajectories are made of."""
    return (*_elementary(), *_slips(), *_oscillations())


def _elementary() -> tuple[Enclosed, ...]:
    def one(name: str, draw: Callable[[Random], Points]) -> Enclosed:
        return Enclosed(name, draw, lambda _, x: (getattr(ball_words, name)(x),))

    positive = lambda random: (decimal(random, -40, 20),)  # noqa: E731
    either = lambda random: (signed(random, -40, 3),)  # noqa: E731
    angle = lambda random: (signed(random, -40, 12),)  # noqa: E731
    in_turn = lambda random: (decimal(random, -40, 0) * Fraction(62, 100),)  # noqa: E731
    return (
        *(one(name, positive) for name in ("sqrt", "log")),
        *(one(name, either) for name in ("exp", "expm1")),
        *(one(name, angle) for name in ("versine", "sine_deficit", "cosine_deficit")),
        Enclosed("depth_and_cotangent", in_turn, lambda _, x: ball_words.depth_and_cotangent(x)),
        one("log1p", lambda random: (decimal(random, -40, 5),)),
        Enclosed("sine_cosine", angle, lambda _, x: ball_words.sine_cosine(x)),
        Enclosed("atan2", lambda random: (*angle(random), *angle(random)), lambda _, y, x: (ball_words.atan2(y, x),)),
    )


def _slips() -> tuple[Enclosed, ...]:
    def flows(_: Ball, guard: Number, gap: Number, push: Number, theta: Number) -> Numbers:
        at = Variables(guard, gap, push)
        return (*_TOLD(guard_and_gap)(at, theta), _TOLD(push_at)(at, theta), _TOLD(slid_at)(at, theta))

    def lands(_: Ball, guard: Number, gap: Number, push: Number) -> Numbers:
        return (_TOLD(first_contact)(Variables(guard, gap, push), True)[0],)

    def sticks(ball: Ball, scene: Scene, offset: Number, v: Number) -> Numbers:
        frame, zero = Frame(ball, scene.pair), ball.number(0)
        pair = undamped.Pair(frame.q, frame.r, frame.sqrt_q, zero, literal=False)
        w = v * v + offset * (2 + offset)
        start = undamped.Start(STICK, 1.0, 1 + offset, zero, offset, v, zero, True, zero, w, zero, zero, zero)
        how, duration, _ = _TOLD(undamped.locate)(pair, start)
        return (duration,) if how == MOVING else ()

    start = lambda random: (decimal(random, -6, 6), signed(random, -9, 2), signed(random, -9, 3))  # noqa: E731
    return (
        Enclosed(
            "end of a slip from S",
            lambda random: (decimal(random, -30, 3), decimal(random, -30, 6)),
            lambda _, gap, push: _TOLD(contact)(gap, push),
        ),
        Enclosed("flow of a slip", lambda random: (*start(random), decimal(random, -12, 3)), flows),
        Enclosed("first contact of a slip", start, lands),
        Enclosed(
            "stick time to the exit", lambda random: (-decimal(random, -30, -1), signed(random, -9, 3)), sticks, masses
        ),
    )


def _oscillations() -> tuple[Enclosed, ...]:
    def moves(ball: Ball, scene: Scene, y: Number, v: Number, t: Number) -> Numbers:
        pair, found = begin(scene, ball).pair, []
        for of in (pair.stick, pair.slip):
            found += [*_TOLD(propagate)(of, y, v, t), _TOLD(integral_of_square)(of, y, v, t)]
        return tuple(found)

    def passes_zero(ball: Ball, scene: Scene, y: Number, v: Number) -> Numbers:
        of = begin(scene, ball).pair.stick
        return (_TOLD(overdamped_jerk_zero if of.regime < 0 else first_zero)(of, y, v, ball.number(_LATE)),)

    def constants(ball: Ball, scene: Scene) -> Numbers:
        frame = Frame(ball, scene.pair)
        return frame.q, frame.r, frame.sqrt_q, frame.two_zeta, frame.length, frame.rate, frame.speed

    state = lambda random: (signed(random, -3, 3), signed(random, -3, 3))  # noqa: E731
    return (
        Enclosed("damped motion", lambda random: (*state(random), decimal(random, -3, 2)), moves, damping),
        Enclosed("first zero of a damped motion", state, passes_zero, damping),
        Enclosed("constants of a pair", lambda _: (), constants, damping),
    )


def audit_enclosures(
    seed: int, cases: int, scenes: int, progress: Progress, tried: Sequence[Enclosed] | None = None
) -> Iterator[Row]:
    """Yield a row a function, `cases` points each, one for the trajectories of `scenes` scenes a kind, and the sum."""
    rows = []
    for one in tried or functions():
        points = counted(cases, f"enclosures of {one.name}, point", progress)
        rows.append(_function_row(one, Random(f"{seed} {one.name}"), points))
        yield rows[-1]
    rows.append(_trajectory_row(Random(f"{seed} ball trajectories"), scenes, progress))
    yield rows[-1]
    trials, failures = sum(row.tried for row in rows), sum(int(row.measured["failures"]) for row in rows)
    yield Row("enclosures", "together", trials, {"failures": failures}, "failures = 0", trials > 0 and not failures)


def _function_row(one: Enclosed, random: Random, cases: Iterable[int]) -> Row:
    trials, undecided, missed = 0, Counter[str](), []
    for _ in cases:
        digits, points = random.choice(_DIGITS), one.draw(random)
        exact = (one.scene(random),) if one.scene else ()
        coarse, fine = Ball(digits), Ball(3 * digits)
        try:
            with coarse.context():
                enclosures = one.value(coarse, *exact, *(_ball_around(random, coarse, point) for point in points))
            with fine.context():
                truths = one.value(fine, *exact, *(fine.number(point) for point in points))
                meet = meetings(enclosures, truths)
        except NumericsError as error:
            undecided[type(error).__name__] += 1
            continue
        trials += len(meet)
        if not all(meet):
            missed.append(f"{digits} digits at {points} {exact}")
    return _row(f"function: {one.name}", trials, undecided, missed)


def _ball_around(random: Random, ball: Ball, point: Fraction) -> arb:
    """Return a ball that contains an exact point: as tight as can be, or wide with the point anywhere in it."""
    if random.random() < 0.5:
        return ball.number(point)
    radius = abs(point) * Fraction(1, 10 ** random.randint(2, ball.digits))
    shift = radius * Fraction(random.randint(-1000, 1000), 1000)
    return ball.number(point + shift) + arb(0, 1) * ball.number(radius)


def meetings(enclosures: Numbers, truths: Numbers) -> list[bool]:
    """Return for each finite enclosure whether it has a point in common with the narrower ball around the truth.

    An enclosure without bounds says nothing: it is no trial.
    """
    pairs = zip(enclosures, truths, strict=True)
    return [bool(truth.is_finite() and wide.overlaps(truth)) for wide, truth in pairs if wide.is_finite()]


def _trajectory_row(random: Random, scenes: int, progress: Progress) -> Row:
    trials, undecided, missed = 0, Counter[str](), []
    for kind, draw in KINDS.items():
        for case in range(scenes):
            progress(f"ball trajectories: {kind}, scene {case + 1} of {scenes}")
            scene, digits = draw(random), random.choice(_DIGITS)
            try:
                coarse = run_scene(scene, Ball(digits), _MAX_EVENTS)
                fine = run_scene(scene, Ball(3 * digits), _MAX_EVENTS)
            except NumericsError as error:
                undecided[type(error).__name__] += 1
                continue
            counted = compare_trajectories(coarse, fine)
            trials += counted or 0
            if counted is None:
                missed.append(f"{digits} digits, {kind}: {scene}")
    return _row("trajectories", trials, undecided, missed)


def compare_trajectories(coarse: Trajectory, fine: Trajectory) -> int | None:
    """Return how many enclosures of two ball trajectories meet; None if two do not, or the event sequences differ."""
    if coarse.modes != fine.modes or coarse.event_kinds != fine.event_kinds or coarse.status is not fine.status:
        return None
    numbers = [tuple(_numbers(one)) for one in (coarse, fine)]
    with fine.arithmetic.context():
        meet = meetings(*numbers)
    return len(meet) if all(meet) else None


def _numbers(trajectory: Trajectory) -> Iterator[arb]:
    for event in trajectory.events:
        yield event.t
        yield from event.y
        yield from event.reduced
    yield from trajectory.final
    ledger = trajectory.ledger
    yield from (ledger.initial, ledger.final, ledger.friction, ledger.viscous, ledger.residual)


def _row(name: str, trials: int, undecided: Counter[str], missed: list[str]) -> Row:
    measured = {"failures": len(missed)} | {f"refused, {kind}": count for kind, count in sorted(undecided.items())}
    passed = trials > 0 and not missed
    return Row("enclosures", name, trials, measured, "failures = 0", passed, [{"missed": missed[:_KEPT]}])
