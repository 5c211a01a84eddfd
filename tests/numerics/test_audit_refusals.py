"""The audit of refusals: a reader that takes what is no scene, or is slow, or says nothing, is seen."""

import time

import pytest
from audit_rows import quiet

from numerics.audit import refusals
from numerics.scene.file import parse_scene

READERS = {
    "accepts everything": (lambda text: None, "accepted wrongly"),
    "accepts negative masses": (lambda text: parse_scene(text.replace("-", "")), "accepted wrongly"),
    "refuses everything": (lambda text: parse_scene(""), "refused wrongly"),
    "raises ValueError": (lambda text: int("x"), "other errors"),
    "slow": (lambda text: (time.sleep(0), parse_scene(text)) if len(text) % 7 else spin(), "over 1 s"),
}


def spin():
    end = time.process_time() + 1.05
    while time.process_time() < end:
        pass
    parse_scene("")


@pytest.mark.parametrize("name", READERS)
def test_a_wrong_reader_fails(name):
    reader, figure = READERS[name]
    rows = list(refusals.audit_refusals(0, 3 if name == "slow" else 400, quiet, reader))
    assert not all(row.passed for row in rows)
    assert sum(row.measured[figure] for row in rows) > 0


@pytest.mark.parametrize(
    ("number", "valid"),
    [
        ("1", True),
        ("1_0.5", True),
        ('"1_0.5"', False),
        ('" 5e-2 "', True),
        ("nan", False),
        ('".5"', True),
        ("1e1001", False),
        ('"1/2"', True),
        ('" 1e3 / 7 "', True),
        ('"-1/-2"', True),
        ('"1/2/3"', False),
        ('"1/0"', False),
        ("1/2", False),
    ],
)
def test_the_second_reading_agrees_where_it_is_plain(number, valid):
    text = f"[pair]\nm1={number}\nm2=1\na2=1\nb=1\n[run]\nuntil=1"
    assert refusals.describes_a_scene(text) == valid
    try:
        parse_scene(text)
    except refusals.InvalidScene:
        assert not valid
    else:
        assert valid
