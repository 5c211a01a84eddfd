"""What a user meets: one place to import from, short texts, tables, kinds of numbers."""

import doctest
import inspect
import pickle
import re
import typing
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from three_scenes import PAPER

import numerics
from numerics import (
    Force,
    Pair,
    PlanePair,
    Scene,
    State,
    damping,
    load_scene,
    response,
    scene_text,
    solve,
    solve_many,
)
from numerics.scene.file import parse_scene

# one place


def test_everything_a_user_needs_is_in_one_place_and_star_brings_it():
    names, brought = dir(numerics), {}
    assert all(callable(getattr(numerics, name)) for name in names)
    assert solve(PAPER).success
    assert dir(numerics) == names  # what was imported since is not listed
    exec("from numerics import *", brought)
    assert set(brought) - {"__builtins__"} == set(names)
    assert numerics.__version__
    assert pickle.loads(pickle.dumps(solve)) is solve


def test_help_begins_with_one_line_for_each_name():
    told = re.findall(r"^    (\w+(?:, \w+)*)  +\S.*$", numerics.__doc__, re.MULTILINE)
    assert sorted(name for names in told for name in names.split(", ")) == dir(numerics)
    assert len(numerics.__doc__.splitlines()) < 80


def public(kind):
    """The public attributes of a class, and those that its instances get."""
    return [name for name in dir(kind) if not name.startswith("_")]


CLASSES = [one for name in dir(numerics) if inspect.isclass(one := getattr(numerics, name))]
INNER = """ENERGIES EVENT_COLUMNS FORMAT but columns context end_bounds end_numbers event_rows
floats frame kept made of pictures pieces require_filippov restored row signs"""
FOR_THE_HOUSE = {*INNER.split(), *(name for name in public(numerics.Trajectory) if name.startswith("row_"))}
GUIDE = (Path(__file__).resolve().parents[2] / "docs" / "guide.md").read_text("utf-8")


@pytest.mark.parametrize("kind", [one for one in CLASSES if not issubclass(one, Exception)])
def test_every_attribute_of_what_a_user_meets_is_told_and_shown_in_an_example_that_runs(kind):
    examples = "".join(one.source for one in doctest.DocTestFinder().find(kind, kind.__name__) for one in one.examples)
    assert examples
    for name in set(public(kind)) - FOR_THE_HOUSE:
        static = inspect.getattr_static(kind, name)
        assert not callable(static) or inspect.getdoc(static)
        assert re.search(rf"\b{name}\b", examples) or f".{name}(" in GUIDE, name


def annotations(one):
    """Those of a function as a type checker reads them, of its overloads if it has some; of the fields of a class."""
    function = inspect.unwrap(getattr(one, "__func__", getattr(one, "fget", getattr(one, "func", one))))
    if inspect.isclass(one):
        return [{key: kind for key, kind in inspect.get_annotations(one).items() if key[0] != "_"}]
    if not inspect.isfunction(function):
        return []  # of Python itself
    return [inspect.get_annotations(each) for each in typing.get_overloads(function) or [function]]


@pytest.mark.parametrize("name", dir(numerics))
def test_no_public_signature_is_without_a_type(name):
    of = getattr(numerics, name)
    members = {*public(of), "__init__"} - FOR_THE_HOUSE if inspect.isclass(of) else ()
    for one in (of, *(inspect.getattr_static(of, member) for member in members)):
        assert not re.search(r"\bAny\b", str(annotations(one))), one


@pytest.mark.parametrize("name", [one for one in dir(numerics) if inspect.isfunction(getattr(numerics, one))])
def test_every_function_says_what_it_raises_and_has_an_example(name):
    assert re.search("(?s)Raise.*>>>", getattr(numerics, name).__doc__) or name == "scene_text"


# texts


def test_every_record_is_shown_in_one_short_line():
    forced, run = load_scene("forced-sine-stick-slip"), solve(PAPER)
    found = response(forced, digits=8)
    records = [PAPER, forced, load_scene("forced-sweep"), run.events[0], run.segments[0], run.ledger, run.accuracy]
    records += [found, found.thresholds, found.orbit, damping(load_scene("at-rest"), "0.001")]
    for one in records:
        assert re.fullmatch(rf"{type(one).__name__}.{{,240}}", repr(one))
    shown = Pair(m1="1/3", m2=0.1, a2=200, b=5)
    assert eval(repr(shown)) == shown
    assert repr(Pair("1." + "3" * 400, 1, 2, 3)) == "Pair(m1=1.33333, m2=1, a2=2, b=3)"


# pictures, times, tables


# numbers of any kind

ONE_FIFTH = [0.2, "0.2", "1/5", " 1 / 5 ", Decimal("0.2"), Fraction(1, 5), np.float64(0.2), np.float32(0.2)]


@pytest.mark.parametrize("fifth", ONE_FIFTH)
def test_every_kind_of_number_is_read(fifth):
    """A float of 32 bits by the decimals that it prints, too."""
    assert Scene(PAPER.pair, State(x1=fifth), fifth) == Scene(PAPER.pair, State("0.2"), "0.2")
    assert Force.samples(np.array([fifth]), [1]) == Force.step("0.2", 1)
    assert PlanePair(1, 1, 200, np.array([fifth, fifth])).b == (Fraction(1, 5),) * 2
    batch = solve_many(1, 1, 200, 1, v1=np.array([fifth]), until=1)
    assert batch.inputs["v1"].tolist() == [0.2]


def test_a_ratio_is_a_number_in_a_scene_file_and_in_a_batch():
    scene = Scene(Pair("1/3", 1, 200, "1/2"), State(v1="3/20"), "7/3")
    assert parse_scene(scene_text(scene)) == scene
    batch = solve_many("1/3", 1, 200, "1/2", v1=["3/20", " 0.1 ", Fraction(1, 7)], until="7/3", exact=True)
    assert batch.y[:, 0].tolist() == [*map(float, solve(scene).final_state)]
