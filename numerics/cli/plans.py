"""`python -m numerics track`, `move` and `ring`: references, transfers, and when a motion has settled."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from numerics.cli.printing import answer, draw, number_lines, numbers
from numerics.exits import FAILED, OK, refuse
from numerics.files import whole_file
from numerics.shown import shown_steps

if TYPE_CHECKING:
    from numerics.scene import Scene


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
        "stuck_amplitude": ("amplitude that sticking at the limit needs", "N"),
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
    return _hand_over(found.scene, options, "no transfer is given: between these amplitudes the least time is open")


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
