"""`python -m numerics response`, `track`, `move`, `ring` and `damping`: control questions about a pair.

Long-time response to a periodic force; references, transfers, settling. Each command computes its result, solves it
again event by event where it is a scene, draws it, and prints it as JSON or as lines.
"""

from __future__ import annotations

import argparse
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from numerics.cli.printing import answer, asked, draw, in_brief, number_lines, numbers, write_text
from numerics.exits import FAILED, OK, USAGE, refuse
from numerics.meter import shown_steps

if TYPE_CHECKING:
    from numerics.control.response import Response
    from numerics.control.rotating import RotatingResponse

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


_SLIPS_FOR_EVER = {
    "yes": "at this amplitude that motion slips permanently",
    "below U**": "no such motion slips permanently, as the amplitude is below U**",
    "turns back": "U** is not enough here; v1 - v2 changes its sign between them",
    "undecided": "undecided whether v1 - v2 keeps its sign between them",
}
"""What is known of the motion that reverses twice a period."""


def _slips_for_ever(found: Response) -> str:
    """Return whether the motion that reverses twice a period slips permanently at the amplitude of the one sine."""
    from numerics.arithmetic.ball import Ball

    known = found.thresholds
    assert known is not None
    with Ball(found.digits + 10).context():
        if Ball.number(abs(found.drive.piece.sines[0].amplitude)) < known.non_stop:
            return "below U**"
    if found.orbit is not None and [leg.side for leg in found.orbit.legs] == [1, -1]:
        return "yes"
    return "turns back" if found.is_only_one else "undecided"


def _of_response(found: Response) -> Shown:
    from numerics.linear.modes import MODES

    grows, known, digits = found.growth > 0, found.thresholds, found.digits
    names = {"regime": found.regime.name.lower().replace("_", "-"), "sentence": found.regime.value}
    record: dict[str, Any] = {**names, "attraction": found.attraction}
    lines = [f"{found.regime.value}; {found.attraction}"]
    if known is not None:
        record |= {} if grows else {"slips_for_ever": _slips_for_ever(found)}
        record |= numbers(known, "entrainment", "exception", "non_stop")
    growth, decay = found.growth if grows else None, next(iter(found.moduli), None)
    record |= numbers(found, "drift", growth=growth, decay=decay)
    lines += number_lines(record)
    if "slips_for_ever" in record:
        lines.append(f"  two reversals per period: {_SLIPS_FOR_EVER[record['slips_for_ever']]}")
    record |= {"multipliers": [], "events": []}
    for one, size in zip(found.multipliers or (), found.moduli, strict=True):
        record["multipliers"].append(numbers(found, re=one.real, im=one.imag, size=size))
        lines.append(f"  multiplier {one.str(digits, radius=False)}, modulus {size.str(digits, radius=False)}")
    for leg in () if found.orbit is None else found.orbit.legs:
        event = {"to": MODES[leg.side].value, **numbers(found, t=leg.start, x1=leg.state[0], v1=leg.state[1])}
        record["events"].append(event)
        lines.append(f"  t = {event['t']} s: {event['to']}, x1 = {event['x1']} m, v1 = v2 = {event['v1']} m/s")
    return record, lines


def _of_rotating(found: RotatingResponse) -> Shown:
    """Return the motion that rotates with a force; vectors are complex, with the force along x at t = 0."""
    from flint import acb

    vectors = {name: getattr(found, name) for name in ("friction", "q1", "v1", "v2")}
    parts = {"along": attrgetter("real"), "across": attrgetter("imag")}
    values = {f"{name}_{way}": part(one) for name, one in vectors.items() for way, part in parts.items()}
    record: dict[str, Any] = {name: getattr(found, name) for name in ("sentence", "attracts")}
    record |= numbers(found, "threshold", "speed", **values)
    exponents = [acb(one.real.mid(), 0 if one.imag.contains(0) else one.imag.mid()) for one in found.exponents]
    record["exponents"] = [
        [str(part.str(found.digits, radius=False)) for part in (one.real, one.imag)] for one in exponents
    ]
    every = "every motion tends to it" if found.attracts else "other motions need not tend to it"
    lines = [f"{found.sentence}; {every}", *number_lines(record)]
    lines += [f"  exponent {one.str(found.digits, radius=False)} 1/s" for one in exponents]
    return record, lines


def print_tracking(options: argparse.Namespace) -> int:
    """Print the friction that a reference requires, and write the force that makes body 2 follow it, as a scene."""
    from numerics.scene.decimals import decimal_text
    from numerics.scene.file import load_reference

    scene, found = _ask(options, "track", load_reference(options.reference))
    demands, lines = [], []
    for one in found.demands:
        excess = None if one.possible else one.too_much
        shown = numbers(found, asked=one.force, at=one.at, too_much_by=excess)
        start, end, b = (decimal_text(exact) for exact in (one.start, one.end, one.b))
        asks, verdict = in_brief(one.force, found.digits), "within"
        if excess is not None:
            verdict = f"TOO MUCH by {in_brief(excess, found.digits)} for"
        demands.append({"piece": one.number, "possible": one.possible, **shown, "from": start, "until": end, "b": b})
        lines.append(f"piece {one.number}, {start} s to {end} s: requires {asks}, {verdict} b = {b} N")
    if found.scene is not None and found.is_at_limit and found.force_error > 0:
        lines.append(
            f"friction is at its limit: phases rounded to 60 digits change u by {found.force_error:.0e} N s in total"
        )
    record = {"possible": found.scene is not None, "demands": demands, "force_error": f"{found.force_error:.1e}"}
    otherwise = "no force makes body 2 follow: a piece requires more than friction can give"
    return _plan(options, found, (record, lines), otherwise, scene.pair)


