"""The reference of forced scenes checked by itself: with other digits and steps it comes to the frozen answers."""

import pytest
from flint import arb, ctx
from forced_reference import Reference
from sixty_digits import FORCED, forced_scene

# longer than a second, or decided by less than the digits of a quick run
LONG = {"four-thousand-events", "fast-ripple", "mass-ratio-1e-6", "sine-that-starts-late", "thousand-pieces"}
SHARP = {name for name in FORCED if "just-" in name and "contact" in name}
SIGNS = {"0": 0, "+": 1, "-": -1}


@pytest.mark.parametrize("name", sorted(set(FORCED) - LONG - SHARP))
def test_fewer_digits_and_other_steps_come_to_the_same(name):
    found, truth = Reference(forced_scene(name), digits=60, radians=3).run(), FORCED[name]
    assert found.modes == [SIGNS[one] for one in truth["modes"]]
    kept = [(found.events[one["n"]], one) for one in truth["events"]]
    assert all(event.cause == one["cause"] for event, one in kept)
    got = [(event.t, *event.y) for event, _ in kept] + [(found.t, *found.state())]
    scales = (0, found.far, found.fast, found.far, found.fast)
    with ctx.workdps(60):
        for row, right in zip(got, [*(one["row"] for _, one in kept), truth["final"]], strict=True):
            for one, text, scale in zip(row, right, scales, strict=True):
                assert abs(one - arb(text)) <= arb(10) ** -40 * (abs(arb(text)) + scale)
