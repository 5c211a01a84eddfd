"""What the other subcommands of `python -m numerics` do; all heavy imports happen here, when a command runs."""

from __future__ import annotations

import argparse

from numerics.cli.printing import answer, number_lines
from numerics.cli.solving import LABELS
from numerics.exits import OK


def list_scenes(_: argparse.Namespace) -> int:
    """Print the short name and a description of each shipped scene, one per line."""
    from numerics.scene.file import described_scenes

    for name, what in described_scenes().items():
        print(f"{name:28}{what}")
    return OK


def print_energy(options: argparse.Namespace) -> int:
    """Print the energy of a scene at one time, however late."""
    from numerics.free.energy import energy_at
    from numerics.scene.file import load_line
    from numerics.trajectory.rendering import with_radius

    found = energy_at(
        load_line(options.scene),
        options.at,
        digits=options.digits,
        max_steps=options.max_steps,
        max_digits=options.max_digits,
    )
    x1, v1, _, v2 = found.si_state
    values = {"energy": found.energy, "energy_excess": found.energy_excess, "x1": x1, "v1": v1, "v2": v2}
    shown = {"t": options.at, "mode": found.mode.value}
    with found.frame.arithmetic.context():
        for name, value in values.items():
            shown |= with_radius(name, value, options.digits)
    road = found.road.name.lower().replace("_", "-")
    way = {"excursions": str(found.excursions), "road": road, "stepped": found.stepped, "digits": options.digits}
    lines = [
        f"at t = {options.at} s, {found.mode.value}, after {found.excursions} excursions",
        f"  energy = {shown['energy']} J\n  {LABELS['energy_excess']} = {shown['energy_excess']}",
        *number_lines({name: shown[name] for name in shown if "energy" not in name}),
        f"{options.digits} right digits of the energy and its excess, proved",
        *([f"{found.road.value} ({found.stepped} events computed one by one)"] if options.explain else []),
    ]
    answer(options, shown | way, lines)
    return OK
