"""Hostile descriptions of a force or a friction, through the command line: exit code 2 and one line, at once."""

import time

import pytest

from numerics.__main__ import main

VALID = "[pair]\nm1 = 1\nm2 = 1\na2 = 200\nb = 0.05\n[run]\nuntil = 5\n"
SECONDS = 5


def force(text):
    return VALID + "[[force]]\n" + text + "\n"


def friction(text):
    return VALID + "[[friction]]\n" + text + "\n"


HOSTILE = {
    "a ratio with nothing below": force('from = "1/0"'),
    "a ratio of a ratio": force('from = "1/2/3"'),
    "an exponent out of range": force('polynomial = ["1e1001"]'),
    "an exponent of nine digits": force("polynomial = [1e999999999]"),
    "a number too long": force(f'polynomial = ["{"1" * 1001}"]'),
    "a date for a time": force("from = 1979-05-27"),
    "a date for a coefficient": force("polynomial = [1979-05-27]"),
    "a phase that is nan": force("sines = [{ amplitude = 1, omega = 1, phase = nan }]"),
    "an amplitude that is inf": force("sines = [{ amplitude = inf, omega = 1 }]"),
    "an amplitude that is true": force("sines = [{ amplitude = true, omega = 1 }]"),
    "a frequency in words": force('sines = [{ amplitude = 1, omega = "fast" }]'),
    "a frequency barely negative": force('sines = [{ amplitude = 1, omega = "-1e-300" }]'),
    "a time barely negative": force('from = "-1e-300"'),
    "too many sines": force(f"sines = [{', '.join(['{ amplitude = 1, omega = 1 }'] * 1001)}]"),
    "the same key twice": force("from = 1\nfrom = 2"),
    "brackets without end": force(f"polynomial = {'[' * 3000}{']' * 3000}"),
    "digits as one text": force('polynomial = "123"'),
    "a sine that is a text": force('sines = ["sin"]'),
    "a force that is a text": 'force = "sin"\n' + VALID,
    "a key with a line break": force('"a\\nb" = 1'),
    "control characters": force('from = "\\u001b[31m1"'),
    "digits of another script": force('from = "\u0661"'),
    "an underscore in a text": force('from = "1_0"'),
    "thousands, the last out of order": VALID + "".join(f"[[force]]\nfrom = {k}\n" for k in [*range(5000), 4000]),
    "too many pieces": VALID + "".join(f"[[force]]\nfrom = {k}\n" for k in range(100_001)),
    "friction as one table": VALID + "[friction]\nfrom = 1\nb = 1\n",
    "friction that is inf": friction("from = 1\nb = inf"),
    "friction that is nan": friction("from = 1\nb = nan"),
    "friction at a time that is nan": friction("from = nan\nb = 1"),
    "friction at a list": friction("from = [1]\nb = 1"),
    "friction in words": friction('from = 1\nb = "strong"'),
    "friction barely negative": friction('from = 1\nb = "-1e-300"'),
    "friction with a key it has not": friction("from = 1\nb = 1\nmu = 2"),
    "friction twice at one time": friction('from = 1\nb = 1\n[[friction]]\nfrom = "2/2"\nb = 2'),
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_it_is_refused_in_one_line_at_once(kind, tmp_path, capsys):
    path, began = tmp_path / "scene.toml", time.process_time()
    path.write_text(HOSTILE[kind], "utf-8")
    assert main(["solve", str(path)]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.startswith("error: ")
    assert told.err.endswith("\n")
    assert told.err[:-1].isprintable()
    assert len(told.err) < 300
    assert time.process_time() - began < SECONDS
