"""Where a stronger sentence would be false: friction read literally."""

from dataclasses import replace

import pytest

from numerics import (
    Force,
    InvalidScene,
    fastest_transfer,
    load_reference,
    load_scene,
    solve,
    track,
)
from numerics.control.tracking import stuck_force


def test_read_literally_friction_gives_what_a_reference_asks():
    """sgn(0) = 0 with a stick that is never left: body 2 follows too-fast."""
    rest, reference = replace(load_scene("at-rest"), law="three-valued-sgn", until=2), load_reference("too-fast")
    force = stuck_force(rest.pair, Force(reference))
    assert solve(replace(rest, force=force)).sol(2) == pytest.approx([0.1, 0, 0.1, 0], abs=1e-9)
    for asked in (lambda: track(rest, reference), lambda: fastest_transfer(rest, "0.01")):
        with pytest.raises(InvalidScene, match="law"):
            asked()
