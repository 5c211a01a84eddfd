"""When a pair under a force that ends as a constant or as sines is known to stick for ever.

In stick the motion is the stuck response and a free part (e, e') whose energy a2 e^2 + M e'^2 never grows. The load of
the free part is at most (m2/M) (sqrt(a2) + a1/sqrt(M)) times the root of it, that of the response at most the sum of
m2 omega^2 |A|/Z(M): once both together are below b, the pair never slips again.
"""

from __future__ import annotations

from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import sqrt
from numerics.control.orbit import Drive
from numerics.control.response import stuck_state
from numerics.control.thresholds import stiffness
from numerics.long_time.resting_place import RestingPlace
from numerics.motion.modes import Mode


def stuck_for_ever(trajectory: Any, drive: Drive) -> RestingPlace | None:
    """Return where a trajectory in balls sticks for ever from its last event on; None if that is not proved yet.

    `drive` acts at the horizon and after it. In the arithmetic's context.
    """
    response = stuck_state(drive, Ball.number(trajectory.scene.until))
    if trajectory.final_mode is not Mode.STICK or response is None:
        return None
    x1, v1, x2, _ = trajectory.final_state
    pair, number = drive.pair, Ball.number
    place, speed = x1 - response[0], v1 - response[1]
    energy = number(pair.a2) * place * place + number(pair.mass) * speed * speed
    root = number(pair.a2).sqrt() + number(pair.a1) / number(pair.mass).sqrt()
    load = number(pair.m2 / pair.mass) * root * sqrt(energy)
    for one in drive.piece.sines:
        load += number(pair.m2 * abs(one.amplitude) * one.omega**2) / stiffness(pair, pair.mass, one.omega)
    if not load < number(drive.b):
        return None
    return RestingPlace(x1 - x2, len(trajectory.events) - 1, arb(0), arb(0))
