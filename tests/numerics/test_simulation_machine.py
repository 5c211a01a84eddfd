"""A simulation driven by rules: advance, go to the next event, switch arithmetic, serialise and restore, flip signs.

After every rule it is held against one uninterrupted solve in balls. The flow never moves two solutions apart in the
energy norm, so what rounding a restart costs bounds the distance for ever.
"""

from fractions import Fraction
from itertools import pairwise

from flint import arb, fmpq
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule
from strategies import scenes

from numerics.errors import EventUndecided, OutOfRange
from numerics.linear.modes import Mode
from numerics.scene import Scene, State
from numerics.scene.file import parse_scene
from numerics.solver.solve import solve
from numerics.trajectory.comparison import as_fraction
from numerics.trajectory.trajectory import Trajectory

EVENTS = 10
WAYS = {
    "ball": {"digits": 40},
    "mpmath": {"arithmetic": "mpmath", "digits": 40},
    "float64": {"arithmetic": "float64"},
}
WRITTEN = {"ball": 45, "mpmath": 45, "float64": 17}
ERROR = {"ball": 1e-38, "mpmath": 1e-36, "float64": 1e-8}
"""What each arithmetic may be off in the energy norm, relative to the initial state."""
MARGIN = {"ball": 1e-25, "mpmath": 1e-25, "float64": 1e-5}
"""How far from a tie (w = 0, an entry on the edge) every event must stay for the sequences to be compared."""


def exact(value) -> Fraction:
    """The rational of a float or an mpmath number, or a ball's midpoint."""
    if isinstance(value, arb):
        mantissa, exponent = value.mid().man_exp()
        return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return as_fraction(value)


def decimal_text(value: Fraction, digits: int) -> str:
    """A number rounded to so many decimal digits."""
    if value == 0:
        return "0"
    place = digits - (len(str(abs(value.numerator))) - len(str(value.denominator)))
    return f"{round(value * Fraction(10) ** place)}e{-place}"


def scene_text(scene: Scene, state: tuple[str, ...], until: Fraction) -> str:
    """The scene file of the same pair with another state and horizon; parameters with 60 digits, or exactly."""
    pair = scene.pair
    lines = [
        "[pair]",
        *(f'{name} = "{decimal_text(getattr(pair, name), 60)}"' for name in ("m1", "m2", "a1", "a2", "b")),
    ]
    lines += ["[initial]", *(f'{name} = "{one}"' for name, one in zip(("x1", "v1", "x2", "v2"), state, strict=True))]
    return "\n".join([*lines, "[run]", f'until = "{decimal_text(until, 60)}"', f'law = "{scene.law.value}"', ""])


