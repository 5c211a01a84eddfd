"""`python -m numerics track`, `move` and `ring`: references, transfers, and when a motion has settled."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING

from numerics.cli.printing import numbers, print_numbers, shown_steps, write_figure
from numerics.exits import FAILED, OK, USAGE, refuse, wrong_path
from numerics.files import whole_file

if TYPE_CHECKING:
    from numerics.control.transfer import Transfer
    from numerics.scene import Scene


def print_tracking(options: argparse.Namespace) -> int:
    """Print what a reference asks of the interface, and write the force that makes body 2 follow, as a scene."""
    from numerics.arithmetic.ball import Ball
    from numerics.control.answers import solved_again
    from numerics.control.tracking import track
    from numerics.scene.decimals import decimal_text
    from numerics.scene.file import load_reference, load_scene

    wrong = wrong_path(options.out) or wrong_path(options.plot, "--plot")
    if wrong is not None:
        return refuse(wrong, USAGE)
    scene = load_scene(options.scene)
    found = track(scene, load_reference(options.reference), digits=options.digits, max_digits=options.max_digits)
    solved_again(found)
    if options.plot is not None:
        from numerics.control.pictures import draw_tracking

        write_figure(draw_tracking(found, scene.pair), options.plot)
    demands = []
    for demand in found.demands:
        shown = numbers({"asked": demand.force, "at": demand.at}, found.digits)
        with Ball(found.digits + 20).context():
            over = (demand.force - Ball.number(demand.b)).upper()
            shown |= {} if demand.possible else {"too_much_by": over.str(3, radius=False)}
        shown |= {"from": decimal_text(demand.start), "until": decimal_text(demand.end), "b": decimal_text(demand.b)}
        demands.append({"piece": demand.number, "possible": demand.possible, **shown})
    record = {"possible": found.scene is not None, "demands": demands, "force_error": f"{found.force_error:.1e}"}
    if options.json:
        print(json.dumps(record | {"digits": found.digits} | _scene_key(found.scene), indent=1))
    else:
        for one in demands:
            verdict = "within" if one["possible"] else f"TOO MUCH by {one['too_much_by']} N for"
            span = f"piece {one['piece']}, {one['from']} s to {one['until']} s"
            print(f"{span}: asks {one['asked']} N, {verdict} b = {one['b']} N")
        if found.scene is not None and found.is_at_limit and found.force_error > 0:
            print(f"friction is at its limit: phases rounded to 60 digits change {found.force_error:.0e} N s in all")
    return _hand_over(found.scene, options, "no force makes body 2 follow: friction cannot give what a piece asks")


def print_transfer(options: argparse.Namespace) -> int:
    """Print the fastest transfer from rest to rest, and write its force as a scene."""
    from numerics.control.answers import solved_again
    from numerics.control.transfer import fastest_transfer
    from numerics.scene.file import load_scene

    wrong = wrong_path(options.out) or wrong_path(options.plot, "--plot")
    if wrong is not None:
        return refuse(wrong, USAGE)
    found = fastest_transfer(
        load_scene(options.scene),
        options.distance,
        amplitude=options.amplitude,
        margin=options.margin,
        digits=options.digits,
        max_digits=options.max_digits,
    )
    solved = solved_again(found)
    if options.plot is not None and solved is not None:
        from numerics.control.pictures import draw_transfer

        write_figure(draw_transfer(found, solved), options.plot)
    names = ("bound", "time", "stuck_amplitude", "least_amplitude")
    shown = numbers({name: getattr(found, name) for name in names}, found.digits)
    if options.json:
        road = found.road.name.lower().replace("_", "-")
        record = {"road": road, "sentence": found.road.value, "fastest": found.fastest, **shown, "digits": found.digits}
        print(json.dumps(record | _scene_key(found.scene), indent=1))
    else:
        _print_transfer(found, shown)
    return _hand_over(found.scene, options, "no transfer is given: between these amplitudes the least time is open")


def _print_transfer(found: Transfer, shown: dict[str, str]) -> None:
    from numerics.control.transfer import Road

    print(f"{found.road.value}; {found.fastest}" if found.scene else found.fastest)
    labels = {
        "bound": "no control arrives before",
        "time": "this transfer takes",
        "stuck_amplitude": "amplitude that sticking at the limit needs",
        "least_amplitude": "least amplitude with which the bound can be met",
    }
    print_numbers(shown, {"bound": "s", "time": "s", "stuck_amplitude": "N", "least_amplitude": "N"}, labels)
    if found.road is Road.SLIP:
        slips = "the written decimals leave slips of about 10^-20 m where the bodies stick"
        print(f"friction is at its limit: {slips}; a transfer with --margin keeps clear of them")
    elif found.road is Road.STUCK and found.margin == 0:
        print("friction is within 10^-18 of its limit, as far as decimals go; --margin keeps clear of it")


def _scene_key(scene: Scene | None) -> dict[str, str]:
    from numerics.scene.writing import scene_text

    return {} if scene is None else {"scene": scene_text(scene)}


def _hand_over(scene: Scene | None, options: argparse.Namespace, otherwise: str) -> int:
    """Write or print a scene; FAILED with a sentence if there is none."""
    from numerics.scene.writing import scene_text

    if scene is None:
        return refuse(otherwise, FAILED)
    if options.out is not None:
        with whole_file(options.out) as file:
            file.write(scene_text(scene).encode())
    elif not options.json:
        print(scene_text(scene), end="")
    return OK


def print_ring(options: argparse.Namespace) -> int:
    """Print when the relative motion of a scene enters its tolerance ring for good."""
    from numerics.control.ring import ring_entry
    from numerics.scene.file import load_scene

    wrong = wrong_path(options.plot, "--plot")
    if wrong is not None:
        return refuse(wrong, USAGE)
    asked = {name: getattr(options, name) for name in ("rate", "digits", "max_digits")}
    with shown_steps() as say:
        found = ring_entry(load_scene(options.scene), options.radius, **asked, tell=say)
    if options.plot is not None:
        from numerics.control.pictures import draw_ring

        write_figure(draw_ring(found), options.plot)
    shown = numbers({"entry": found.entry, "centre": found.centre}, found.digits)
    if options.json:
        print(
            json.dumps(
                {
                    **shown,
                    "around": "limit" if found.orbit is None else "periodic motion",
                    "why": found.why,
                    "digits": found.digits,
                },
                indent=1,
            )
        )
        return OK
    centre = "the limit of x1 - x2" if found.orbit is None else "the limit of x1 - x2 less that of the periodic motion"
    labels = {"entry": "inside the ring for good from t", "centre": f"its centre, {centre},"}
    print_numbers(shown, {"entry": "s", "centre": "m"}, labels)
    print(f"{found.why}; {found.digits} right digits, proved")
    return OK
