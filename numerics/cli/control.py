"""`python -m numerics response`, `track`, `move` and `ring`: what a control engineer asks of a pair.

The long run under a periodic force; references, transfers, and when a motion has settled.
"""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any, cast

from numerics.cli.printing import answer, draw, number_lines, numbers
from numerics.exits import FAILED, OK, refuse
from numerics.files import whole_file
from numerics.shown import shown_steps

if TYPE_CHECKING:
    from numerics.control.response import PeriodicMotions, Response
    from numerics.plane.rotating import RotatingResponse
    from numerics.scene import Scene


def print_response(options: argparse.Namespace) -> int:
    """Print the regime of a scene under its periodic force, with thresholds, periodic motion and multipliers."""
    from numerics.control.answers import solved_again
    from numerics.control.response import PeriodicMotions, response
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
    "non_stop": ("U**, needed to slip for ever with two reversals a period", "N"),
    "drift": ("mean velocity of body 2", "m/s"),
    "growth": ("v1's amplitude grows by", "m/s^2 at least"),
    "decay": ("decay", "of a distance left a period"),
}
_SLIPS_FOR_EVER = {
    "yes": "two reversals: at this amplitude that motion keeps slipping",
    "below U**": "two reversals: none slips for ever so at this amplitude, which is below U**",
    "turns back": "two reversals: U** is not enough here; at this amplitude the relative velocity changes its sign",
    "undecided": "two reversals: it is not decided whether the relative velocity keeps its sign at this amplitude",
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


def print_tracking(options: argparse.Namespace) -> int:
    """Print what a reference asks of the interface, and write the force that makes body 2 follow, as a scene."""
    from numerics.arithmetic.ball import Ball
    from numerics.control.answers import solved_again
    from numerics.control.tracking import track
    from numerics.scene.decimals import decimal_text
    from numerics.scene.file import load_line, load_reference

    scene = load_line(options.scene)
    found = track(scene, load_reference(options.reference), digits=options.digits, max_digits=options.max_digits)
    solved_again(found)
    draw(options, "draw_tracking", found, scene.pair)
    demands, lines = [], []
    for one in found.demands:
        shown = numbers({"asked": one.force, "at": one.at}, found.digits)
        start, end, b = (decimal_text(exact) for exact in (one.start, one.end, one.b))
        verdict = "within"
        if not one.possible:
            with Ball(found.digits + 20).context():
                shown["too_much_by"] = (one.force - Ball.number(one.b)).upper().str(3, radius=False)
            verdict = f"TOO MUCH by {shown['too_much_by']} N for"
        demands.append({"piece": one.number, "possible": one.possible, **shown, "from": start, "until": end, "b": b})
        lines.append(f"piece {one.number}, {start} s to {end} s: asks {shown['asked']} N, {verdict} b = {b} N")
    if found.scene is not None and found.is_at_limit and found.force_error > 0:
        lines.append(f"friction is at its limit: phases rounded to 60 digits change {found.force_error:.0e} N s in all")
    record = {"possible": found.scene is not None, "demands": demands, "force_error": f"{found.force_error:.1e}"}
    answer(options, record | {"digits": found.digits} | _scene_key(found.scene), lines)
    return _hand_over(found.scene, options, "no force makes body 2 follow: friction cannot give what a piece asks")


def print_transfer(options: argparse.Namespace) -> int:
    """Print the fastest transfer from rest to rest, and write its force as a scene."""
    from numerics.control.answers import solved_again
    from numerics.control.transfer import Road, fastest_transfer
    from numerics.scene.file import load_line

    asked = {name: getattr(options, name) for name in ("amplitude", "margin", "digits", "max_digits")}
    found = fastest_transfer(load_line(options.scene), options.distance, **asked)
    solved = solved_again(found)
    if solved is not None:
        draw(options, "draw_transfer", found, solved)
    named = {
        "bound": ("no control arrives before", "s"),
        "time": ("this transfer takes", "s"),
        "stuck_amplitude": ("amplitude that sticking at the limit needs, or at the margin below it", "N"),
        "least_amplitude": ("least amplitude with which the bound can be met", "N"),
    }
    shown = numbers({name: getattr(found, name) for name in named}, found.digits)
    lines = [f"{found.road.value}; {found.fastest}" if found.scene else found.fastest, *number_lines(shown, named)]
    if found.road is Road.SLIP:
        slips = "the written decimals leave slips of about 10^-20 m where the bodies stick"
        lines.append(f"friction is at its limit: {slips}; a transfer with --margin keeps clear of them")
    elif found.road is Road.STUCK and found.margin == 0:
        lines.append("friction is within 10^-18 of its limit, as far as decimals go; --margin keeps clear of it")
    road = found.road.name.lower().replace("_", "-")
    record = {"road": road, "sentence": found.road.value, "fastest": found.fastest, **shown, "digits": found.digits}
    answer(options, record | _scene_key(found.scene), lines)
    return _hand_over(found.scene, options, "no transfer is given: at this amplitude the least time is open")


def _scene_key(scene: Scene | None) -> dict[str, str]:
    from numerics.scene.writing import scene_text

    return {} if scene is None else {"scene": scene_text(scene)}


def _hand_over(scene: Scene | None, options: argparse.Namespace, otherwise: str) -> int:
    """Write or print a scene; FAILED with a sentence if there is none."""
    if scene is None:
        return refuse(otherwise, FAILED)
    text = _scene_key(scene)["scene"]
    if options.out is not None:
        with whole_file(options.out) as file:
            file.write(text.encode())
    elif not options.json:
        print(text, end="")
    return OK


def print_ring(options: argparse.Namespace) -> int:
    """Print when the relative motion of a scene enters its tolerance ring for good."""
    from numerics.control.ring import ring_entry
    from numerics.scene.file import load_line

    asked = {name: getattr(options, name) for name in ("rate", "digits", "max_digits")}
    with shown_steps() as say:
        found = ring_entry(load_line(options.scene), options.radius, **asked, tell=say)
    draw(options, "draw_ring", found)
    shown = numbers({"entry": found.entry, "centre": found.centre}, found.digits)
    around, less = ("limit", "") if found.orbit is None else ("periodic motion", " less that of the periodic motion")
    named = {
        "entry": ("inside the ring for good from t", "s"),
        "centre": (f"its centre, the limit of x1 - x2{less},", "m"),
    }
    lines = [*number_lines(shown, named), f"{found.why}; {found.digits} right digits, proved"]
    answer(options, {**shown, "around": around, "why": found.why, "digits": found.digits}, lines)
    return OK
