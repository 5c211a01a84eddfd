"""`python -m numerics response`, `track`, `move`, `ring` and `damping`: control questions about a pair.

Long-time response to a periodic force; references, transfers, settling. Each command computes its result, solves it
again event by event where it is a scene, draws it, and prints it as JSON or as lines.
"""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from numerics.cli.printing import answer, asked, draw, in_brief, number_lines, numbers, write_text
from numerics.exits import FAILED, OK, USAGE, refuse
from numerics.meter import shown_steps

if TYPE_CHECKING:
    from numerics.control.response import Response
    from numerics.control.rotating import RotatingResponse
    from numerics.control.transfer import Transfer

Shown = tuple[dict[str, Any], list[str]]
"""A result for JSON, and as lines."""


def _ask(options: argparse.Namespace, question: str, *given: Any, names: str = "") -> tuple[Any, Any]:
    """Return the scene of a command, and what the function of a name finds for it, with options of these names."""
    import numerics
    from numerics.scene.file import load_line, load_scene

    scene = (load_scene if question == "response" else load_line)(options.scene)
    with shown_steps():
        return scene, getattr(numerics, question)(scene, *given, **asked(options, *names.split()))


def _print(options: argparse.Namespace, found: Any, shown: Shown, unproved: str = "") -> int:
    """Print what is found, and how many digits of it are right."""
    record, lines = shown
    answer(options, record | {"digits": found.digits}, [*lines, f"{found.digits} right digits, proved{unproved}"])
    return OK


def print_response(options: argparse.Namespace) -> int:
    """Print the regime of a scene under its periodic force, with thresholds, periodic motion and multipliers."""
    from numerics.control.rotating import RotatingResponse

    _, found = _ask(options, "response", names="amplitude omega max_events")
    turns = isinstance(found, RotatingResponse)
    draw(options, "draw_rotating" if turns else "draw_response", found)
    return _print(options, found, _of_rotating(found) if turns else _of_response(found))


def _of_response(found: Response) -> Shown:
    from numerics.linear.modes import MODES

    names = {"regime": found.regime.name.lower().replace("_", "-"), "sentence": found.regime.value}
    record: dict[str, Any] = {**names, "attraction": found.attraction}
    if found.thresholds is not None:
        record |= numbers(found.thresholds, "entrainment", "exception", "non_stop")
    growth = found.growth if found.growth > 0 else None
    record |= numbers(found, "drift", growth=growth, decay=next(iter(found.moduli), None))
    lines = [f"{found.regime.value}; {found.attraction}", *number_lines(record)]
    record |= {"multipliers": [], "events": []}
    for one, size in zip(found.multipliers or (), found.moduli, strict=True):
        record["multipliers"].append(numbers(found, re=one.real, im=one.imag, size=size))
        lines.append("  multiplier {}, modulus {}".format(*(x.str(found.digits, radius=False) for x in (one, size))))
    for leg in () if found.orbit is None else found.orbit.legs:
        event = {"to": MODES[leg.side].value, **numbers(found, t=leg.start, x1=leg.state[0], v1=leg.state[1])}
        record["events"].append(event)
        lines.append("  t = {t} s: {to}, x1 = {x1} m, v1 = v2 = {v1} m/s".format(**event))
    return record, lines


def _of_rotating(found: RotatingResponse) -> Shown:
    """Return the motion that rotates with a force; vectors as parts along x, as the force is at t = 0, and y."""
    vectors = {name: getattr(found, name) for name in ("friction", "q1", "v1", "v2")}
    values = {f"{name}_along": one.real for name, one in vectors.items()}
    values |= {f"{name}_across": one.imag for name, one in vectors.items()}
    record: dict[str, Any] = {"sentence": found.sentence, "attracts": found.attracts, "clockwise": found.clockwise}
    record |= numbers(found, "threshold", "speed", **values)
    every = "every motion tends to it" if found.attracts else "other motions need not tend to it"
    lines = [f"{found.sentence}; {every}", *number_lines(record)]
    lines += [f"  exponent {one.str(found.digits, radius=False)} 1/s" for one in found.exponents]
    return record | {"exponents": [numbers(found, re=one.real, im=one.imag) for one in found.exponents]}, lines


def print_tracking(options: argparse.Namespace) -> int:
    """Print the friction that a reference requires, and write the force that makes body 2 follow it, as a scene."""
    from numerics.scene.decimals import decimal_text
    from numerics.scene.file import load_reference

    scene, found = _ask(options, "track", load_reference(options.reference))
    draw(options, "draw_tracking", found, scene.pair)
    demands, lines = [], []
    for one in found.demands:
        excess = None if one.possible else one.too_much
        start, end, b = (decimal_text(exact) for exact in (one.start, one.end, one.b))
        verdict = "within" if excess is None else f"TOO MUCH by {in_brief(excess, found.digits)} for"
        needs = in_brief(one.force, found.digits)
        lines.append(f"piece {one.number}, {start} s to {end} s: requires {needs}, {verdict} b = {b} N")
        shown = numbers(found, asked=one.force, at=one.at, too_much_by=excess)
        demands.append({"piece": one.number, "possible": one.possible, **shown, "from": start, "until": end, "b": b})
    if found.scene is not None and not found.sticks:
        lines.append(f"friction is at its limit: rounded phases change u by {found.force_error:.0e} N s in total")
    record = {"possible": found.scene is not None, "demands": demands, "force_error": f"{found.force_error:.1e}"}
    otherwise = "no force makes body 2 follow: a piece requires more than friction can give"
    return _plan(options, found, (record, lines), otherwise)


