"""`python -m numerics response`: what a pair does in the long run under a periodic force."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any, cast

from numerics.cli.printing import answer, draw, number_lines, numbers
from numerics.exits import OK
from numerics.shown import shown_steps

if TYPE_CHECKING:
    from numerics.control.response import PeriodicMotions, Response
    from numerics.plane.rotating import RotatingResponse


def print_response(options: argparse.Namespace) -> int:
    """Print the regime of a scene under its periodic force, with thresholds, periodic motion and multipliers."""
    from numerics.control.answers import solved_again
    from numerics.control.response import PeriodicMotions, response
    from numerics.scene import Scene
    from numerics.scene.file import load_scene
    from numerics.scene.plane import PlaneScene

    asked = {name: getattr(options, name) for name in ("amplitude", "omega", "digits", "max_digits", "max_events")}
    scene: Scene | PlaneScene = load_scene(options.scene)
    if isinstance(scene, PlaneScene):
        from numerics.cli.surface import print_rotating

        print_rotating(cast("RotatingResponse", response(scene, **asked)), options)
        return OK
    with shown_steps() as say:
        found = cast("Response | PeriodicMotions", response(scene, **asked, tell=say))
        say("solving one period of it again by events")
        for one in found.motions if isinstance(found, PeriodicMotions) else [found]:
            solved_again(one)
    if isinstance(found, PeriodicMotions):
        draw(options, "draw_motions", found)
        record, lines = _of_motions(found)
    else:
        draw(options, "draw_response", found)
        record, lines = _of_response(found)
    answer(options, record, [*lines, f"{found.digits} right digits, proved"])
    return OK


def _of_motions(found: PeriodicMotions) -> tuple[dict[str, Any], list[str]]:
    """Return all motions that were found for JSON, and as lines."""
    edge = numbers({"entrainment": found.entrainment}, found.digits)
    motions = [_of_response(one) for one in found.motions]
    record = {
        "sentence": found.sentence,
        "is_all": found.is_all,
        "starts": found.starts,
        "digits": found.digits,
        **edge,
    }
    lines = [found.sentence, *number_lines(edge, _NAMED)]
    for number, (_, (first, *others)) in enumerate(motions, start=1):
        lines += [f"{number}: {first}", *others]
    return record | {"motions": [one for one, _ in motions]}, lines


def _lines(found: Response, record: dict[str, Any]) -> list[str]:
    """Return a response as lines."""
    lines = [f"{record['sentence']}; {record['attraction']}", *number_lines(record, _NAMED)]
    if "slips_for_ever" in record:
        lines.append(f"  {_SLIPS_FOR_EVER[record['slips_for_ever']]}")
    for multiplier in found.multipliers or ():
        shown, size = (one.str(found.digits, radius=False) for one in (multiplier, abs(multiplier)))
        lines.append(f"  multiplier {shown}, size {size}")
    for event in record["events"]:
        lines.append(f"  t = {event['t']} s: {event['to']}, x1 = {event['x1']} m, v1 = v2 = {event['v1']} m/s")
    return lines


_NAMED = {
    "entrainment": ("U*", "N"),
    "exception": ("other motions stick up to U*/cos(pi omega/(2 Omega))", "N"),
    "non_stop": ("U**, necessary for no stops", "N"),
    "drift": ("mean velocity of body 2", "m/s"),
    "growth": ("v1's amplitude grows by", "m/s^2 at least"),
    "decay": ("decay", "of a distance left a period"),
}
_SLIPS_FOR_EVER = {
    "yes": "no stops: at this amplitude the motion with two reversals a period keeps slipping",
    "below U**": "no stops: not at this amplitude, which is below U**",
    "turns back": "no stops: U** is not enough here; at this amplitude the relative velocity would change its sign",
    "undecided": "no stops: it is not decided whether the relative velocity keeps its sign at this amplitude",
}


def _slips_for_ever(found: Response) -> str:
    """Return whether the motion that reverses twice a period slips for ever at the amplitude of the one sine."""
    from numerics.arithmetic.ball import Ball
    from numerics.control.thresholds import NonStop

    drive, known = found.drive, found.thresholds
    assert known is not None
    sine = drive.piece.sines[0]
    with Ball(found.digits + 10).context():
        amplitude = Ball.number(abs(sine.amplitude))
        if amplitude < known.non_stop:
            return "below U**"
        keeps = NonStop(drive.pair, sine.omega).keeps_slipping(amplitude)
        if keeps and not amplitude > known.non_stop:
            return "undecided"
        return "undecided" if keeps is None else "yes" if keeps else "turns back"


def _of_response(found: Response) -> tuple[dict[str, Any], list[str]]:
    """Return a response for JSON, and as lines."""
    from numerics.linear.modes import MODES

    digits, known = found.digits, found.thresholds
    record: dict[str, Any] = {
        "regime": found.regime.name.lower().replace("_", "-"),
        "sentence": found.regime.value,
        "attraction": found.attraction,
        "digits": digits,
    }
    values = {"drift": found.drift, "growth": found.growth if found.growth > 0 else None}
    if known is not None:
        edges = {"entrainment": known.entrainment, "exception": known.exception, "non_stop": known.non_stop}
        values = edges | values
        if found.growth == 0:
            record["slips_for_ever"] = _slips_for_ever(found)
    multipliers = found.multipliers or ()
    values["decay"] = abs(multipliers[0]) if multipliers else None
    record |= numbers(values, digits)
    record["multipliers"] = [numbers({"re": one.real, "im": one.imag, "size": abs(one)}, digits) for one in multipliers]
    record["events"] = []
    for leg in found.orbit.events if found.orbit is not None else ():
        record["events"].append(
            {"to": MODES[leg.side].value, **numbers({"t": leg.t, "x1": leg.x, "v1": leg.v}, digits)}
        )
    return record, _lines(found, record)
