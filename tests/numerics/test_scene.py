"""Scenes are exact, and whatever describes no scene is refused in one line."""

import re
import tomllib
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from reaching import LeftOut, reaching

from numerics import InvalidScene
from numerics.scene.decimals import exact_decimal
from numerics.scene.file import load_scene, parse_scene

VALID = """[pair]
m1 = 1
m2 = 1
a2 = 200
b = 0.5
[initial]
x1 = 0.005
v1 = 0.15
[run]
until = 5
"""
HUGE = "0x" + "f" * 20000


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_float_means_its_shortest_decimal_text(value):
    assert exact_decimal(value, "x1") == Fraction(repr(value)) == exact_decimal(Decimal(repr(value)), "x1")


@pytest.mark.parametrize("text", ["1_000", "+5", "0o17", "0x1F", "0b11", "5e-1", '"0.5"', '" 7 "', "1e1000", "1e-1000"])
def test_toml_spellings_of_a_number(text):
    assert parse_scene(VALID.replace("m1 = 1", f"m1 = {text}")).pair.m1 > 0


REFUSED = tomllib.loads((Path(__file__).parents[1] / "refused.toml").read_text("utf-8"))
BAD_VALUES = REFUSED["values"] | {
    "5000 digits": "1" * 5000,
    "4000 decimals": "0." + "1" * 4000,
    "huge hexadecimal": HUGE,
    "deeply nested": "[" * 20000 + "]" * 20000,
}


ALLOWED = {("x1", "zero"), ("x1", "negative"), ("a1", "zero"), ("a2", "zero"), ("b", "zero"), ("m2", "inf")}


@pytest.mark.parametrize("name", ["m1", "m2", "a2", "b", "until", "x1", "a1", "law"])
@pytest.mark.parametrize("kind", BAD_VALUES)
def test_bad_values_are_refused_in_one_line_that_names_them(name, kind):
    if (name, kind) in ALLOWED:
        return
    text = VALID.replace("[run]", "[run]\nlaw = 'filippov'").replace("[pair]", "[pair]\na1 = 1")
    assert parse_scene(text)
    bad = re.sub(rf"^{name} = .*$", lambda _: f"{name} = {BAD_VALUES[kind]}", text, flags=re.MULTILINE)
    require_refusal(bad, f"^({name} |not a TOML scene: )")


def require_refusal(text, said=None):
    with pytest.raises(InvalidScene, match=said) as caught:
        parse_scene(text)
    assert len(str(caught.value)) < 300
    assert str(caught.value).isprintable()


BAD_TEXTS = {
    "empty": "",
    "no table": "m1 = 1",
    "missing key": VALID.replace("m2 = 1\n", ""),
    "long key": VALID + "a" * 5000 + " = 5\n",
    "pair is an array": "pair = [1]\n[run]\nuntil = 5\n",
    "forces that are numbers": "force = [1]\n" + VALID,
    "byte order mark": "\ufeff" + VALID,
    "nul": VALID + "\0",
    "a1 negative": VALID.replace("m1 = 1", "m1 = 1\na1 = -1"),
    "brackets without end": f"{VALID}[[force]]\npolynomial = {'[' * 3000}{']' * 3000}",
    "too many pieces": VALID + "".join(f"[[force]]\nfrom = {k}\n" for k in range(100_001)),
}


def with_pair(text):
    """A scene, but for the text behind its pair."""
    run = "" if "[run]" in text else "[run]\nuntil = 5\n"
    return f"{run}[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.5\n{text}\n"


BAD_TEXTS |= {name: with_pair(text) for name, text in REFUSED["refused"].items()}


@pytest.mark.parametrize("kind", BAD_TEXTS)
def test_bad_files_are_refused_in_one_line(kind):
    require_refusal(BAD_TEXTS[kind])


MOST = [(64, "coefficients", "polynomial", "1"), (1000, "sines", "sines", "{ amplitude = 1, omega = 1 }")]


@pytest.mark.parametrize(("most", "what", "key", "one"), MOST)
def test_a_piece_has_at_most_so_many_numbers(most, what, key, one):
    enough, more = (f"{VALID}[[force]]\n{key} = [{', '.join([one] * count)}]" for count in (most, most + 1))
    assert parse_scene(enough).is_forced
    require_refusal(more, f"{most + 1} {what}")


@pytest.mark.parametrize("text", REFUSED["proved"])
def test_friction_that_comes_down_to_0_and_no_further_is_proved(text):
    assert parse_scene(with_pair(text)).is_forced


@pytest.mark.parametrize("said", REFUSED["said"])
def test_a_refusal_says_what_is_wrong(said):
    for text in REFUSED["said"][said]:
        with pytest.raises(InvalidScene, match=said):
            parse_scene(with_pair(text))


@given(st.text())
def test_no_text_is_anything_but_a_scene_or_invalid(text):
    with pytest.raises(InvalidScene):
        parse_scene(text)


@reaching
@given(st.one_of(st.none(), st.booleans(), st.binary(), st.complex_numbers(), st.lists(st.integers()), st.text()))
def test_no_object_is_anything_but_a_number_or_invalid(value):
    if isinstance(value, str) and any(digit in value for digit in "0123456789"):
        raise LeftOut
    with pytest.raises(InvalidScene):
        exact_decimal(value, "x1")


def test_a_file_that_cannot_be_read(tmp_path):
    (tmp_path / "latin.toml").write_bytes(VALID.encode() + b"# \xff\n")
    (tmp_path / "large.toml").write_bytes(VALID.encode() + b"#" * 2**25)
    for path in ("latin.toml", "large.toml", "absent.toml", ".", "a\0b"):
        with pytest.raises(InvalidScene) as caught:
            load_scene(tmp_path / path)
        assert "\n" not in str(caught.value)
