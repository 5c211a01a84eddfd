"""Scenes under a force and at the extremes in every arithmetic: right to the digits that are claimed, or refused.

The answers share nothing with the solver: how they were found is told in tests/forced and tests/extremes.
"""

from decimal import Decimal, localcontext

import pytest
from sixty_digits import (
    CATALOGUE,
    EXTREMES,
    FORCED,
    HERE,
    WAYS,
    extreme,
    extreme_scene,
    forced,
    require_right,
)

from numerics import EventUndecided, NumericsError, solve
from numerics.free.energy import energy_at
from numerics.solver.truth import record
from numerics.trajectory.run import free_scene


def solved(case):
    return record(solve(case.scene, **case.asked))


@pytest.mark.parametrize(
    ("kind", "name", "way"),
    [
        pytest.param(kind, name, way, id=f"{name}-{way}")
        for kind, names in ((forced, FORCED), (extreme, EXTREMES))
        for name in names
        for way in (*WAYS, *["mpmath"] * (kind is extreme and free_scene(extreme_scene(name))))
    ],
)
def test_right_to_the_digits_claimed_or_refused(kind, name, way):
    case = kind(name, way)
    try:
        found, error = solved(case), None
    except NumericsError as refused:
        error = refused
    assert ("right" if error is None else type(error).__name__) in case.right
    if error is None:
        require_right(found, case)
    else:
        assert str(error).isprintable()
        assert "ball" in str(error) or "raise max_digits" in str(error)


def test_every_extreme_scene_has_an_entry_and_an_answer_and_says_what_it_is():
    files = {path.stem: path.read_text("utf-8") for path in (HERE / "extremes" / "scenes").glob("*.toml")}
    assert set(files) == set(CATALOGUE) == set(EXTREMES)
    assert all(text.startswith("# ") for text in files.values())


@pytest.mark.parametrize(
    ("kind", "name", "way", "place"),
    [
        (forced, "sine-stick-slip", "ball", 37),
        (forced, "many-causes", "ball", 37),
        (extreme, "excess-1e-12", "ball", 48),
        (extreme, "excess-1e-12", "mpmath", 45),
        (forced, "sine-stick-slip", "float64", 8),
    ],
)
def test_a_wrong_answer_is_seen(kind, name, way, place):
    """By one digit, by a radius that is too small, by a cause or a mode."""
    case = kind(name, way)
    found = solved(case)
    require_right(found, case)
    n, row, cause = case.rows[3]
    at = row[4].index(".") + place
    digit = row[4][:at] + str((int(row[4][at]) + 5) % 10) + row[4][at + 1 :]
    wrong = [case._replace(rows=[(n, [*row[:4], digit], cause)]), case._replace(modes=case.modes + "0")]
    wrong += [case._replace(rows=[(n, row, "none")])]
    for one in wrong:
        with pytest.raises(AssertionError):
            require_right(found, one)
    if way == "ball":
        found["events"][n] |= {"v2": found["events"][n]["v2"][:45], "v2_radius": "0"}
        with pytest.raises(AssertionError):
            require_right(found, case._replace(digits=30))


@pytest.mark.parametrize("name", [name for name, entry in CATALOGUE.items() if "late" in entry])
def test_the_energy_at_the_horizon_without_stepping_there(name):
    one, late = extreme_scene(name), EXTREMES[name]["late"]
    found = energy_at(one, one.until, digits=late["digits"])
    with found.frame.arithmetic.context():
        text = found.energy_excess.mid().str(60, radius=False)
    with localcontext() as context:
        context.prec = 80
        truth = Decimal(late["energy_excess"])
        assert abs(Decimal(str(text)) - truth) <= truth * Decimal(10) ** -late["digits"]
    assert str(found.excursions) == late.get("excursions", str(found.excursions))
    assert found.excursions > 10**6


def test_an_undecided_graze_shows_the_enclosure():
    case = extreme("graze-to-900-digits", "ball")
    with pytest.raises(EventUndecided, match="graze") as caught:
        solved(case)
    assert "+/-" in caught.value.enclosure
    assert caught.value.digits <= 500
    # with the digits that it asks for it is decided
    require_right(solved(case._replace(asked={"arithmetic": "ball", "digits": 50})), case)