class Simulation(RuleBasedStateMachine):
    """`now` is the time within the current run, which began at `began` of the whole one; `sign` tells the flips."""

    @initialize(scene=scenes(damped=None, periods=(1, 2)), way=st.sampled_from(list(WAYS)))
    def begin(self, scene, way):
        whole = solve(scene, max_events=EVENTS, **WAYS["ball"])
        if not whole.success:  # end before the cap
            scene = Scene(scene.pair, scene.initial, exact(whole.events[-1].t).limit_denominator(10**30), scene.law)
        # everything in decimals, as the files say it
        at = [decimal_text(one, 60) for one in (scene.initial.x1, scene.initial.v1, scene.initial.x2, scene.initial.v2)]
        scene = parse_scene(scene_text(scene, tuple(at), scene.until))
        self.whole = self.run = solve(scene, max_events=EVENTS + 2, **WAYS["ball"])
        self.scene, self.way, self.sign = scene, "ball", 1
        self.began = self.now = Fraction(0)
        self.error = ERROR["ball"]
        self.energy = scene.energy
        self.switch(way)

    @rule(part=st.fractions(0, 1, max_denominator=1000))
    def advance(self, part):
        self.now += (self.scene.until - self.now) * part

    @rule()
    def go_to_the_next_event(self):
        later = [exact(event.t) for event in self.run.events if exact(event.t) > self.now]
        if later:
            self.now = min(later[0], self.scene.until)

    @rule(way=st.sampled_from(list(WAYS)))
    def switch(self, way):
        try:
            self.run: Trajectory = solve(self.scene, max_events=EVENTS + 4, **WAYS[way])
        except (EventUndecided, OutOfRange):  # too near a tie for its digits
            assert way != "ball"
            self.switch("ball")
            return
        self.way, self.error = way, max(self.error, ERROR[way])

    @rule()
    def serialise_and_restore(self):
        left = self.scene.until - self.now
        if left < self.scene.until / 1000:
            return
        values = [exact(one) for one in self.run.sol(self.now)]
        if self.mode is Mode.STICK:
            values[1] = values[3]
        text = scene_text(self.scene, tuple(decimal_text(one, WRITTEN[self.way]) for one in values), left)
        self.scene, self.began, self.now = parse_scene(text), self.began + self.now, Fraction(0)
        self.switch(self.way)

    @rule()
    def flip_the_signs(self):
        at = self.scene.initial
        flipped = State(-at.x1, -at.v1, -at.x2, -at.v2)
        self.scene, self.sign = Scene(self.scene.pair, flipped, self.scene.until, self.scene.law), -self.sign
        self.switch(self.way)

    @property
    def mode(self) -> Mode:
        return self.run.mode_at(self.now)

    @property
    def state(self) -> State:
        return State(*(exact(one) for one in self.run.sol(self.now)))

    @property
    def scale(self) -> Fraction:
        """The energy that errors are relative to."""
        return self.whole.scene.energy + self.whole.scene.pair.critical_energy

    @property
    def next_to_an_event(self) -> bool:
        tiny = self.scene.until / 10**6
        return any(abs(exact(event.t) - self.now) < tiny for event in self.run.events) or self.now < tiny

    @invariant()
    def the_energy_never_increases(self):
        energy = Scene(self.scene.pair, self.state, 1).energy
        assert energy <= self.energy + self.scale * Fraction(4 * self.error)
        self.energy = energy

    @invariant()
    def the_mode_is_legal(self):
        pair, at, mode = self.scene.pair, self.state, self.mode
        if self.next_to_an_event:
            return
        if mode is Mode.STICK:
            load = (pair.a2 * at.x1 + pair.a1 * at.v1) / (pair.a2 * pair.half_width)
            assert abs(load) <= 1 + Fraction(self.error) * 100
            assert at.v1 == at.v2
        else:
            assert mode.sign * (at.v1 - at.v2) > 0

    @invariant()
    def the_excess_is_what_the_ledger_leaves(self):
        reduced = self.run.reduced(self.now)
        energy = Scene(self.scene.pair, self.state, 1).energy / self.scene.pair.critical_energy
        size = max(1, energy, self.scale / self.scene.pair.critical_energy)
        assert abs(exact(reduced.w) - (energy - 1)) <= size * Fraction(ERROR[self.way])
        ledger = self.run.ledger
        assert abs(exact(ledger.residual)) <= self.scale * Fraction(ERROR[self.way])

    @invariant()
    def it_is_where_the_uninterrupted_run_is(self):
        at, time = self.state, min(self.began + self.now, self.whole.scene.until)
        there = [self.sign * exact(one) for one in self.whole.sol(time)]
        pair = self.scene.pair
        apart = Scene(pair, State(at.x1 - there[0], at.v1 - there[1], 0, at.v2 - there[3]), 1).energy
        assert apart <= self.scale * Fraction(30 * self.error) ** 2

    @invariant()
    def the_sequence_is_that_of_the_uninterrupted_run(self):
        margin = max(MARGIN[self.way], 1e4 * self.error)
        if self.whole_is_marginal(margin):
            return
        late = self.began + self.now + self.whole.scene.until * Fraction(margin)
        early = self.whole.scene.until * (1 - Fraction(margin))
        ours = [e.after.sign * self.sign for e in self.run.events if late < self.began + exact(e.t) < early]
        theirs = [e.after.sign for e in self.whole.events if late < exact(e.t) < early]
        assert ours == theirs

    def whole_is_marginal(self, margin: float) -> bool:
        """Whether a rounding of relative size `margin` might add or remove an event, or move one across `now`."""
        with self.whole.arithmetic.context():
            near = arb(fmpq(*Fraction(margin).as_integer_ratio()))
            two_zeta = self.whole.frame.two_zeta
            times = [*(event.t for event in self.whole.events), self.whole.segments[-1].end]
            short = self.whole.scene.until * Fraction(4 * margin)
            if any(exact(b) - exact(a) < short for a, b in pairwise(times)):
                return True
            if any(abs(exact(t) - self.began - self.now) < short for t in times):
                return True
            states = [event.reduced for event in self.whole.events] + [self.whole.initial]
            return any(
                not abs(state.w) > near or not abs(abs(state.X + two_zeta * state.V1) - 1) > near
                for event, state in zip([*self.whole.events, None], states, strict=True)
                if event is None or event.after is Mode.STICK or event.before is not Mode.STICK
            )


TestSimulation = Simulation.TestCase
TestSimulation.settings = settings(max_examples=settings().max_examples, stateful_step_count=10)