def print_transfer(options: argparse.Namespace) -> int:
    """Print the transfer from rest to rest with the least time, energy or peak, and write its force as a scene."""
    if (options.least == "time") is (options.time is not None):
        return refuse("--least energy or peak and --time go together; leave both out for the least time", USAGE)
    if options.time is None:
        _, found = _ask(options, "fastest_transfer", options.distance, names="amplitude margin")
    elif options.amplitude is not None:
        return refuse("--amplitude is for the least time; leave it out with --least energy or peak", USAGE)
    else:
        _, found = _ask(options, "cheapest_transfer", options.distance, options.time, names="least margin")
    otherwise = "no transfer is given: the minimum time at this amplitude is not known"
    return _plan(options, found, _of_transfer(found, options.least), otherwise)


def _of_transfer(found: Transfer, least: str) -> Shown:
    from numerics.scene.decimals import decimal_text

    costs = {least: found.cost, f"least_{least}": found.least_cost}
    shown = numbers(found, "bound", "time", "stuck_amplitude", "least_amplitude", **costs)
    road = "" if found.scene is None else found.road.value  # what is open says so itself
    lines = ["; ".join(filter(None, (road, found.fastest))), *number_lines(shown)]
    record = {"road": found.road.name.lower().replace("_", "-"), "sentence": found.road.value, **shown}
    if found.holding_force is None:
        rounded = {
            "SLIP": "its decimals may leave slips of about 10^-20 m",
            "STUCK": "to within 10^-18, as its times are decimals",
        }
        if found.margin == 0 and found.road.name in rounded:
            lines.append(f"friction is at its limit: {rounded[found.road.name]}; --margin avoids this")
        return record | {"fastest": found.fastest}, lines
    limit = "at its limit, or the margin, for a part of the time" if found.is_at_limit else "below its limit"
    holds = decimal_text(found.holding_force)
    lines += [f"friction is {limit}", f"afterwards, and not counted, the force a2 D = {holds} N holds the pair there"]
    return record | {"is_at_limit": found.is_at_limit, "holding_force": holds}, lines


def _plan(options: argparse.Namespace, found: Any, shown: Shown, otherwise: str) -> int:
    """Solve a plan again, draw and print it, and write or print its scene; FAILED with a sentence if there is none."""
    from numerics.control.answers import solved_again
    from numerics.control.transfer import Transfer
    from numerics.scene.file import scene_text

    solved, (record, lines) = solved_again(found), shown
    if isinstance(found, Transfer) and solved is not None:
        draw(options, "draw_transfer", found, solved)
    text = "" if found.scene is None else scene_text(found.scene)
    if text and options.out is None:
        lines = [f"# {line}" for line in lines]  # all of it is a scene file then
    answer(options, record | {"digits": found.digits} | ({"scene": text} if text else {}), lines)
    if not text:
        return refuse(otherwise, FAILED)
    if options.out is not None:
        write_text(text, options.out)
    elif not options.json:
        print(text, end="")
    return OK


def print_ring(options: argparse.Namespace) -> int:
    """Print the time from which on the relative motion of a scene stays inside its tolerance ring."""
    _, found = _ask(options, "ring_entry", options.radius, names="rate")
    draw(options, "draw_ring", found)
    record = numbers(found, "entry", "centre")
    less = "" if found.orbit is None else " minus that of the periodic motion"
    lines = [*number_lines(record, centre=f"its centre, the limit of x1 - x2{less},"), found.why]
    around = "limit" if found.orbit is None else "periodic motion"
    return _print(options, found, ({**record, "around": around, "why": found.why}, lines))


def print_damping(options: argparse.Namespace) -> int:
    """Print when a free pair sticks permanently, when it rests, and the damper that is best for that."""
    from numerics.scene.decimals import decimal_text

    _, found = _ask(options, "damping", options.tolerance)
    draw(options, "draw_damping", found)
    best = None if found.best is None else decimal_text(found.best)
    record: dict[str, Any] = {"a1": best}
    said = "a1 = infinity is as good as any" if best is None else f"a1 = {best} N s/m"
    lines = [f"best of {len(found.sampled)} dampers tried: {said}"]
    dampers = {"best": best, "own": decimal_text(found.scene.pair.a1), "heavy": "infinity"}
    for (name, a1), times in zip(dampers.items(), (found.at_best, found.own, found.heavy), strict=True):
        record[name] = None if times is None else numbers(found, **times._asdict())
        if times is not None:
            text = "  a1 = {}: stuck from {stuck} s, at rest from {rest} s".format(a1, **record[name])
            lines.append(text.replace("from inf s", "never"))
    return _print(options, found, (record, lines), "; that no other damper is better is not")