def print_transfer(options: argparse.Namespace) -> int:
    """Print the transfer from rest to rest with the least time, energy or peak, and write its force as a scene."""
    if (options.least == "time") is (options.time is not None):
        return refuse("--least energy or peak and --time go together; leave both out for the least time", USAGE)
    if options.time is None:
        _, found = _ask(options, "fastest_transfer", options.distance, names="amplitude margin")
        shown, otherwise = _of_fastest(found), "no transfer is given: the minimum time at this amplitude is not known"
        return _plan(options, found, shown, otherwise)
    if options.amplitude is not None:
        return refuse("--amplitude is for the least time; leave it out with --least energy or peak", USAGE)
    _, found = _ask(options, "cheapest_transfer", options.distance, options.time, names="least margin")
    return _plan(options, found, _of_cheapest(found, options.least))


def _of_fastest(found: Any) -> Shown:
    from numerics.control.transfer import TransferKind

    shown = numbers(found, "bound", "time", "stuck_amplitude", "least_amplitude")
    lines = [f"{found.road.value}; {found.fastest}" if found.scene else found.fastest, *number_lines(shown)]
    if found.road is TransferKind.SLIP:
        slips = "rounding to decimals leaves slips of about 10^-20 m where the bodies stick"
        lines.append(f"friction is at its limit: {slips}; --margin avoids them")
    elif found.road is TransferKind.STUCK and found.margin == 0:
        lines.append("friction is at its limit to within 10^-18, as the times are decimals; --margin avoids this")
    road = found.road.name.lower().replace("_", "-")
    return {"road": road, "sentence": found.road.value, "fastest": found.fastest, **shown}, lines


def _of_cheapest(found: Any, least: str) -> Shown:
    from numerics.scene.decimals import decimal_text

    shown = numbers(found, "bound", "time", **{least: found.cost, f"least_{least}": found.least_cost})
    limit = "at its limit, or the margin, for a part of the time" if found.is_at_limit else "below its limit"
    holds = decimal_text(found.holding_force)
    record = {"sentence": found.road.value, **shown, "is_at_limit": found.is_at_limit, "holding_force": holds}
    lines = [found.road.value, *number_lines(shown), f"friction is {limit}"]
    lines.append(f"afterwards, and counted in neither number, the force a2 D = {holds} N holds the pair there")
    return record, lines


def _plan(options: argparse.Namespace, found: Any, shown: Shown, otherwise: str = "", *pair: Any) -> int:
    """Solve a plan again, draw and print it, and write or print its scene; FAILED with a sentence if there is none."""
    from numerics.control.answers import solved_again
    from numerics.scene.file import scene_text

    solved, (record, lines) = solved_again(found), shown
    if pair or solved is not None:
        draw(options, "draw_tracking" if pair else "draw_transfer", found, *(pair or (solved,)))
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
    shown = numbers(found, "entry", "centre")
    around, less = ("limit", "") if found.orbit is None else ("periodic motion", " minus that of the periodic motion")
    lines = number_lines(shown, centre=f"its centre, the limit of x1 - x2{less},")
    record = {**shown, "around": around, "why": found.why, "digits": found.digits}
    answer(options, record, [*lines, f"{found.why}; {found.digits} right digits, proved"])
    return OK


def print_damping(options: argparse.Namespace) -> int:
    """Print when a free pair sticks permanently, when it rests, and the damper that is best for that."""
    from numerics.scene.decimals import decimal_text

    _, found = _ask(options, "damping", options.tolerance)
    draw(options, "draw_damping", found)
    best = "" if found.best is None else decimal_text(found.best)
    record: dict[str, Any] = {}
    at_rest = found.own.rest == 0 == found.heavy.rest
    lines = [
        f"best of {len(found.sampled)} dampers tried: "
        + (f"a1 = {best} N s/m" if best else "all, at rest from the start" if at_rest else "the heavier, the better")
    ]
    for name, times, a1 in (
        ("best", found.at_best, best),
        ("own", found.own, decimal_text(found.scene.pair.a1)),
        ("heavy", found.heavy, "infinity"),
    ):
        record[name] = None if times is None else numbers(found, **times._asdict())
        if times is not None:
            stuck, rest = (record[name][one] for one in ("stuck", "rest"))
            lines.append(f"  a1 = {a1}: stuck from {stuck} s, at rest from {rest} s".replace("from inf s", "never"))
    record |= {"a1": best or None}
    return _print(options, found, (record, lines), "; that no other damper is better is not")
