"""python -m numerics audit: its rows at the small size, and that each kind of row fails when its fault is planted."""

import dataclasses
import json
import os
from itertools import islice

import pytest
from audit_rows import quiet
from interruption import interrupted

from numerics.__main__ import main
from numerics.audit import plan, table
from numerics.audit.formulas import MOST_ULP

SECTIONS = ["formulas", "enclosures", "trajectories", "energy", "error bounds", "bit for bit", "refusals"]


@pytest.fixture(scope="module")
def small():
    return list(plan.audit(plan.SIZES["small"], 7, quiet))


def test_every_row_is_as_required(small):
    assert [row.name for row in small if not row.passed] == []
    assert list(dict.fromkeys(row.section for row in small)) == SECTIONS
    assert all(row.tried > 0 for row in small)


def test_the_json_has_its_shape(small):
    record = json.loads(json.dumps(table.as_record(small, 7, "small")))
    assert list(record) == ["seed", "size", "passed", "rows"]
    assert (record["seed"], record["size"], record["passed"]) == (7, "small", True)
    keys = ["section", "name", "tried", "measured", "required", "passed", "details"]
    assert all(list(row) == keys for row in record["rows"])
    for row in record["rows"]:
        if row["section"] == "formulas":
            decades = [one["decade"] for one in row["details"]]
            assert decades == list(range(decades[0], decades[-1] + 1))
            assert all(0 <= one["mean_ulp"] <= one["max_ulp"] <= MOST_ULP for one in row["details"])
    reasons = [row["details"][0]["reasons"] for row in record["rows"] if row["section"] == "refusals"]
    assert all(sum(one.values()) > 100 for one in reasons)


def test_tables_are_printed(small, capsys):
    for show in (table.print_table, table.print_decades, table.print_reasons):
        show(small, 200)
    out = capsys.readouterr().out
    assert "FAIL" not in out
    assert "rise: (x - sin x)/(1 - cos x)" in out
    assert "not a TOML scene" in out


def test_the_exit_code_is_that_of_the_rows(capsys, monkeypatch, small):
    shown = list(islice(small, 3))
    monkeypatch.setattr(plan, "audit", lambda *_: iter(shown))
    assert main(["audit", "--size", "small", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["passed"] is True
    shown[1] = dataclasses.replace(shown[1], passed=False)
    assert main(["audit", "--size", "small", "--decades"]) == 1
    captured = capsys.readouterr()
    assert "FAIL" in captured.out
    assert captured.err == ""


@pytest.mark.parametrize("arguments", [["--size", "huge"], ["--seed", "-1"], ["--seed", "x"]])
def test_wrong_usage(arguments, capsys):
    with pytest.raises(SystemExit) as stop:
        main(["audit", *arguments])
    assert stop.value.code == 2


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_an_interrupt_ends_it_in_one_line(tmp_path):
    code, out, err = interrupted("numerics", ["audit", "--size", "large"], "flint", tmp_path)
    assert (code, out) == (130, "")
    assert err == "error: interrupted; nothing was written\n"
