"""A sine that a user gives beside a scene: its amplitude, its frequency, or both."""

from __future__ import annotations

from fractions import Fraction

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, short


def given_sine(amplitude: Exact | None, omega: Exact | None) -> dict[str, Fraction]:
    """Return what was given of amplitude and omega. Raises InvalidScene for what no sine can have."""
    given = {"amplitude": amplitude, "omega": omega}
    asked = {name: exact_decimal(one, name) for name, one in given.items() if one is not None}
    if asked.get("omega", Fraction(1)) <= 0:
        raise InvalidScene(f"omega = {short(asked['omega'])} must be > 0; give a frequency in rad/s")
    if asked.get("amplitude") == 0:
        raise InvalidScene("amplitude = 0 must not be 0; without a force there is no response")
    return asked
